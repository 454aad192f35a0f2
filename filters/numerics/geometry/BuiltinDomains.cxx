#include "BuiltinDomains.h"

#include "AngularDomains.h"
#include "Error.h"

#include <cmath>
#include <functional>
#include <map>

namespace crossfield
{
namespace
{
double RequirePositive(double length, const char* what)
{
  if (!(length > 0.0) || !std::isfinite(length))
  {
    throw Error(std::string("The ") + what + " of a built-in domain must be a positive length.");
  }
  return length;
}

/// Returns points on an arc of an ellipse centred at the origin, without the end point.
Loop Arc(double semiAxisX, double semiAxisY, double from, double to, double edgeLength)
{
  // The length is that of the circle with the larger semi-axis, so no segment exceeds the edge
  // length. Four equal quarters preserve the symmetries of the shape.
  const double length = std::max(semiAxisX, semiAxisY) * (to - from);
  const double quarters = (to - from) / (0.5 * Pi);
  const double segments =
    quarters * std::max(2.0, std::ceil(length / quarters / edgeLength * (1.0 - 1e-12)));
  // A mesh with a million boundary edges has at least ten times as many triangles.
  if (!(segments < 1e6))
  {
    throw Error("The edge length of a built-in domain would cut its curve into more than a million "
                "segments; give a larger one.");
  }
  const auto count = static_cast<int>(segments);
  Loop points;
  for (int i = 0; i < count; ++i)
  {
    const double angle = from + (to - from) * i / count;
    points.emplace_back(semiAxisX * std::cos(angle), semiAxisY * std::sin(angle));
  }
  return points;
}

/// Function that makes the loops of a shape. A side of a polygon remains one segment; the mesher
/// divides it.
using Maker = std::function<std::vector<Loop>(const BuiltinDomain&)>;

double EdgeLength(const BuiltinDomain& domain, double width, double height)
{
  return domain.edgeLength > 0.0 ? domain.edgeLength : std::hypot(width, height) / 40.0;
}

std::vector<Loop> Disk(const BuiltinDomain& domain)
{
  const double r = RequirePositive(domain.radius, "radius");
  return { Arc(r, r, 0.0, 2.0 * Pi, EdgeLength(domain, 2.0 * r, 2.0 * r)) };
}

std::vector<Loop> Ring(const BuiltinDomain& domain)
{
  const double inner = RequirePositive(domain.innerRadius, "inner radius");
  if (!(inner < domain.radius))
  {
    throw Error("The inner radius of a ring must be smaller than its radius.");
  }
  std::vector<Loop> loops = Disk(domain);
  const double edgeLength = EdgeLength(domain, 2.0 * domain.radius, 2.0 * domain.radius);
  loops.push_back(Arc(inner, inner, 0.0, 2.0 * Pi, edgeLength));
  return loops;
}

std::vector<Loop> Ellipse(const BuiltinDomain& domain)
{
  const double width = RequirePositive(domain.width, "width");
  const double height = RequirePositive(domain.height, "height");
  return { Arc(0.5 * width, 0.5 * height, 0.0, 2.0 * Pi, EdgeLength(domain, width, height)) };
}

std::vector<Loop> QuarterDisk(const BuiltinDomain& domain)
{
  const double r = RequirePositive(domain.radius, "radius");
  Loop loop = Arc(r, r, 0.0, 0.5 * Pi, EdgeLength(domain, r, r));
  loop.emplace_back(0.0, r);
  loop.emplace_back(0.0, 0.0);
  return { loop };
}

std::vector<Loop> Box(double width, double height)
{
  return { { { 0.0, 0.0 }, { width, 0.0 }, { width, height }, { 0.0, height } } };
}

std::vector<Loop> Square(const BuiltinDomain& domain)
{
  const double width = RequirePositive(domain.width, "width");
  return Box(width, width);
}

std::vector<Loop> Rectangle(const BuiltinDomain& domain)
{
  return Box(RequirePositive(domain.width, "width"), RequirePositive(domain.height, "height"));
}

std::vector<Loop> LShape(const BuiltinDomain& domain)
{
  const double w = RequirePositive(domain.width, "width");
  return { { { 0.0, 0.0 }, { w, 0.0 }, { w, 0.5 * w }, { 0.5 * w, 0.5 * w }, { 0.5 * w, w },
    { 0.0, w } } };
}

std::vector<Loop> Hexagonal(const BuiltinDomain& domain)
{
  return HexagonalDomain(RequirePositive(domain.radius, "radius"));
}

std::vector<Loop> Star(const BuiltinDomain& domain)
{
  const double inner = RequirePositive(domain.innerRadius, "inner radius");
  if (!(inner < RequirePositive(domain.radius, "radius")))
  {
    throw Error("The inner radius of a star must be smaller than its radius.");
  }
  return StarDomain(domain.radius, inner);
}

/// Makes an angular domain of the paper that is described by its width alone.
template <std::vector<Loop> (*Make)(double)>
std::vector<Loop> Angular(const BuiltinDomain& domain)
{
  return Make(RequirePositive(domain.width, "width"));
}

std::vector<Loop> AngularHole(const BuiltinDomain& domain)
{
  const double width = RequirePositive(domain.width, "width");
  return AngularHoleDomain(width, EdgeLength(domain, width, 0.5 * width));
}

const std::vector<std::pair<std::string, Maker>>& Makers()
{
  static const std::vector<std::pair<std::string, Maker>> makers = { { "disk", Disk },
    { "ring", Ring }, { "ellipse", Ellipse }, { "quarter-disk", QuarterDisk }, { "square", Square },
    { "rectangle", Rectangle }, { "l-shape", LShape }, { "hexagonal", Hexagonal }, { "star", Star },
    { "angular-balanced", Angular<AngularBalancedDomain> },
    { "angular-negative", Angular<AngularNegativeDomain> },
    { "angular-positive", Angular<AngularPositiveDomain> }, { "angular-hole", AngularHole } };
  return makers;
}
}

const std::vector<std::string>& BuiltinDomainNames()
{
  static const std::vector<std::string> names = []
  {
    std::vector<std::string> result;
    for (const auto& maker : Makers())
    {
      result.push_back(maker.first);
    }
    return result;
  }();
  return names;
}

std::vector<Loop> MakeBuiltinDomain(const BuiltinDomain& domain)
{
  if (domain.edgeLength < 0.0 || !std::isfinite(domain.edgeLength))
  {
    throw Error("The edge length of a built-in domain must be positive, or 0 for the default.");
  }
  std::string known;
  for (const auto& [name, make] : Makers())
  {
    if (name == domain.name)
    {
      return make(domain);
    }
    known += (known.empty() ? "" : ", ") + name;
  }
  throw Error("There is no built-in domain '" + domain.name + "'; choose one of " + known + ".");
}
}
