#include "LatticeCore.h"
#include "Support.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace crossfield::test
{
namespace
{
constexpr int Margin = 2;

/// A lattice with random points scattered over it, and a wall of points all around and across.
struct ScatteredPoints
{
  TriangularLattice lattice;
  std::vector<Point> others;
  double wall;

  explicit ScatteredPoints(unsigned seed)
  {
    Random random(seed);
    this->lattice.origin = Point(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
    this->lattice.spacing = random.Uniform(0.05, 0.1);
    this->lattice.columns = 40 + static_cast<int>(seed);
    this->lattice.rows = 50;
    const Point size = this->Upper() - this->lattice.origin;
    this->wall = this->lattice.origin.y() + random.Uniform(0.3, 0.6) * size.y();
    for (int i = 0; i < 8; ++i)
    {
      this->others.push_back(this->lattice.origin +
        Point(random.Uniform(0.0, 1.0) * size.x(), random.Uniform(0.0, 1.0) * size.y()));
    }
    for (double way = 0.0; way <= size.maxCoeff(); way += this->lattice.spacing)
    {
      const Point& lower = this->lattice.origin;
      for (const Point& place : { Point(lower.x() + way, lower.y()),
             Point(lower.x(), lower.y() + way), Point(lower.x() + way, this->Upper().y()),
             Point(this->Upper().x(), lower.y() + way), Point(lower.x() + way, this->wall) })
      {
        this->others.push_back(place);
      }
    }
  }

  Point Upper() const
  {
    return this->lattice.At(this->lattice.columns - 1, this->lattice.rows - 1);
  }
  /// Returns whether a point is below the wall.
  bool IsInside(const Point& point) const { return point.y() < this->wall; }

  double ToOthers(const Point& point) const
  {
    double distance = std::numeric_limits<double>::infinity();
    for (const Point& other : this->others)
    {
      distance = std::min(distance, (other - point).norm());
    }
    return distance / this->lattice.spacing;
  }

  LatticeCore Core() const
  {
    return { this->lattice, this->others, Margin,
      [this](const Point& point) { return this->IsInside(point); } };
  }
};

using Edge = std::pair<std::size_t, std::size_t>;

TEST(LatticeCore, ContainsExactlyTheTrianglesFarFromOtherPoints)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    SCOPED_TRACE(seed);
    const ScatteredPoints scattered(seed);
    const LatticeCore core = scattered.Core();
    ASSERT_FALSE(core.GetTriangles().empty());
    for (const LatticeCore::Triangle& triangle : core.GetTriangles())
    {
      for (const std::size_t corner : triangle)
      {
        EXPECT_TRUE(scattered.IsInside(scattered.lattice.At(corner)));
        EXPECT_GE(scattered.ToOthers(scattered.lattice.At(corner)), Margin);
      }
    }
    // Points are marked in squares of lattice points; these are wider by at most one on either
    // side, and by half a spacing of rounding.
    const double surely = std::sqrt(2.0) * (Margin + 2.0) + 1.0;
    for (int row = 0; row < scattered.lattice.rows; ++row)
    {
      for (int column = 0; column < scattered.lattice.columns; ++column)
      {
        const Point point = scattered.lattice.At(column, row);
        EXPECT_TRUE(!scattered.IsInside(point) || scattered.ToOthers(point) < surely + 1.0 ||
          core.IsInterior(column, row));
      }
    }
  }
}

TEST(LatticeCore, TrianglesAreEquilateralAndBorderEdgesHaveOne)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    SCOPED_TRACE(seed);
    const ScatteredPoints scattered(seed);
    const LatticeCore core = scattered.Core();
    std::map<Edge, int> edges;
    std::vector<int> trianglesAt(scattered.lattice.Count(), 0);
    for (const LatticeCore::Triangle& triangle : core.GetTriangles())
    {
      const std::array<Point, 3> at = { scattered.lattice.At(triangle[0]),
        scattered.lattice.At(triangle[1]), scattered.lattice.At(triangle[2]) };
      EXPECT_GT(Cross(at[1] - at[0], at[2] - at[0]), 0.0);
      for (std::size_t i = 0; i < 3; ++i)
      {
        EXPECT_NEAR((at[i] - at[(i + 1) % 3]).norm(), scattered.lattice.spacing, 1e-13);
        ++edges[{ triangle[i], triangle[(i + 1) % 3] }];
        ++trianglesAt[triangle[i]];
      }
    }
    std::vector<Edge> border;
    for (const auto& [edge, count] : edges)
    {
      EXPECT_EQ(count, 1); // each triangle occurs once
      if (edges.count({ edge.second, edge.first }) == 0)
      {
        border.push_back(edge);
      }
    }
    std::vector<Edge> found;
    for (const auto& edge : core.GetBorder())
    {
      found.emplace_back(edge[0], edge[1]);
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, border);
    for (int row = 0; row < scattered.lattice.rows; ++row)
    {
      for (int column = 0; column < scattered.lattice.columns; ++column)
      {
        EXPECT_EQ(
          core.IsInterior(column, row), trianglesAt[scattered.lattice.NumberOf(column, row)] == 6);
      }
    }
  }
}

TEST(LatticeCore, EachPartContainsAFirstTriangle)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    SCOPED_TRACE(seed);
    const LatticeCore core = ScatteredPoints(seed).Core();
    std::map<Edge, std::size_t> leftOf;
    for (std::size_t t = 0; t < core.GetTriangles().size(); ++t)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        leftOf[{ core.GetTriangles()[t][i], core.GetTriangles()[t][(i + 1) % 3] }] = t;
      }
    }
    std::vector<bool> reached(core.GetTriangles().size(), false);
    std::vector<std::size_t> stack = core.GetFirsts();
    while (!stack.empty())
    {
      const std::size_t t = stack.back();
      stack.pop_back();
      if (reached[t])
      {
        continue;
      }
      reached[t] = true;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const auto other =
          leftOf.find({ core.GetTriangles()[t][(i + 1) % 3], core.GetTriangles()[t][i] });
        if (other != leftOf.end())
        {
          stack.push_back(other->second);
        }
      }
    }
    EXPECT_EQ(std::count(reached.begin(), reached.end(), false), 0);
  }
}
}
}
