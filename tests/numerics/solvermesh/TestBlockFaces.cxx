// Connections and patches of blocks: every face once, transformations map points onto points.

#include "BlockFaces.h"

#include "BlockChecks.h"
#include "Error.h"
#include "MeshBlocks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace crossfield::test
{
namespace
{
using Corners = std::vector<int>; // points of a face in ascending order

/// Calls `use` with the indices of every point of a range, from `begin` to `end`, and the steps from `begin`.
template <typename Use>
void ForEachPoint(const BlockRange& range, const Use& use)
{
  std::array<int, 3> step{};
  std::array<int, 3> steps{};
  for (std::size_t d = 0; d < 3; ++d)
  {
    steps[d] = std::abs(range.end[d] - range.begin[d]);
  }
  for (step[2] = 0; step[2] <= steps[2]; ++step[2])
  {
    for (step[1] = 0; step[1] <= steps[1]; ++step[1])
    {
      for (step[0] = 0; step[0] <= steps[0]; ++step[0])
      {
        std::array<int, 3> index = range.begin;
        for (std::size_t d = 0; d < 3; ++d)
        {
          index[d] += range.end[d] < range.begin[d] ? -step[d] : step[d];
        }
        use(index, step);
      }
    }
  }
}

/// Adds the faces of a range to the counts.
void CountFaces(const SolverMesh& mesh, BlockRange range, std::map<Corners, int>& counts)
{
  for (std::size_t d = 0; d < 3; ++d)
  {
    if (range.begin[d] > range.end[d])
    {
      std::swap(range.begin[d], range.end[d]);
    }
  }
  const MeshBlock& block = mesh.blocks[Index(range.block)];
  ForEachPoint(range,
    [&](const std::array<int, 3>& index, const std::array<int, 3>&)
    {
      Corners corners;
      std::array<int, 3> at{};
      for (int corner = 0; corner < 8; ++corner)
      {
        bool isFace = true;
        bool isFirst = true;
        for (std::size_t d = 0; d < 3; ++d)
        {
          const int step = (corner >> d) & 1;
          const bool isAlong = range.begin[d] != range.end[d];
          isFirst = isFirst && (isAlong || step == 0);
          isFace = isFace && (!isAlong || index[d] < range.end[d]);
          at[d] = index[d] + step;
        }
        if (!isFace)
        {
          return;
        }
        if (isFirst)
        {
          corners.push_back(block.nodes[block.PlaceOf(at)]);
        }
      }
      std::sort(corners.begin(), corners.end());
      ++counts[corners];
    });
}

/// Expects that the transformation maps the points of the first range onto those of the second and is a rotation.
void ExpectConnection(const SolverMesh& mesh, const BlockConnection& connection)
{
  const MeshBlock& from = mesh.blocks[Index(connection.from.block)];
  const MeshBlock& to = mesh.blocks[Index(connection.to.block)];
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  for (std::size_t d = 0; d < 3; ++d)
  {
    const int image = connection.transform[d];
    if (d < static_cast<std::size_t>(mesh.dimension))
    {
      ASSERT_TRUE(image != 0 && std::abs(image) <= mesh.dimension);
      matrix(std::abs(image) - 1, static_cast<int>(d)) = image > 0 ? 1.0 : -1.0;
    }
    else
    {
      EXPECT_EQ(image, 0);
      matrix(2, 2) = 1.0;
    }
  }
  EXPECT_EQ(matrix.determinant(), 1.0) << "both blocks are right-handed";
  const auto map = [&](std::array<int, 3> index)
  {
    std::array<int, 3> image = connection.to.begin;
    for (std::size_t d = 0; d < static_cast<std::size_t>(mesh.dimension); ++d)
    {
      const int t = connection.transform[d];
      image[Index(std::abs(t) - 1)] += (t > 0 ? 1 : -1) * (index[d] - connection.from.begin[d]);
    }
    return image;
  };
  ForEachPoint(connection.from,
    [&](const std::array<int, 3>& index, const std::array<int, 3>&)
    { EXPECT_EQ(from.nodes[from.PlaceOf(index)], to.nodes[to.PlaceOf(map(index))]); });
  EXPECT_EQ(map(connection.from.end), connection.to.end);
  // One step out of the first block is one step into the second.
  const auto across = Index(connection.from.face / 2);
  std::array<int, 3> outside = connection.from.begin;
  outside[across] += connection.from.face % 2 == 0 ? -1 : 1;
  const std::array<int, 3> inside = map(outside);
  for (std::size_t d = 0; d < 3; ++d)
  {
    EXPECT_GE(inside[d], 0);
    EXPECT_LE(inside[d], to.cells[d]);
  }
}

void ExpectPartition(const SolverMesh& mesh)
{
  const BlockFaces faces = FindBlockFaces(mesh, MeshFaces(mesh));
  std::map<Corners, int> inner;
  for (const BlockConnection& connection : faces.connections)
  {
    ExpectConnection(mesh, connection);
    std::map<Corners, int> both;
    CountFaces(mesh, connection.from, inner);
    CountFaces(mesh, connection.from, both);
    CountFaces(mesh, connection.to, both);
    for (const auto& [corners, count] : both)
    {
      EXPECT_EQ(count, 2);
    }
  }
  std::map<Corners, int> boundary;
  for (const BlockPatch& patch : faces.patches)
  {
    std::map<Corners, int> ofPatch;
    CountFaces(mesh, patch.range, ofPatch);
    for (const auto& [corners, count] : ofPatch)
    {
      EXPECT_EQ(count, 1);
      EXPECT_TRUE(boundary.emplace(corners, patch.side).second) << "a face is in one patch";
    }
  }
  std::map<Corners, int> expected;
  const int corners = mesh.CornersOfFace();
  for (int face = 0; face < mesh.FaceCount(); ++face)
  {
    Corners key(mesh.faces.begin() + face * corners, mesh.faces.begin() + (face + 1) * corners);
    std::sort(key.begin(), key.end());
    expected[key] = mesh.side[Index(face)];
  }
  EXPECT_EQ(boundary, expected);
  // Faces between blocks: those on the sides of blocks that are not on the boundary.
  std::map<Corners, int> ofBlocks;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
  {
    for (int face = 0; face < 2 * mesh.dimension; ++face)
    {
      BlockRange whole = { static_cast<int>(b), face, {}, mesh.blocks[b].cells };
      (face % 2 == 0 ? whole.end : whole.begin)[Index(face / 2)] =
        face % 2 == 0 ? 0 : mesh.blocks[b].cells[Index(face / 2)];
      CountFaces(mesh, whole, ofBlocks);
    }
  }
  for (const auto& [key, count] : ofBlocks)
  {
    const std::size_t different = std::set<int>(key.begin(), key.end()).size();
    if (different > static_cast<std::size_t>(mesh.dimension - 1) && expected.count(key) == 0)
    {
      EXPECT_EQ(count, 2);
      EXPECT_EQ(inner.count(key), 1U) << "an inner face is in a connection";
      inner.erase(key);
    }
  }
  EXPECT_TRUE(inner.empty());
}
}

TEST(BlockFaces, RandomBlocksAreConnectedWherePointsCoincide)
{
  for (std::uint32_t seed = 1; seed <= 40; ++seed)
  {
    ExpectPartition(RandomBlocks(2, seed));
    ExpectPartition(RandomBlocks(3, seed));
  }
}

TEST(BlockFaces, AGridOfBlocksHasOneConnectionForEachPairOfNeighbours)
{
  const SolverMesh mesh = BlockGrid({ 3, 2, 2 }, { 2, 3, 4 }, 3);
  const BlockFaces faces = FindBlockFaces(mesh, MeshFaces(mesh));
  EXPECT_EQ(faces.connections.size(), 2U * 2 * 2 + 3U * 1 * 2 + 3U * 2 * 1);
  EXPECT_EQ(faces.patches.size(), 2U * (2 * 2 + 3 * 2 + 3 * 2));
  EXPECT_TRUE(faces.collapsed.empty());
}

TEST(BlockFaces, ARingIsConnectedToItself)
{
  for (const int layers : { 0, 3 })
  {
    const SolverMesh mesh = Ring(12, 4, layers);
    ExpectPartition(mesh);
    const BlockFaces faces = FindBlockFaces(mesh, MeshFaces(mesh));
    ASSERT_EQ(faces.connections.size(), 1U);
    EXPECT_EQ(faces.connections[0].from.face, 0);
    EXPECT_EQ(faces.connections[0].to.face, 1);
    EXPECT_EQ(faces.connections[0].transform, (std::array<int, 3>{ 1, 2, layers == 0 ? 0 : 3 }));
  }
}

TEST(BlockFaces, ASideThatIsFoldedOntoItselfIsConnectedInHalves)
{
  // A C-grid: a row of quads around a slit, whose sides are the first and the last edges of row 0.
  const SolverMesh mesh = CGrid(5, 8, 3);
  ExpectPartition(mesh);
  const BlockFaces faces = FindBlockFaces(mesh, MeshFaces(mesh));
  ASSERT_EQ(faces.connections.size(), 1U);
  const BlockConnection& wake = faces.connections[0];
  EXPECT_EQ(wake.from.end[0] - wake.from.begin[0], 5);
  EXPECT_EQ(wake.to.begin[0], 18);
  EXPECT_EQ(wake.to.end[0], 13);
  EXPECT_EQ(wake.transform, (std::array<int, 3>{ -1, -2, 0 }));
}

TEST(BlockFaces, SidesOfPrismsOnAnAxisCollapse)
{
  for (const double angle : { 90.0, 360.0 })
  {
    const SolverMesh mesh = Revolved(angle);
    ExpectPartition(mesh);
    const BlockFaces faces = FindBlockFaces(mesh, MeshFaces(mesh));
    ASSERT_EQ(faces.collapsed.size(), 2U) << "two blocks touch the axis";
    for (const BlockRange& range : faces.collapsed)
    {
      EXPECT_EQ(range.face, 2);
    }
  }
}

TEST(BlockFaces, APieceOfASideIsAPatch)
{
  SolverMesh mesh = BlockGrid({ 1, 1, 0 }, { 6, 2, 0 }, 1);
  mesh.sideNames.emplace_back("inlet");
  const auto inlet = static_cast<int>(mesh.sideNames.size()) - 1;
  for (int face = 0; face < mesh.FaceCount(); ++face)
  {
    const auto x = [&](int end)
    { return mesh.points[Index(mesh.faces[Index(2 * face + end)])].x(); };
    if (mesh.side[Index(face)] == 0 && std::abs(0.5 * (x(0) + x(1)) - 1.0) < 0.3)
    {
      mesh.side[Index(face)] = inlet; // the middle two of six edges
    }
  }
  ExpectPartition(mesh);
  EXPECT_EQ(FindBlockFaces(mesh, MeshFaces(mesh)).patches.size(), 6U);
}

TEST(BlockFaces, LeftHandedBlocksAreTurned)
{
  SolverMesh mesh = BlockGrid({ 2, 2, 1 }, { 2, 3, 2 }, 9);
  for (Eigen::Vector3d& point : mesh.points)
  {
    point.x() = -point.x();
  }
  OrientBlocks(mesh);
  RequireBlocks(mesh, ".xyz");
  ExpectPartition(mesh);
  for (const MeshBlock& block : mesh.blocks)
  {
    const auto at = [&](int i, int j, int k) {
      return mesh.points[Index(block.NodeAt({ i, j, k }))];
    };
    EXPECT_GT(
      (at(1, 0, 0) - at(0, 0, 0)).cross(at(0, 1, 0) - at(0, 0, 0)).dot(at(0, 0, 1) - at(0, 0, 0)),
      0.0);
  }
}

TEST(BlockFaces, DamagedBlocksAreRefused)
{
  const SolverMesh mesh = BlockGrid({ 2, 1, 0 }, { 2, 2, 0 }, 1);
  const auto refuse = [](SolverMesh damaged, const char* words)
  {
    const auto find = [&]
    {
      RequireBlocks(damaged, ".xyz");
      FindBlockFaces(damaged, MeshFaces(damaged));
    };
    EXPECT_TRUE(Refuses(find, { words }));
  };
  SolverMesh damaged = mesh;
  damaged.blocks.clear();
  refuse(damaged, "no arrays BlockId");
  damaged = mesh;
  damaged.blocks.pop_back();
  refuse(damaged, "damaged");
  damaged = mesh;
  damaged.blocks[0].nodes[3] = 99;
  refuse(damaged, "damaged");
  damaged = mesh;
  damaged.blocks[0].cells = { 1 << 30, 1 << 30, 0 };
  refuse(damaged, "damaged");
  damaged = mesh;
  damaged.blocks[1] = damaged.blocks[0];
  refuse(damaged, "damaged");
  damaged = mesh;
  damaged.faces.resize(damaged.faces.size() - 2);
  damaged.side.pop_back();
  refuse(damaged, "belongs to no side");
}
}
