// Periodic sides of meshes: nodes that match, their links in .msh, refusals.

#include "SidePairs.h"

#include "MeshFormats.h"
#include "formats/FormatChecks.h"

#include <Eigen/Geometry>

#include <cmath>
#include <iterator>
#include <map>
#include <sstream>

namespace crossfield::test
{
namespace
{
/// A sector of a ring whose sides bottom and top are images of each other under a rotation.
LatticeMesh Sector(int dimension, int order, double angle, std::uint32_t seed)
{
  LatticeMesh lattice(dimension, order, 3, 4, seed);
  const Eigen::Vector2d centre(0.4, -0.7);
  for (std::size_t i = 0; i < lattice.Places.size(); ++i)
  {
    const Eigen::Vector3i& p = lattice.Places[i];
    const double radius = 1.0 + 0.2 * p.x() / order + 0.01 * p.x() * p.x();
    const double at = 0.3 + angle * p.y() / (4.0 * order);
    lattice.Mesh.points[i].head<2>() =
      centre + radius * Eigen::Vector2d(std::cos(at), std::sin(at));
  }
  SidePair pair;
  pair.first = 0;
  pair.second = 2;
  const Eigen::Vector3d origin(centre.x(), centre.y(), 0.0);
  pair.motion = (Eigen::Translation3d(origin) * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) *
    Eigen::Translation3d(-origin))
                  .matrix();
  lattice.Mesh.pairs = { pair };
  return lattice;
}

/// Expects that pairs join the bottom to the top of each column of nodes, each once.
void ExpectColumns(const LatticeMesh& lattice, const std::map<int, int>& nodes)
{
  const int order = lattice.Mesh.order;
  const int across = lattice.Mesh.dimension == 2 ? 1 : order + 1;
  EXPECT_EQ(nodes.size(), Index((3 * order + 1) * across));
  for (const auto& [from, to] : nodes)
  {
    EXPECT_EQ(
      lattice.Places[Index(to)] - lattice.Places[Index(from)], Eigen::Vector3i(0, 4 * order, 0));
  }
}

std::string MessageOf(const SolverMesh& mesh)
{
  try
  {
    Written(mesh, "a.msh");
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "no error";
}
}

TEST(SidePairs, MatchAcrossASectorInMemoryAndInMsh)
{
  std::uint32_t seed = 70;
  for (const auto& [dimension, order] :
    { std::pair{ 2, 1 }, { 2, 2 }, { 2, 3 }, { 3, 1 }, { 3, 2 } })
  {
    const LatticeMesh lattice = Sector(dimension, order, 0.9, ++seed);
    ExpectColumns(
      lattice, MatchPair(lattice.Mesh, MeshFaces(lattice.Mesh), lattice.Mesh.pairs[0]).nodes);
    for (const MshVersion version : { MshVersion::V22, MshVersion::V41 })
    {
      std::istringstream file(Written(lattice.Mesh, "a.msh", version));
      std::string word;
      while (file >> word && word != "$Periodic")
      {
      }
      int links = 0;
      int entityDimension = 0;
      int image = 0;
      int master = 0;
      ASSERT_TRUE(file >> links >> entityDimension >> image >> master >> word);
      EXPECT_EQ(links, 1);
      EXPECT_EQ(entityDimension, dimension - 1);
      EXPECT_EQ(image, 3) << "top";
      EXPECT_EQ(master, 1) << "bottom";
      EXPECT_EQ(word, version == MshVersion::V22 ? "Affine" : "16");
      for (int i = 0; i < 16; ++i)
      {
        double entry = 0.0;
        file >> entry;
        EXPECT_EQ(entry, lattice.Mesh.pairs[0].motion(i / 4, i % 4));
      }
      std::map<int, int> nodes;
      int count = 0;
      file >> count;
      for (int i = 0; i < count; ++i)
      {
        file >> image >> master;
        nodes[master - 1] = image - 1; // the cells use all points
      }
      ExpectColumns(lattice, nodes);
      EXPECT_TRUE(file >> word && word == "$EndPeriodic");
    }
  }
}

TEST(SidePairs, RefuseSidesThatDoNotMatch)
{
  LatticeMesh lattice = Sector(2, 1, 0.9, 5);
  EXPECT_EQ(MessageOf(lattice.Mesh), "no error");
  SolverMesh other = lattice.Mesh;
  other.pairs[0].second = 1;
  EXPECT_NE(
    MessageOf(other).find("'bottom' and 'right side' have 4 and 5 nodes"), std::string::npos)
    << MessageOf(other);
  other = lattice.Mesh;
  const int moved =
    std::next(MatchPair(other, MeshFaces(other), other.pairs[0]).nodes.begin())->second;
  other.points[Index(moved)].x() += 1e-7;
  EXPECT_NE(MessageOf(other).find("and 3 of them match"), std::string::npos) << MessageOf(other);
  other = lattice.Mesh;
  other.pairs[0].second = 0;
  EXPECT_NE(MessageOf(other).find("damaged"), std::string::npos) << MessageOf(other);
}
}
