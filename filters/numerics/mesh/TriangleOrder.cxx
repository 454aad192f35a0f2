#include "TriangleOrder.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace crossfield
{
namespace
{
/// Of each coordinate. The key of a triangle is its place on the curve, and its number where places are equal.
constexpr unsigned int Bits = 16;

/// The place of a square of a grid of side 2^Bits on Hilbert's curve. From the largest squares to the smallest the curve
/// visits the four quarters of each as a U; inside the first it is transposed, inside the last also reflected.
std::uint64_t PlaceOnCurve(std::uint32_t x, std::uint32_t y)
{
  std::uint64_t place = 0;
  for (std::uint32_t side = 1U << (Bits - 1); side > 0; side >>= 1U)
  {
    const bool right = (x & side) != 0;
    const bool upper = (y & side) != 0;
    const std::uint64_t quarter = right ? (upper ? 2 : 3) : (upper ? 1 : 0);
    place = 4 * place + quarter;
    x &= side - 1;
    y &= side - 1;
    if (!upper)
    {
      if (right)
      {
        x = side - 1 - x;
        y = side - 1 - y;
      }
      std::swap(x, y);
    }
  }
  return place;
}
}

//------------------------------------------------------------------------------
TriangleMesh OrderTriangles(const TriangleMesh& mesh)
{
  if (mesh.points.empty())
  {
    return mesh;
  }
  Point low = mesh.points.front();
  Point high = low;
  for (const Point& point : mesh.points)
  {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double extent = (high - low).maxCoeff();
  // Of sums of three corners, whose coordinates are from 0 to 3 extents.
  const double squares = extent > 0.0 ? ((1U << Bits) - 1) / (3.0 * extent) : 0.0;

  std::vector<std::uint64_t> keys(mesh.triangles.size());
  for (std::size_t t = 0; t < keys.size(); ++t)
  {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto corner = [&](int i) -> Point
    { return mesh.points[static_cast<std::size_t>(i)] - low; };
    const Point place = squares * (corner(a) + corner(b) + corner(c));
    keys[t] = PlaceOnCurve(static_cast<std::uint32_t>(place.x()),
                static_cast<std::uint32_t>(place.y()))
        << 32U |
      t; // a mesh has fewer than 2^32 triangles
  }
  std::sort(keys.begin(), keys.end());

  TriangleMesh result;
  result.points.reserve(mesh.points.size());
  result.triangles.reserve(mesh.triangles.size());
  std::vector<int> numbers(mesh.points.size(), -1);
  const auto number = [&](int point)
  {
    int& found = numbers[static_cast<std::size_t>(point)];
    if (found < 0)
    {
      found = static_cast<int>(result.points.size());
      result.points.push_back(mesh.points[static_cast<std::size_t>(point)]);
    }
    return found;
  };
  for (const std::uint64_t key : keys)
  {
    const auto& [a, b, c] = mesh.triangles[key & 0xFFFFFFFFU];
    const int first = number(a);
    const int second = number(b);
    result.triangles.push_back({ first, second, number(c) });
  }
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    number(static_cast<int>(i));
  }
  const auto renumber = [&number](std::vector<BoundaryEdge> edges)
  {
    for (BoundaryEdge& edge : edges)
    {
      edge.vertices = { number(edge.vertices[0]), number(edge.vertices[1]) };
    }
    return edges;
  };
  result.boundary = renumber(mesh.boundary);
  result.imprinted = renumber(mesh.imprinted);
  return result;
}
}
