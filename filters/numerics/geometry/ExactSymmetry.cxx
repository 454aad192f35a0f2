#include "ExactSymmetry.h"

#include "BoundarySymmetry.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

namespace crossfield
{
namespace
{
constexpr double SinglePrecision = 1e-6; // of the diagonal

/// Vertices of all loops, found by position.
class VertexSearch
{
public:
  VertexSearch(const PlanarDomain& domain, double reach)
    : Reach(reach)
  {
    for (const Loop& loop : domain.loops)
    {
      this->Places.insert(this->Places.end(), loop.begin(), loop.end());
    }
    std::sort(this->Places.begin(), this->Places.end(), IsBefore);
  }

  /// Returns the nearest vertex within reach of a place.
  std::optional<Point> Find(const Point& place) const
  {
    std::optional<Point> nearest;
    double least = this->Reach;
    const Point first(place.x() - this->Reach, 0.0);
    for (auto vertex = std::lower_bound(this->Places.begin(), this->Places.end(), first, IsBefore);
         vertex != this->Places.end() && vertex->x() <= place.x() + this->Reach; ++vertex)
    {
      if ((*vertex - place).norm() <= least)
      {
        least = (*vertex - place).norm();
        nearest = *vertex;
      }
    }
    return nearest;
  }

private:
  static bool IsBefore(const Point& a, const Point& b) { return a.x() < b.x(); }

  std::vector<Point> Places;
  double Reach;
};

/// Turns the axis of a group to the mean over all vertices, and to a multiple of 15° that is within
/// the tolerance: the axis of FindSymmetries has the error of two vertices.
void RefineAxis(const PlanarDomain& domain, const VertexSearch& vertices, SymmetryGroup& group)
{
  using Complex = std::complex<double>;
  const SymmetryGroup one{ group.centre, 1, true, group.axis };
  const Isometry reflection = one.Elements().back();
  Complex sum = 0.0;
  for (const Loop& loop : domain.loops)
  {
    for (const Point& vertex : loop)
    {
      if (const std::optional<Point> image = vertices.Find(reflection(vertex)))
      {
        const Point from = vertex - group.centre;
        const Point to = *image - group.centre;
        sum += Complex(to.x(), to.y()) * Complex(from.x(), from.y());
      }
    }
  }
  const Complex present = std::polar(1.0, 2.0 * group.axis);
  group.axis += 0.5 * std::arg(sum * std::conj(present));
  constexpr double Step = Pi / 12.0;
  const double rounded = Step * std::round(group.axis / Step);
  group.axis = std::abs(group.axis - rounded) < SinglePrecision ? rounded : group.axis;
}

/// Moves the vertices of a loop that are not regular onto the segment between the next ones that are.
void Straighten(const std::vector<bool>& isRegular, Loop& loop)
{
  const std::size_t count = loop.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (isRegular[i])
    {
      continue;
    }
    std::size_t before = i;
    std::size_t after = i;
    while (!isRegular[before])
    {
      before = (before + count - 1) % count;
    }
    while (!isRegular[after])
    {
      after = (after + 1) % count;
    }
    const Point along = (loop[after] - loop[before]).normalized();
    loop[i] = loop[before] + along.dot(loop[i] - loop[before]) * along;
  }
}
}

PlanarDomain WithExactSymmetries(const PlanarDomain& domain)
{
  SymmetryGroup group = FindSymmetries(domain, SinglePrecision);
  const std::size_t count = group.Elements().size();
  if (count == FindSymmetries(domain).Elements().size())
  {
    return domain;
  }
  const VertexSearch vertices(domain, 2.0 * SinglePrecision * domain.Diagonal());
  if (group.reflects)
  {
    RefineAxis(domain, vertices, group);
  }
  const std::vector<Isometry> elements = group.Elements();
  PlanarDomain result = domain;
  for (Loop& loop : result.loops)
  {
    std::vector<bool> isRegular;
    for (Point& vertex : loop)
    {
      Point sum = Point::Zero();
      std::size_t images = 0;
      for (const Isometry& map : elements)
      {
        if (const std::optional<Point> image = vertices.Find(map(vertex)))
        {
          sum += map.Inverse()(*image) - vertex;
          ++images;
        }
      }
      // Other vertices are on straight sides.
      isRegular.push_back(images == count);
      if (isRegular.back())
      {
        vertex += sum / static_cast<double>(images);
      }
    }
    if (std::count(isRegular.begin(), isRegular.end(), true) < 3)
    {
      return domain;
    }
    Straighten(isRegular, loop);
  }
  return FindSymmetries(result).Elements().size() == count ? result : domain;
}
}
