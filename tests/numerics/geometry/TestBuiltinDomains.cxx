#include "BuiltinDomains.h"
#include "MakePlanarDomain.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield::test
{
namespace
{
double Perimeter(const std::vector<Loop>& loops)
{
  double length = 0.0;
  for (const Loop& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      length += (loop[(i + 1) % loop.size()] - loop[i]).norm();
    }
  }
  return length;
}

double LongestSegment(const std::vector<Loop>& loops)
{
  double longest = 0.0;
  for (const Loop& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      longest = std::max(longest, (loop[(i + 1) % loop.size()] - loop[i]).norm());
    }
  }
  return longest;
}

struct Exact
{
  const char* name;
  double area;
  double perimeter;
};

/// Returns the exact values for the default lengths: radius 1, inner radius 0.4, width 1, height
/// 0.5.
std::vector<Exact> CurvedDomains()
{
  return { { "disk", Pi, 2.0 * Pi }, { "ring", Pi * (1.0 - 0.16), 2.0 * Pi * 1.4 },
    { "quarter-disk", 0.25 * Pi, 2.0 + 0.5 * Pi },
    { "ellipse", 0.125 * Pi, 2.0 * std::comp_ellint_2(std::sqrt(0.75)) } };
}

TEST(BuiltinDomains, CurvesConvergeAtSecondOrder)
{
  for (const Exact& exact : CurvedDomains())
  {
    SCOPED_TRACE(exact.name);
    std::vector<double> sizes;
    std::vector<double> areaErrors;
    std::vector<double> perimeterErrors;
    for (const double size : { 0.02, 0.01, 0.005, 0.0025 })
    {
      BuiltinDomain shape;
      shape.name = exact.name;
      // An integer number of segments on each quarter of each curve, so that halving the size
      // halves them.
      shape.edgeLength = 0.5 * Pi * size;
      const std::vector<Loop> loops = MakeBuiltinDomain(shape);
      sizes.push_back(size);
      areaErrors.push_back(exact.area - MakePlanarDomain(loops).Area());
      perimeterErrors.push_back(exact.perimeter - Perimeter(loops));
    }
    // Arcs of any radius lose the same area per length, so the errors of a ring even cancel.
    EXPECT_GE(ConvergenceRate(sizes, areaErrors), 1.98);
    EXPECT_NEAR(ConvergenceRate(sizes, perimeterErrors), 2.0, 0.02);
    EXPECT_LT(std::abs(areaErrors.back()), 1e-4);
  }
}

TEST(BuiltinDomains, PolygonsAreExact)
{
  BuiltinDomain shape;
  shape.width = 3.0;
  shape.height = 0.25;
  const auto check = [&](const char* name, double area, double perimeter)
  {
    shape.name = name;
    const std::vector<Loop> loops = MakeBuiltinDomain(shape);
    EXPECT_DOUBLE_EQ(MakePlanarDomain(loops).Area(), area) << name;
    EXPECT_DOUBLE_EQ(Perimeter(loops), perimeter) << name;
  };
  check("square", 9.0, 12.0);
  check("rectangle", 0.75, 6.5);
  check("l-shape", 6.75, 12.0);
}

TEST(BuiltinDomains, CurveSegmentsRespectTheEdgeLength)
{
  Random random(3);
  for (int trial = 0; trial < 50; ++trial)
  {
    BuiltinDomain shape;
    shape.edgeLength = random.Uniform(0.01, 0.3);
    shape.innerRadius = random.Uniform(0.1, 0.9);
    shape.width = random.Uniform(0.5, 2.0);
    shape.height = random.Uniform(0.5, 2.0);
    for (const char* name : { "disk", "ring", "ellipse" })
    {
      shape.name = name;
      EXPECT_LE(LongestSegment(MakeBuiltinDomain(shape)), shape.edgeLength * (1.0 + 1e-12)) << name;
    }
  }
}

TEST(BuiltinDomains, EveryNameMakesAnOrientedDomain)
{
  ASSERT_FALSE(BuiltinDomainNames().empty());
  for (const std::string& name : BuiltinDomainNames())
  {
    SCOPED_TRACE(name);
    BuiltinDomain shape;
    shape.name = name;
    const std::vector<Loop> loops = MakeBuiltinDomain(shape);
    ASSERT_FALSE(loops.empty());
    EXPECT_NEAR(SignedArea(loops[0]), SignedArea(MakePlanarDomain(loops).loops[0]), 1e-14);
    for (const Loop& loop : loops)
    {
      EXPECT_GT(SignedArea(loop), 0.0);
    }
  }
}

TEST(BuiltinDomains, RoundShapesKeepTheirSymmetry)
{
  for (const char* name : { "disk", "ring", "ellipse" })
  {
    for (const double edgeLength : { 0.0, 0.07, 0.3 })
    {
      const PlanarDomain domain = Builtin(name, edgeLength);
      for (const Loop& loop : domain.loops)
      {
        for (const Point& point : loop)
        {
          // The mirror images of each vertex are vertices.
          const auto has = [&](const Point& image)
          {
            return std::any_of(loop.begin(), loop.end(),
              [&](const Point& other) { return (other - image).norm() < 1e-14; });
          };
          EXPECT_TRUE(has({ -point.x(), point.y() }) && has({ point.x(), -point.y() })) << name;
        }
      }
    }
  }
}

TEST(BuiltinDomains, RefusesAnUnknownNameAndListsTheKnownOnes)
{
  BuiltinDomain shape;
  shape.name = "klein-bottle";
  std::vector<std::string> parts = BuiltinDomainNames();
  parts.push_back("'klein-bottle'");
  EXPECT_TRUE(Refuses([&] { MakeBuiltinDomain(shape); }, parts));
}

TEST(BuiltinDomains, RefusesLengthsThatAreNotPositive)
{
  struct Case
  {
    const char* name;
    double BuiltinDomain::*length;
    const char* words;
  };
  const std::vector<Case> cases = { { "disk", &BuiltinDomain::radius, "radius" },
    { "quarter-disk", &BuiltinDomain::radius, "radius" },
    { "ring", &BuiltinDomain::radius, "radius" },
    { "ring", &BuiltinDomain::innerRadius, "inner radius" },
    { "ellipse", &BuiltinDomain::width, "width" }, { "ellipse", &BuiltinDomain::height, "height" },
    { "square", &BuiltinDomain::width, "width" }, { "rectangle", &BuiltinDomain::width, "width" },
    { "rectangle", &BuiltinDomain::height, "height" },
    { "l-shape", &BuiltinDomain::width, "width" } };
  for (const Case& test : cases)
  {
    for (const double bad : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
           std::numeric_limits<double>::infinity() })
    {
      BuiltinDomain shape;
      shape.name = test.name;
      shape.*test.length = bad;
      EXPECT_TRUE(Refuses([&] { MakeBuiltinDomain(shape); }, { test.words }))
        << test.name << " " << bad;
    }
  }
  BuiltinDomain ring;
  ring.name = "ring";
  ring.innerRadius = ring.radius;
  EXPECT_TRUE(Refuses([&] { MakeBuiltinDomain(ring); }, { "smaller than its radius" }));
  BuiltinDomain disk;
  for (const double bad : { -0.1, std::numeric_limits<double>::quiet_NaN() })
  {
    disk.edgeLength = bad;
    EXPECT_TRUE(Refuses([&] { MakeBuiltinDomain(disk); }, { "edge length" }));
  }
}
}
}
