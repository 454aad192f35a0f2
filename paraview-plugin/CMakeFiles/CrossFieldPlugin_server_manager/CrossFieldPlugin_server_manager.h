#ifndef CrossFieldPlugin_server_manager_h
#define CrossFieldPlugin_server_manager_h

#include "CrossFieldPlugin_server_manager_data.h"
#include <string>
#include <vector>

inline void CrossFieldPlugin_server_manager_initialize(std::vector<std::string>& xmls)
{
  (void)xmls;
  {
    char *init_string = CrossFieldPlugin_server_managerCrossFieldSourcesGetInterfaces();
    xmls.emplace_back(init_string);
    delete [] init_string;
  }
  {
    char *init_string = CrossFieldPlugin_server_managerCrossFieldFiltersGetInterfaces();
    xmls.emplace_back(init_string);
    delete [] init_string;
  }
}

#endif
