#include "CornerClassification.h"
#include "MakePlanarDomain.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

namespace crossfield::test
{
namespace
{
constexpr double QuarterInside = Pi / 16.0;

/// Returns the index in −4 .. 4 of minimum energy at a given price per quarter, by brute force.
int Cheapest(double angle, double price)
{
  int best = -4;
  for (int k = -4; k <= 4; ++k)
  {
    if (CornerEnergy(angle, k) - price * k < CornerEnergy(angle, best) - price * best)
    {
      best = k;
    }
  }
  return best;
}

/// Returns a simple polygon, star-shaped about the origin, with arbitrary angles.
PlanarDomain RandomPolygon(Random& random, int corners)
{
  Loop loop;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * Pi * (i + random.Uniform(0.0, 0.8)) / corners;
    loop.emplace_back(random.Uniform(0.2, 1.0) * Point(std::cos(angle), std::sin(angle)));
  }
  return MakePlanarDomain({ loop });
}

/// Enumerates all assignments of indices in −3 .. 4 to corners of these angles.
void ForEachAssignment(const std::vector<double>& angles,
  const std::function<void(const std::vector<int>&, double, int)>& visit)
{
  std::vector<int> indices(angles.size(), 0);
  const std::function<void(std::size_t, double, int)> descend =
    [&](std::size_t depth, double energy, int sum)
  {
    if (depth == angles.size())
    {
      visit(indices, energy, sum);
      return;
    }
    for (int k = -3; k <= 4; ++k)
    {
      indices[depth] = k;
      descend(depth + 1, energy + CornerEnergy(angles[depth], k), sum + k);
    }
  };
  descend(0, 0.0, 0);
}

std::vector<double> Angles(const CornerClassification& result)
{
  std::vector<double> angles;
  for (const ClassifiedCorner& corner : result.corners)
  {
    angles.push_back(corner.angle);
  }
  return angles;
}

/// Classifies a triangle whose first corner, at the origin, has this angle below π.
CornerClassification WithCorner(double angle)
{
  return ClassifyCorners(
    MakePlanarDomain({ { { 0.0, 0.0 }, { 1.0, 0.0 }, { std::cos(angle), std::sin(angle) } } }));
}

/// Returns the corner nearest to the origin.
const ClassifiedCorner& CornerAtOrigin(const CornerClassification& result)
{
  return *std::min_element(result.corners.begin(), result.corners.end(),
    [](const Corner& a, const Corner& b) { return a.position.norm() < b.position.norm(); });
}

CornerClassification WithReflexCorner(double angle)
{
  // A fan of points around the origin, counter-clockwise from direction 0 to the angle.
  Loop loop = { { 0.0, 0.0 } };
  for (int i = 0; i <= 16; ++i)
  {
    loop.emplace_back(std::cos(angle * i / 16.0), std::sin(angle * i / 16.0));
  }
  return ClassifyCorners(MakePlanarDomain({ loop }));
}

TEST(CornerClassification, RulesFollowTheRanges)
{
  Random random(51);
  for (int trial = 0; trial < 2000; ++trial)
  {
    const double angle = random.Uniform(0.02, 2.0 * Pi - 0.02);
    const CornerClassification result = WithReflexCorner(angle);
    const ClassifiedCorner& corner = CornerAtOrigin(result);
    if (corner.position.norm() > 1e-9)
    {
      continue; // nearly straight: no corner
    }
    EXPECT_NEAR(corner.angle, angle, 1e-12);
    EXPECT_EQ(corner.scarce, Cheapest(angle, QuarterInside));
    EXPECT_EQ(corner.excess, Cheapest(angle, -QuarterInside));
    const double a = angle / (2.0 * Pi);
    EXPECT_LE(3.0 / 8.0 - 7.0 * a / 8.0, corner.scarce / 4.0 + 1e-12);
    EXPECT_GE(5.0 / 8.0 - 7.0 * a / 8.0, corner.scarce / 4.0 - 1e-12);
    EXPECT_LE(3.0 / 8.0 - 9.0 * a / 8.0, corner.excess / 4.0 + 1e-12);
    EXPECT_GE(5.0 / 8.0 - 9.0 * a / 8.0, corner.excess / 4.0 - 1e-12);
    EXPECT_EQ(corner.conventional, static_cast<int>(std::lround(2.0 - 2.0 * angle / Pi)));
  }
}

TEST(CornerClassification, InwardPointsIntoTheDomain)
{
  Random random(52);
  for (int trial = 0; trial < 100; ++trial)
  {
    const PlanarDomain domain = RandomPolygon(random, random.Integer(3, 9));
    for (const Corner& corner : FindCorners(domain.loops, 0.0))
    {
      const Loop& loop = domain.loops[0];
      const Point inside = corner.position + 1e-7 * corner.inward;
      double winding = 0.0;
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        winding += AngleBetween(loop[i] - inside, loop[(i + 1) % loop.size()] - inside);
      }
      EXPECT_NEAR(winding, 2.0 * Pi, 1e-6);
    }
  }
}

TEST(CornerClassification, ExactMinimumAgreesWithBruteForce)
{
  Random random(53);
  std::map<Scenario, int> seen;
  for (int trial = 0; trial < 1000; ++trial)
  {
    // Seven corners have two million assignments, so fewer trials are used.
    const int count = trial % 50 == 0 ? 7 : random.Integer(3, 5);
    const CornerClassification result = ClassifyCorners(RandomPolygon(random, count));
    const std::vector<double> angles = Angles(result);
    double minimum = std::numeric_limits<double>::infinity();
    double minimumBalanced = minimum;
    ForEachAssignment(angles,
      [&](const std::vector<int>&, double energy, int sum)
      {
        minimum = std::min(minimum, energy + QuarterInside * std::abs(4 - sum));
        if (sum == 4)
        {
          minimumBalanced = std::min(minimumBalanced, energy);
        }
      });
    EXPECT_NEAR(result.energy, minimum, 1e-9 * (1.0 + minimum));
    int sum = 0;
    double energy = 0.0;
    for (const ClassifiedCorner& corner : result.corners)
    {
      sum += corner.quarterIndex;
      energy += corner.energy;
    }
    EXPECT_EQ(result.interiorQuarters, 4 - sum);
    EXPECT_NEAR(result.energy, energy + QuarterInside * std::abs(4 - sum), 1e-12 * (1.0 + energy));

    // The scenario rule of the paper agrees: every feasible scenario is optimal.
    bool any = false;
    for (const ScenarioCost& scenario : result.scenarios)
    {
      any = any || scenario.feasible;
      if (scenario.feasible)
      {
        EXPECT_NEAR(scenario.energy, minimum, 1e-9 * (1.0 + minimum));
      }
      EXPECT_GE(scenario.energy, minimum - 1e-9 * (1.0 + minimum));
    }
    EXPECT_TRUE(any);
    EXPECT_TRUE(result.scenarios[static_cast<std::size_t>(result.scenario)].feasible);
    const ScenarioCost& balanced = result.scenarios[1];
    if (balanced.sum == 4 && std::isfinite(minimumBalanced) && balanced.feasible)
    {
      EXPECT_NEAR(balanced.energy, minimumBalanced, 1e-9 * (1.0 + minimum));
    }
    ++seen[result.scenario];
  }
  EXPECT_EQ(seen.size(), 3u) << "some scenario was never met";
}

TEST(CornerClassification, TiesAgreeWithBruteForce)
{
  // Regular polygons, rectangles and triangles with equal angles have ties; random polygons have
  // none.
  std::vector<PlanarDomain> domains = { Builtin("l-shape"), Builtin("rectangle"),
    Builtin("angular-balanced"), Builtin("angular-negative"), Builtin("angular-positive") };
  for (int n = 3; n <= 7; ++n)
  {
    const Similarity turn{ 0.3, 1.0, Point(0.0, 0.0) };
    domains.push_back(turn(MakePlanarDomain({ RegularPolygon(n) })));
  }
  Random random(54);
  for (int trial = 0; trial < 20; ++trial)
  {
    domains.push_back(RandomPolygon(random, random.Integer(3, 5)));
  }
  for (std::size_t d = 0; d < domains.size(); ++d)
  {
    SCOPED_TRACE(d);
    const CornerClassification result = ClassifyCorners(domains[d]);
    const std::vector<double> angles = Angles(result);
    std::vector<bool> tied(angles.size(), false);
    ForEachAssignment(angles,
      [&](const std::vector<int>& indices, double energy, int sum)
      {
        if (energy + QuarterInside * std::abs(4 - sum) < result.energy + 1e-9)
        {
          for (std::size_t i = 0; i < indices.size(); ++i)
          {
            tied[i] = tied[i] || indices[i] != result.corners[i].quarterIndex;
          }
        }
      });
    for (std::size_t i = 0; i < tied.size(); ++i)
    {
      EXPECT_EQ(result.corners[i].tied, tied[i]) << i;
    }
  }
}

TEST(CornerClassification, KeepsOverridesAndOptimisesTheOthers)
{
  Random random(55);
  for (int trial = 0; trial < 100; ++trial)
  {
    const PlanarDomain domain = RandomPolygon(random, 5);
    const CornerClassification plain = ClassifyCorners(domain);
    if (plain.corners.size() < 2)
    {
      continue;
    }
    ClassificationOptions options;
    const int index = random.Integer(-2, 2);
    // The position only has to be close to the corner.
    options.overrides = { { plain.corners[1].position + Point(1e-4, 0.0), index } };
    const CornerClassification result = ClassifyCorners(domain, options);
    EXPECT_EQ(result.corners[1].quarterIndex, index);
    EXPECT_TRUE(result.corners[1].overridden);
    EXPECT_FALSE(result.corners[1].tied);
    double minimum = std::numeric_limits<double>::infinity();
    ForEachAssignment(Angles(result),
      [&](const std::vector<int>& indices, double energy, int sum)
      {
        if (indices[1] == index)
        {
          minimum = std::min(minimum, energy + QuarterInside * std::abs(4 - sum));
        }
      });
    EXPECT_NEAR(result.energy, minimum, 1e-9 * (1.0 + minimum));
    EXPECT_GE(result.energy, plain.energy - 1e-9);
  }
  ClassificationOptions options;
  options.overrides = { { Point(1.0, 0.0), 1 } };
  EXPECT_TRUE(Refuses([&] { ClassifyCorners(Builtin("disk"), options); }, { "no corners" }));
}

TEST(CornerClassification, PrintedCoefficientWidensTheRanges)
{
  // With π/8 for an interior quarter the limits of k = 0 and 1 move from 6π/7 to 1 · π and beyond.
  ClassificationOptions printed;
  printed.coefficient = InteriorCoefficient::Printed;
  Random random(56);
  for (int trial = 0; trial < 200; ++trial)
  {
    const PlanarDomain domain = RandomPolygon(random, 4);
    const CornerClassification result = ClassifyCorners(domain, printed);
    double minimum = std::numeric_limits<double>::infinity();
    ForEachAssignment(Angles(result),
      [&](const std::vector<int>&, double energy, int sum)
      { minimum = std::min(minimum, energy + Pi / 8.0 * std::abs(4 - sum)); });
    EXPECT_NEAR(result.energy, minimum, 1e-9 * (1.0 + minimum));
    for (const ClassifiedCorner& corner : result.corners)
    {
      EXPECT_EQ(corner.scarce, Cheapest(corner.angle, Pi / 8.0));
    }
  }
}

TEST(CornerClassification, SplittingHalfIndicesMovesAQuarterInside)
{
  // A corner of 30° has k = 2, and the other corners do not.
  const double angle = Pi / 6.0;
  const CornerClassification plain = WithCorner(angle);
  ASSERT_EQ(CornerAtOrigin(plain).quarterIndex, 2);
  EXPECT_TRUE(plain.split.empty());
  ClassificationOptions options;
  options.splitHalves = true;
  const PlanarDomain domain =
    MakePlanarDomain({ { { 0.0, 0.0 }, { 1.0, 0.0 }, { std::cos(angle), std::sin(angle) } } });
  const CornerClassification result = ClassifyCorners(domain, options);
  EXPECT_EQ(CornerAtOrigin(result).quarterIndex, 1);
  ASSERT_EQ(result.split.size(), 1u);
  EXPECT_EQ(result.split[0].quarterIndex, 1);
  EXPECT_EQ(result.interiorQuarters, plain.interiorQuarters + 1);
  // On the bisector, near the corner.
  const Point place = result.split[0].position;
  EXPECT_NEAR(std::atan2(place.y(), place.x()), 0.5 * angle, 1e-12);
  EXPECT_NEAR(place.norm(), 0.25 * std::cos(0.5 * angle), 1e-12);

  options.overrides = { { Point(0.0, 0.0), 2 } };
  const CornerClassification kept = ClassifyCorners(domain, options);
  EXPECT_EQ(CornerAtOrigin(kept).quarterIndex, 2);
  EXPECT_TRUE(kept.split.empty());
}

TEST(CornerClassification, NamedDomains)
{
  const auto scenario = [](const char* name) { return ClassifyCorners(Builtin(name)); };
  EXPECT_EQ(scenario("square").scenario, Scenario::Balanced);
  EXPECT_NEAR(scenario("square").energy, 0.0, 1e-15);
  EXPECT_EQ(scenario("l-shape").scenario, Scenario::Balanced);
  EXPECT_NEAR(scenario("l-shape").energy, 0.0, 1e-15);
  EXPECT_EQ(scenario("disk").scenario, Scenario::Scarce);
  EXPECT_EQ(scenario("disk").interiorQuarters, 4);
  EXPECT_DOUBLE_EQ(scenario("disk").energy, Pi / 4.0);
  EXPECT_EQ(scenario("ring").scenario, Scenario::Balanced);
  EXPECT_EQ(scenario("ring").interiorQuarters, 0);
  // The paper: leaving the two flat angles unchanged costs less than giving each of them a quarter.
  const CornerClassification balanced = scenario("angular-balanced");
  EXPECT_EQ(balanced.scenario, Scenario::Balanced);
  for (const ClassifiedCorner& corner : balanced.corners)
  {
    EXPECT_EQ(corner.quarterIndex, corner.Cancellable() ? 0 : 1);
  }
  EXPECT_EQ(std::string(ScenarioName(Scenario::Excess)), "excess");
}

TEST(CornerClassification, IsInvariantUnderSimilarities)
{
  Random random(57);
  for (int trial = 0; trial < 50; ++trial)
  {
    const PlanarDomain domain = RandomPolygon(random, 6);
    const CornerClassification plain = ClassifyCorners(domain);
    for (const double scale : { 1e-6, 1.0, 1e6 })
    {
      const Similarity move{ random.Uniform(-Pi, Pi), scale, Point(0.0, 0.0) };
      const CornerClassification moved = ClassifyCorners(MakePlanarDomain(move(domain).loops));
      EXPECT_NEAR(moved.energy, plain.energy, 1e-9 * (1.0 + plain.energy));
      EXPECT_EQ(moved.scenario, plain.scenario);
      EXPECT_EQ(moved.interiorQuarters, plain.interiorQuarters);
    }
  }
}
}
}
