#include "SizeExtension.h"

#include "MakePlanarDomain.h"
#include "MeshForPoints.h"

#include <gtest/gtest.h>

#include <cmath>

namespace crossfield
{
namespace
{
SharedPlanarTopology Plate()
{
  const PlanarDomain plate =
    MakePlanarDomain({ { { 0.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 1.0 }, { 0.0, 1.0 } } });
  return ShareTopology(MeshThroughPoints(plate, {}, 0.1));
}

/// Returns exp(0.4 x − 0.7 y), whose logarithm is linear, hence a harmonic P1 function.
double Size(const Point& place)
{
  return std::exp(0.4 * place.x() - 0.7 * place.y());
}
}

TEST(SizeExtension, IsExactIfTheLogarithmIsLinear)
{
  const SharedPlanarTopology topology = Plate();
  const auto count = static_cast<Eigen::Index>(topology->mesh.points.size());
  Eigen::VectorXd sizes = Eigen::VectorXd::Constant(count, -1.0); // inner values are ignored
  for (const BoundaryEdge& edge : topology->mesh.boundary)
  {
    sizes[edge.vertices[0]] = Size(topology->PointAt(edge.vertices[0]));
  }
  const Eigen::VectorXd extended = ExtendSizes(*topology, sizes);
  for (int v = 0; v < count; ++v)
  {
    EXPECT_NEAR(extended[v] / Size(topology->PointAt(v)), 1.0, 1e-12);
  }
}

TEST(SizeExtension, EquivalentSizeGivesTheSameNumberOfQuads)
{
  const SharedPlanarTopology topology = Plate();
  const auto count = static_cast<Eigen::Index>(topology->mesh.points.size());
  EXPECT_NEAR(EquivalentSize(topology->mesh, Eigen::VectorXd::Constant(count, 0.3)), 0.3, 1e-12);
  Eigen::VectorXd sizes(count);
  for (int v = 0; v < count; ++v)
  {
    sizes[v] = Size(topology->PointAt(v));
  }
  // ∫ exp(−0.8 x + 1.4 y) over [0, 3] × [0, 1]
  const double quads = (1.0 - std::exp(-2.4)) / 0.8 * (std::exp(1.4) - 1.0) / 1.4;
  EXPECT_NEAR(EquivalentSize(topology->mesh, sizes), std::sqrt(3.0 / quads), 2e-3);
}
}
