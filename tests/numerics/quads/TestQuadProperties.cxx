#include "QuadMesher.h"

#include "BoundarySymmetry.h"
#include "DomainQueries.h"
#include "Layouts.h"
#include "MakePlanarDomain.h"
#include "MeshForPoints.h"
#include "SeamlessMapSolve.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>

namespace crossfield::test
{
namespace
{
struct RandomCase
{
  std::string name;
  PlanarDomain domain;
  Configuration configuration;
};

/// Returns singularities at random positions with a minimum distance from each other and the
/// boundary. `sum` is the sum of their indices.
Configuration Scatter(Random& random, const PlanarDomain& domain, int pairs, int sum, double apart)
{
  Configuration configuration;
  int positive = pairs + std::max(0, sum);
  int negative = pairs + std::max(0, -sum);
  while (positive + negative > 0)
  {
    const Point place(random.Uniform(-2.0, 6.0), random.Uniform(-2.0, 4.0));
    bool free = SignedDistance(place, domain) > apart;
    for (const Singularity& other : configuration)
    {
      free = free && (other.position - place).norm() > apart;
    }
    if (free)
    {
      configuration.push_back({ place, positive > 0 ? 1 : -1 });
      --(positive > 0 ? positive : negative);
    }
    apart *= 0.9999; // terminates even if the first distance is too large
  }
  return configuration;
}

/// Returns adjacent columns of random heights: corners of index +1 and −1 that add up to 4.
PlanarDomain RandomColumns(Random& random)
{
  Loop loop = { { 0.0, 0.0 } };
  const int columns = random.Integer(1, 4);
  loop.emplace_back(columns, 0.0);
  for (int c = columns, last = 0; c-- > 0;)
  {
    int height = random.Integer(1, 3);
    height += height == last ? 1 : 0;
    loop.emplace_back(c + 1.0, height);
    loop.emplace_back(c, height);
    last = height;
  }
  return MakePlanarDomain({ loop });
}

/// Returns a ring with fourfold symmetry and symmetric singularities, so that the holonomy defect
/// is zero.
RandomCase SymmetricRing(Random& random)
{
  const double wave = random.Uniform(-0.1, 0.1);
  const double inner = random.Uniform(0.25, 0.45);
  Loop loop;
  constexpr int Count = 128;
  for (int i = 0; i < Count; ++i)
  {
    const double angle = 2.0 * Pi * i / Count;
    loop.push_back((1.0 + wave * std::cos(4.0 * angle)) * Point(std::cos(angle), std::sin(angle)));
  }
  RandomCase result{ "ring", MakePlanarDomain({ loop, RegularPolygon(48, inner) }), {} };
  if (random.Integer(0, 2) > 0)
  {
    const bool turned = random.Integer(0, 1) == 1;
    const double first = turned ? Pi / 4.0 : 0.0;
    result.configuration = Join(OnCircle(4, inner + 0.75 * (0.9 - inner), first, 1, 0.0),
      OnCircle(4, inner + 0.35 * (0.9 - inner), first, -1, 0.0));
  }
  return result;
}

RandomCase MakeRandomCase(int number)
{
  Random random(static_cast<std::uint32_t>(16000 + number));
  switch (number % 4)
  {
  case 0:
  {
    const PlanarDomain domain = RandomSmoothDomain(random);
    return { "smooth", domain, Scatter(random, domain, random.Integer(0, 3), 4, 0.2) };
  }
  case 1:
  {
    const PlanarDomain domain = RandomColumns(random);
    return { "columns", domain, Scatter(random, domain, random.Integer(0, 2), 0, 0.25) };
  }
  case 2:
    return SymmetricRing(random);
  default:
  {
    // Up to thirty singularities.
    const PlanarDomain domain = RandomSmoothDomain(random);
    return { "many", domain, Scatter(random, domain, random.Integer(4, 13), 4, 0.12) };
  }
  }
}

SeamlessMap MapOf(const RandomCase& random)
{
  const double meshSize = 0.05 * std::sqrt(random.domain.Area() / Pi);
  return SolveSeamlessMap(
    ShareTopology(MeshThroughPoints(random.domain, random.configuration, meshSize)),
    random.configuration);
}

/// Returns whether all distances between cones, and from singularities to the boundary, are larger
/// than 2 h.
bool FarApart(const SeamlessMap& map, double size)
{
  const SharedPlanarTopology topology = RequirePlanar(map.topology);
  for (std::size_t i = 0; i < map.cones.size(); ++i)
  {
    const Point& place = topology->PointAt(map.cones[i].vertex);
    for (std::size_t j = 0; j < i; ++j)
    {
      if ((topology->PointAt(map.cones[j].vertex) - place).norm() <= 2.0 * size)
      {
        return false;
      }
    }
    for (const Loop& loop : topology->AlignedLoops())
    {
      if (!map.cones[i].onBoundary && DistanceToLoop(place, loop) <= 2.0 * size)
      {
        return false;
      }
    }
  }
  return true;
}

void ExpectConforming(const QuadResult& result, const SeamlessMap& map, double size)
{
  const QuadMesh& mesh = result.mesh;
  // Throws unless the mesh is conforming and manifold, and no quad has a point twice.
  EXPECT_EQ(
    mesh.EulerCharacteristic(), map.topology->edges.EulerCharacteristic(map.topology->mesh));
  std::vector<int> valences(mesh.points.size(), 0);
  for (const std::array<int, 4>& quad : mesh.quads)
  {
    EXPECT_EQ(std::set<int>(quad.begin(), quad.end()).size(), 4U);
    for (const int point : quad)
    {
      ++valences[static_cast<std::size_t>(point)];
    }
  }
  std::map<int, int> requested;
  std::map<int, int> obtained;
  for (const Cone& cone : map.cones)
  {
    ++requested[cone.onBoundary ? 100 + cone.quarterIndex : cone.quarterIndex];
  }
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    const bool inside = mesh.points[p].curve.loop < 0;
    const int index = (inside ? 4 : 2) - valences[p];
    if (index != 0)
    {
      ++obtained[inside ? index : 100 + index];
    }
  }
  EXPECT_EQ(obtained, requested);
  if (FarApart(map, size))
  {
    EXPECT_EQ(result.quality.inverted, 0)
      << result.quality.jacobian.min << " at " << DescribePlace(result.quality.where);
  }
  // Every side of a block is a full side of another block, or on the boundary.
  std::size_t boundary = 0;
  std::size_t edges = 0;
  for (std::size_t b = 0; b < result.blocks.blocks.size(); ++b)
  {
    const QuadBlock& block = result.blocks.blocks[b];
    for (std::size_t side = 0; side < 4; ++side)
    {
      const BlockNeighbour& neighbour = block.neighbours[side];
      std::vector<int> points = PointsAlong(block, side);
      edges += points.size() - 1;
      if (neighbour.block < 0)
      {
        boundary += points.size() - 1;
        for (const int point : points)
        {
          EXPECT_GE(mesh.points[static_cast<std::size_t>(point)].curve.loop, 0);
        }
        continue;
      }
      const QuadBlock& other = result.blocks.blocks[static_cast<std::size_t>(neighbour.block)];
      if (neighbour.orientation < 0)
      {
        std::reverse(points.begin(), points.end());
      }
      EXPECT_EQ(points, PointsAlong(other, static_cast<std::size_t>(neighbour.side)));
      const BlockNeighbour& back = other.neighbours[static_cast<std::size_t>(neighbour.side)];
      EXPECT_EQ(back.block, static_cast<int>(b));
      EXPECT_EQ(back.side, static_cast<int>(side));
      EXPECT_EQ(back.orientation, neighbour.orientation);
    }
  }
  EXPECT_EQ(boundary, mesh.boundary.size());
  // The layout has each boundary edge once, and each edge between blocks once.
  std::size_t drawn = 0;
  for (const std::vector<int>& side : SidesOf(result.blocks.blocks))
  {
    drawn += side.size() - 1;
  }
  EXPECT_EQ(2 * drawn, edges + boundary);
}

/// Five meshes for each random domain. CROSSFIELD_QUAD_CASES sets the number of domains,
/// CROSSFIELD_QUAD_FIRST the first one.
TEST(QuadProperties, HoldOnRandomDomains)
{
  const char* requested = std::getenv("CROSSFIELD_QUAD_CASES");
  const int cases = requested == nullptr ? 12 : std::atoi(requested);
  const char* from = std::getenv("CROSSFIELD_QUAD_FIRST");
  const bool print = requested != nullptr;
  int meshes = 0;
  int far = 0;
  for (int number = from == nullptr ? 0 : std::atoi(from); number < cases; ++number)
  {
    const RandomCase random = MakeRandomCase(number);
    const SeamlessMap map = MapOf(random);
    for (const double defect : map.holonomyDefect)
    {
      EXPECT_LT(std::abs(defect), 1e-3) << number; // not exactly 0, as the mesh is not symmetric
    }
    const double extent = std::sqrt(random.domain.Area() / Pi);
    for (const double part : { 0.04, 0.09, 0.2, 0.45, 1.0 })
    {
      SCOPED_TRACE(random.name + " " + std::to_string(number) + " " + std::to_string(part));
      try
      {
        QuadOptions options;
        options.quadSize = part * extent;
        const QuadResult result = MakeQuads(LayoutOf(map), options);
        ExpectConforming(result, map, options.quadSize);
        ++meshes;
        far += FarApart(map, options.quadSize) ? 1 : 0;
        if (print)
        {
          std::printf(
            "%d %s %zu at %.2f: %zu quads %zu blocks %.3f (%d inverted) far %d zero %d nodes %d gap %.3f "
            "released %d moved %.2g s %.3f %.3f\n",
            number, random.name.c_str(), random.configuration.size(), part,
            result.mesh.quads.size(), result.blocks.blocks.size(), result.quality.jacobian.min,
            result.quality.inverted, FarApart(map, options.quadSize), result.counts.ZeroArcs(),
            result.counts.nodes, result.counts.Gap(), result.smoothing.released,
            result.smoothing.moved / options.quadSize, result.counts.seconds, result.smoothSeconds);
        }
      }
      catch (const Error& error)
      {
        ADD_FAILURE() << error.what();
      }
    }
  }
  EXPECT_GE(far, meshes / 4); // mostly fine meshes
}

/// Returns the maximum distance of images of points under an isometry from the nearest points.
double Asymmetry(const QuadMesh& mesh, const Isometry& isometry)
{
  double worst = 0.0;
  for (const QuadPoint& point : mesh.points)
  {
    const Point image = isometry(point.InPlane());
    double nearest = std::numeric_limits<double>::infinity();
    for (const QuadPoint& other : mesh.points)
    {
      nearest = std::min(nearest, (other.InPlane() - image).norm());
    }
    worst = std::max(worst, nearest);
  }
  return worst;
}

TEST(QuadProperties, AreAsSymmetricAsDomainAndConfiguration)
{
  const PlanarDomain disk = MakePlanarDomain({ RegularPolygon(96) });
  const PlanarDomain plate = MakePlanarDomain(
    { { { -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 } }, RegularPolygon(48, 0.3) });
  const std::vector<RandomCase> cases = {
    { "four", disk, OnCircle(4, 0.6, Pi / 4.0, 1, 0.0) },
    { "plate", plate, OnCircle(4, 0.55, Pi / 4.0, -1, 0.0) },
    { "six", disk,
      Join(OnCircle(6, 0.7, 0.0, 1, 0.0), { { { 0.2, 0.0 }, -1 }, { { -0.2, 0.0 }, -1 } }) },
  };
  for (const RandomCase& symmetric : cases)
  {
    const SeamlessMap map = MapOf(symmetric);
    for (const Sizing sizing : { Sizing::Conformal, Sizing::Uniform })
    {
      QuadOptions options;
      options.quadSize = 0.2;
      options.sizes.sizing = sizing;
      const QuadResult result = MakeQuads(LayoutOf(map), options);
      EXPECT_GE(result.smoothing.symmetries, 4);
      const double extent = symmetric.domain.Diagonal();
      for (const Isometry& isometry :
        { Isometry{ Point::Zero(), 0.0, true }, Isometry{ Point::Zero(), Pi, false } })
      {
        EXPECT_LT(Asymmetry(result.mesh, isometry), 1e-9 * extent) << symmetric.name;
      }
      // A turn by 0.3 is not a symmetry.
      EXPECT_GT(Asymmetry(result.mesh, { Point::Zero(), 0.3, false }), 1e-3 * extent);
    }
  }
}
}
}
