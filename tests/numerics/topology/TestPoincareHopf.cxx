#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "PoincareHopf.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Divides every side into `pieces` parts of unequal length.
std::vector<Loop> Subdivided(const std::vector<Loop>& loops, int pieces)
{
  std::vector<Loop> result;
  for (const Loop& loop : loops)
  {
    result.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      for (int piece = 0; piece < pieces; ++piece)
      {
        const double t = static_cast<double>(piece * piece) / (pieces * pieces);
        result.back().push_back((1.0 - t) * loop[i] + t * loop[(i + 1) % loop.size()]);
      }
    }
  }
  return result;
}

/// Returns a right-angled domain: a skyline of random heights over a base, with square islands.
PlanarDomain Skyline(Random& random, int towers, int islands)
{
  Loop outline = { { 0.0, 0.0 }, { static_cast<double>(towers), 0.0 } };
  for (int i = towers - 1; i >= 0; --i)
  {
    const double height = 2.0 + i % 2 + random.Uniform(0.1, 0.9);
    outline.emplace_back(i + 1.0, height);
    outline.emplace_back(static_cast<double>(i), height);
  }
  std::vector<Loop> loops = { outline };
  for (int i = 0; i < islands; ++i)
  {
    loops.push_back({ { i + 0.2, 0.2 }, { i + 0.2, 0.7 }, { i + 0.8, 0.7 }, { i + 0.8, 0.2 } });
  }
  return MakePlanarDomain(loops);
}

TEST(PoincareHopf, SmallestRotationKeepsTheCrossAligned)
{
  Random random(40);
  for (int i = 0; i < 1000; ++i)
  {
    const double turning = random.Uniform(-Pi, Pi);
    const double rotation = SmallestRotation(turning);
    EXPECT_LE(std::abs(rotation), 0.25 * Pi);
    EXPECT_NEAR(std::remainder(turning - rotation, 0.5 * Pi), 0.0, 1e-14);
  }
  // Eighth turns are smooth, and three of them to either side give the same rotation, also with
  // rounding to single precision.
  for (const double rounding : { -1e-6, -1e-15, 0.0, 1e-15, 1e-6 })
  {
    for (const double eighth : { -0.25 * Pi, 0.25 * Pi })
    {
      EXPECT_NEAR(SmallestRotation(eighth + rounding), eighth, 1e-5);
      EXPECT_EQ(SmallestRotationIndex(eighth + rounding), 0);
    }
    EXPECT_NEAR(SmallestRotation(0.75 * Pi + rounding), 0.25 * Pi, 1e-5);
    EXPECT_NEAR(SmallestRotation(-0.75 * Pi + rounding), 0.25 * Pi, 1e-5);
  }
}

TEST(PoincareHopf, RegularPolygons)
{
  // A corner that turns by more than π/4 has quarter index 1, all others 0.
  Random random(41);
  for (int n = 3; n <= 40; ++n)
  {
    for (int trial = 0; trial < 10; ++trial)
    {
      const Similarity move{ random.Uniform(-Pi, Pi), random.Uniform(0.1, 10.0),
        Point(random.Uniform(-5.0, 5.0), random.Uniform(-5.0, 5.0)) };
      const PlanarDomain polygon = move(MakePlanarDomain({ RegularPolygon(n) }));
      EXPECT_EQ(Required(polygon), n < 8 ? 4 - n : 4) << n;
    }
  }
}

TEST(PoincareHopf, NamedDomains)
{
  EXPECT_EQ(Required(Builtin("disk")), 4);
  EXPECT_EQ(Required(Builtin("ellipse")), 4);
  EXPECT_EQ(Required(Builtin("ring")), 0);
  EXPECT_EQ(Required(Builtin("square")), 0);
  EXPECT_EQ(Required(Builtin("rectangle")), 0);
  EXPECT_EQ(Required(Builtin("l-shape")), 0);
  EXPECT_EQ(Required(Builtin("quarter-disk")), 1);
}

TEST(PoincareHopf, ValenceAndTangentTurningAddUpToTheSum)
{
  // Half disk: the arc turns by π minus half a step at either end. That half step belongs to the
  // corners, which turn by π/2 plus half a step; the cross rotates by the excess over π/2.
  Loop loop;
  for (int i = 0; i <= 60; ++i)
  {
    loop.emplace_back(std::cos(Pi * i / 60), std::sin(Pi * i / 60));
  }
  const PoincareHopfCount half = CountQuarters({ loop }, 2);
  const double excess = 0.5 * Pi / 60.0;
  EXPECT_NEAR(half.tangentTurning, (Pi - 2.0 * excess) / (2.0 * Pi), 1e-12);
  EXPECT_NEAR(half.valence, 2.0 * excess / (2.0 * Pi), 1e-12);
  EXPECT_EQ(half.requiredInteriorQuarters, 2);
  EXPECT_EQ(half.eulerCharacteristic, 1);
  EXPECT_TRUE(half.Consistent());

  // An equilateral triangle has corners only: each turns by 120°, and the cross by 30°.
  const PoincareHopfCount triangle = CountQuarters({ RegularPolygon(3) }, 0);
  EXPECT_NEAR(triangle.valence, 0.25, 1e-14);
  EXPECT_NEAR(triangle.tangentTurning, 0.0, 1e-14);

  // A disk has no corners: the tangent turns once, and once in the opposite direction around an
  // island.
  const PoincareHopfCount ring = CountQuarters(Builtin("ring").loops, 0);
  EXPECT_EQ(ring.valence, 0.0);
  EXPECT_NEAR(ring.tangentTurning, 0.0, 1e-12);
  EXPECT_EQ(ring.eulerCharacteristic, 0);
}

TEST(PoincareHopf, RightAngledDomainsRequireNoSingularities)
{
  Random random(42);
  for (int trial = 0; trial < 40; ++trial)
  {
    const int towers = random.Integer(1, 9);
    const PlanarDomain domain = Skyline(random, towers, random.Integer(0, towers));
    const PlanarDomain moved = Similarity{ random.Uniform(-Pi, Pi), 3.0, Point(1.0, 2.0) }(domain);
    const PoincareHopfCount count = CountQuarters(moved.loops, 0);
    EXPECT_EQ(count.requiredInteriorQuarters, 0);
    EXPECT_EQ(count.eulerCharacteristic, domain.EulerCharacteristic());
    EXPECT_NEAR(count.valence, 0.0, 1e-12);
  }
}

TEST(PoincareHopf, IsInvariantUnderRotationScaleAndSubdivision)
{
  Random random(43);
  std::vector<PlanarDomain> domains = { Builtin("quarter-disk"), Builtin("l-shape"),
    Builtin("ring"), Skyline(random, 5, 3) };
  for (const int n : { 3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 20 })
  {
    domains.push_back(MakePlanarDomain({ RegularPolygon(n), RegularPolygon(3 + n % 5, 0.1) }));
  }
  for (std::size_t d = 0; d < domains.size(); ++d)
  {
    SCOPED_TRACE(d);
    const PoincareHopfCount plain = CountQuarters(domains[d].loops, 3);
    const auto expectSame = [&](const PoincareHopfCount& count)
    {
      EXPECT_EQ(count.requiredInteriorQuarters, plain.requiredInteriorQuarters);
      EXPECT_EQ(count.eulerCharacteristic, plain.eulerCharacteristic);
      EXPECT_EQ(count.givenInteriorQuarters, 3);
      EXPECT_NEAR(count.valence, plain.valence, 1e-9);
      EXPECT_NEAR(count.tangentTurning, plain.tangentTurning, 1e-9);
    };
    for (int trial = 0; trial < 20; ++trial)
    {
      const Similarity move{ random.Uniform(-Pi, Pi), std::exp(random.Uniform(-14.0, 14.0)),
        Point::Zero() };
      expectSame(CountQuarters(move(domains[d].loops), 3));
    }
    expectSame(CountQuarters(Subdivided(domains[d].loops, 4), 3));
  }
}

TEST(PoincareHopf, RoundingDoesNotDecideAboutCorners)
{
  // A dodecagon turns by exactly the corner angle at every vertex: no corner, whatever its
  // position.
  Random random(45);
  for (int trial = 0; trial < 50; ++trial)
  {
    const Similarity move{ random.Uniform(-Pi, Pi), random.Uniform(0.1, 10.0), Point::Zero() };
    const PoincareHopfCount count = CountQuarters({ move(RegularPolygon(12)) }, 0);
    EXPECT_NEAR(count.valence, 0.0, 1e-9);
    EXPECT_NEAR(count.tangentTurning, 1.0, 1e-9);
    EXPECT_EQ(count.requiredInteriorQuarters, 4);
  }
}

TEST(PoincareHopf, RequiredSumIsIndependentOfTheCornerAngle)
{
  // Turning angles below π/4 rotate the cross by the same angle, whether as a corner or as a curve.
  Random random(44);
  for (int trial = 0; trial < 20; ++trial)
  {
    const PlanarDomain domain = RandomSmoothDomain(random);
    for (const double angle : { 0.01, 0.1, 0.25 * Pi })
    {
      EXPECT_EQ(CountQuarters(domain.loops, 0, angle).requiredInteriorQuarters, 4);
    }
  }
}

TEST(PoincareHopf, CountsOfDrilledMeshesEqualThoseOfTheirDomains)
{
  for (const char* name : { "disk", "ring", "quarter-disk", "l-shape" })
  {
    SCOPED_TRACE(name);
    const PlanarDomain domain = Builtin(name);
    const double size = domain.Diagonal();
    const bool isRing = domain.loops.size() > 1;
    const Point place = isRing ? Point(0.7, 0.0) : Point(0.15 * size, 0.15 * size);
    const Configuration holes = { { place, 3, 0.02 * size },
      { place + Point(0.0, 0.08 * size), -1, 0.02 * size } };
    const TriangleMesh mesh = DrillHoles(domain, holes);
    const PoincareHopfCount count = CountMeshQuarters(PlanarTopology(mesh));
    EXPECT_EQ(count.requiredInteriorQuarters, Required(domain));
    EXPECT_EQ(count.eulerCharacteristic, domain.EulerCharacteristic());
    EXPECT_EQ(count.givenInteriorQuarters, 2);
  }
}

TEST(PoincareHopf, RejectsAnInconsistentSumWithBothNumbers)
{
  PoincareHopfCount count = CountQuarters(Builtin("disk").loops, -3);
  EXPECT_TRUE(Refuses([&] { RequireConsistent(count); },
    { "add up to -3", "Poincaré-Hopf", "requires 4", "total 7" }, Error::Kind::Inconsistent));
  count.givenInteriorQuarters = 4;
  EXPECT_NO_THROW(RequireConsistent(count));
}
}
}
