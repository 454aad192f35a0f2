// Blocks of blockMeshDict: cut where they are folded, and along chords of cells.

#include "CutBlocks.h"

#include "MeshBlocks.h"
#include "Plane.h"
#include "SweepQuads.h"
#include "formats/FormatChecks.h"

#include <cmath>
#include <set>

namespace crossfield::test
{
namespace
{

/// Ring of one block that meets itself, from radius 1 to 2.
SolverMesh Ring(int around, int across)
{
  SolverMesh mesh;
  mesh.regionNames = { "domain" };
  mesh.sideNames = { "inner", "outer" };
  std::vector<BlockPlace> places;
  for (int j = 0; j <= across; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2.0 * Pi * i / around;
      const double radius = 1.0 + static_cast<double>(j) / across;
      mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
  }
  for (int j = 0; j < across; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      const auto at = [&](int a, int b) { return (i + a) % around + around * (j + b); };
      // Rows go outwards, so that the block is right-handed.
      mesh.cells.insert(mesh.cells.end(), { at(0, 0), at(0, 1), at(1, 0), at(1, 1) });
      mesh.region.push_back(0);
      places.push_back({ 0, { j, i, 0 } });
      if (j == 0 || j + 1 == across)
      {
        const int b = j == 0 ? 0 : 1;
        mesh.faces.insert(mesh.faces.end(), { at(0, b), at(1, b) });
        mesh.side.push_back(b);
      }
    }
  }
  mesh.blocks = GatherBlocks(mesh, places);
  return mesh;
}

}

TEST(CutBlocks, RingsAreCutUntilTheirCornersAreNotFolded)
{
  const SolverMesh quads = Ring(12, 3);
  ASSERT_EQ(quads.blocks.size(), 1U);
  const SolverMesh mesh = SweepQuads(quads, {});
  const std::vector<MeshBlock> blocks = CutBlocks(mesh, MeshFaces(mesh));
  EXPECT_GE(blocks.size(), 3U);
  int cells = 0;
  for (const MeshBlock& block : blocks)
  {
    cells += block.cells[0] * block.cells[1] * block.cells[2];
    EXPECT_EQ(std::set<int>(block.nodes.begin(), block.nodes.end()).size(), block.nodes.size());
  }
  EXPECT_EQ(cells, 36);
  const std::string dict = FoamTextOf(quads, "system/blockMeshDict");
  EXPECT_NE(dict.find("polyLine"), std::string::npos);
  EXPECT_NE(dict.find("frontAndBack"), std::string::npos);
}

TEST(CutBlocks, CutsFollowChordsThroughNeighbours)
{
  // A block for each of two rows of four cells; the side changes behind the first cell of the lower one.
  SolverMesh quads = LatticeMesh(2, 1, 4, 2, 3).Mesh;
  OrientCells(quads);
  const auto order = [](const SolverMesh& mesh, int cell)
  {
    const Eigen::Vector3d& point = mesh.points[Index(mesh.Cell(cell)[0])];
    return std::array<int, 2>{ static_cast<int>(std::lround(point.x() * 3.0)),
      static_cast<int>(std::lround(point.y() * 7.0)) };
  };
  std::vector<BlockPlace> places;
  for (int cell = 0; cell < quads.CellCount(); ++cell)
  {
    // Cells were turned at random: the first corner of all must be the lower left one.
    int* nodes = quads.cells.data() + 4 * cell;
    std::sort(nodes, nodes + 4,
      [&](int a, int b)
      {
        const Eigen::Vector3d& p = quads.points[Index(a)];
        const Eigen::Vector3d& q = quads.points[Index(b)];
        return p.y() != q.y() ? p.y() < q.y() : p.x() < q.x();
      });
    const std::array<int, 2> at = order(quads, cell);
    places.push_back({ at[1], { at[0], 0, 0 } });
  }
  quads.blocks = GatherBlocks(quads, places);
  ASSERT_EQ(quads.blocks.size(), 2U);
  quads.sideNames.emplace_back("inlet");
  for (int face = 0; face < quads.FaceCount(); ++face)
  {
    const auto middle = [&](int axis)
    {
      return (quads.points[Index(quads.faces[Index(2 * face)])][axis] +
               quads.points[Index(quads.faces[Index(2 * face + 1)])][axis]) /
        2.0;
    };
    if (middle(1) < 1e-9 && middle(0) < 1.0 / 3.0)
    {
      quads.side[Index(face)] = 4;
    }
  }
  const std::string dict = FoamTextOf(quads, "system/blockMeshDict");
  std::size_t count = 0;
  for (std::size_t at = dict.find("hex ("); at != std::string::npos;
       at = dict.find("hex (", at + 1))
  {
    ++count;
  }
  EXPECT_EQ(count, 4U) << dict; // both rows are cut behind the first column
  EXPECT_NE(dict.find("(1 1 1) simpleGrading (1 1 1)"), std::string::npos) << dict;
  EXPECT_NE(dict.find("(3 1 1) simpleGrading (1 1 1)"), std::string::npos) << dict;
  EXPECT_EQ(dict.find("polyLine"), std::string::npos) << "all edges are straight";
}
}
