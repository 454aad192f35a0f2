#include "CadLibrary.h"

#include "Error.h"
#include "OwnLibrary.h"

namespace
{
/** Returns the function of the library, null if there is no library. */
ReadCadFunction* Load()
{
  static auto* const Function =
    reinterpret_cast<ReadCadFunction*>(OwnLibrary::Find("libcrossfieldCad.so", ReadCadName));
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
crossfield::Drawing Read(const std::string& file, const CadRequest& request)
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
  read(file, request, drawing, error);
  if (!error.empty())
  {
    throw crossfield::Error(error);
  }
  return drawing;
}
}
