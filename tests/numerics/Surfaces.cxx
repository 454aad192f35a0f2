#include "Surfaces.h"

#include "Support.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace crossfield::test
{
namespace
{
void AddQuad(SurfaceMesh& surface, int a, int b, int c, int d)
{
  surface.triangles.push_back({ a, b, c });
  surface.triangles.push_back({ a, c, d });
}

/// Removes the triangles with a corner below z = 0, and the points without triangles.
SurfaceMesh UpperPart(const SurfaceMesh& surface)
{
  constexpr double Rounding = 1e-12;
  SurfaceMesh part;
  std::vector<int> number(surface.points.size(), -1);
  for (auto triangle : surface.triangles)
  {
    const bool isBelow = std::any_of(triangle.begin(), triangle.end(),
      [&surface](int vertex) { return surface.points[vertex].z() < -Rounding; });
    if (isBelow)
    {
      continue;
    }
    for (int& vertex : triangle)
    {
      int& own = number[vertex];
      if (own < 0)
      {
        own = static_cast<int>(part.points.size());
        part.points.push_back(surface.points[vertex]);
      }
      vertex = own;
    }
    part.triangles.push_back(triangle);
  }
  return part;
}
}

SurfaceMesh CubedSphere(int n)
{
  SurfaceMesh surface;
  std::map<std::array<int, 3>, int> numbers; // of points of the cube, with coordinates 0 … n
  const auto at = [&](const std::array<int, 3>& place)
  {
    const auto [found, isNew] = numbers.insert({ place, static_cast<int>(surface.points.size()) });
    if (isNew)
    {
      SpacePoint point;
      for (int axis = 0; axis < 3; ++axis)
      {
        point[axis] = std::tan(0.25 * Pi * (2.0 * place[axis] / n - 1.0));
      }
      surface.points.push_back(point.normalized());
    }
    return found->second;
  };
  for (int corner = 0; corner < 8; ++corner)
  {
    at({ corner % 2 * n, corner / 2 % 2 * n, corner / 4 * n });
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int end : { 0, n })
    {
      for (int i = 0; i < n; ++i)
      {
        for (int j = 0; j < n; ++j)
        {
          // Counter-clockwise seen from outside.
          const auto corner = [&](int di, int dj)
          {
            std::array<int, 3> place{};
            place[axis] = end;
            place[(axis + 1) % 3] = i + (end == n ? di : dj);
            place[(axis + 2) % 3] = j + (end == n ? dj : di);
            return at(place);
          };
          const std::array<int, 4> around = { corner(0, 0), corner(1, 0), corner(1, 1),
            corner(0, 1) };
          SpacePoint centre = SpacePoint::Zero();
          for (std::size_t k = 0; k < 4; ++k)
          {
            centre += surface.points[around[k]];
            surface.triangles.push_back(
              { around[k], around[(k + 1) % 4], static_cast<int>(surface.points.size()) });
          }
          surface.points.push_back(centre.normalized());
        }
      }
    }
  }
  return surface;
}

SurfaceMesh Can(int n)
{
  SurfaceMesh surface = CubedSphere(n);
  for (SpacePoint& point : surface.points)
  {
    point /= point.cwiseAbs().maxCoeff(); // on the cube
    const double radius = point.head<2>().norm();
    if (radius > 0.0)
    {
      point.head<2>() *= point.head<2>().cwiseAbs().maxCoeff() / radius;
    }
  }
  return surface;
}

SurfaceMesh Hemisphere(int n)
{
  return UpperPart(CubedSphere(n));
}

std::vector<Cone> ConesOfCube(const SurfaceMesh& surface)
{
  std::vector<Cone> cones;
  for (int vertex = 0; vertex < static_cast<int>(surface.points.size()); ++vertex)
  {
    if ((surface.points[vertex].cwiseAbs().array() - std::sqrt(1.0 / 3.0)).abs().maxCoeff() < 1e-9)
    {
      cones.push_back({ vertex, 1, false, static_cast<int>(cones.size()) });
    }
  }
  return cones;
}

SurfaceMesh Torus(double R, int m, int n)
{
  SurfaceMesh surface;
  for (int i = 0; i < m; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const double u = 2.0 * Pi * i / m;
      const double v = 2.0 * Pi * j / n;
      const double radius = R + std::cos(v);
      surface.points.emplace_back(radius * std::cos(u), radius * std::sin(u), std::sin(v));
      const int k = (i + 1) % m;
      const int l = (j + 1) % n;
      // Diagonals alternate, so that the mesh has the reflections of the torus.
      const std::array<int, 4> around = { i * n + j, k * n + j, k * n + l, i * n + l };
      const auto first = static_cast<std::size_t>((i + j) % 2);
      AddQuad(surface, around[first], around[first + 1], around[(first + 2) % 4],
        around[(first + 3) % 4]);
    }
  }
  return surface;
}

SurfaceMesh BoxWithHoles(int genus, int n)
{
  const auto isFull = [&](std::array<int, 3> cube)
  {
    return cube[0] >= 0 && cube[0] < 2 * genus + 1 && cube[1] >= 0 && cube[1] < 3 && cube[2] == 0 &&
      (cube[0] % 2 == 0 || cube[1] != 1);
  };
  SurfaceMesh surface;
  std::map<std::array<int, 3>, int> numbers; // of points, in units of 1 / n
  const auto at = [&](const std::array<int, 3>& place)
  {
    const auto [found, isNew] = numbers.insert({ place, static_cast<int>(surface.points.size()) });
    if (isNew)
    {
      surface.points.push_back(SpacePoint(place[0], place[1], place[2]) / n);
    }
    return found->second;
  };
  for (int x = 0; x < 2 * genus + 1; ++x)
  {
    for (int y = 0; y < 3; ++y)
    {
      for (int axis = 0; axis < 3 && isFull({ x, y, 0 }); ++axis)
      {
        for (const int end : { 0, 1 })
        {
          std::array<int, 3> cube = { x, y, 0 };
          cube[axis] += 2 * end - 1;
          if (isFull(cube))
          {
            continue;
          }
          for (int i = 0; i < n * n; ++i)
          {
            const auto corner = [&](int di, int dj)
            {
              std::array<int, 3> place = { n * x, n * y, 0 };
              place[axis] += n * end;
              place[(axis + 1) % 3] += i % n + (end == 1 ? di : dj);
              place[(axis + 2) % 3] += i / n + (end == 1 ? dj : di);
              return at(place);
            };
            AddQuad(surface, corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
          }
        }
      }
    }
  }
  return surface;
}

TriangleMesh GridOfSquare(int n)
{
  TriangleMesh mesh;
  const auto at = [n](int i, int j) { return i * (n + 1) + j; };
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      mesh.points.emplace_back(static_cast<double>(i) / n, static_cast<double>(j) / n);
      if (i < n && j < n)
      {
        mesh.triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
        mesh.triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
      }
    }
  }
  const auto add = [&mesh](int from, int to) {
    mesh.boundary.push_back({ { from, to }, BoundaryKind::Outer, 0, 0 });
  };
  for (int i = 0; i < n; ++i)
  {
    add(at(i, 0), at(i + 1, 0));
    add(at(n, i), at(n, i + 1));
    add(at(n - i, n), at(n - i - 1, n));
    add(at(0, n - i), at(0, n - i - 1));
  }
  return mesh;
}

std::vector<Cone> ConesOfSquare(int n)
{
  std::vector<Cone> cones = { { n / 3 * (n + 1) + 5, 1, false, 0 },
    { 2 * n / 3 * (n + 1) + 7, -1, false, 1 } };
  for (const int corner : { 0, n, n * (n + 1), (n + 1) * (n + 1) - 1 })
  {
    cones.push_back({ corner, 1, true, -1 });
  }
  return cones;
}

Eigen::Matrix3d TurnOfBent()
{
  return Eigen::AngleAxisd(0.7, SpacePoint(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
}

SurfaceMesh BentAtRandom(const TriangleMesh& mesh, int n, unsigned seed, double largest)
{
  Random random(seed);
  const Eigen::Matrix3d turn = TurnOfBent();
  std::vector<SpacePoint> lines = { SpacePoint::Zero() };
  for (int i = 0; i < n; ++i)
  {
    const double angle = random.Uniform(-largest, largest);
    lines.push_back(lines.back() + SpacePoint(std::cos(angle), 0.0, std::sin(angle)) / n);
  }
  SurfaceMesh surface;
  for (const Point& point : mesh.points)
  {
    const auto line = static_cast<std::size_t>(std::lround(point.x() * n));
    surface.points.push_back(turn * (lines[line] + SpacePoint(0.0, point.y(), 0.0)));
  }
  surface.triangles = mesh.triangles;
  return surface;
}
}
