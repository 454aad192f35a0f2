#include "FoamCase.h"

#include "Error.h"
#include "FoamText.h"
#include "WriteBlockMesh.h"
#include "WriteFoam.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <vector>

namespace crossfield
{
namespace
{
namespace fs = std::filesystem;

/// Files of a mesh with their classes in OpenFOAM.
struct MeshFile
{
  const char* name;
  const char* type;
};
constexpr std::array<MeshFile, 8> MeshFiles = { { { "points", "vectorField" },
  { "faces", "faceList" }, { "owner", "labelList" }, { "neighbour", "labelList" },
  { "boundary", "polyBoundaryMesh" }, { "cellZones", "regIOobject" },
  { "faceZones", "regIOobject" }, { "pointZones", "regIOobject" } } };

bool StartsWith(const fs::path& file, const std::string& text)
{
  std::ifstream stream(file, std::ios::binary);
  std::string start(text.size(), '\0');
  return stream.read(start.data(), static_cast<std::streamsize>(start.size())) && start == text;
}

/// Returns whether a file has the header of this program up to its class. Programs of OpenFOAM write other blanks.
bool IsOwnMeshFile(const fs::path& file, const MeshFile& part)
{
  MeshText header;
  AddFoamHeader(header, part.type, "", "");
  const std::string text = header.Take();
  return StartsWith(file, text.substr(0, text.find(part.type) + std::string(part.type).size()));
}

/// Returns the first .foam file of a folder in alphabetical order, empty if there is none.
std::string FirstMarker(const fs::path& folder)
{
  std::vector<std::string> found;
  std::error_code failed; // a folder that cannot be listed has none
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
  {
    if (entry.path().extension() == ".foam")
    {
      found.push_back(entry.path().filename().string());
    }
  }
  return found.empty() ? "" : *std::min_element(found.begin(), found.end());
}
}

std::string FoamMarker(const std::string& name)
{
  if (name != FoamFolder(name))
  {
    return name;
  }
  const std::string last =
    fs::path(name).parent_path().filename().string(); // without the / at the end
  return name + (last.empty() || last[0] == '.' ? "case" : last) + ".foam";
}

void RequireOwnCase(const std::string& name)
{
  const std::string given = FoamFolder(name);
  const fs::path folder = given.empty() ? "." : given;
  const fs::path mesh = folder / "constant/polyMesh";
  const fs::path dictionary = folder / "system/blockMeshDict";
  std::error_code failed;
  const bool hasDictionary = fs::exists(dictionary, failed);
  const bool isOwnDictionary = StartsWith(dictionary, BlockMeshNote);
  const auto exists = [&mesh](const MeshFile& part)
  {
    std::error_code ignored;
    return fs::exists(mesh / part.name, ignored) ||
      fs::exists(mesh / (std::string(part.name) + ".gz"), ignored);
  };
  const bool hasMesh = std::any_of(MeshFiles.begin(), MeshFiles.end(), exists);
  const bool isOwnMesh = isOwnDictionary ||
    std::any_of(MeshFiles.begin(), MeshFiles.end(),
      [&mesh](const MeshFile& part) { return IsOwnMeshFile(mesh / part.name, part); });
  if (hasMesh && !isOwnMesh)
  {
    throw Error("The folder '" + mesh.string() +
      "' has a mesh of another program, which would be replaced; remove this folder, or give another case.");
  }
  if (hasDictionary && !isOwnDictionary)
  {
    throw Error("The dictionary '" + dictionary.string() +
      "' was not written by CrossField and would be replaced; move or remove it, or give another case.");
  }
  const std::string other = FirstMarker(folder);
  if (hasMesh && !other.empty() && !fs::exists(FoamMarker(name), failed))
  {
    throw Error("The folder '" + mesh.string() + "' has the mesh of '" + (folder / other).string() +
      "', which would be replaced; give that name, or a case in another folder.");
  }
}
}
