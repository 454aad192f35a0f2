#include "CgnsLibrary.h"

#include "Error.h"
#include "MeshFormats.h"
#include "OwnLibrary.h"
#include "WriteCgns.h"

namespace
{
WriteCgnsFunction* LoadCgnsWriter()
{
  static auto* const Function =
    reinterpret_cast<WriteCgnsFunction*>(OwnLibrary::Find("libcrossfieldCgns.so", WriteCgnsName));
  return Function;
}
}

namespace CgnsLibrary
{
//------------------------------------------------------------------------------
bool IsAvailable()
{
  return LoadCgnsWriter() != nullptr;
}

//------------------------------------------------------------------------------
void Require()
{
  if (!IsAvailable())
  {
    throw crossfield::Error(
      "A .cgns file cannot be written, because CrossField was built without CGNS; write a .xyz or .msh "
      "file, or install libcgns-dev and build again.");
  }
}

//------------------------------------------------------------------------------
std::string Write(crossfield::SolverMesh mesh)
{
  Require();
  crossfield::PrepareMesh(mesh, crossfield::MeshFormat::Cgns);
  std::string bytes;
  std::string error;
  LoadCgnsWriter()(mesh, bytes, error);
  if (!error.empty())
  {
    throw crossfield::Error(error);
  }
  return bytes;
}
}
