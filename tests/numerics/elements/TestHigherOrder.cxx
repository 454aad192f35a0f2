// Quads of order 2 and 3: areas, nodes, thin rows, errors.

#include "HigherOrder.h"

#include "Error.h"
#include "Index.h"
#include "LagrangeQuad.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// A ring of columns × rows quads between circles of radii 1 and `outer`; both are curves.
StraightQuads Ring(int columns, int rows, double outer)
{
  StraightQuads quads;
  for (int j = 0; j <= rows; ++j)
  {
    const double radius = 1.0 + (outer - 1.0) * j / rows;
    for (int i = 0; i < columns; ++i)
    {
      const double angle = 2.0 * Pi * i / columns;
      quads.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
  }
  const auto at = [columns](int i, int j) { return j * columns + i % columns; };
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      quads.quads.push_back({ at(i + 1, j), at(i, j), at(i, j + 1), at(i + 1, j + 1) });
    }
  }
  for (int i = 0; i < columns; ++i)
  {
    quads.edges.push_back({ { at(i + 1, 0), at(i, 0) }, 0 });
    quads.edges.push_back({ { at(i, rows), at(i + 1, rows) }, 1 });
  }
  for (const double radius : { 1.0, outer })
  {
    PlaneCurve circle;
    circle.kind = PlaneCurve::Kind::Circle;
    circle.axis = Point(radius, 0.0);
    quads.curves.push_back(circle);
  }
  return quads;
}

/// Returns the area of a polygon through many points of the curved edges.
double AreaOf(const CurvedQuads& quads)
{
  constexpr int Parts = 200;
  double area = 0.0;
  const int p = quads.order;
  for (const std::vector<int>& edge : quads.edges)
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
        place += value * quads.points[Index(edge[Index(i)])];
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

TEST(HigherOrder, NodesOfBoundaryEdgesAreOnTheCurve)
{
  for (const int order : { 2, 3 })
  {
    const StraightQuads straight = Ring(24, 5, 2.0);
    const CurvedQuads curved = RaiseOrder(straight, order);
    EXPECT_EQ(curved.inverted, 0);
    EXPECT_EQ(curved.curvedRows, 1);
    EXPECT_EQ(curved.points.size(),
      straight.points.size() +
        Index((order - 1) * (24 * 5 + 24 * 6) + (order - 1) * (order - 1) * 120));
    for (std::size_t e = 0; e < curved.edges.size(); ++e)
    {
      EXPECT_EQ(curved.edges[e].front(), straight.edges[e].points[0]);
      EXPECT_EQ(curved.edges[e].back(), straight.edges[e].points[1]);
      for (const int node : curved.edges[e])
      {
        EXPECT_NEAR(curved.points[Index(node)].norm(), e % 2 == 0 ? 1.0 : 2.0, 1e-15);
      }
    }
    EXPECT_NEAR(curved.sagittas[0], 1.0 - std::cos(Pi / 24), order == 2 ? 1e-12 : 1e-2);
  }
}

TEST(HigherOrder, NeighboursShareNodes)
{
  for (const int order : { 2, 3 })
  {
    const CurvedQuads curved = RaiseOrder(Ring(12, 3, 1.5), order);
    for (const std::vector<int>& quad : curved.quads)
    {
      const auto at = [&](int i, int j)
      { return curved.points[Index(quad[Index(j * (order + 1) + i)])]; };
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

TEST(HigherOrder, AreasConvergeWithOrderFour)
{
  // Equal steps are symmetric, so the areas of both orders are one order better than p + 1 for p = 2.
  for (const int order : { 2, 3 })
  {
    std::vector<double> errors;
    for (const int columns : { 16, 32 })
    {
      errors.push_back(
        std::abs(AreaOf(RaiseOrder(Ring(columns, 4, 2.0), order)) / (3.0 * Pi) - 1.0));
    }
    EXPECT_GT(std::log2(errors[0] / errors[1]), 3.8);
  }
}

TEST(HigherOrder, ThinRowsFollowTheBoundary)
{
  // The sagitta of 12 columns is 0.034; rows have a height of 0.01.
  const StraightQuads straight = Ring(12, 60, 1.6);
  for (const int order : { 2, 3 })
  {
    const CurvedQuads curved = RaiseOrder(straight, order);
    EXPECT_EQ(curved.inverted, 0);
    EXPECT_GT(curved.curvedRows, 4);
    EXPECT_GT(curved.jacobianRatio, 0.3);
    EXPECT_GT(*std::min_element(curved.jacobianRatios.begin(), curved.jacobianRatios.end()), 0.3);
  }
}

TEST(HigherOrder, QuadsThatCannotBeCurvedAreReported)
{
  // One row that is thinner than the sagitta, and straight outside.
  StraightQuads straight = Ring(6, 1, 1.05);
  for (StraightEdge& edge : straight.edges)
  {
    edge.curve = edge.curve == 0 ? 0 : -1;
  }
  const CurvedQuads curved = RaiseOrder(straight, 2);
  EXPECT_EQ(curved.inverted, 6);
  EXPECT_LE(curved.jacobianRatio, 0.0);
}

TEST(HigherOrder, DoesNotDependOnPositionSizeOrDirection)
{
  StraightQuads straight = Ring(12, 30, 1.6);
  const CurvedQuads curved = RaiseOrder(straight, 3);
  const double scale = 1e5;
  const auto moved = [scale](const Point& point)
  {
    return Point(scale * (0.6 * point.x() - 0.8 * point.y()) + 3.0 * scale,
      scale * (0.8 * point.x() + 0.6 * point.y()));
  };
  for (Point& point : straight.points)
  {
    point = moved(point);
  }
  for (PlaneCurve& curve : straight.curves)
  {
    curve.axis = moved(curve.axis) - moved(Point::Zero());
    curve.centre = moved(curve.centre);
  }
  const CurvedQuads other = RaiseOrder(straight, 3);
  ASSERT_EQ(other.quads, curved.quads);
  for (std::size_t i = 0; i < curved.points.size(); ++i)
  {
    EXPECT_LT((other.points[i] - moved(curved.points[i])).norm(), 1e-12 * scale);
  }
}

TEST(HigherOrder, RefusesOtherOrdersAndForeignEdges)
{
  StraightQuads straight = Ring(12, 2, 1.6);
  EXPECT_THROW(RaiseOrder(straight, 1), Error);
  EXPECT_THROW(RaiseOrder(straight, 4), Error);
  straight.edges[0].points = { 0, 5 };
  EXPECT_THROW(RaiseOrder(straight, 2), Error);
}
}
}
