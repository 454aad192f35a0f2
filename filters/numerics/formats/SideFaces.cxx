#include "SideFaces.h"

#include "CellLattice.h"
#include "Error.h"
#include "Index.h"
#include "MeshText.h"

#include <algorithm>
#include <array>

namespace crossfield
{
namespace
{
/// The faces of all cells, in buckets by their smallest corner.
class FaceBuckets
{
public:
  explicit FaceBuckets(const ExportMesh& mesh)
    : Mesh(mesh)
    , FacesOfCell(mesh.dimension == 2 ? 4 : 6)
    , Starts(mesh.points.size() + 1, 0)
  {
    const CellLattice lattice(mesh.dimension, mesh.order);
    for (int face = 0; face < this->FacesOfCell; ++face)
    {
      this->Corners.push_back(lattice.FaceCorners(face));
    }
    const std::size_t count = mesh.region.size() * Index(this->FacesOfCell);
    for (std::size_t i = 0; i < count; ++i)
    {
      ++this->Starts[Index(this->KeyOf(i)[0]) + 1];
    }
    for (std::size_t point = 0; point < mesh.points.size(); ++point)
    {
      this->Starts[point + 1] += this->Starts[point];
    }
    this->Faces.resize(count);
    std::vector<std::size_t> next(this->Starts.begin(), this->Starts.end() - 1);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Faces[next[Index(this->KeyOf(i)[0])]++] = i;
    }
  }

  /// Returns the faces with these corners.
  std::vector<std::size_t> Find(const FaceKey& key) const
  {
    std::vector<std::size_t> found;
    for (std::size_t i = this->Starts[Index(key[0])]; i < this->Starts[Index(key[0]) + 1]; ++i)
    {
      if (this->KeyOf(this->Faces[i]) == key)
      {
        found.push_back(this->Faces[i]);
      }
    }
    return found;
  }

  SideFace FaceOf(std::size_t i) const
  {
    const auto number = static_cast<int>(i % Index(this->FacesOfCell));
    return { static_cast<int>(i / Index(this->FacesOfCell)), number };
  }

  FaceKey KeyOf(std::size_t i) const
  {
    const SideFace face = this->FaceOf(i);
    const int* nodes = this->Mesh.Cell(face.cell);
    FaceKey key{};
    const std::vector<int>& corners = this->Corners[Index(face.face)];
    for (std::size_t c = 0; c < corners.size(); ++c)
    {
      key[c] = nodes[corners[c]];
    }
    return KeyOfFace(key, static_cast<int>(corners.size()));
  }

  std::size_t Count() const { return this->Faces.size(); }

private:
  const ExportMesh& Mesh;
  int FacesOfCell;
  std::vector<std::vector<int>> Corners; ///< Per face of a cell, positions of its corners.
  std::vector<std::size_t> Starts;       ///< Per point, the beginning of its bucket.
  std::vector<std::size_t> Faces;        ///< Cell · faces of a cell + face.
};
}

FaceKey KeyOfFace(FaceKey corners, int count)
{
  if (count == 2)
  {
    return { std::min(corners[0], corners[1]), std::max(corners[0], corners[1]), 0, 0 };
  }
  std::sort(corners.begin(), corners.end());
  auto* const last = std::unique(corners.begin(), corners.end());
  std::fill(last, corners.end(), *(last - 1));
  return corners;
}

SideFaces FindSideFaces(const ExportMesh& mesh)
{
  const FaceBuckets buckets(mesh);
  const std::string kind = mesh.dimension == 2 ? "edge" : "face";
  const std::string article = mesh.dimension == 2 ? "an " : "a ";
  SideFaces result;
  result.ofSide.resize(mesh.sideNames.size());
  result.isInside.resize(mesh.sideNames.size(), false);
  std::vector<bool> hasSide(buckets.Count(), false);
  const int corners = mesh.CornersOfFace();
  for (int i = 0; i < mesh.FaceCount(); ++i)
  {
    FaceKey key{};
    std::copy_n(
      mesh.faces.begin() + static_cast<std::ptrdiff_t>(i) * corners, corners, key.begin());
    key = KeyOfFace(key, corners);
    const std::vector<std::size_t> found = buckets.Find(key);
    const std::size_t side = Index(mesh.side[Index(i)]);
    if (found.empty() || hasSide[found[0]])
    {
      throw Error("Side '" + mesh.sideNames[side] + "' has " + article + kind + " at " +
        PlaceOf(mesh, key[0]) +
        (found.empty() ? " that belongs to no cell" : " that is given twice") +
        "; give the boundary of this mesh.");
    }
    for (const std::size_t face : found)
    {
      hasSide[face] = true;
    }
    result.isInside[side] = result.isInside[side] || found.size() > 1;
    result.ofSide[side].push_back(buckets.FaceOf(found[0]));
  }
  for (std::size_t i = 0; i < buckets.Count(); ++i)
  {
    const FaceKey corner = buckets.KeyOf(i);
    const bool isLine = mesh.dimension == 3 && corner[1] == corner[3];
    if (!hasSide[i] && !isLine &&
      buckets.Find(corner).size() == 1) // a prism has a face that is a line
    {
      throw Error("The " + kind + " of the boundary at " + PlaceOf(mesh, corner[0]) +
        " belongs to no side; give all edges of the boundary.");
    }
  }
  return result;
}

void RequireNoInnerSides(const ExportMesh& mesh, const SideFaces& faces, const std::string& format)
{
  for (std::size_t side = 0; side < faces.isInside.size(); ++side)
  {
    if (faces.isInside[side])
    {
      throw Error("The format " + format + " has sides on the boundary only, and '" +
        mesh.sideNames[side] + "' is inside; leave it out, or write a .msh or .vtu file.");
    }
  }
}
}
