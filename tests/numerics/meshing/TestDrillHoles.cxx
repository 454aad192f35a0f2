#include "DrillHoles.h"
#include "HoleRadii.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace crossfield::test
{
namespace
{
constexpr int Trials = 40;

struct Drilled
{
  PlanarDomain domain;
  Configuration holes;
  DrillOptions options;
  TriangleMesh mesh;
};

/// Drills random holes into a random smooth domain with a random mesh size; trial 0 has no hole.
Drilled DrillRandom(int trial)
{
  Random random(static_cast<std::uint32_t>(1000 + trial));
  Drilled result;
  result.domain = RandomSmoothDomain(random);
  result.holes = RandomHoles(random, result.domain, trial % 9);
  result.options.meshSize = trial % 4 == 0 ? 0.0 : random.Uniform(0.06, 0.2);
  result.mesh = DrillHoles(result.domain, result.holes, result.options);
  return result;
}

/// Returns the distances of the boundary vertices of a hole from its centre.
std::vector<double> RimDistances(const Drilled& drilled, int hole)
{
  std::vector<double> distances;
  for (const BoundaryEdge& edge : drilled.mesh.boundary)
  {
    if (edge.kind == BoundaryKind::Hole && edge.id == hole)
    {
      distances.push_back(
        (drilled.mesh.points[edge.vertices[0]] - drilled.holes[hole].position).norm());
    }
  }
  return distances;
}

/// Returns the number of corners of a hole's polygon: the rim vertices on the circle itself, up to
/// the rounding of coordinates of size one.
int PolygonCorners(const Drilled& drilled, int hole)
{
  const std::vector<double> distances = RimDistances(drilled, hole);
  return static_cast<int>(std::count_if(distances.begin(), distances.end(),
    [&](double distance) { return std::abs(distance - drilled.holes[hole].radius) < 2e-15; }));
}

double PolygonSide(const Drilled& drilled, int hole)
{
  return 2.0 * drilled.holes[hole].radius * std::sin(Pi / PolygonCorners(drilled, hole));
}

TEST(DrillHoles, HasTopologyAndAreaOfTheDrilledDomain)
{
  for (int trial = 0; trial < Trials; ++trial)
  {
    SCOPED_TRACE(trial);
    const Drilled drilled = DrillRandom(trial);
    const int holeCount = static_cast<int>(drilled.holes.size());
    EXPECT_EQ(NumberEdges(drilled.mesh).EulerCharacteristic(drilled.mesh), 1 - holeCount);
    double area = drilled.domain.Area();
    for (int i = 0; i < holeCount; ++i)
    {
      const int corners = PolygonCorners(drilled, i);
      const double radius = drilled.holes[i].radius;
      area -= 0.5 * corners * radius * radius * std::sin(2.0 * Pi / corners);
    }
    EXPECT_NEAR(MeshArea(drilled.mesh), area, 1e-12 * area);
  }
}

TEST(DrillHoles, HolesAreRegularPolygonsOnTheirCircles)
{
  for (int trial = 0; trial < Trials; ++trial)
  {
    SCOPED_TRACE(trial);
    const Drilled drilled = DrillRandom(trial);
    const double meshSize = ResolveMeshSize(drilled.options, drilled.domain);
    for (int i = 0; i < static_cast<int>(drilled.holes.size()); ++i)
    {
      const Singularity& hole = drilled.holes[i];
      const int corners = PolygonCorners(drilled, i);
      EXPECT_GE(corners, drilled.options.minimumHoleEdges);
      EXPECT_GE(corners, 8 * std::abs(hole.quarterIndex));
      EXPECT_LE(PolygonSide(drilled, i), meshSize * (1.0 + 1e-12));
      // Points that the mesher inserts on a side are between its middle and its ends.
      const double apothem = hole.radius * std::cos(Pi / corners);
      for (const double distance : RimDistances(drilled, i))
      {
        EXPECT_LE(distance, hole.radius * (1.0 + 1e-12));
        EXPECT_GE(distance, apothem * (1.0 - 1e-12));
      }
    }
  }
}

TEST(DrillHoles, MarksEveryLoopWithItsRowAndIndex)
{
  for (int trial = 0; trial < Trials; ++trial)
  {
    SCOPED_TRACE(trial);
    const Drilled drilled = DrillRandom(trial);
    const std::vector<BoundaryLoop> loops = FindBoundaryLoops(drilled.mesh);
    ASSERT_EQ(loops.size(), drilled.holes.size() + 1);
    EXPECT_EQ(loops[0].kind, BoundaryKind::Outer);
    for (std::size_t i = 0; i < loops.size(); ++i)
    {
      // Counter-clockwise around the enclosed region, for all kinds of loops.
      EXPECT_GT(SignedArea(WalkedPoints(drilled.mesh, loops[i])), 0.0);
      if (i > 0)
      {
        EXPECT_EQ(loops[i].kind, BoundaryKind::Hole);
        EXPECT_EQ(loops[i].id, static_cast<int>(i) - 1);
        EXPECT_EQ(loops[i].quarterIndex, drilled.holes[i - 1].quarterIndex);
      }
    }
  }
}

TEST(DrillHoles, RespectsBoundsOfAnglesAndLengths)
{
  for (int trial = 0; trial < Trials; ++trial)
  {
    SCOPED_TRACE(trial);
    const Drilled drilled = DrillRandom(trial);
    EXPECT_GE(SmallestAngle(drilled.mesh), 20.7);
    // Target size by the formula of docs/method.md §10.1: graded down to the segments of the
    // boundary and to the sides of the holes.
    std::vector<std::pair<Point, double>> sources;
    for (std::size_t i = 0; i < drilled.domain.loops[0].size(); ++i)
    {
      const Loop& loop = drilled.domain.loops[0];
      const double side = (loop[(i + 1) % loop.size()] - loop[i]).norm();
      sources.push_back({ loop[i], side });
      sources.push_back({ loop[(i + 1) % loop.size()], side });
    }
    for (int i = 0; i < static_cast<int>(drilled.holes.size()); ++i)
    {
      const int corners = PolygonCorners(drilled, i);
      for (const Point& corner :
        RegularPolygon(corners, drilled.holes[i].radius, drilled.holes[i].position))
      {
        sources.push_back({ corner, PolygonSide(drilled, i) });
      }
    }
    const double meshSize = ResolveMeshSize(drilled.options, drilled.domain);
    for (const auto& [a, b] : NumberEdges(drilled.mesh).vertices)
    {
      const Point middle = 0.5 * (drilled.mesh.points[a] + drilled.mesh.points[b]);
      double target = meshSize;
      for (const auto& [place, side] : sources)
      {
        target = std::min(target, side + drilled.options.gradation * (middle - place).norm());
      }
      ASSERT_LE((drilled.mesh.points[a] - drilled.mesh.points[b]).norm(), 1.8 * target);
    }
  }
}

TEST(DrillHoles, IsDeterministic)
{
  for (int trial = 0; trial < Trials; trial += 4)
  {
    EXPECT_TRUE(Identical(DrillRandom(trial).mesh, DrillRandom(trial).mesh)) << trial;
  }
}

TEST(DrillHoles, InnerLoopsAndHolesKeepTheirKinds)
{
  const PlanarDomain ring = Builtin("ring");
  const TriangleMesh mesh = DrillHoles(ring, OnCircle(3, 0.7, 0.1, -1, 0.05));
  std::map<BoundaryKind, int> loops;
  for (const BoundaryLoop& loop : FindBoundaryLoops(mesh))
  {
    ++loops[loop.kind];
    EXPECT_EQ(loop.quarterIndex, loop.kind == BoundaryKind::Hole ? -1 : 0);
    EXPECT_GT(SignedArea(WalkedPoints(mesh, loop)), 0.0);
  }
  EXPECT_EQ(loops[BoundaryKind::Outer], 1);
  EXPECT_EQ(loops[BoundaryKind::Inner], 1);
  EXPECT_EQ(loops[BoundaryKind::Hole], 3);
  EXPECT_EQ(NumberEdges(mesh).EulerCharacteristic(mesh), -3);
}

TEST(DrillHoles, HoleEdgesGrowWithTheQuarterIndex)
{
  // At least 8 |k| edges, so that the phase turns by no more than π/4 from one edge to the next.
  for (const int quarters : { -6, -5, 3, 5, 6 })
  {
    DrillOptions options;
    options.minimumHoleEdges = 12;
    const Configuration holes = { { { 0.1, 0.2 }, quarters, 0.05 } };
    const Drilled drilled{ Builtin("disk"), holes, options,
      DrillHoles(Builtin("disk"), holes, options) };
    EXPECT_GE(PolygonCorners(drilled, 0), 8 * std::abs(quarters));
  }
}

TEST(DrillHoles, NearlyTouchingHolesAreResolved)
{
  // Gaps of a hundredth of the radius between two holes, and between a hole and the boundary.
  const PlanarDomain disk = Builtin("disk", 0.05);
  const Configuration holes = { { { -0.1, 0.0 }, 1, 0.1 }, { { 0.101, 0.0 }, 1, 0.1 },
    { { 0.0, 0.89 }, 2, 0.1 } };
  const TriangleMesh mesh = DrillHoles(disk, holes);
  EXPECT_EQ(NumberEdges(mesh).EulerCharacteristic(mesh), -2);
  EXPECT_GE(SmallestAngle(mesh), 20.7);
}

TEST(DrillHoles, MeshSizeDefaultsToAFortiethOfTheDiagonal)
{
  const PlanarDomain square = Builtin("square");
  EXPECT_DOUBLE_EQ(ResolveMeshSize({}, square), std::sqrt(2.0) / 40.0);
  DrillOptions options;
  options.meshSize = 0.3;
  EXPECT_EQ(ResolveMeshSize(options, square), 0.3);
  // The default radius is the mesh size, or a third of the distance to the boundary if that is
  // smaller.
  const Configuration holes = { { { 0.5, 0.5 }, 1, 0.0 } };
  EXPECT_EQ(WithDefaultRadii(square, holes, 0.1)[0].radius, 0.1);
  const Drilled drilled{ square, { { { 0.5, 0.5 }, 1, 0.5 / 3.0 } }, options,
    DrillHoles(square, holes, options) };
  EXPECT_GE(PolygonCorners(drilled, 0), 32);
}

TEST(DrillHoles, CommutesWithScaling)
{
  const Drilled drilled = DrillRandom(5);
  for (const double scale : { 1e-6, 1e6 })
  {
    const Similarity move{ 0.0, scale, Point::Zero() };
    DrillOptions options = drilled.options;
    options.meshSize *= scale;
    const TriangleMesh mesh = DrillHoles(move(drilled.domain), move(drilled.holes), options);
    EXPECT_EQ(NumberEdges(mesh).EulerCharacteristic(mesh),
      NumberEdges(drilled.mesh).EulerCharacteristic(drilled.mesh));
    EXPECT_GE(SmallestAngle(mesh), 20.7);
    EXPECT_NEAR(MeshArea(mesh), scale * scale * MeshArea(drilled.mesh), 1e-12 * MeshArea(mesh));
    const auto count = static_cast<double>(drilled.mesh.triangles.size());
    EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), count, 0.1 * count);
  }
}

TEST(DrillHoles, RefusesHolesThatDoNotFit)
{
  const PlanarDomain ring = Builtin("ring");
  const auto drill = [&](const Configuration& holes) { return [=] { DrillHoles(ring, holes); }; };
  const Singularity good{ { 0.7, 0.0 }, 1, 0.1 };
  // Beyond the outer loop, and in the ring's own hole.
  EXPECT_TRUE(Refuses(drill({ good, { { 2.0, 0.0 }, 1, 0.1 } }),
    { "singularity 2", "(2, 0)", "outside", "move it" }));
  EXPECT_TRUE(Refuses(drill({ { { 0.1, 0.0 }, 1, 0.01 } }), { "singularity 1", "outside" }));
  // Too close to one of the boundaries: the message states the distance.
  EXPECT_TRUE(Refuses(drill({ { { 0.0, 0.75 }, 1, 0.5 } }),
    { "singularity 1", "(0, 0.75)", "radius 0.5", "cuts the boundary", "only 0.24", "smaller" }));
  EXPECT_TRUE(Refuses(drill({ { { 0.5, 0.0 }, 1, 0.101 } }), { "cuts the boundary" }));
  EXPECT_FALSE(Refuses(drill({ { { 0.5, 0.0 }, 1, 0.09 } }), {}));
  // Overlap, tangency, and one hole inside another: the message states both rows and both numbers.
  EXPECT_TRUE(Refuses(drill({ good, { { 0.7, 0.125 }, -1, 0.1 } }),
    { "Two holes overlap: ", "singularity 1", "singularity 2", "0.125 apart", "add up to 0.2" }));
  EXPECT_TRUE(Refuses(drill({ good, { { 0.7, 0.2 }, -1, 0.1 } }), { "overlap" }));
  EXPECT_TRUE(Refuses(drill({ good, good }), { "overlap" }));
}

TEST(DrillHoles, RefusesInvalidNumbers)
{
  constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  const PlanarDomain disk = Builtin("disk");
  EXPECT_TRUE(Refuses(
    [&] {
      DrillHoles(disk, { { { 0.0, 0.0 }, 1, -0.1 } });
    },
    { "singularity 1", "radius", "not positive" }));
  for (const double bad : { NotANumber, Infinity })
  {
    for (const Singularity& hole : { Singularity{ { bad, 0.0 }, 1, 0.1 },
           Singularity{ { 0.0, bad }, 1, 0.1 }, Singularity{ { 0.0, 0.0 }, 1, bad } })
    {
      EXPECT_TRUE(Refuses(
        [&] {
          DrillHoles(disk, { { { 0.5, 0.0 }, 1, 0.1 }, hole });
        },
        { "Row 2", "not a finite number" }));
    }
  }
  for (const double bad : { -0.1, NotANumber, Infinity })
  {
    DrillOptions options;
    options.meshSize = bad;
    EXPECT_TRUE(Refuses([&] { DrillHoles(disk, {}, options); }, { "mesh size", "positive" }));
  }
  for (const double bad : { 0.0, -1.0, NotANumber })
  {
    DrillOptions options;
    options.gradation = bad;
    EXPECT_TRUE(Refuses([&] { DrillHoles(disk, {}, options); }, { "gradation", "positive" }));
  }
}

TEST(DrillHoles, RefusesHolesWithFewerThanThreeEdges)
{
  const PlanarDomain disk = Builtin("disk");
  for (const int few : { -1, 0, 1, 2 })
  {
    DrillOptions options;
    options.minimumHoleEdges = few;
    // An index of zero requires no edges of its own, and a small radius requires one.
    EXPECT_TRUE(Refuses(
      [&] {
        DrillHoles(disk, { { { 0.0, 0.0 }, 0, 1e-3 } }, options);
      },
      { "edges" }));
  }
}
}
}
