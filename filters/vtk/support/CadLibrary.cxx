#include "CadLibrary.h"

#include "Error.h"
#include "ReadCad.h"

#include <dlfcn.h>

namespace
{
/** Returns the function of the library, null if there is no library. */
ReadCadFunction* Load()
{
  static ReadCadFunction* const Function = []() -> ReadCadFunction*
  {
    // The library is installed next to this one.
    Dl_info own{};
    static const char Here = 0;
    std::string folder = dladdr(&Here, &own) != 0 ? own.dli_fname : "";
    folder.erase(folder.rfind('/') == std::string::npos ? 0 : folder.rfind('/') + 1);
    void* library = dlopen((folder + "libcrossfieldCad.so").c_str(), RTLD_NOW | RTLD_LOCAL);
    return library == nullptr ? nullptr
                              : reinterpret_cast<ReadCadFunction*>(dlsym(library, ReadCadName));
  }();
  return Function;
}
}

namespace CadLibrary
{
//------------------------------------------------------------------------------
bool IsCad(const std::string& ending)
{
  return ending == ".step" || ending == ".stp" || ending == ".brep";
}

//------------------------------------------------------------------------------
bool IsAvailable()
{
  return Load() != nullptr;
}

//------------------------------------------------------------------------------
crossfield::Drawing Read(const std::string& file)
{
  ReadCadFunction* const read = Load();
  if (read == nullptr)
  {
    throw crossfield::Error("The file '" + file +
      "' cannot be read, because CrossField was built without Open CASCADE; export the face as a "
      ".dxf file, or install libocct-data-exchange-dev and build again.");
  }
  crossfield::Drawing drawing;
  std::string error;
  read(file, drawing, error);
  if (!error.empty())
  {
    throw crossfield::Error(error);
  }
  return drawing;
}
}
