#include "HardCases.h"

#include "BuiltinDomains.h"
#include "DomainQueries.h"
#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns the unit disk with circular islands.
PlanarDomain Islands(const std::vector<Singularity>& circles)
{
  std::vector<Loop> loops = Builtin("disk", 0.05).loops;
  for (const Singularity& circle : circles)
  {
    loops.push_back(RegularPolygon(
      static_cast<int>(2.0 * Pi * circle.radius / 0.05), circle.radius, circle.position));
  }
  return MakePlanarDomain(loops);
}

PlanarDomain FlatEllipse()
{
  BuiltinDomain ellipse;
  ellipse.name = "ellipse";
  ellipse.width = 6.0;
  ellipse.height = 1.2;
  ellipse.edgeLength = 0.06;
  return MakePlanarDomain(MakeBuiltinDomain(ellipse));
}

HardCase Drill(const std::string& name, const PlanarDomain& domain, const Configuration& holes,
  double meshSize = 0.05)
{
  DrillOptions options;
  options.meshSize = meshSize;
  return { name, DrillHoles(domain, holes, options) };
}
}

std::vector<HardCase> NamedHardCases()
{
  const PlanarDomain disk = Builtin("disk", 0.05);
  const PlanarDomain ring = Builtin("ring", 0.05);
  const Singularity right{ { 0.4, 0.0 }, 0, 0.15 };
  const Singularity left{ { -0.4, 0.1 }, 0, 0.15 };
  const Singularity below{ { 0.0, -0.5 }, 0, 0.1 };
  return {
    Drill("diskV4", disk,
      { { { 0.0, 0.0 }, 1, 0.01 }, { { -0.2, 0.2 }, 1, 0.01 }, { { 0.2, -0.2 }, 1, 0.01 },
        { { -0.2, -0.2 }, 1, 0.01 } }),
    Drill("five around one", disk,
      Join(OnCircle(5, 0.6, 0.0, 1, 0.05), { { { 0.0, 0.0 }, -1, 0.05 } })),
    Drill("six and two", disk,
      Join(OnCircle(6, 0.7, 0.0, 1, 0.05),
        { { { 0.2, 0.0 }, -1, 0.05 }, { { -0.2, 0.0 }, -1, 0.05 } })),
    Drill("flat ellipse", FlatEllipse(),
      { { { 1.5, 0.25 }, 1, 0.05 }, { { -1.5, 0.25 }, 1, 0.05 }, { { -1.5, -0.25 }, 1, 0.05 },
        { { 1.5, -0.25 }, 1, 0.05 } },
      0.06),
    Drill("ring", ring, Join(OnCircle(4, 0.8, 0.0, 1, 0.05), OnCircle(4, 0.55, Pi / 4, -1, 0.05))),
    Drill(
      "ring in rays", ring, Join(OnCircle(4, 0.8, 0.0, 1, 0.05), OnCircle(4, 0.55, 0.0, -1, 0.05))),
    Drill("two islands", Islands({ right, left }), OnCircle(4, 0.75, 0.4, -1, 0.04)),
    Drill("three islands", Islands({ right, left, below }), OnCircle(8, 0.75, 0.4, -1, 0.04)),
    Drill("two islands, both signs", Islands({ right, left }),
      Join(OnCircle(4, 0.75, 0.4, 1, 0.04),
        Join(OnCircle(4, 0.2, 0.0, -1, 0.04), OnCircle(4, 0.65, 0.4 + Pi / 4, -1, 0.04)))),
  };
}

HardCase RandomHardCase(int number)
{
  Random random(static_cast<std::uint32_t>(7000 + number));
  const PlanarDomain domain = RandomSmoothDomain(random, 140);
  const int negative = random.Integer(0, 2);
  const auto count = static_cast<std::size_t>(4 + 2 * negative);
  Configuration holes;
  for (int attempt = 0; holes.size() < count; ++attempt)
  {
    if (attempt % 1000 == 999)
    {
      holes.clear(); // restart: no more holes fit
    }
    const Point place(random.Uniform(-1.5, 1.5), random.Uniform(-1.5, 1.5));
    const double radius = random.Uniform(0.02, 0.08);
    bool free = SignedDistance(place, domain) > 2.0 * radius + 0.1;
    for (const Singularity& other : holes)
    {
      free = free && (other.position - place).norm() > 1.5 * (other.radius + radius) + 0.05;
    }
    if (free)
    {
      const bool positive = holes.size() < count - static_cast<std::size_t>(negative);
      holes.push_back({ place, positive ? 1 : -1, radius });
    }
  }
  return Drill("random " + std::to_string(number), domain, holes, 0.06);
}
}
