#ifndef CrossFieldPlugin_server_manager_modules_h
#define CrossFieldPlugin_server_manager_modules_h

#include "CrossFieldPlugin_server_manager_modules_data.h"
#include <string>
#include <vector>

inline void CrossFieldPlugin_server_manager_modules_initialize(std::vector<std::string>& xmls)
{
  (void)xmls;
}

#endif
