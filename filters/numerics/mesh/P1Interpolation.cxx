#include "P1Interpolation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace crossfield
{
P1Interpolation::P1Interpolation(const TriangleMesh& mesh, Eigen::VectorXd values)
  : Points(mesh.points)
  , Triangles(mesh.triangles)
  , Values(std::move(values))
{
  Eigen::AlignedBox2d box;
  for (const Point& point : this->Points)
  {
    box.extend(point);
  }
  this->Corner = box.min();
  const auto count = static_cast<double>(std::max<std::size_t>(this->Triangles.size(), 1));
  this->Width =
    std::max(std::sqrt(box.sizes().prod() / count), 1e-3 * box.sizes().maxCoeff()); // thin domains
  this->Columns = 1 + static_cast<int>(box.sizes().x() / this->Width);
  this->Rows = 1 + static_cast<int>(box.sizes().y() / this->Width);
  this->Buckets.resize(
    static_cast<std::size_t>(this->Columns) * static_cast<std::size_t>(this->Rows));
  for (int t = 0; t < static_cast<int>(this->Triangles.size()); ++t)
  {
    Eigen::AlignedBox2d bounds;
    for (const int vertex : this->Triangles[t])
    {
      bounds.extend(this->Points[vertex]);
    }
    for (int row = this->Row(bounds.min().y()); row <= this->Row(bounds.max().y()); ++row)
    {
      for (int column = this->Column(bounds.min().x()); column <= this->Column(bounds.max().x());
           ++column)
      {
        this->Buckets[row * this->Columns + column].push_back(t);
      }
    }
  }
}

int P1Interpolation::Column(double x) const
{
  const double column = std::floor((x - this->Corner.x()) / this->Width);
  return static_cast<int>(std::clamp(column, 0.0, static_cast<double>(this->Columns - 1)));
}

int P1Interpolation::Row(double y) const
{
  const double row = std::floor((y - this->Corner.y()) / this->Width);
  return static_cast<int>(std::clamp(row, 0.0, static_cast<double>(this->Rows - 1)));
}

P1Interpolation::Nearest P1Interpolation::InTriangle(int triangle, const Point& place) const
{
  const std::array<int, 3>& vertices = this->Triangles[triangle];
  const auto point = [&](std::size_t i) -> const Point& { return this->Points[vertices[i]]; };
  const double area = Cross(point(1) - point(0), point(2) - point(0));
  std::array<double, 3> weights{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    weights[i] = Cross(point((i + 1) % 3) - place, point((i + 2) % 3) - place) / area;
  }
  Nearest nearest{ 0.0, 0.0 };
  if (*std::min_element(weights.begin(), weights.end()) >= 0.0)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      nearest.value += weights[i] * this->Values[vertices[i]];
    }
    return nearest;
  }
  nearest.squaredDistance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    const Point side = point(j) - point(i);
    const double part = std::clamp(side.dot(place - point(i)) / side.squaredNorm(), 0.0, 1.0);
    const double squared = (point(i) + part * side - place).squaredNorm();
    if (squared < nearest.squaredDistance)
    {
      nearest = { squared,
        (1.0 - part) * this->Values[vertices[i]] + part * this->Values[vertices[j]] };
    }
  }
  return nearest;
}

double P1Interpolation::At(const Point& place) const
{
  const int column = this->Column(place.x());
  const int row = this->Row(place.y());
  Nearest best{ std::numeric_limits<double>::infinity(), 0.0 };
  // Search rings of buckets around that of the point, until no bucket farther out can contain a
  // nearer triangle.
  const int most = std::max(this->Columns, this->Rows);
  for (int ring = 0; ring <= most; ++ring)
  {
    const double reached = std::max(0, ring - 1) * this->Width;
    if (best.squaredDistance <= reached * reached)
    {
      break;
    }
    for (int r = std::max(0, row - ring); r <= std::min(this->Rows - 1, row + ring); ++r)
    {
      for (int c = std::max(0, column - ring); c <= std::min(this->Columns - 1, column + ring); ++c)
      {
        if (std::max(std::abs(r - row), std::abs(c - column)) != ring)
        {
          continue;
        }
        for (const int t : this->Buckets[r * this->Columns + c])
        {
          const Nearest here = this->InTriangle(t, place);
          if (here.squaredDistance < best.squaredDistance)
          {
            best = here;
          }
          if (best.squaredDistance == 0.0)
          {
            return best.value;
          }
        }
      }
    }
  }
  return best.value;
}
}
