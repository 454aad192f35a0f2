#include "OwnLibrary.h"

#include <dlfcn.h>

#include <string>

namespace OwnLibrary
{
//------------------------------------------------------------------------------
void* Find(const char* library, const char* function)
{
  Dl_info own{};
  static const char Here = 0;
  std::string folder = dladdr(&Here, &own) != 0 ? own.dli_fname : "";
  folder.erase(folder.rfind('/') == std::string::npos ? 0 : folder.rfind('/') + 1);
  void* handle = dlopen((folder + library).c_str(), RTLD_NOW | RTLD_LOCAL);
  return handle == nullptr ? nullptr : dlsym(handle, function);
}
}
