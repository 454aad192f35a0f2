#include "SampledPatch.h"

#include "SurfaceMap.h"
#include "SurfaceParts.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"
#include "TMeshPatches.h"
#include "TraceGraph.h"

#include <gtest/gtest.h>

#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns the area of all cells.
double AreaOf(const SampledPatch& sample)
{
  SurfaceMesh cells;
  cells.points = sample.places;
  for (int row = 0; row < sample.rows; ++row)
  {
    for (int column = 0; column < sample.columns; ++column)
    {
      const int low = row * (sample.columns + 1) + column;
      const int high = low + sample.columns + 1;
      cells.triangles.push_back({ low, low + 1, high + 1 });
      cells.triangles.push_back({ low, high + 1, high });
    }
  }
  return AreaOf(cells);
}

TEST(SampledPatch, CoversTheSurface)
{
  const SurfaceMesh closed = CubedSphere(12);
  const SurfaceMesh open = Hemisphere(12);
  for (const bool isOpen : { false, true })
  {
    const SurfaceMesh& surface = isOpen ? open : closed;
    const auto topology = std::make_shared<const SurfaceTopology>(surface);
    const SeamlessMap map = SolveSurfaceMap(topology, ConesOfCube(surface));
    const TMesh mesh = MakeTMesh(map, TraceSeparatrices(map));
    double area = 0.0;
    for (const TPatch& patch : mesh.patches)
    {
      const SampledPatch sample = SamplePatch(map, mesh, patch, 0.05);
      ASSERT_EQ(
        sample.places.size(), static_cast<std::size_t>((sample.columns + 1) * (sample.rows + 1)));
      EXPECT_GE(sample.columns, mesh.SideLength(patch, 0) / 0.05);
      for (const SpacePoint& place : sample.places)
      {
        EXPECT_NEAR(place.norm(), 1.0, 0.01) << "on a triangle of the sphere";
      }
      EXPECT_NEAR(
        sample.positions.back().x(), mesh.SideLength(patch, 0), 1e-5 * mesh.SideLength(patch, 0));
      area += AreaOf(sample);
    }
    EXPECT_NEAR(area, crossfield::AreaOf(surface), 0.01 * area);
  }
}
}
}
