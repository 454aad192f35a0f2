#include "WriteFoam.h"

#include "Error.h"
#include "FoamMesh.h"
#include "FoamText.h"
#include "Index.h"
#include "SweepQuads.h"
#include "WriteBlockMesh.h"

#include <Eigen/Geometry>

#include <cmath>

namespace crossfield
{
namespace
{
const char* const MeshFolder = "constant/polyMesh";

std::string WritePoints(const SolverMesh& mesh, const FoamMesh& foam)
{
  constexpr std::size_t BytesOfPoint = 48;
  MeshText text;
  text.Reserve(foam.point.size() * BytesOfPoint);
  AddFoamHeader(text, "vectorField", MeshFolder, "points");
  text.Add(static_cast<int>(foam.point.size())).Add("\n(\n");
  for (const int point : foam.point)
  {
    text.Add('(').Add(mesh.points[point]).Add(")\n");
  }
  return text.Add(")\n").Take();
}

std::string WriteFaces(const FoamMesh& foam)
{
  constexpr std::size_t BytesOfCorner = 9;
  MeshText text;
  text.Reserve(foam.corners.size() * BytesOfCorner);
  AddFoamHeader(text, "faceList", MeshFolder, "faces");
  text.Add(static_cast<int>(foam.owner.size())).Add("\n(\n");
  for (std::size_t face = 0; face < foam.owner.size(); ++face)
  {
    const auto first = Index(foam.starts[face]);
    const auto end = Index(foam.starts[face + 1]);
    text.Add(static_cast<int>(end - first)).Add('(');
    for (std::size_t i = first; i < end; ++i)
    {
      text.Add(foam.corners[i]).Add(i + 1 == end ? ")\n" : " ");
    }
  }
  return text.Add(")\n").Take();
}

void AddLabels(MeshText& text, const std::vector<int>& labels)
{
  text.Add(static_cast<int>(labels.size())).Add("\n(\n");
  for (const int label : labels)
  {
    text.Add(label).Add('\n');
  }
  text.Add(")\n");
}

std::string WriteLabels(
  const std::vector<int>& labels, const std::string& object, const std::string& note)
{
  constexpr std::size_t BytesOfLabel = 9;
  MeshText text;
  text.Reserve(labels.size() * BytesOfLabel);
  AddFoamHeader(text, "labelList", MeshFolder, object, note);
  AddLabels(text, labels);
  return text.Take();
}

std::string WriteBoundary(const std::vector<FoamPatch>& patches)
{
  MeshText text;
  AddFoamHeader(text, "polyBoundaryMesh", MeshFolder, "boundary");
  text.Add(static_cast<int>(patches.size())).Add("\n(\n");
  for (const FoamPatch& patch : patches)
  {
    text.Add("    ").Add(patch.name).Add("\n    {\n        type ").Add(patch.type);
    if (!patch.neighbour.empty())
    {
      text.Add(";\n        neighbourPatch ").Add(patch.neighbour);
    }
    text.Add(";\n        nFaces ").Add(patch.count).Add(";\n        startFace ").Add(patch.start);
    text.Add(";\n    }\n");
  }
  return text.Add(")\n").Take();
}

/// `kind` is cell, face or point.
std::string WriteZones(const std::vector<FoamZone>& zones, const std::string& kind)
{
  MeshText text;
  AddFoamHeader(text, "regIOobject", MeshFolder, kind + "Zones");
  text.Add(static_cast<int>(zones.size())).Add("\n(\n");
  for (const FoamZone& zone : zones)
  {
    text.Add(zone.name).Add("\n{\n    type ").Add(kind).Add("Zone;\n    ");
    text.Add(kind).Add("Labels List<label>\n");
    AddLabels(text, zone.members);
    text.Add(";\n");
    if (kind == "face")
    {
      text.Add("    flipMap List<bool> ").Add(static_cast<int>(zone.members.size()));
      text.Add("{0};\n"); // all the same
    }
    text.Add("}\n");
  }
  return text.Add(")\n").Take();
}

/// Throws Error if the faces of the layer are not normal to a coordinate axis.
void RequireAxis(const SolverMesh& mesh)
{
  if (mesh.sweep.layers != 1 || mesh.sweep.isRotation)
  {
    return;
  }
  const int* corners = mesh.Cell(0); // along the height, 0 is below 4
  const Eigen::Vector3d height = mesh.points[corners[4]] - mesh.points[corners[0]];
  constexpr double Tolerance = 1e-9; // rounding of a sweep along a normal that was computed
  if (height.cwiseAbs().maxCoeff() < (1.0 - Tolerance) * height.norm())
  {
    throw Error(
      "One layer of cells is a two-dimensional case, which OpenFOAM has in planes normal to x, y or z "
      "only; rotate the domain, or extrude it in two layers.");
  }
}

std::vector<std::pair<std::string, std::string>> WriteSolid(const SolverMesh& mesh)
{
  RequireAxis(mesh);
  const std::string folder = std::string(MeshFolder) + "/";
  std::vector<std::pair<std::string, std::string>> files;
  const MeshFaces faces(mesh);
  {
    const FoamMesh foam = MakeFoamMesh(mesh, faces);
    MeshText note;
    note.Add("nPoints: ").Add(static_cast<int>(foam.point.size())).Add("  nCells: ");
    note.Add(mesh.CellCount()).Add("  nFaces: ").Add(static_cast<int>(foam.owner.size()));
    note.Add("  nInternalFaces: ").Add(static_cast<int>(foam.neighbour.size()));
    const std::string counts = note.Take();
    files.emplace_back(folder + "points", WritePoints(mesh, foam));
    files.emplace_back(folder + "faces", WriteFaces(foam));
    files.emplace_back(folder + "owner", WriteLabels(foam.owner, "owner", counts));
    files.emplace_back(folder + "neighbour", WriteLabels(foam.neighbour, "neighbour", counts));
    files.emplace_back(folder + "boundary", WriteBoundary(foam.patches));
    files.emplace_back(folder + "cellZones", WriteZones(foam.cellZones, "cell"));
    files.emplace_back(folder + "faceZones", WriteZones(foam.faceZones, "face"));
    files.emplace_back(folder + "pointZones", WriteZones({}, "point"));
  }
  const std::string dict = WriteBlockMesh(mesh, faces);
  if (!dict.empty())
  {
    files.emplace_back("system/blockMeshDict", dict);
  }
  return files;
}
}

std::string FoamFolder(const std::string& name)
{
  const std::size_t slash = name.rfind('/');
  return slash == std::string::npos ? "" : name.substr(0, slash + 1);
}

double FoamThickness(const SolverMesh& quads)
{
  Eigen::AlignedBox3d box;
  for (const int node : quads.cells)
  {
    box.extend(quads.points[node]);
  }
  // Solvers ignore the thickness; this one is not far from usual lengths of edges.
  constexpr double Part = 0.1;
  return std::pow(10.0, std::floor(std::log10(Part * box.diagonal().norm())));
}

std::vector<std::pair<std::string, std::string>> WriteFoam(const SolverMesh& mesh)
{
  if (mesh.dimension == 3)
  {
    return WriteSolid(mesh);
  }
  Sweep sweep;
  sweep.height = FoamThickness(mesh);
  return WriteSolid(SweepQuads(mesh, sweep));
}
}
