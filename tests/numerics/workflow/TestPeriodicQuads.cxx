// Periodic sides: equal numbers of edges, nodes that match to rounding, good quads, refusals.

#include "QuadWorkflow.h"

#include "Index.h"
#include "MakePlanarDomain.h"
#include "NodePairs.h"
#include "QuadSides.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// A domain with sides 'a' and 'b' that are images of each other, and 'low' and 'high' between them.
struct PeriodicDomain
{
  PlanarDomain domain;
  BoundarySides sides;
  double angle = 0.0; ///< Of the motion from a to b.
};

/// Moves points of the unit square to the domain.
using Chart = std::function<Point(double, double)>;

PeriodicDomain MakeDomain(const Chart& chart, Random& random, int holes, double angle)
{
  const int across = random.Integer(12, 30);
  const int along = random.Integer(12, 40);
  Loop outer;
  std::vector<std::string> names;
  const auto add = [&](int count, const std::string& name, auto place)
  {
    for (int i = 0; i < count; ++i)
    {
      outer.push_back(place(static_cast<double>(i) / count));
      names.push_back(name);
    }
  };
  add(along, "low", [&](double t) { return chart(t, 0.0); });
  add(across, "b", [&](double t) { return chart(1.0, t); });
  add(along, "high", [&](double t) { return chart(1.0 - t, 1.0); });
  add(across, "a", [&](double t) { return chart(0.0, 1.0 - t); });
  std::vector<Loop> loops = { outer };
  for (int hole = 0; hole < holes; ++hole)
  {
    const Point centre = chart((hole + random.Uniform(0.4, 0.6)) / holes, random.Uniform(0.4, 0.6));
    double distance = DistanceToLoop(centre, outer);
    for (std::size_t other = 1; other < loops.size(); ++other)
    {
      distance = std::min(distance, DistanceToLoop(centre, loops[other]));
    }
    loops.push_back(
      RegularPolygon(random.Integer(16, 40), random.Uniform(0.25, 0.5) * distance, centre));
  }
  Similarity place;
  place.angle = random.Uniform(0.0, 6.0);
  place.scale = std::pow(10.0, random.Uniform(-2.0, 2.0));
  place.shift = { random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0) };
  PeriodicDomain result;
  result.domain = MakePlanarDomain(place(loops));
  result.angle = angle;
  // MakePlanarDomain may begin loops elsewhere.
  SegmentNames segments;
  for (const Loop& loop : result.domain.loops)
  {
    segments.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point middle = 0.5 * (loop[i] + loop[(i + 1) % loop.size()]);
      std::size_t nearest = 0;
      double distance = 1e300;
      for (std::size_t k = 0; k < outer.size(); ++k)
      {
        const Point other = place(Point(0.5 * (outer[k] + outer[(k + 1) % outer.size()])));
        if ((other - middle).norm() < distance)
        {
          distance = (other - middle).norm();
          nearest = k;
        }
      }
      const bool isOuter = distance < 1e-9 * result.domain.Diagonal();
      segments.back().push_back(isOuter ? names[nearest] : std::string());
    }
  }
  result.sides = NameSides(result.domain, segments);
  return result;
}

/// A passage between two wavy translates.
PeriodicDomain RandomPassage(Random& random)
{
  const double width = random.Uniform(1.0, 2.5);
  const double wave = random.Uniform(-0.2, 0.2);
  const double shear = random.Uniform(-0.5, 0.5);
  const double rise = random.Uniform(-0.4, 0.4);
  const double bulge = random.Uniform(-0.15, 0.15);
  const Chart chart = [=](double s, double t) -> Point
  {
    const double x = width * s + wave * std::sin(2.0 * Pi * t) + shear * t;
    return { x, t + rise * s + bulge * std::sin(Pi * s) * (1.0 - 2.0 * t) };
  };
  return MakeDomain(chart, random, random.Integer(0, 2), 0.0);
}

/// A sector between a curve and its rotated copy.
PeriodicDomain RandomSector(Random& random)
{
  const double inner = random.Uniform(0.4, 1.5);
  const double angle = random.Uniform(0.3, 2.5);
  const double twist = random.Uniform(-0.6, 0.6);
  const double wave = random.Uniform(-0.1, 0.1);
  const Chart chart = [=](double s, double t) -> Point
  {
    const double radius = inner + t;
    const double at = angle * (s - 1.0) + twist * t * t + wave * std::sin(2.0 * Pi * t);
    return radius * Point(std::cos(at), std::sin(at));
  };
  return MakeDomain(chart, random, random.Integer(0, 2), angle);
}

QuadRequest RequestFor(const PeriodicDomain& domain, int count)
{
  QuadRequest request;
  request.sides = domain.sides;
  request.quadCount = count;
  request.periodicNames = { { "a", "b" } };
  return request;
}

/// Expects equal numbers of edges, and nodes of b at the images of those of a.
void ExpectPeriodic(const PeriodicDomain& domain, const QuadWorkflowResult& result)
{
  const QuadMesh& mesh = result.quads.mesh;
  ASSERT_EQ(result.periodic.size(), 1U);
  const PeriodicReport& report = result.periodic[0];
  EXPECT_NEAR(report.sides.motion.angle, domain.angle, 1e-12);
  const auto first = PiecesOf(mesh, domain.sides.Find("a"));
  const auto second = PiecesOf(mesh, domain.sides.Find("b"));
  ASSERT_EQ(first.size(), 1U);
  ASSERT_EQ(second.size(), 1U);
  ASSERT_EQ(first[0].size(), second[0].size());
  EXPECT_EQ(report.edges + 1, static_cast<int>(first[0].size()));
  double worst = 0.0;
  for (std::size_t i = 0; i < first[0].size(); ++i)
  {
    const Point image = report.sides.motion(mesh.points[Index(first[0][i])].place);
    worst = std::max(
      worst, (image - mesh.points[Index(second[0][second[0].size() - 1 - i])].place).norm());
  }
  EXPECT_LE(worst, 1e-12 * domain.domain.Diagonal());
  EXPECT_EQ(report.mismatch, worst);
  // nodes of b are on the boundary, too
  const std::vector<LoopArc> arcs(domain.domain.loops.begin(), domain.domain.loops.end());
  for (const int point : second[0])
  {
    const Point& place = mesh.points[Index(point)].place;
    EXPECT_LE(
      (arcs[0].At(arcs[0].Nearest(place)) - place).norm(), 1e-10 * domain.domain.Diagonal());
  }
  EXPECT_EQ(result.quads.quality.inverted, 0);
}
}

namespace
{
struct Sample
{
  double ratio;
  double mean;
};
Sample Compare(const PeriodicDomain& domain, QuadRequest request, int trial)
{
  const QuadWorkflowResult result = MakeQuadMesh(domain.domain, request);
  ExpectPeriodic(domain, result);
  request.periodicNames.clear();
  const QuadWorkflowResult without = MakeQuadMesh(domain.domain, request);
  const double ratio = result.quads.quality.jacobian.min / without.quads.quality.jacobian.min;
  std::printf("%d: %d/%d quads, jacobian %.3f of %.3f, mean %.3f of %.3f\n", trial,
    int(result.quads.mesh.quads.size()), int(without.quads.mesh.quads.size()),
    result.quads.quality.jacobian.min, without.quads.quality.jacobian.min,
    result.quads.quality.jacobian.mean, without.quads.quality.jacobian.mean);
  fflush(stdout);
  return { ratio, result.quads.quality.jacobian.mean / without.quads.quality.jacobian.mean };
}
int Seed(int base)
{
  const char* s = std::getenv("SEED");
  return s ? base + std::atoi(s) : base;
}
}

TEST(PeriodicQuads, MatchOnRandomDomains)
{
  Random random(Seed(20260));
  for (int trial = 0; trial < 24; ++trial)
  {
    const PeriodicDomain domain = trial % 2 == 0 ? RandomPassage(random) : RandomSector(random);
    SCOPED_TRACE(trial);
    Compare(domain, RequestFor(domain, random.Integer(150, 900)), trial);
  }
}

TEST(PeriodicQuads, MatchWithLayersAndNumbers)
{
  Random random(Seed(20263));
  for (int trial = 0; trial < 16; ++trial)
  {
    const PeriodicDomain domain = trial % 2 == 0 ? RandomPassage(random) : RandomSector(random);
    SCOPED_TRACE(trial);
    QuadRequest request = RequestFor(domain, random.Integer(300, 1200));
    const double size = std::sqrt(domain.domain.Area() / request.quadCount);
    for (const char* name : { "low", "high" })
    {
      if (random.Integer(0, 2) > 0)
      {
        LayerPrescription layer;
        layer.name = name;
        layer.first = random.Uniform(0.02, 0.2) * size;
        layer.growth = random.Uniform(1.2, 1.5);
        request.layers.push_back(layer);
      }
    }
    if (domain.domain.loops.size() > 1 && random.Integer(0, 1) == 0)
    {
      LayerPrescription layer;
      layer.name = "hole0";
      layer.first = random.Uniform(0.05, 0.2) * size;
      request.layers.push_back(layer);
    }
    try
    {
      Compare(domain, request, trial);
    }
    catch (const Error& e)
    {
      std::printf("%d: %s\n", trial, e.what());
      request.periodicNames.clear();
      try
      {
        MakeQuadMesh(domain.domain, request);
        std::printf("   works without\n");
      }
      catch (const Error& e2)
      {
        std::printf("   and without: %s\n", e2.what());
      }
    }
  }
}

TEST(PeriodicQuads, DISABLED_Large)
{
  Random random(Seed(7));
  for (int trial = 0; trial < 4; ++trial)
  {
    const PeriodicDomain domain = trial % 2 == 0 ? RandomPassage(random) : RandomSector(random);
    SCOPED_TRACE(trial);
    if (trial == 1)
    {
      for (int n : { 300, 1000, 3000, 10000, 20000 })
      {
        QuadRequest r = RequestFor(domain, n);
        try
        {
          MakeQuadMesh(domain.domain, r);
          std::printf("%d works\n", n);
        }
        catch (const Error& e)
        {
          std::printf("%d %s\n", n, e.what());
        }
        r.periodicNames.clear();
        auto w = MakeQuadMesh(domain.domain, r);
        for (auto& c : w.corners)
          std::printf("corner %g %g index %d\n", c.position.x(), c.position.y(), c.quarterIndex);
        for (auto& c : w.singularities)
          std::printf("sing %g %g index %d\n", c.position.x(), c.position.y(), c.quarterIndex);
        auto m = MeasureSides(w.quads.mesh);
        for (size_t i = 0; i < m.size(); ++i)
          std::printf("%s %d %g\n", w.quads.mesh.sideNames[i].c_str(), m[i].edges, m[i].length);
        for (auto& e : w.events)
          std::printf("%s\n", e.c_str());
      }
      continue;
    }
    Compare(domain, RequestFor(domain, 20000), trial);
  }
}
}
