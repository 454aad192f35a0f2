#include "QuadSizes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace crossfield
{
void SetTargetLengths(QuadMesh& mesh, const TargetSizes& sizes, double area)
{
  if (sizes.sizing == Sizing::Conformal)
  {
    return;
  }
  double squares = 0.0;
  std::vector<double> relative;
  relative.reserve(mesh.quads.size());
  for (const std::array<int, 4>& quad : mesh.quads)
  {
    Point centre = Point::Zero();
    for (const int point : quad)
    {
      centre += 0.25 * mesh.points[point].place;
    }
    relative.push_back(sizes.At(centre));
    squares += relative.back() * relative.back();
  }
  const double factor = std::sqrt(area / squares);
  for (std::size_t q = 0; q < relative.size(); ++q)
  {
    mesh.targetLengths[q] = { factor * relative[q], factor * relative[q] };
  }
  const double mean = std::sqrt(squares / static_cast<double>(relative.size()));
  for (QuadPoint& point : mesh.points)
  {
    point.scale = sizes.At(point.place) / mean;
  }
}

void SetMeasuredLengths(QuadMesh& mesh)
{
  // A shorter side, in the worst case one of length zero, would make its quad as stiff as it is
  // thin.
  constexpr double Shortest = 0.3;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    std::array<double, 4> sides{};
    double mean = 0.0;
    for (std::size_t side = 0; side < 4; ++side)
    {
      const auto from = static_cast<std::size_t>(mesh.quads[q][side]);
      const auto to = static_cast<std::size_t>(mesh.quads[q][(side + 1) % 4]);
      sides[side] = (mesh.points[to].place - mesh.points[from].place).norm();
      mean += 0.25 * sides[side];
    }
    mesh.targetLengths[q] = { std::max(Shortest * mean, 0.5 * (sides[0] + sides[2])),
      std::max(Shortest * mean, 0.5 * (sides[1] + sides[3])) };
  }
}
}
