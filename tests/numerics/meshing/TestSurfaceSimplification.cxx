#include "SurfaceSimplification.h"

#include "SurfaceParts.h"
#include "Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace crossfield::test
{
namespace
{
/// Returns points − edges + triangles.
int EulerCharacteristicOf(const SurfaceMesh& surface)
{
  std::set<std::array<int, 2>> edges;
  for (const std::array<int, 3>& v : surface.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto [low, high] = std::minmax(v[i], v[(i + 1) % 3]);
      edges.insert({ low, high });
    }
  }
  return static_cast<int>(surface.points.size() + surface.triangles.size()) -
    static_cast<int>(edges.size());
}

TEST(SurfaceSimplification, StaysNearASphere)
{
  const SurfaceMesh sphere = CubedSphere(24);
  const SimplifiedSurface coarse = Simplified(sphere, FindFeatureEdges(sphere, Pi), 2000);
  EXPECT_NEAR(static_cast<double>(coarse.surface.triangles.size()), 2000.0, 4.0);
  EXPECT_EQ(EulerCharacteristicOf(coarse.surface), 2);
  EXPECT_EQ(coarse.features.count, 0U);
  for (const SpacePoint& point : coarse.surface.points)
  {
    EXPECT_NEAR(point.norm(), 1.0, 0.006) << "a triangle is off it by 0.002";
  }
  EXPECT_NEAR(AreaOf(coarse.surface), AreaOf(sphere), 0.003 * AreaOf(sphere));
}

TEST(SurfaceSimplification, ASmallSurfaceIsReturnedAsItIs)
{
  const SurfaceMesh sphere = CubedSphere(4);
  const SimplifiedSurface same = Simplified(sphere, FindFeatureEdges(sphere, Pi), 2000);
  EXPECT_EQ(same.surface.triangles, sphere.triangles);
  EXPECT_EQ(same.features.isFeature.size(), sphere.triangles.size());
}

TEST(SurfaceSimplification, SharpEdgesAndTheBoundaryStay)
{
  for (const SurfaceMesh& surface : { Can(16), Hemisphere(16) })
  {
    const FeatureEdges features = FindFeatureEdges(surface, DefaultFeatureAngle);
    const SimplifiedSurface coarse = Simplified(surface, features, 1000);
    EXPECT_LT(coarse.surface.triangles.size(), 1010U);
    EXPECT_EQ(coarse.features.count, features.count);
    const auto sidesWithout = [](const SurfaceMesh& mesh)
    {
      int count = 0;
      for (const std::array<int, 3>& neighbours : FindNeighbours(mesh))
      {
        count += static_cast<int>(std::count(neighbours.begin(), neighbours.end(), -1));
      }
      return count;
    };
    EXPECT_EQ(sidesWithout(coarse.surface), sidesWithout(surface));
    std::size_t marked = 0;
    for (std::size_t t = 0; t < coarse.surface.triangles.size(); ++t)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        if (coarse.features.isFeature[t][i])
        {
          ++marked;
          const SpacePoint& point =
            coarse.surface.points[static_cast<std::size_t>(coarse.surface.triangles[t][i])];
          EXPECT_NEAR(std::abs(point.z()), 1.0, 1e-12) << "an end of the can";
          EXPECT_NEAR(point.head<2>().norm(), 1.0, 1e-12);
        }
      }
    }
    EXPECT_EQ(marked, 2 * features.count);
  }
}
}
}
