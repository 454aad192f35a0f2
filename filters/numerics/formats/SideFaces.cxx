#include "SideFaces.h"

#include "Error.h"
#include "Index.h"
#include "MeshText.h"

namespace crossfield
{
namespace
{
SideFaces FindIn(
  const ExportMesh& mesh, const FaceBuckets& buckets, const std::vector<int>& partners)
{
  const std::string kind = mesh.dimension == 2 ? "edge" : "face";
  const std::string article = mesh.dimension == 2 ? "an " : "a ";
  SideFaces result;
  result.ofSide.resize(mesh.sideNames.size());
  result.isInside.resize(mesh.sideNames.size(), false);
  std::vector<bool> hasSide(buckets.Count(), false);
  const std::size_t corners = Index(mesh.CornersOfFace());
  for (int i = 0; i < mesh.FaceCount(); ++i)
  {
    const FaceBuckets::Key key =
      FaceBuckets::MakeKey(mesh.faces.data() + Index(i) * corners, corners);
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
    if (!hasSide[i] && partners[i] == FaceBuckets::Alone)
    {
      throw Error("The " + kind + " of the boundary at " + PlaceOf(mesh, buckets.KeyOf(i)[0]) +
        " belongs to no side; give all edges of the boundary.");
    }
  }
  return result;
}
}

SideFaces FindSideFaces(const ExportMesh& mesh)
{
  return MeshFaces(mesh).sides;
}

MeshFaces::MeshFaces(const ExportMesh& mesh)
  : buckets(mesh)
  , partners(this->buckets.FindPartners())
  , sides(FindIn(mesh, this->buckets, this->partners))
{
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
