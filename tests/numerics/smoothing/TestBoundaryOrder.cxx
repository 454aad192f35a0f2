// Points of quads on the boundary are put in order, and stay in order while they slide.

#include "BoundaryOrder.h"

#include "FreePoints.h"
#include "Layouts.h"
#include "MeshBoundary.h"
#include "MeshForPoints.h"
#include "QuadEnergy.h"
#include "QuadMesher.h"
#include "QuadSizes.h"
#include "SeamlessMapSolve.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield::test
{
namespace
{
/// Quads of the L-shape with a pair: corners are fixed points on the boundary, and those on the ring
/// have none.
QuadResult QuadsOf(const SeamlessMap& map)
{
  QuadOptions options;
  options.quadCount = 200;
  return MakeQuads(LayoutOf(map), options);
}

SeamlessMap MapOfL()
{
  const Configuration pair = { { { 0.5, 0.6 }, 1 }, { { 0.8, 0.7 }, -1 } };
  return SolveSeamlessMap(ShareTopology(MeshThroughPoints(LShape(), pair, 0.1)), pair);
}

SeamlessMap MapOfRing()
{
  const Configuration eight = Join(OnCircle(4, 0.8, 0.1, 1, 0.0), OnCircle(4, 0.6, 0.1, -1, 0.0));
  return SolveSeamlessMap(
    ShareTopology(MeshThroughPoints(Builtin("ring", 0.1), eight, 0.1)), eight);
}

Eigen::VectorXd RandomVector(Random& random, Eigen::Index size)
{
  return Eigen::VectorXd::NullaryExpr(size, [&random] { return random.Uniform(-1.0, 1.0); });
}

/// Returns the length of a boundary edge of quads.
double EdgeLength(const QuadMesh& mesh, const BoundaryCurves& curves, const QuadBoundaryEdge& edge)
{
  const CurvePlace& from = mesh.points[static_cast<std::size_t>(edge.points[0])].curve;
  const CurvePlace& to = mesh.points[static_cast<std::size_t>(edge.points[1])].curve;
  return LengthAlong(from, to, curves.Length(from.loop));
}

double ShortestEdge(const QuadMesh& mesh, const BoundaryCurves& curves)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    shortest = std::min(shortest, EdgeLength(mesh, curves, edge));
  }
  return shortest;
}

/// Checks the gradient of an energy along a random direction, at points moved a little at random.
void ExpectGradient(QuadEnergy& energy, double epsilon, Random& random)
{
  const Eigen::VectorXd start = energy.Unknowns();
  const Eigen::VectorXd at = start + energy.Masked(1e-3 * RandomVector(random, start.size()));
  const Eigen::VectorXd direction = energy.Masked(RandomVector(random, at.size()));
  Eigen::VectorXd gradient;
  const double value = energy.Value(at, epsilon, &gradient);
  ASSERT_TRUE(std::isfinite(value));
  EXPECT_EQ(energy.Value(at, epsilon, nullptr), value);
  const double step = 1e-7;
  const double difference = (energy.Value(at + step * direction, epsilon, nullptr) -
                              energy.Value(at - step * direction, epsilon, nullptr)) /
    (2.0 * step);
  EXPECT_NEAR(gradient.dot(direction), difference, 1e-5 * gradient.norm() * direction.norm());
  EXPECT_EQ(energy.Masked(gradient), gradient);
}

TEST(LengthAlong, IsTheLengthToTheNextPosition)
{
  EXPECT_DOUBLE_EQ(LengthAlong({ 0, 1.0 }, { 0, 3.5 }, 10.0), 2.5);
  EXPECT_DOUBLE_EQ(LengthAlong({ 0, 9.0 }, { 0, 0.5 }, 10.0), 1.5);
  EXPECT_DOUBLE_EQ(LengthAlong({ 0, 3.5 }, { 0, 3.0 }, 10.0), -0.5);
  EXPECT_DOUBLE_EQ(LengthAlong({ 0, 0.5 }, { 0, 9.5 }, 10.0), -1.0);
  EXPECT_DOUBLE_EQ(LengthAlong({ 0, 1.0 }, { 0, 8.0 }, 10.0), 7.0);
}

TEST(QuadEnergy, GradientMatchesForPowersAndOrderOnTheBoundary)
{
  Random random(71);
  for (const SeamlessMap& map : { MapOfL(), MapOfRing() })
  {
    const QuadResult result = QuadsOf(map);
    const MeshBoundary curves(*RequirePlanar(map.topology));
    std::vector<double> weights(result.mesh.quads.size());
    for (std::size_t q = 0; q < weights.size(); ++q)
    {
      weights[q] = 1.0 + static_cast<double>(q % 3);
    }
    for (const double power : { 1.0, 2.5, 4.0 })
    {
      for (const bool holds : { false, true })
      {
        for (const double epsilon : { 0.0, 0.5 })
        {
          SCOPED_TRACE(std::to_string(power) + " " + std::to_string(holds));
          QuadEnergy energy(result.mesh, curves, AllButFixed(result.mesh), 0.3, weights);
          energy.SetPower(power);
          if (holds)
          {
            energy.HoldOrderOnBoundary();
          }
          ExpectGradient(energy, epsilon, random);
        }
      }
    }
  }
}

/// 2/p (f/2)^p: of a corner with f = 2 it is 2/p, and it grows with the power.
TEST(QuadEnergy, PowersKeepTheMinimum)
{
  QuadMesh square;
  square.points.resize(4);
  square.points[1].MoveTo({ 2.0, 0.0 });
  square.points[2].MoveTo({ 2.0, 3.0 });
  square.points[3].MoveTo({ 0.0, 3.0 });
  square.quads = { { 0, 1, 2, 3 } };
  square.targetLengths = { { 2.0, 3.0 } };
  const SharedPlanarTopology topology = ShareTopology(MeshForPoints(LShape(), {}, 0.5));
  const MeshBoundary curves(*topology);
  for (const double power : { 1.0, 2.0, 4.0 })
  {
    QuadEnergy energy(square, curves, { true, true, true, true }, 0.2, { 3.0 });
    energy.SetPower(power);
    EXPECT_NEAR(energy.IdealValue(), 3.0 * 8.0 / power, 1e-13);
    Eigen::VectorXd gradient;
    EXPECT_NEAR(energy.Value(energy.Unknowns(), 0.0, &gradient), energy.IdealValue(), 1e-13);
    EXPECT_LT(gradient.norm(), 1e-13);
    // A square of side s instead: f = (1 − a) |J|² / D + a (D² + 1) / D.
    Eigen::VectorXd doubled = 2.0 * energy.Unknowns();
    const double f = 0.8 * 8.0 / 4.0 + 0.2 * 17.0 / 4.0;
    EXPECT_NEAR(energy.Value(doubled, 0.0, nullptr),
      3.0 * 4.0 * 2.0 / power * std::pow(0.5 * f, power), 1e-11);
  }
}

/// Adds d + 1/d + t³ / (1 − t) per boundary edge, and is infinite where edges run backwards.
TEST(QuadEnergy, HoldsTheOrderOnTheBoundary)
{
  for (const SeamlessMap& map : { MapOfL(), MapOfRing() })
  {
    QuadMesh mesh = QuadsOf(map).mesh;
    const MeshBoundary curves(*RequirePlanar(map.topology));
    const std::vector<double> weights(mesh.quads.size(), 1.0);
    QuadEnergy without(mesh, curves, AllButFixed(mesh), 0.3, weights);
    QuadEnergy with(mesh, curves, AllButFixed(mesh), 0.3, weights);
    with.HoldOrderOnBoundary();
    const Eigen::VectorXd at = with.Unknowns();
    const std::vector<int> twins = mesh.Twins();
    double expected = 0.0;
    for (std::size_t side = 0; side < twins.size(); ++side)
    {
      if (twins[side] < 0)
      {
        const std::size_t q = side / 4;
        const QuadBoundaryEdge edge{ { mesh.quads[q][side % 4], mesh.quads[q][(side + 1) % 4] } };
        const double length = EdgeLength(mesh, curves, edge);
        const double d = length / mesh.targetLengths[q][side % 2];
        const CurvePlace& place = mesh.points[static_cast<std::size_t>(edge.points[0])].curve;
        const double t =
          std::max(0.0, (length / curves.Length(place.loop) - 0.125) / (0.5 - 0.125));
        expected += d + 1.0 / d + t * t * t / (1.0 - t);
      }
    }
    // Regularised, as quads fold over while points pass each other.
    constexpr double Epsilon = 1.0;
    EXPECT_NEAR(
      with.Value(at, Epsilon, nullptr) - without.Value(at, Epsilon, nullptr), expected, 1e-9);
    // A point moves past the next one.
    int passed = 0;
    for (const QuadBoundaryEdge& edge : mesh.boundary)
    {
      const auto from = static_cast<std::size_t>(edge.points[0]);
      if (mesh.points[from].fixed)
      {
        continue;
      }
      Eigen::VectorXd past = at;
      past[FirstUnknown(edge.points[0])] += 1.01 * EdgeLength(mesh, curves, edge);
      EXPECT_TRUE(std::isfinite(without.Value(past, Epsilon, nullptr)));
      EXPECT_EQ(with.Value(past, Epsilon, nullptr), std::numeric_limits<double>::infinity());
      ++passed;
    }
    EXPECT_GT(passed, 20);
  }
}

TEST(OrderOnBoundary, MovesOnlyPointsOutOfOrder)
{
  for (const SeamlessMap& map : { MapOfL(), MapOfRing() })
  {
    const QuadMesh ordered = QuadsOf(map).mesh;
    const MeshBoundary curves(*RequirePlanar(map.topology));
    ASSERT_GT(ShortestEdge(ordered, curves), 0.0);
    QuadMesh mesh = ordered;
    OrderOnBoundary(mesh, curves);
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      EXPECT_EQ(mesh.points[p].place, ordered.points[p].place);
      EXPECT_EQ(mesh.points[p].curve.at, ordered.points[p].curve.at);
    }
    int reversed = 0;
    for (const QuadBoundaryEdge& edge : ordered.boundary)
    {
      const auto a = static_cast<std::size_t>(edge.points[0]);
      const auto b = static_cast<std::size_t>(edge.points[1]);
      if (ordered.points[a].fixed || ordered.points[b].fixed)
      {
        continue;
      }
      mesh = ordered;
      std::swap(mesh.points[a].curve, mesh.points[b].curve);
      std::swap(mesh.points[a].place, mesh.points[b].place);
      ASSERT_LT(ShortestEdge(mesh, curves), 0.0);
      OrderOnBoundary(mesh, curves);
      EXPECT_GT(ShortestEdge(mesh, curves), 0.0);
      for (std::size_t p = 0; p < mesh.points.size(); ++p)
      {
        const QuadPoint& point = mesh.points[p];
        if (point.fixed || point.curve.loop != ordered.points[a].curve.loop)
        {
          EXPECT_EQ(point.place, ordered.points[p].place);
        }
        else
        {
          EXPECT_EQ(point.InPlane(), curves.At(point.curve));
        }
      }
      ++reversed;
    }
    EXPECT_GT(reversed, 20);
  }
}

/// Points of a hole that gather on one side of it are spread.
TEST(OrderOnBoundary, SpreadsPointsThatGather)
{
  const SeamlessMap map = MapOfRing();
  QuadMesh mesh = QuadsOf(map).mesh;
  const MeshBoundary curves(*RequirePlanar(map.topology));
  for (QuadPoint& point : mesh.points)
  {
    if (point.curve.loop >= 0)
    {
      point.curve.at *= 0.02;
      point.MoveTo(curves.At(point.curve));
    }
  }
  const auto longest = [&]
  {
    double part = 0.0;
    for (const QuadBoundaryEdge& edge : mesh.boundary)
    {
      const CurvePlace& from = mesh.points[static_cast<std::size_t>(edge.points[0])].curve;
      const CurvePlace& to = mesh.points[static_cast<std::size_t>(edge.points[1])].curve;
      const double loop = curves.Length(from.loop);
      const double turns = (to.at - from.at) / loop;
      part = std::max(part, turns - std::floor(turns));
    }
    return part;
  };
  ASSERT_GT(longest(), 0.97);
  OrderOnBoundary(mesh, curves); // in order, so points stay
  ASSERT_GT(longest(), 0.97);
  OrderOnBoundary(mesh, curves, 0.1);
  EXPECT_LT(longest(), LongestPartOfLoop);
  EXPECT_GT(ShortestEdge(mesh, curves), 0.0);
}

TEST(SetMeasuredLengths, AreMeansOfOppositeSides)
{
  QuadMesh mesh;
  mesh.points.resize(6);
  mesh.points[1].MoveTo({ 4.0, 0.0 });
  mesh.points[2].MoveTo({ 4.0, 3.0 });
  mesh.points[3].MoveTo({ 0.0, 1.0 });
  mesh.points[4].MoveTo({ 4.1, 0.0 });
  mesh.points[5].MoveTo({ 4.1, 3.0 });
  mesh.quads = { { 0, 1, 2, 3 }, { 1, 4, 5, 2 } };
  mesh.targetLengths.resize(2);
  SetMeasuredLengths(mesh);
  EXPECT_NEAR(mesh.targetLengths[0][0], 0.5 * (4.0 + std::sqrt(20.0)), 1e-14);
  EXPECT_NEAR(mesh.targetLengths[0][1], 0.5 * (3.0 + 1.0), 1e-14);
  EXPECT_NEAR(mesh.targetLengths[1][0], 0.3 * 0.25 * (0.1 + 3.0 + 0.1 + 3.0), 1e-14);
  EXPECT_NEAR(mesh.targetLengths[1][1], 3.0, 1e-14);
}
}
}
