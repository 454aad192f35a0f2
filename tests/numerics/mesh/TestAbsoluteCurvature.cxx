#include "AbsoluteCurvature.h"
#include "Support.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns the largest relative error of |κ₁| + |κ₂| at the points of a surface that are chosen.
template <typename Exact>
double LargestError(const SurfaceMesh& surface, const Exact& exact)
{
  const SurfaceTopology topology(surface);
  const Eigen::VectorXd curvature = AbsoluteCurvature(topology);
  double largest = 0.0;
  for (int vertex = 0; vertex < topology.VertexCount(); ++vertex)
  {
    const double expected = exact(topology.PositionOf(vertex));
    if (expected > 0.0)
    {
      largest = std::max(largest, std::abs(curvature[vertex] / expected - 1.0));
    }
  }
  return largest;
}

TEST(AbsoluteCurvature, IsThatOfASphereAndOfATorus)
{
  const auto ofSphere = [](const SpacePoint&) { return 2.0; };
  EXPECT_LT(LargestError(CubedSphere(16), ofSphere), 0.04);
  EXPECT_LT(LargestError(CubedSphere(32), ofSphere), 0.02);
  // Circles of radius 1 around one of radius 3: κ₁ = 1, κ₂ = cos φ / ρ.
  const auto ofTorus = [](const SpacePoint& place)
  {
    const double radius = place.head<2>().norm();
    return 1.0 + std::abs(radius - 3.0) / radius;
  };
  const double coarse = LargestError(Torus(3.0, 24, 72), ofTorus);
  const double fine = LargestError(Torus(3.0, 48, 144), ofTorus);
  EXPECT_LT(coarse, 0.15);
  EXPECT_LT(fine, 0.6 * coarse);
}

TEST(AbsoluteCurvature, DoesNotDependOnSizeAndPlace)
{
  SurfaceMesh torus = Torus(2.0, 16, 32);
  const Eigen::VectorXd before = AbsoluteCurvature(SurfaceTopology(torus));
  const Eigen::AngleAxisd turn(0.7, SpacePoint(1.0, -2.0, 0.5).normalized());
  for (SpacePoint& point : torus.points)
  {
    point = turn * point * 5.0 + SpacePoint(3.0, 1.0, -2.0);
  }
  const Eigen::VectorXd after = AbsoluteCurvature(SurfaceTopology(torus));
  EXPECT_LT((5.0 * after - before).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(AbsoluteCurvature, VanishesInPlanes)
{
  const TriangleMesh square = GridOfSquare(6);
  SurfaceMesh surface;
  surface.points = InSpace(square.points);
  surface.triangles = square.triangles;
  EXPECT_LT(AbsoluteCurvature(SurfaceTopology(surface)).maxCoeff(), 1e-12);
  // A bent sheet has one curvature, along which its ends are no less bent.
  for (SpacePoint& point : surface.points)
  {
    point = { std::sin(point.x()), point.y(), std::cos(point.x()) };
  }
  EXPECT_LT(LargestError(surface, [](const SpacePoint&) { return 1.0; }), 0.2);
}
}
}
