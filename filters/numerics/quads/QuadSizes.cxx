#include "QuadSizes.h"

#include <cmath>

namespace crossfield
{
namespace
{
double SizeAt(const SizeRequest& request, const Point& place)
{
  return request.sizing == QuadSizing::Field ? TargetSize(request.field, place) : 1.0;
}
}

std::vector<double> TargetLengths(const TMesh& mesh, const SizeRequest& request)
{
  std::vector<double> lengths;
  lengths.reserve(mesh.arcs.size());
  for (const TArc& arc : mesh.arcs)
  {
    double length = request.sizing == QuadSizing::Conformal ? arc.length : 0.0;
    // Segments are as short as the triangles that they pass: the midpoint rule is exact enough.
    for (std::size_t i = 1; request.sizing != QuadSizing::Conformal && i < arc.polyline.size(); ++i)
    {
      const Point& from = arc.polyline[i - 1];
      const Point& to = arc.polyline[i];
      length += (to - from).norm() / SizeAt(request, 0.5 * (from + to));
    }
    lengths.push_back(length);
  }
  return lengths;
}

void WantSizes(QuadMesh& mesh, const SizeRequest& request, double area)
{
  if (request.sizing == QuadSizing::Conformal)
  {
    return;
  }
  double squares = 0.0;
  std::vector<double> sizes;
  sizes.reserve(mesh.quads.size());
  for (const std::array<int, 4>& quad : mesh.quads)
  {
    Point centre = Point::Zero();
    for (const int point : quad)
    {
      centre += 0.25 * mesh.points[static_cast<std::size_t>(point)].place;
    }
    sizes.push_back(SizeAt(request, centre));
    squares += sizes.back() * sizes.back();
  }
  const double factor = std::sqrt(area / squares);
  for (std::size_t q = 0; q < sizes.size(); ++q)
  {
    mesh.wanted[q] = { factor * sizes[q], factor * sizes[q] };
  }
  const double mean = std::sqrt(squares / static_cast<double>(sizes.size()));
  for (QuadPoint& point : mesh.points)
  {
    point.scale = SizeAt(request, point.place) / mean;
  }
}
}
