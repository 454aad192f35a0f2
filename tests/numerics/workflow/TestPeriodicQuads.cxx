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
    const double size = (chart(0.5, 1.0) - chart(0.5, 0.0)).norm();
    const Point centre = chart((hole + random.Uniform(0.4, 0.6)) / holes, random.Uniform(0.4, 0.6));
    loops.push_back(
      RegularPolygon(random.Integer(16, 40), random.Uniform(0.08, 0.16) * size, centre));
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

TEST(PeriodicQuads, MatchOnRandomDomains)
{
  Random random(20260);
  double sum = 0.0;
  int count = 0;
  for (int trial = 0; trial < 24; ++trial)
  {
    const PeriodicDomain domain = trial % 2 == 0 ? RandomPassage(random) : RandomSector(random);
    SCOPED_TRACE(trial);
    QuadRequest request = RequestFor(domain, random.Integer(150, 900));
    const QuadWorkflowResult result = MakeQuadMesh(domain.domain, request);
    ExpectPeriodic(domain, result);
    request.periodicNames.clear();
    const QuadWorkflowResult without = MakeQuadMesh(domain.domain, request);
    const double ratio = result.quads.quality.jacobian.min / without.quads.quality.jacobian.min;
    std::printf("%d: %d/%d quads, jacobian %.3f of %.3f, mean %.3f of %.3f\n", trial,
      int(result.quads.mesh.quads.size()), int(without.quads.mesh.quads.size()),
      result.quads.quality.jacobian.min, without.quads.quality.jacobian.min,
      result.quads.quality.jacobian.mean, without.quads.quality.jacobian.mean);
    sum += ratio;
    ++count;
  }
  std::printf("mean %.3f\n", sum / count);
}
}
