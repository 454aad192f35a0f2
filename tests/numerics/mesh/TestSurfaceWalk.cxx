#include "SurfaceWalk.h"

#include "Support.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"

#include <Eigen/Geometry>

#include <cmath>

namespace crossfield::test
{
namespace
{
TEST(SurfaceWalk, IsThatOfThePlaneWhenAMeshIsBent)
{
  constexpr int N = 8;
  const TriangleMesh mesh = GridOfSquare(N);
  const auto planar = ShareTopology(mesh);
  const SurfaceTopology bent(BentAtRandom(mesh, N, 601));
  const SurfaceWalk walk(*planar);
  const SurfaceWalk onBent(bent);
  Random random(602);
  for (int trial = 0; trial < 200; ++trial)
  {
    const int t = random.Integer(0, planar->TriangleCount() - 1);
    const Point start = planar->CentreOf(t);
    const Point step(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
    const MeshPlace end = walk.Walk({ t, start }, InSpace(step));
    const Point target = start + step;
    const bool isInside = target.minCoeff() > 0.0 && target.maxCoeff() < 1.0;
    if (isInside)
    {
      EXPECT_LT((walk.PlaceOf(end) - InSpace(target)).norm(), 1e-13);
    }
    else
    {
      // On the outline, where the step leaves the square.
      const Point left = walk.PlaceOf(end).head<2>();
      EXPECT_LT(std::min(left.minCoeff(), 1.0 - left.maxCoeff()), 1e-13);
      EXPECT_LT(std::abs(Cross(left - start, step)), 1e-13);
    }
    // The same step in the chart of the triangle of the bent mesh.
    const Point side = planar->At(t, 1) - planar->At(t, 0);
    const Point sideOfBent = bent.At(t, 1) - bent.At(t, 0);
    const double angle = AngleBetween(side, sideOfBent);
    const Point turned = Eigen::Rotation2Dd(angle) * step;
    const auto& v = mesh.triangles[static_cast<std::size_t>(t)];
    TangentAxes axes;
    axes.col(0) = bent.PositionOf(v[1]) - bent.PositionOf(v[0]);
    axes.col(0).normalize();
    axes.col(1) = bent.NormalOf(t).cross(axes.col(0));
    const Point unit = sideOfBent.normalized();
    const SpacePoint inSpace =
      axes * Point(unit.dot(turned), Cross(unit, turned)); // components along side 0
    const MeshPlace endOnBent = onBent.Walk({ t, bent.CentreOf(t) }, inSpace);
    // Distances along x from the lines and along y stay.
    const SpacePoint straight = TurnOfBent().transpose() * onBent.PlaceOf(endOnBent);
    EXPECT_NEAR(straight.y(), walk.PlaceOf(end).y(), 1e-12);
    EXPECT_EQ(endOnBent.triangle / (2 * N), end.triangle / (2 * N));
  }
}

TEST(SurfaceWalk, FollowsGreatCirclesOfASphere)
{
  const SurfaceTopology sphere(CubedSphere(24));
  const SurfaceWalk walk(sphere);
  Random random(603);
  for (int trial = 0; trial < 50; ++trial)
  {
    const int t = random.Integer(0, sphere.TriangleCount() - 1);
    const MeshPlace start = { t, sphere.CentreOf(t) };
    const SpacePoint from = walk.PlaceOf(start).normalized();
    const double length = random.Uniform(0.1, 2.0);
    const SpacePoint direction = AxesOf(sphere.NormalOf(t)) * Point(0.6, 0.8);
    const MeshPlace end = walk.Walk(start, length * direction);
    const SpacePoint expected = std::cos(length) * from + std::sin(length) * direction;
    // Up to 30 edges turn the path, each by a few parts of a thousand.
    EXPECT_LT((walk.PlaceOf(end) - expected).norm(), 0.015);
    EXPECT_LT((walk.NormalAt(end) - walk.PlaceOf(end).normalized()).norm(), 5e-3);
  }
}

TEST(SurfaceWalk, FindsWhatIsNear)
{
  const SurfaceTopology sphere(CubedSphere(12));
  const SurfaceWalk walk(sphere);
  Random random(604);
  for (int trial = 0; trial < 50; ++trial)
  {
    const int t = random.Integer(0, sphere.TriangleCount() - 1);
    const SpacePoint in = walk.PlaceOf({ t, sphere.CentreOf(t) });
    EXPECT_LT((walk.PlaceOf(walk.Find(t, in)) - in).norm(), 1e-14);
    // A few triangles away and off the surface: the point below it.
    const SpacePoint off = 1.1 * (in + 0.3 * AxesOf(in.normalized()).col(0));
    const SpacePoint found = walk.PlaceOf(walk.Find(t, off));
    EXPECT_LT(found.normalized().cross(off.normalized()).norm(), 0.015);
  }
}
}
}
