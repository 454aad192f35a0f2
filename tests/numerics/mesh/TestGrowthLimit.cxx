// Limited growth: the exact sizes around a point and a corner, the bound of the slope, and idempotence.

#include "GrowthLimit.h"

#include "MakePlanarDomain.h"
#include "PlanarTopology.h"
#include "Support.h"

#include <limits>

namespace crossfield::test
{
namespace
{
constexpr double Growth = 0.22;

/// Returns values that are infinite except at the vertex nearest to a place, and this vertex.
std::pair<Eigen::VectorXd, int> OnlyAt(
  const PlanarTopology& topology, const Point& place, double value)
{
  int nearest = 0;
  for (int v = 1; v < topology.VertexCount(); ++v)
  {
    if ((topology.PointAt(v) - place).norm() < (topology.PointAt(nearest) - place).norm())
    {
      nearest = v;
    }
  }
  Eigen::VectorXd values =
    Eigen::VectorXd::Constant(topology.VertexCount(), std::numeric_limits<double>::infinity());
  values[nearest] = value;
  return { values, nearest };
}

/// Returns the distance inside the L-shape [0, 2]² without [1, 2]².
double DistanceInLShape(const Point& from, const Point& to)
{
  const bool isAround = (from.x() > 1.0 && to.y() > 1.0) || (from.y() > 1.0 && to.x() > 1.0);
  const Point corner(1.0, 1.0);
  const bool isSeen = Cross(to - from, corner - from) * (from.x() > 1.0 ? 1.0 : -1.0) <= 0.0;
  return isAround && !isSeen ? (corner - from).norm() + (to - corner).norm() : (to - from).norm();
}

TEST(GrowthLimit, IsTheDistanceInsideTheDomain)
{
  const PlanarDomain shape = MakePlanarDomain(
    { { { 0.0, 0.0 }, { 2.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 1.0 }, { 1.0, 2.0 }, { 0.0, 2.0 } } });
  std::vector<double> errors;
  const std::vector<double> edges = { 0.2, 0.1, 0.05, 0.025 };
  for (const double edge : edges)
  {
    const SharedPlanarTopology topology = ShareTopology(DrillMesh(shape, {}, edge));
    const auto [values, vertex] = OnlyAt(*topology, { 1.8, 0.3 }, 0.1);
    const Eigen::VectorXd limited = LimitGrowth(*topology, values, Growth);
    double largest = 0.0;
    for (int v = 0; v < topology->VertexCount(); ++v)
    {
      const double exact =
        0.1 + Growth * DistanceInLShape(topology->PointAt(vertex), topology->PointAt(v));
      EXPECT_GT(limited[v], exact - 1e-9); // the way through triangles is not shorter
      largest = std::max(largest, limited[v] - exact);
    }
    errors.push_back(largest);
  }
  EXPECT_LT(errors.back(), 0.02 * Growth);
  EXPECT_GT(ConvergenceRate(edges, errors), 0.5);
}

TEST(GrowthLimit, BoundsTheSlopeAndChangesNothingElse)
{
  Random random(3);
  for (int example = 0; example < 5; ++example)
  {
    const SharedPlanarTopology topology =
      ShareTopology(DrillMesh(RandomSmoothDomain(random), {}, 0.1));
    Eigen::VectorXd values(topology->VertexCount());
    for (Eigen::Index v = 0; v < values.size(); ++v)
    {
      values[v] = random.Uniform(0.01, 0.5);
    }
    const Eigen::VectorXd limited = LimitGrowth(*topology, values, Growth);
    EXPECT_TRUE((limited.array() <= values.array()).all());
    EXPECT_EQ(limited.minCoeff(), values.minCoeff());
    for (const auto& [from, to] : topology->edges.vertices)
    {
      const double length = (topology->PointAt(to) - topology->PointAt(from)).norm();
      EXPECT_LE(std::abs(limited[to] - limited[from]), (1.0 + 1e-6) * Growth * length);
    }
    EXPECT_LT((LimitGrowth(*topology, limited, Growth) - limited).cwiseAbs().maxCoeff(), 1e-8);
    // Linear functions with a smaller slope stay as they are.
    for (Eigen::Index v = 0; v < values.size(); ++v)
    {
      values[v] = Point(0.1, -0.15).dot(topology->PointAt(static_cast<int>(v)));
    }
    EXPECT_EQ(LimitGrowth(*topology, values, Growth), values);
  }
}
}
}
