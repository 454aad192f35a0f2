#include "SurfaceRefinement.h"

#include "Index.h"
#include "SurfaceParts.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace crossfield
{
namespace
{
/// Divides the sides of triangles.
class SurfaceRefiner
{
public:
  SurfaceRefiner(SurfaceMesh surface, double length)
    : Mesh(std::move(surface))
    , Longest(length)
    , Beyond(FindNeighbours(this->Mesh))
  {
    Eigen::AlignedBox3d box;
    for (const SpacePoint& point : this->Mesh.points)
    {
      box.extend(point);
    }
    // Coordinates may have been stored in single precision.
    this->Flat = 1e-6 * box.diagonal().norm();
  }

  SurfaceMesh Run()
  {
    for (int t = 0; t < static_cast<int>(this->Mesh.triangles.size()); ++t)
    {
      for (int side = 0; side < 3; ++side)
      {
        this->Changed.emplace_back(t, side);
        this->Enter(t, side);
      }
    }
    this->FlipChanged();
    while (!this->Sides.empty())
    {
      const Side side = this->Sides.top();
      this->Sides.pop();
      const int at = this->SideOf(side.triangle, side.from, side.to);
      if (at >= 0)
      {
        this->Divide(side.triangle, at);
        this->FlipChanged();
      }
    }
    return std::move(this->Mesh);
  }

private:
  /// A side that is too long, of a triangle that may have changed since.
  struct Side
  {
    double length = 0.0;
    int triangle = 0;
    int from = 0;
    int to = 0;

    bool operator<(const Side& other) const
    {
      return this->length < other.length ||
        (this->length == other.length && this->triangle < other.triangle);
    }
  };

  const SpacePoint& At(int point) const { return this->Mesh.points[Index(point)]; }
  int PointOf(int triangle, int corner) const
  {
    return this->Mesh.triangles[Index(triangle)][Index(corner % 3)];
  }
  int BeyondOf(int triangle, int side) const
  {
    return this->Beyond[Index(triangle)][Index(side % 3)];
  }

  /// Returns the side of a triangle from one point to another, −1 if it has none.
  int SideOf(int triangle, int from, int to) const
  {
    for (int side = 0; side < 3; ++side)
    {
      if (this->PointOf(triangle, side) == from && this->PointOf(triangle, side + 1) == to)
      {
        return side;
      }
    }
    return -1;
  }

  void Set(int triangle, const std::array<int, 3>& points, const std::array<int, 3>& beyond,
    const std::array<int, 3>& lines)
  {
    this->Mesh.triangles[Index(triangle)] = points;
    if (!this->Mesh.lines.empty())
    {
      this->Mesh.lines[Index(triangle)] = lines;
    }
    this->Beyond[Index(triangle)] = beyond;
    for (int side = 0; side < 3; ++side)
    {
      const int other = beyond[Index(side)];
      const int back =
        other < 0 ? -1 : this->SideOf(other, points[Index((side + 1) % 3)], points[Index(side)]);
      if (back >= 0)
      {
        this->Beyond[Index(other)][Index(back)] = triangle;
      }
      this->Enter(triangle, side);
    }
  }

  /// Notes a side if it is too long, once.
  void Enter(int triangle, int side)
  {
    const int from = this->PointOf(triangle, side);
    const int to = this->PointOf(triangle, side + 1);
    const double length = (this->At(to) - this->At(from)).norm();
    if (length > this->Longest && (from < to || this->BeyondOf(triangle, side) < 0))
    {
      this->Sides.push({ length, triangle, from, to });
    }
  }

  void Divide(int t, int side)
  {
    const int a = this->PointOf(t, side);
    const int b = this->PointOf(t, side + 1);
    const int c = this->PointOf(t, side + 2);
    const int m = static_cast<int>(this->Mesh.points.size());
    this->Mesh.points.push_back(0.5 * (this->At(a) + this->At(b)));
    const int beyondB = this->BeyondOf(t, side + 1);
    const int beyondC = this->BeyondOf(t, side + 2);
    const int o = this->BeyondOf(t, side);
    const int second = this->Add(t);
    const std::array<int, 3> lines = this->LinesFrom(t, side);
    if (o < 0)
    {
      this->Set(second, { m, b, c }, { -1, beyondB, t }, { lines[0], lines[1], -1 });
      this->Set(t, { a, m, c }, { -1, second, beyondC }, { lines[0], -1, lines[2] });
    }
    else
    {
      const int back = this->SideOf(o, b, a);
      const int d = this->PointOf(o, back + 2);
      const int beyondA = this->BeyondOf(o, back + 1);
      const int beyondD = this->BeyondOf(o, back + 2);
      const int fourth = this->Add(o);
      const std::array<int, 3> other = this->LinesFrom(o, back);
      this->Set(second, { m, b, c }, { fourth, beyondB, t }, { lines[0], lines[1], -1 });
      this->Set(fourth, { b, m, d }, { second, o, beyondD }, { other[0], -1, other[2] });
      this->Set(t, { a, m, c }, { o, second, beyondC }, { lines[0], -1, lines[2] });
      this->Set(o, { m, a, d }, { t, beyondA, fourth }, { other[0], other[1], -1 });
      this->Changed.emplace_back(o, 1);
      this->Changed.emplace_back(fourth, 2);
    }
    this->Changed.emplace_back(t, 2);
    this->Changed.emplace_back(second, 1);
  }

  /// Returns the lines along the sides of a triangle, from a side on.
  std::array<int, 3> LinesFrom(int triangle, int side) const
  {
    std::array<int, 3> lines = this->Mesh.LinesOf(Index(triangle));
    std::rotate(lines.begin(), lines.begin() + side, lines.end());
    return lines;
  }

  /// Adds a triangle with the region of another.
  int Add(int like)
  {
    this->Mesh.triangles.push_back({ -1, -1, -1 });
    this->Beyond.push_back({ -1, -1, -1 });
    if (!this->Mesh.regions.empty())
    {
      this->Mesh.regions.push_back(this->Mesh.RegionOf(Index(like)));
    }
    if (!this->Mesh.lines.empty())
    {
      this->Mesh.lines.push_back({ -1, -1, -1 });
    }
    return static_cast<int>(this->Mesh.triangles.size()) - 1;
  }

  static double AngleAt(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c)
  {
    return std::atan2((b - a).cross(c - a).norm(), (b - a).dot(c - a));
  }

  /// Returns whether a side is along a line, or between two regions.
  bool IsOnLine(int t, int side) const
  {
    const int o = this->BeyondOf(t, side);
    const int back = this->SideOf(o, this->PointOf(t, side + 1), this->PointOf(t, side));
    return this->Mesh.RegionOf(Index(t)) != this->Mesh.RegionOf(Index(o)) ||
      this->Mesh.LinesOf(Index(t))[Index(side)] >= 0 ||
      this->Mesh.LinesOf(Index(o))[Index(back)] >= 0;
  }

  /// Returns whether the other diagonal of the two triangles at a side is better, and in their plane.
  bool ShouldFlip(int t, int side) const
  {
    const int o = this->BeyondOf(t, side);
    if (o < 0 || this->IsOnLine(t, side))
    {
      return false;
    }
    const int from = this->PointOf(t, side);
    const int to = this->PointOf(t, side + 1);
    const SpacePoint& a = this->At(from);
    const SpacePoint& b = this->At(to);
    const SpacePoint& c = this->At(this->PointOf(t, side + 2));
    const SpacePoint& d = this->At(this->PointOf(o, this->SideOf(o, to, from) + 2));
    constexpr double Rounding = 1e-9; // of four points on a circle
    if (AngleAt(c, a, b) + AngleAt(d, b, a) <= Pi + Rounding)
    {
      return false;
    }
    const SpacePoint normal = (b - a).cross(c - a).normalized();
    return std::abs((d - a).dot(normal)) <= this->Flat && (a - c).cross(d - c).dot(normal) > 0.0 &&
      (b - d).cross(c - d).dot(normal) > 0.0;
  }

  /// Flips sides that changed, and those that change by that.
  void FlipChanged()
  {
    while (!this->Changed.empty())
    {
      const auto [t, side] = this->Changed.back();
      this->Changed.pop_back();
      if (!this->ShouldFlip(t, side))
      {
        continue;
      }
      const int a = this->PointOf(t, side);
      const int b = this->PointOf(t, side + 1);
      const int c = this->PointOf(t, side + 2);
      const int o = this->BeyondOf(t, side);
      const int back = this->SideOf(o, b, a);
      const int d = this->PointOf(o, back + 2);
      const std::array<int, 4> outer = { this->BeyondOf(t, side + 2), this->BeyondOf(o, back + 1),
        this->BeyondOf(o, back + 2), this->BeyondOf(t, side + 1) };
      const std::array<int, 3> lines = this->LinesFrom(t, side);
      const std::array<int, 3> other = this->LinesFrom(o, back);
      this->Set(t, { c, a, d }, { outer[0], outer[1], o }, { lines[2], other[1], -1 });
      this->Set(o, { d, b, c }, { outer[2], outer[3], t }, { other[2], lines[1], -1 });
      for (const int triangle : { t, o })
      {
        this->Changed.emplace_back(triangle, 0);
        this->Changed.emplace_back(triangle, 1);
      }
    }
  }

  SurfaceMesh Mesh;
  const double Longest;
  double Flat = 0.0;
  std::vector<std::array<int, 3>> Beyond; ///< Per side the neighbour, −1 on the boundary.
  std::priority_queue<Side> Sides;
  std::vector<std::pair<int, int>> Changed; ///< Triangles and sides that may have to be flipped.
};
}

SurfaceMesh Refined(SurfaceMesh surface, double length)
{
  return SurfaceRefiner(std::move(surface), length).Run();
}
}
