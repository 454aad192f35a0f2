// Quads of order 2 and 3: areas, nodes, thin rows, errors.

#include "RaiseOrder.h"

#include "CellLattice.h"
#include "Error.h"
#include "LagrangeQuad.h"
#include "MeshFaces.h"
#include "Support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace crossfield::test
{
namespace
{
/// A ring of columns × rows quads between circles of radii 1 and `outer`; both are curves.
SolverMesh Ring(int columns, int rows, double outer)
{
  SolverMesh mesh;
  mesh.regionNames = { "domain" };
  mesh.sideNames = { "inner", "outer" };
  for (int j = 0; j <= rows; ++j)
  {
    const double radius = 1.0 + (outer - 1.0) * j / rows;
    for (int i = 0; i < columns; ++i)
    {
      const double angle = 2.0 * Pi * i / columns;
      mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
  }
  const auto at = [columns](int i, int j) { return j * columns + i % columns; };
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      mesh.cells.insert(
        mesh.cells.end(), { at(i + 1, j), at(i, j), at(i + 1, j + 1), at(i, j + 1) });
      mesh.region.push_back(0);
    }
  }
  for (int i = 0; i < columns; ++i)
  {
    mesh.faces.insert(mesh.faces.end(), { at(i + 1, 0), at(i, 0), at(i, rows), at(i + 1, rows) });
    mesh.side.insert(mesh.side.end(), { 0, 1 });
    mesh.curve.insert(mesh.curve.end(), { 0, 1 });
  }
  for (const double radius : { 1.0, outer })
  {
    PlaneCurve circle;
    circle.kind = PlaneCurve::Kind::Circle;
    circle.axis = Point(radius, 0.0);
    mesh.curves.push_back(circle);
  }
  return mesh;
}

SolverMesh Raised(const SolverMesh& quads, int order)
{
  OrderQuality ignored;
  return RaiseOrder(quads, order, ignored);
}

/// Returns the places of the nodes of all boundary edges, from end to end.
std::vector<std::vector<Point>> EdgesOf(const SolverMesh& mesh)
{
  std::vector<std::vector<Point>> edges;
  const MeshFaces faces(mesh);
  for (const CellFace& face : faces.BoundaryFaces())
  {
    edges.emplace_back();
    for (const int position : CellLattice(2, mesh.order).Face(face.face))
    {
      edges.back().emplace_back(mesh.points[Index(mesh.Cell(face.cell)[position])].head<2>());
    }
  }
  return edges;
}

/// Returns the area of a polygon through many points of the curved edges.
double AreaOf(const SolverMesh& quads)
{
  constexpr int Parts = 200;
  double area = 0.0;
  const int p = quads.order;
  for (const std::vector<Point>& edge : EdgesOf(quads))
  {
    const auto at = [&](double t)
    {
      Point place = Point::Zero();
      for (int i = 0; i <= p; ++i)
      {
        double value = 1.0;
        for (int k = 0; k <= p; ++k)
        {
          value *= k == i ? 1.0 : (t * p - k) / (i - k);
        }
        place += value * edge[Index(i)];
      }
      return place;
    };
    for (int i = 0; i < Parts; ++i)
    {
      area += 0.5 * Cross(at(static_cast<double>(i) / Parts), at((i + 1.0) / Parts));
    }
  }
  return area;
}

TEST(LagrangeQuad, DetOfAnAffineMapIsConstant)
{
  for (const int order : { 2, 3 })
  {
    Eigen::Matrix2Xd nodes(2, (order + 1) * (order + 1));
    for (int j = 0; j <= order; ++j)
    {
      for (int i = 0; i <= order; ++i)
      {
        nodes.col(j * (order + 1) + i) = Point(2.0 * i + 0.5 * j, 0.3 * i + 1.5 * j) / order;
      }
    }
    const LagrangeQuad::Range range = LagrangeQuad(order).MeasureJacobian(nodes);
    EXPECT_NEAR(range.min, 2.0 * 1.5 - 0.5 * 0.3, 1e-13);
    EXPECT_NEAR(range.max, range.min, 1e-13);
  }
}

TEST(RaiseOrder, NodesOfBoundaryEdgesAreOnTheCurve)
{
  for (const int order : { 2, 3 })
  {
    const SolverMesh straight = Ring(24, 5, 2.0);
    OrderQuality quality;
    const SolverMesh curved = RaiseOrder(straight, order, quality);
    EXPECT_EQ(quality.inverted, 0);
    EXPECT_EQ(quality.curvedRows, 1);
    EXPECT_EQ(curved.points.size(),
      straight.points.size() +
        Index((order - 1) * (24 * 5 + 24 * 6) + (order - 1) * (order - 1) * 120));
    EXPECT_EQ(curved.faces, straight.faces);
    for (std::size_t i = 0; i < curved.points.size(); ++i)
    {
      const bool isOld = i < straight.points.size();
      EXPECT_EQ(curved.sources.points[i], isOld ? static_cast<int>(i) : -1);
      EXPECT_TRUE(!isOld || curved.points[i] == straight.points[i]);
    }
    const std::vector<std::vector<Point>> edges = EdgesOf(curved);
    for (std::size_t e = 0; e < edges.size(); ++e)
    {
      for (const Point& node : edges[e])
      {
        EXPECT_NEAR(node.norm(), e % 2 == 0 ? 1.0 : 2.0, 1e-15);
      }
    }
    EXPECT_NEAR(quality.sagittas[0], 1.0 - std::cos(Pi / 24), order == 2 ? 1e-12 : 1e-2);
  }
}

TEST(RaiseOrder, NeighboursShareNodes)
{
  for (const int order : { 2, 3 })
  {
    const SolverMesh curved = Raised(Ring(12, 3, 1.5), order);
    for (int quad = 0; quad < curved.CellCount(); ++quad)
    {
      const auto at = [&](int i, int j)
      { return curved.points[Index(curved.Cell(quad)[j * (order + 1) + i])]; };
      for (int i = 0; i <= order; ++i)
      {
        // Nodes of a row are in order from one corner to the other.
        const double part = static_cast<double>(i) / order;
        const double length = (at(order, 0) - at(0, 0)).norm();
        EXPECT_LT((at(i, 0) - (1.0 - part) * at(0, 0) - part * at(order, 0)).norm(), 0.2 * length);
        const double height = (at(0, order) - at(0, 0)).norm();
        EXPECT_LT((at(0, i) - (1.0 - part) * at(0, 0) - part * at(0, order)).norm(), 0.2 * height);
      }
    }
  }
}

TEST(RaiseOrder, AreasConvergeWithOrderFour)
{
  // Equal steps are symmetric, so the areas of both orders are one order better than p + 1 for p = 2.
  for (const int order : { 2, 3 })
  {
    std::vector<double> errors;
    for (const int columns : { 16, 32 })
    {
      errors.push_back(std::abs(AreaOf(Raised(Ring(columns, 4, 2.0), order)) / (3.0 * Pi) - 1.0));
    }
    EXPECT_GT(std::log2(errors[0] / errors[1]), 3.8);
  }
}

TEST(RaiseOrder, ThinRowsFollowTheBoundary)
{
  // The sagitta of 12 columns is 0.034; rows have a height of 0.01.
  for (const int order : { 2, 3 })
  {
    OrderQuality quality;
    RaiseOrder(Ring(12, 60, 1.6), order, quality);
    EXPECT_EQ(quality.inverted, 0);
    EXPECT_GT(quality.curvedRows, 4);
    EXPECT_GT(quality.jacobianRatio, 0.3);
    EXPECT_EQ(*std::min_element(quality.jacobianRatios.begin(), quality.jacobianRatios.end()),
      quality.jacobianRatio);
  }
}

TEST(RaiseOrder, QuadsThatCannotBeCurvedAreReported)
{
  // One row that is thinner than the sagitta, and straight outside.
  SolverMesh straight = Ring(6, 1, 1.05);
  std::replace(straight.curve.begin(), straight.curve.end(), 1, -1);
  OrderQuality quality;
  RaiseOrder(straight, 2, quality);
  EXPECT_EQ(quality.inverted, 6);
  EXPECT_LE(quality.jacobianRatio, 0.0);
}

TEST(RaiseOrder, DoesNotDependOnPositionSizeOrDirection)
{
  SolverMesh straight = Ring(12, 30, 1.6);
  const SolverMesh curved = Raised(straight, 3);
  const double scale = 1e5;
  const auto moved = [scale](const Point& point)
  {
    return Point(scale * (0.6 * point.x() - 0.8 * point.y()) + 3.0 * scale,
      scale * (0.8 * point.x() + 0.6 * point.y()));
  };
  for (Eigen::Vector3d& point : straight.points)
  {
    point.head<2>() = moved(point.head<2>());
  }
  for (PlaneCurve& curve : straight.curves)
  {
    curve.axis = moved(curve.axis) - moved(Point::Zero());
    curve.centre = moved(curve.centre);
  }
  const SolverMesh other = Raised(straight, 3);
  ASSERT_EQ(other.cells, curved.cells);
  for (std::size_t i = 0; i < curved.points.size(); ++i)
  {
    EXPECT_LT(
      (other.points[i].head<2>() - moved(curved.points[i].head<2>())).norm(), 1e-12 * scale);
  }
}

TEST(RaiseOrder, RefusesOtherOrdersAndForeignEdges)
{
  SolverMesh straight = Ring(12, 2, 1.6);
  EXPECT_THROW(Raised(straight, 1), Error);
  EXPECT_THROW(Raised(straight, 4), Error);
  EXPECT_THROW(Raised(Raised(straight, 2), 2), Error);
  std::swap(straight.cells[0], straight.cells[1]);
  std::swap(straight.cells[2], straight.cells[3]);
  EXPECT_THROW(Raised(straight, 2), Error) << "a quad of the other orientation";
  straight = Ring(12, 2, 1.6);
  straight.faces[1] = 5;
  EXPECT_THROW(Raised(straight, 2), Error);
}

/// The faces of a cube, n × n quads each, blown up to the unit sphere, with z ≤ `top`.
SolverMesh QuadsOfSphere(int n, double top)
{
  SolverMesh mesh;
  mesh.regionNames = { "domain" };
  mesh.sideNames = { "rim" };
  std::map<std::array<int, 3>, int> numbers;
  std::map<std::pair<int, int>, int> edges;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int end : { 0, n })
    {
      for (int i = 0; i < n * n; ++i)
      {
        const auto at = [&](int di, int dj)
        {
          std::array<int, 3> key{};
          const auto a = static_cast<std::size_t>(axis);
          key[a] = end;
          key[(a + 1) % 3] = i % n + (end == 0 ? dj : di);
          key[(a + 2) % 3] = i / n + (end == 0 ? di : dj);
          const auto [found, isNew] = numbers.emplace(key, static_cast<int>(mesh.points.size()));
          if (isNew)
          {
            SpacePoint place;
            for (std::size_t k = 0; k < 3; ++k)
            {
              place[static_cast<Eigen::Index>(k)] = std::tan(0.25 * Pi * (2.0 * key[k] / n - 1.0));
            }
            mesh.points.push_back(place.normalized());
          }
          return found->second;
        };
        const std::array<int, 4> quad = { at(0, 0), at(1, 0), at(0, 1), at(1, 1) };
        if (std::all_of(quad.begin(), quad.end(),
              [&](int p) { return mesh.points[static_cast<std::size_t>(p)].z() <= top + 1e-12; }))
        {
          mesh.cells.insert(mesh.cells.end(), quad.begin(), quad.end());
          mesh.region.push_back(0);
          for (const auto& [a, b] :
            { std::pair(0, 1), std::pair(1, 3), std::pair(3, 2), std::pair(2, 0) })
          {
            const int from = quad[static_cast<std::size_t>(a)];
            const int to = quad[static_cast<std::size_t>(b)];
            if (edges.erase({ to, from }) == 0)
            {
              edges[{ from, to }] = 0;
            }
          }
        }
      }
    }
  }
  for (const auto& [edge, side] : edges)
  {
    mesh.faces.insert(mesh.faces.end(), { edge.first, edge.second });
    mesh.side.push_back(side);
  }
  return mesh;
}

TEST(RaiseOrder, PlacesNodesOnASurface)
{
  for (const double top : { 1.0, 0.0 }) // closed, and half of it
  {
    for (const int order : { 2, 3 })
    {
      const SolverMesh quads = QuadsOfSphere(4, top);
      EXPECT_EQ(quads.side.empty(), top == 1.0);
      const auto place = [&](const SpacePoint& near, const std::array<int, 4>& corners,
                           bool isOnLine) -> SpacePoint
      {
        EXPECT_LT((near - quads.points[static_cast<std::size_t>(corners[0])]).norm(), 0.6);
        EXPECT_EQ(isOnLine, top == 0.0 && std::abs(near.z()) < 1e-12);
        return near.normalized();
      };
      OrderQuality quality;
      const SolverMesh raised = RaiseOrder(quads, order, quality, {}, place);
      const int cells = quads.CellCount();
      const int edges = (4 * cells + quads.FaceCount()) / 2;
      EXPECT_EQ(raised.points.size(),
        quads.points.size() +
          static_cast<std::size_t>((order - 1) * edges + (order - 1) * (order - 1) * cells));
      for (const SpacePoint& point : raised.points)
      {
        EXPECT_NEAR(point.norm(), 1.0, 1e-14);
      }
      EXPECT_EQ(quality.inverted, 0);
      EXPECT_GT(quality.jacobianRatio, 0.5);
    }
  }
}
}
}
