#include "BlockLattice.h"

#include "Error.h"
#include "Index.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace crossfield
{
namespace
{
/// Returns twice the area or six times the volume of the cells, up to a positive factor.
double SignedSize(const ExportMesh& mesh, const ExportBlock& block)
{
  double size = 0.0;
  const bool isFlat = mesh.dimension == 2;
  std::array<int, 3> at{};
  for (at[2] = 0; at[2] < (isFlat ? 1 : block.cells[2]); ++at[2])
  {
    for (at[1] = 0; at[1] < block.cells[1]; ++at[1])
    {
      for (at[0] = 0; at[0] < block.cells[0]; ++at[0])
      {
        const auto corner = [&](int i, int j, int k) -> const Eigen::Vector3d&
        {
          const std::array<int, 3> index = { at[0] + i, at[1] + j, at[2] + k };
          return mesh.points[Index(block.nodes[BlockPoint(block, index)])];
        };
        const Eigen::Vector3d normal =
          (corner(1, 1, 0) - corner(0, 0, 0)).cross(corner(0, 1, 0) - corner(1, 0, 0));
        size += isFlat
          ? normal.z()
          : normal.dot(corner(0, 0, 1) + corner(1, 1, 1) - corner(0, 0, 0) - corner(1, 1, 0));
      }
    }
  }
  return size;
}

void Transpose(ExportBlock& block)
{
  ExportBlock turned = block;
  std::swap(turned.cells[0], turned.cells[1]);
  std::array<int, 3> at{};
  for (at[2] = 0; at[2] <= block.cells[2]; ++at[2])
  {
    for (at[1] = 0; at[1] <= block.cells[1]; ++at[1])
    {
      for (at[0] = 0; at[0] <= block.cells[0]; ++at[0])
      {
        turned.nodes[BlockPoint(turned, { at[1], at[0], at[2] })] =
          block.nodes[BlockPoint(block, at)];
      }
    }
  }
  block = std::move(turned);
}
}

std::size_t BlockPoint(const ExportBlock& block, const std::array<int, 3>& index)
{
  return Index(index[0]) +
    Index(block.cells[0] + 1) * (Index(index[1]) + Index(block.cells[1] + 1) * Index(index[2]));
}

void RequireBlocks(const ExportMesh& mesh, const std::string& format)
{
  if (mesh.blocks.empty())
  {
    throw Error("The format " + format +
      " has structured blocks only, and the cells of this mesh have no arrays BlockId, I and J; give the "
      "quads of a Quad Mesher, or write a .msh or .vtu file.");
  }
  const auto isPoint = [&mesh](int node) { return node >= 0 && Index(node) < mesh.points.size(); };
  const double mostPoints = 8.0 * (static_cast<double>(mesh.points.size()) + mesh.CellCount());
  double cells = 0.0;
  bool isValid = true;
  for (const ExportBlock& block : mesh.blocks)
  {
    const bool isFlat = mesh.dimension == 2;
    const auto& n = block.cells;
    isValid = isValid && n[0] > 0 && n[1] > 0 && (isFlat ? n[2] == 0 : n[2] > 0);
    const double points = (n[0] + 1.0) * (n[1] + 1.0) * (n[2] + 1.0);
    isValid = isValid && points <= mostPoints &&
      block.nodes.size() == static_cast<std::size_t>(points) &&
      std::all_of(block.nodes.begin(), block.nodes.end(), isPoint);
    cells += static_cast<double>(n[0]) * n[1] * (isFlat ? 1 : n[2]);
  }
  if (!isValid || cells != mesh.CellCount())
  {
    throw Error(
      "The mesh is damaged: its blocks do not have the cells of the mesh; make it again.");
  }
}

void OrientBlocks(ExportMesh& mesh)
{
  if (mesh.dimension == 2 && !mesh.HasConstantHeight())
  {
    return;
  }
  for (ExportBlock& block : mesh.blocks)
  {
    if (SignedSize(mesh, block) < 0.0)
    {
      Transpose(block);
    }
  }
}
}
