// Invariance of the count of quarter indices on domains of all kinds.

#include "BuiltinDomains.h"
#include "MakePlanarDomain.h"
#include "PoincareHopf.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace crossfield::test
{
namespace
{
/// Returns a star-shaped polygon around a centre with radii in the given range.
Loop RandomPolygon(Random& random, int corners, const Point& centre, double minimum, double maximum)
{
  Loop loop;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * Pi * (i + random.Uniform(0.0, 0.8)) / corners;
    loop.push_back(
      centre + random.Uniform(minimum, maximum) * Point(std::cos(angle), std::sin(angle)));
  }
  return loop;
}

/// Returns the loops of a random polygon with random polygonal islands, in random order.
std::vector<Loop> RandomLoops(Random& random)
{
  std::vector<Loop> loops = { RandomPolygon(
    random, random.Integer(3, 12), Point::Zero(), 8.0, 12.0) };
  const std::vector<Point> centres = { { 1.0, 1.0 }, { -1.0, 1.0 }, { -1.0, -1.0 }, { 1.0, -1.0 } };
  // A triangle of circumradius 8 mostly contains the circle of radius 4; islands stay within 1.8.
  const int islands = random.Integer(0, 4);
  for (int i = 0; i < islands; ++i)
  {
    const Point centre = 0.7 * centres[std::size_t(i)];
    loops.push_back(RandomPolygon(random, random.Integer(3, 8), centre, 0.1, 0.6));
  }
  return loops;
}

bool IsSound(const std::vector<Loop>& loops)
{
  try
  {
    MakePlanarDomain(loops);
    return true;
  }
  catch (const Error&)
  {
    return false;
  }
}

void ExpectIdentities(const PlanarDomain& domain)
{
  const PoincareHopfCount count = CountQuarters(domain.loops, 0);
  int quarters = 0;
  for (const CountedCorner& corner : count.corners)
  {
    quarters += corner.quarterIndex;
  }
  EXPECT_EQ(count.requiredInteriorQuarters, 4 * domain.EulerCharacteristic() - quarters);
  EXPECT_NEAR(4.0 * (count.valence + count.tangentTurning), count.requiredInteriorQuarters, 1e-9);
  // The contributions of the loops add up to the sums.
  ASSERT_EQ(count.loops.size(), domain.loops.size());
  double valence = 0.0;
  double turning = 0.0;
  for (std::size_t l = 0; l < count.loops.size(); ++l)
  {
    const LoopCount& part = count.loops[l];
    valence += part.valence;
    turning += part.tangentTurning;
    EXPECT_NEAR(
      4.0 * (part.valence + part.tangentTurning), (l == 0 ? 4 : -4) - part.cornerQuarters, 1e-9);
  }
  EXPECT_NEAR(valence, count.valence, 1e-12);
  EXPECT_NEAR(turning, count.tangentTurning, 1e-12);
}

TEST(PoincareHopfInvariance, BothCountsAgreeOnEveryBuiltinDomain)
{
  for (const std::string& name : BuiltinDomainNames())
  {
    SCOPED_TRACE(name);
    ExpectIdentities(Builtin(name));
    ExpectIdentities(Builtin(name, 0.01));
  }
}

TEST(PoincareHopfInvariance, RandomPolygonsWithIslands)
{
  Random random(60);
  int domains = 0;
  while (domains < 200)
  {
    const std::vector<Loop> loops = RandomLoops(random);
    if (!IsSound(loops))
    {
      continue;
    }
    ++domains;
    const PlanarDomain domain = MakePlanarDomain(loops);
    ExpectIdentities(domain);
    const PoincareHopfCount plain = CountQuarters(domain.loops, 0);

    std::vector<Loop> other = loops;
    const auto expectSame = [&](double tolerance)
    {
      const PoincareHopfCount count = CountQuarters(MakePlanarDomain(other).loops, 0);
      EXPECT_EQ(count.requiredInteriorQuarters, plain.requiredInteriorQuarters);
      EXPECT_EQ(count.eulerCharacteristic, plain.eulerCharacteristic);
      EXPECT_EQ(count.corners.size(), plain.corners.size());
      EXPECT_NEAR(count.valence, plain.valence, tolerance);
      EXPECT_NEAR(count.tangentTurning, plain.tangentTurning, tolerance);
    };
    // Reversal and renumbering of loops.
    for (Loop& loop : other)
    {
      std::rotate(loop.begin(), loop.begin() + random.Integer(0, static_cast<int>(loop.size()) - 1),
        loop.end());
      if (random.Integer(0, 1) == 1)
      {
        std::reverse(loop.begin(), loop.end());
      }
    }
    random.Shuffle(other);
    expectSame(1e-12);
    // Rotation and scaling.
    for (const double scale : { 1e-6, 1e6 })
    {
      other = Similarity{ random.Uniform(-Pi, Pi), scale, Point(0.0, 0.0) }(loops);
      expectSame(1e-9);
    }
    // Subdivision.
    other = loops;
    for (Loop& loop : other)
    {
      Loop fine;
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        const Point& next = loop[(i + 1) % loop.size()];
        fine.push_back(loop[i]);
        fine.push_back(0.5 * (loop[i] + next));
        fine.push_back(0.25 * loop[i] + 0.75 * next);
      }
      loop = fine;
    }
    expectSame(1e-9);
  }
}

TEST(PoincareHopfInvariance, RegularPolygonsUpToTwelve)
{
  for (int n = 3; n <= 12; ++n)
  {
    const PlanarDomain polygon = MakePlanarDomain({ RegularPolygon(n) });
    ExpectIdentities(polygon);
    EXPECT_EQ(CountQuarters(polygon.loops, 0).requiredInteriorQuarters, n < 8 ? 4 - n : 4) << n;
  }
}

TEST(PoincareHopfInvariance, AngularDomainsOfThePaper)
{
  const std::map<std::string, int> expected = { { "angular-balanced", 0 },
    { "angular-negative", -2 }, { "angular-positive", 2 }, { "angular-hole", -2 },
    { "hexagonal", -2 }, { "star", -1 } };
  for (const auto& [name, quarters] : expected)
  {
    EXPECT_EQ(CountQuarters(Builtin(name).loops, 0).requiredInteriorQuarters, quarters) << name;
  }
  const auto flat = [](const char* name)
  {
    int number = 0;
    for (const Corner& corner : FindCorners(Builtin(name).loops))
    {
      number += corner.Cancellable() ? 1 : 0;
    }
    return number;
  };
  EXPECT_EQ(flat("angular-balanced"), 2);
  EXPECT_EQ(flat("angular-negative"), 0);
  EXPECT_EQ(flat("angular-positive"), 4);
  EXPECT_EQ(flat("angular-hole"), 4);
  // The paper: V = 1/2 due to the external boundary; the tangent of the hole turns by −1.
  const PoincareHopfCount hole = CountQuarters(Builtin("angular-hole").loops, 0);
  EXPECT_NEAR(hole.valence, 0.5, 1e-12);
  EXPECT_NEAR(hole.loops[0].valence, 0.5, 1e-12);
  EXPECT_NEAR(hole.tangentTurning, -1.0, 1e-12);
  EXPECT_NEAR(hole.loops[1].tangentTurning, -1.0, 1e-12);
}

TEST(PoincareHopfInvariance, ChosenIndicesReplaceTheSmallestRotations)
{
  Random random(61);
  for (int trial = 0; trial < 100; ++trial)
  {
    const PlanarDomain domain =
      MakePlanarDomain({ RandomPolygon(random, 6, Point::Zero(), 0.5, 1.0) });
    std::vector<CornerChoice> choices;
    int sum = 0;
    for (const Point& point : domain.loops[0])
    {
      // Positions rounded to single precision.
      choices.push_back({ point.cast<float>().cast<double>(), random.Integer(-2, 2) });
      sum += choices.back().quarterIndex;
    }
    random.Shuffle(choices);
    const PoincareHopfCount count = CountQuarters(domain.loops, 0, DefaultCornerAngle, choices);
    EXPECT_EQ(count.requiredInteriorQuarters, 4 - sum);
    EXPECT_EQ(count.corners.size(), 6u);
    EXPECT_NEAR(4.0 * (count.valence + count.tangentTurning), 4 - sum, 1e-9);
    EXPECT_TRUE(count.hasChoices);
  }
}

TEST(PoincareHopfInvariance, RejectsChoicesOffTheBoundary)
{
  const PlanarDomain square = Builtin("square");
  const auto count = [&](const std::vector<CornerChoice>& choices)
  { CountQuarters(square.loops, 0, DefaultCornerAngle, choices); };
  EXPECT_TRUE(Refuses(
    [&] {
      count({ { Point(0.5, 0.5), 1 } });
    },
    { "(0.5, 0.5)", "not a vertex" }));
  EXPECT_TRUE(Refuses(
    [&] {
      count({ { Point(1.0, 1.0), 1 }, { Point(1.0, 1.0), 0 } });
    },
    { "two chosen" }));
  const double none = std::nan("");
  EXPECT_TRUE(Refuses([&] { count({ { Point(none, 0.0), 1 } }); }, { "not a vertex" }));
}

TEST(PoincareHopfInvariance, ReasonStatesWhatToAddOrRemove)
{
  PoincareHopfCount count = CountQuarters(Builtin("disk").loops, 6);
  EXPECT_NE(
    ConsistencyReason(count).find("add singularities of total -2 or remove some of total 2."),
    std::string::npos);
  count.givenInteriorQuarters = 4;
  EXPECT_EQ(ConsistencyReason(count),
    "The quarter indices of the singularities add up to 4, as the "
    "Poincaré-Hopf theorem requires on this domain.");
}
}
}
