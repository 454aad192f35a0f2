#include "CanonicalFrame.h"

#include <algorithm>
#include <complex>
#include <optional>

namespace crossfield
{
namespace
{
using Complex = std::complex<double>;

/// Part of the sum of absolute values below which a sum counts as zero. Coordinates may have been
/// stored in single precision.
constexpr double Vanishing = 1e-6;

Point CentroidOf(const Loop& loop)
{
  double twiceArea = 0.0;
  Point sum = Point::Zero();
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
  {
    // Relative to the first vertex, which is accurate far from the origin as well.
    const Point from = loop[i] - loop[0];
    const Point to = loop[i + 1] - loop[0];
    const double part = Cross(from, to);
    twiceArea += part;
    sum += part / 3.0 * (from + to);
  }
  return twiceArea == 0.0 ? loop[0] : Point(loop[0] + sum / twiceArea);
}

/// Vertex relative to the centroid, and half of the length of its two segments.
struct WeightedVertex
{
  Complex place;
  double weight;
};

std::vector<WeightedVertex> WeighVertices(const std::vector<Loop>& loops, const Point& centre)
{
  std::vector<WeightedVertex> vertices;
  for (const Loop& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point& before = loop[(i + loop.size() - 1) % loop.size()];
      const Point& after = loop[(i + 1) % loop.size()];
      const Point place = loop[i] - centre;
      vertices.push_back(
        { { place.x(), place.y() }, 0.5 * ((loop[i] - before).norm() + (after - loop[i]).norm()) });
    }
  }
  return vertices;
}

/// Direction modulo 2π / fold.
struct SymmetricDirection
{
  double angle;
  int fold;
};

/// Returns the direction of the first moment Σ weight z^m, m = 1, 2, ..., that does not vanish. If
/// the boundary has an m-fold symmetry, all previous ones do. Finer polygons than the last m count
/// as circles.
std::optional<SymmetricDirection> FindDirection(
  const std::vector<WeightedVertex>& vertices, double extent)
{
  constexpr int LastMoment = 64;
  for (int fold = 1; fold <= LastMoment; ++fold)
  {
    Complex moment = 0.0;
    double size = 0.0;
    for (const WeightedVertex& vertex : vertices)
    {
      const Complex part = vertex.weight * std::pow(vertex.place / extent, fold);
      moment += part;
      size += std::abs(part);
    }
    if (std::abs(moment) > Vanishing * size)
    {
      return SymmetricDirection{ std::arg(moment) / fold, fold };
    }
  }
  return std::nullopt;
}

/// Returns the mean direction of the segments modulo π/2; nothing if the mean vanishes.
std::optional<double> FindSideDirection(const std::vector<Loop>& loops)
{
  Complex sum = 0.0;
  double length = 0.0;
  for (const Loop& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point along = loop[(i + 1) % loop.size()] - loop[i];
      sum += std::polar(along.norm(), 4.0 * std::atan2(along.y(), along.x()));
      length += along.norm();
    }
  }
  return std::abs(sum) > Vanishing * length ? std::optional<double>(0.25 * std::arg(sum))
                                            : std::nullopt;
}

/// Returns the number of quarter turns from a side direction to the one next to a direction. The
/// bounds between them are at 22.5° from the sides, where no mirror line of the sides is.
double CountQuarterTurns(double side, const SymmetricDirection& direction)
{
  return std::floor((direction.angle - side) / (0.5 * Pi) + 0.25);
}
}

CanonicalFrame::CanonicalFrame(const std::vector<Loop>& loops)
{
  if (loops.empty() || loops[0].size() < 3)
  {
    return;
  }
  const Point centre = CentroidOf(loops[0]);
  const std::vector<WeightedVertex> vertices = WeighVertices(loops, centre);
  double extent = 0.0;
  for (const WeightedVertex& vertex : vertices)
  {
    extent = std::max(extent, std::abs(vertex.place));
  }
  const std::optional<SymmetricDirection> direction = FindDirection(vertices, extent);
  const std::optional<double> side = FindSideDirection(loops);
  double angle = side ? *side : direction ? direction->angle : 0.0;
  if (side && direction && direction->fold <= 2) // otherwise quarter turns change nothing
  {
    angle += 0.5 * Pi * CountQuarterTurns(*side, *direction);
  }
  const double quarters = std::round(angle / (0.5 * Pi));
  if (std::abs(angle - 0.5 * Pi * quarters) < AngleRounding)
  {
    this->Axis = Point(std::round(std::cos(angle)), std::round(std::sin(angle)));
    return;
  }
  this->Origin = centre;
  this->Axis = Point(std::cos(angle), std::sin(angle));
  this->Quantum = std::ldexp(1.0, std::ilogb(extent) - 46);
}

Point CanonicalFrame::ToFrame(const Point& point) const
{
  const Point place = point - this->Origin;
  const Point coordinates(this->Axis.dot(place), Cross(this->Axis, place));
  if (this->Quantum == 0.0)
  {
    return coordinates;
  }
  return this->Quantum * (coordinates / this->Quantum).array().round().matrix();
}

std::vector<Loop> CanonicalFrame::ToFrame(const std::vector<Loop>& loops) const
{
  std::vector<Loop> result = loops;
  for (Loop& loop : result)
  {
    for (Point& point : loop)
    {
      point = this->ToFrame(point);
    }
  }
  return result;
}

Point CanonicalFrame::FromFrame(const Point& coordinates) const
{
  return this->Origin +
    Point(this->Axis.x() * coordinates.x() - this->Axis.y() * coordinates.y(),
      this->Axis.y() * coordinates.x() + this->Axis.x() * coordinates.y());
}

double CanonicalFrame::GetAngle() const
{
  return std::atan2(this->Axis.y(), this->Axis.x());
}
}
