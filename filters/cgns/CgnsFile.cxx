#include "CgnsFile.h"

#include "Error.h"

#include <cgnslib.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace fs = std::filesystem;

CgnsFile::CgnsFile()
{
  std::error_code failed;
  this->Folder = (fs::temp_directory_path(failed) / "crossfieldXXXXXX").string();
  if (failed || mkdtemp(this->Folder.data()) == nullptr)
  {
    throw crossfield::Error(
      "The folder for temporary files cannot be written, and a .cgns file needs "
      "one; check the free space, or set TMPDIR.");
  }
  this->Name = this->Folder + "/mesh.cgns";
  try
  {
    Require(cg_set_file_type(CG_FILE_HDF5));
    Require(cg_open(this->Name.c_str(), CG_MODE_WRITE, &this->File));
  }
  catch (...)
  {
    fs::remove_all(this->Folder, failed);
    throw;
  }
}

CgnsFile::~CgnsFile()
{
  if (this->File >= 0)
  {
    cg_close(this->File);
  }
  std::error_code ignored;
  fs::remove_all(this->Folder, ignored);
}

void CgnsFile::Require(int status)
{
  if (status != CG_OK)
  {
    throw crossfield::Error("The .cgns file cannot be written by libcgns (" +
      std::string(cg_get_error()) + "); check the free space of the folder for temporary files.");
  }
}

std::string CgnsFile::Take()
{
  const int file = this->File;
  this->File = -1;
  Require(cg_close(file));
  std::ifstream stream(this->Name, std::ios::binary);
  std::string bytes{ std::istreambuf_iterator<char>(stream), {} };
  if (!stream || bytes.empty())
  {
    throw crossfield::Error(
      "The .cgns file cannot be read back from the folder for temporary files; "
      "check its free space, or set TMPDIR.");
  }
  return bytes;
}
