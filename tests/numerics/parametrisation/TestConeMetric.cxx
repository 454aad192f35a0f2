// Flips and splits of a cone metric change its triangulation only: not its lengths, areas and
// angles, and not the crosses.

#include "ConeMetric.h"

#include "MeshForPoints.h"
#include "MetricCases.h"
#include "MetricDerivatives.h"
#include "PhaseSteps.h"
#include "SeamlessMapSolve.h"
#include "Support.h"
#include "TriangleArea.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace crossfield::test
{
namespace
{
using Side = ConeMetric::Side;

template <typename Entries>
const typename Entries::value_type& At(const Entries& entries, int i)
{
  return entries[static_cast<std::size_t>(i)];
}

int EdgeOf(const ConeMetric& metric, Side side)
{
  return At(At(metric.Triangles(), side.triangle).edges, side.side);
}

/// Checks that references between triangles, edges and the boundary agree.
void ExpectConsistent(const ConeMetric& metric, int euler)
{
  const auto triangles = static_cast<int>(metric.Triangles().size());
  std::set<std::pair<int, int>> starts;
  std::set<std::pair<int, int>> ends;
  for (int t = 0; t < triangles; ++t)
  {
    const ConeMetric::Triangle& triangle = At(metric.Triangles(), t);
    for (int i = 0; i < 3; ++i)
    {
      const int a = At(triangle.vertices, i);
      const int b = At(triangle.vertices, (i + 1) % 3);
      const int neighbour = At(triangle.neighbours, i);
      if (neighbour < 0)
      {
        const int entry = -1 - neighbour;
        ASSERT_LT(entry, static_cast<int>(metric.Boundary().size()));
        EXPECT_EQ(metric.AtBoundary(entry).triangle, t);
        EXPECT_EQ(metric.AtBoundary(entry).side, i);
        EXPECT_EQ(At(metric.Boundary(), entry).vertices[0], a);
        EXPECT_EQ(At(metric.Boundary(), entry).vertices[1], b);
        continue;
      }
      const Side across = metric.Across({ t, i });
      ASSERT_EQ(across.triangle, neighbour);
      ASSERT_LT(across.side, 3);
      EXPECT_EQ(metric.Across(across).triangle, t);
      EXPECT_EQ(metric.Across(across).side, i);
      EXPECT_EQ(At(At(metric.Triangles(), neighbour).vertices, across.side), b);
      EXPECT_EQ(At(At(metric.Triangles(), neighbour).vertices, (across.side + 1) % 3), a);
      EXPECT_EQ(
        At(triangle.jumps, i) + At(At(metric.Triangles(), neighbour).jumps, across.side), 0);
    }
  }
  EXPECT_EQ(static_cast<int>(metric.Points().size()) -
      static_cast<int>(metric.LogLengths().size()) + triangles,
    euler);
}

/// Returns the sum of the jumps around every vertex, modulo 4; on the boundary, plus the difference
/// of the directions of the two boundary edges. It is the quarter index.
std::vector<int> JumpsAround(const ConeMetric& metric)
{
  std::vector<int> sums(metric.Points().size(), 0);
  for (const ConeMetric::Triangle& triangle : metric.Triangles())
  {
    for (int i = 0; i < 3; ++i)
    {
      const bool inside = At(triangle.neighbours, i) >= 0;
      const int jump = inside ? At(triangle.jumps, i) : -At(triangle.jumps, i);
      // Counter-clockwise around a vertex the last side of a triangle, which ends there, is crossed.
      sums[static_cast<std::size_t>(At(triangle.vertices, (i + 1) % 3))] += jump;
      if (!inside)
      {
        sums[static_cast<std::size_t>(At(triangle.vertices, i))] -= jump;
      }
    }
  }
  for (int& sum : sums)
  {
    sum = ((sum % 4) + 4) % 4;
  }
  return sums;
}

/// Returns a ring of a cross field with cones +1 and −1, whose jumps are not all 0.
ConeMetric RingMetric(const SharedPlanarTopology& topology, const Configuration& configuration)
{
  const SeamlessMap map = SolveSeamlessMap(topology, configuration);
  const PlacedConfiguration placed = PlaceForMap(*topology, configuration, {});
  const PointPotential potential = PointPotentialOn(topology->mesh, {}, 0);
  return { *topology,
    FrameTriangles(*topology, StepsOf(potential, potential.Solve(placed.interior))).jump,
    map.cones };
}

Configuration PairsOfRing()
{
  return Join(OnCircle(4, 0.8, 0.1, 1, 0.0), OnCircle(4, 0.6, 0.15, -1, 0.0));
}

TEST(ConeMetric, AnglesOfKnownTriangles)
{
  // Sides 3, 4, 5; side i is opposite to vertex i + 2.
  const MetricAngles right = AnglesFromLogLengths({ std::log(3.0), std::log(4.0), std::log(5.0) });
  EXPECT_NEAR(right.angle[1], 0.5 * Pi, 1e-15);
  EXPECT_NEAR(right.angle[0], std::atan2(4.0, 3.0), 1e-15);
  EXPECT_NEAR(right.cotangent[2], 4.0 / 3.0, 1e-14);
  EXPECT_NEAR(right.cotangent[1], 0.0, 1e-15);
  // Any size.
  const MetricAngles tiny = AnglesFromLogLengths({ -800.0, -800.0, -800.0 });
  EXPECT_NEAR(tiny.angle[0], Pi / 3.0, 1e-15);
  const MetricAngles none = AnglesFromLogLengths({ 0.0, 0.0, 1.0 });
  EXPECT_EQ(*std::min_element(none.angle.begin(), none.angle.end()), 0.0);
  EXPECT_DOUBLE_EQ(*std::max_element(none.angle.begin(), none.angle.end()), Pi);
}

TEST(ConeMetric, FlipsAndSplitsKeepTheMetricOfThePlane)
{
  Random random(41);
  for (const bool frame : { false, true })
  {
    const SharedPlanarTopology topology =
      frame ? SquareFrame(0.3, 0.2) : ShareTopology(MeshForPoints(Builtin("disk", 0.2), {}, 0.2));
    ConeMetric metric = PlaneMetric(*topology);
    const std::size_t before = metric.Triangles().size();
    EXPECT_GT(ChangeAtRandom(random, 400, metric), 100);
    EXPECT_GT(metric.Triangles().size(), before + 50);
    EXPECT_GT(metric.Boundary().size(), topology->mesh.boundary.size());
    ExpectConsistent(metric, frame ? 0 : 1);
    double area = 0.0;
    for (int t = 0; t < static_cast<int>(metric.Triangles().size()); ++t)
    {
      const ConeMetric::Triangle& triangle = At(metric.Triangles(), t);
      for (int i = 0; i < 3; ++i)
      {
        const SpacePoint along = At(metric.Points(), At(triangle.vertices, (i + 1) % 3)) -
          At(metric.Points(), At(triangle.vertices, i));
        EXPECT_NEAR(metric.Length(EdgeOf(metric, { t, i })) / along.norm(), 1.0, 1e-11);
        EXPECT_NEAR(At(metric.AnglesOf(t).angle, i), metric.AngleOnSurface(t, i), 1e-6);
      }
      const double here = crossfield::TriangleArea(metric.Triangulation(), triangle.vertices);
      EXPECT_GT(here, 0.0);
      EXPECT_NEAR(metric.AreaOf(t), here, 1e-11);
      area += here;
    }
    EXPECT_NEAR(area, MeshArea(topology->mesh), 1e-12);
    EXPECT_TRUE(metric.IsValid());
  }
}

TEST(ConeMetric, FlipsAndSplitsKeepConesAndCrosses)
{
  const Configuration configuration = PairsOfRing();
  const SharedPlanarTopology topology =
    ShareTopology(MeshThroughPoints(Builtin("ring", 0.1), configuration, 0.1));
  ConeMetric metric = RingMetric(topology, configuration);
  Random random(42);
  // A metric with a different cone at every vertex.
  Perturb(random, 0.1, metric);
  const std::size_t vertices = metric.Points().size();
  const auto areaOf = [](const ConeMetric& m)
  {
    double area = 0.0;
    for (int t = 0; t < static_cast<int>(m.Triangles().size()); ++t)
    {
      area += m.AreaOf(t);
    }
    return area;
  };
  const double area = areaOf(metric);
  const Eigen::VectorXd defects = MetricDerivatives(metric).AngleDefects();
  const std::vector<int> jumps = JumpsAround(metric);
  for (std::size_t v = 0; v < vertices; ++v)
  {
    const bool onBoundary = std::any_of(metric.Boundary().begin(), metric.Boundary().end(),
      [&](const BoundaryEdge& edge) { return edge.vertices[0] == static_cast<int>(v); });
    const int quarters = metric.QuartersAt(static_cast<int>(v));
    EXPECT_EQ((jumps[v] + quarters - (onBoundary ? 2 : 4) + 8) % 4, 0) << v;
  }
  EXPECT_GT(ChangeAtRandom(random, 300, metric), 60);
  ExpectConsistent(metric, 0);
  EXPECT_NEAR(areaOf(metric), area, 1e-12 * area);
  const Eigen::VectorXd after = MetricDerivatives(metric).AngleDefects();
  const std::vector<int> jumpsAfter = JumpsAround(metric);
  ASSERT_GT(metric.Points().size(), vertices + 30);
  for (std::size_t v = 0; v < metric.Points().size(); ++v)
  {
    const auto row = static_cast<Eigen::Index>(v);
    EXPECT_NEAR(after[row], v < vertices ? defects[row] : 0.0, 1e-9);
    EXPECT_EQ(jumpsAfter[v], v < vertices ? jumps[v] : 0);
  }
}

TEST(ConeMetric, FlippingTwiceIsTheIdentity)
{
  const Configuration configuration = PairsOfRing();
  const SharedPlanarTopology topology =
    ShareTopology(MeshThroughPoints(Builtin("ring", 0.1), configuration, 0.1));
  ConeMetric metric = RingMetric(topology, configuration);
  const auto cornersOf = [&metric](int t)
  {
    std::array<int, 3> corners = At(metric.Triangles(), t).vertices;
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
  };
  int flips = 0;
  for (int t = 0; t < static_cast<int>(metric.Triangles().size()); ++t)
  {
    const int other = At(metric.Triangles(), t).neighbours[0];
    if (other < 0 || metric.AngleOnSurface(t, 2) < 0.4 * Pi)
    {
      continue;
    }
    const std::set<std::array<int, 3>> before = { cornersOf(t), cornersOf(other) };
    const std::vector<double> logs = metric.LogLengths();
    const std::vector<int> jumps = JumpsAround(metric);
    metric.Flip({ t, 0 });
    const std::set<std::array<int, 3>> between = { cornersOf(t), cornersOf(other) };
    EXPECT_NE(between, before);
    metric.Flip({ t, 0 });
    const std::set<std::array<int, 3>> after = { cornersOf(t), cornersOf(other) };
    EXPECT_EQ(after, before);
    EXPECT_EQ(JumpsAround(metric), jumps);
    for (std::size_t e = 0; e < logs.size(); ++e)
    {
      EXPECT_NEAR(metric.LogLengths()[e], logs[e], 1e-12);
    }
    ++flips;
  }
  EXPECT_GT(flips, 50);
  ExpectConsistent(metric, 0);
}

TEST(ConeMetric, SplitsDivideLengthsAndBoundaryEdges)
{
  const SharedPlanarTopology topology = SquareFrame(0.0, 0.5);
  for (const double fraction : { 0.2, 0.5, 0.7 })
  {
    ConeMetric metric = PlaneMetric(*topology);
    for (int entry = 0; entry < static_cast<int>(topology->mesh.boundary.size()); ++entry)
    {
      const BoundaryEdge edge = At(metric.Boundary(), entry);
      const Side side = metric.AtBoundary(entry);
      const double length = metric.Length(EdgeOf(metric, side));
      const auto added = static_cast<int>(metric.Boundary().size());
      metric.Split(side, fraction);
      const Side first = metric.AtBoundary(entry);
      const Side second = metric.AtBoundary(added);
      EXPECT_NEAR(metric.Length(EdgeOf(metric, first)), fraction * length, 1e-14);
      EXPECT_NEAR(metric.Length(EdgeOf(metric, second)), (1.0 - fraction) * length, 1e-14);
      const int middle = static_cast<int>(metric.Points().size()) - 1;
      EXPECT_EQ(metric.QuartersAt(middle), 2);
      EXPECT_EQ(At(metric.Boundary(), entry).vertices[0], edge.vertices[0]);
      EXPECT_EQ(At(metric.Boundary(), entry).vertices[1], middle);
      EXPECT_EQ(At(metric.Boundary(), added).vertices[0], middle);
      EXPECT_EQ(At(metric.Boundary(), added).vertices[1], edge.vertices[1]);
      EXPECT_EQ(At(metric.Boundary(), added).kind, edge.kind);
      EXPECT_EQ(At(metric.Boundary(), added).id, edge.id);
      EXPECT_EQ(At(At(metric.Triangles(), first.triangle).jumps, first.side),
        At(At(metric.Triangles(), second.triangle).jumps, second.side));
    }
    ExpectConsistent(metric, 0);
    EXPECT_LT(MetricDerivatives(metric).AngleDefects().lpNorm<Eigen::Infinity>(), 1e-12);
  }
}

TEST(ConeMetric, RefusesCrossesThatDoNotClose)
{
  const SharedPlanarTopology topology = SquareFrame(0.0, 0.5);
  const std::vector<std::array<int, 3>> jumps(topology->mesh.triangles.size(), { 0, 0, 0 });
  const Cone corner = { topology->mesh.boundary[0].vertices[0], 1, true, -1 };
  EXPECT_TRUE(
    Refuses([&] { ConeMetric(*topology, jumps, { corner }); }, { "do not close", "finer mesh" }));
}
}
}
