// T-meshes of symmetric configurations have their symmetries: separatrices that arrive at the same
// time pass through each other, and those along edges of the mesh meet head-on.

#include "TMeshSymmetry.h"

#include "MakePlanarDomain.h"
#include "TMeshChecks.h"

#include <algorithm>
#include <set>

namespace crossfield::test
{
namespace
{
/// Returns the number of symmetries of a domain that map a T-mesh to itself.
int CountSymmetries(const TMesh& mesh, const PlanarDomain& domain)
{
  int count = 0;
  for (const Isometry& element : FindSymmetries(domain).Elements())
  {
    const std::vector<int> images = FindArcImages(mesh, element, 1e-6);
    if (images.empty())
    {
      continue;
    }
    ++count;
    EXPECT_EQ(std::set<int>(images.begin(), images.end()).size(), mesh.arcs.size());
    for (std::size_t arc = 0; arc < images.size(); ++arc)
    {
      EXPECT_NEAR(
        mesh.arcs[arc].length, mesh.arcs[static_cast<std::size_t>(images[arc])].length, 1e-9);
    }
  }
  return count;
}

/// Returns a square plate with a T-slot in each side.
PlanarDomain SlottedPlate()
{
  const Loop side = { { 1.0, -0.15 }, { 0.7, -0.15 }, { 0.7, -0.4 }, { 0.5, -0.4 }, { 0.5, 0.4 },
    { 0.7, 0.4 }, { 0.7, 0.15 }, { 1.0, 0.15 }, { 1.0, 1.0 } };
  Loop plate;
  for (int quarter = 0; quarter < 4; ++quarter)
  {
    for (const Point& point : side)
    {
      plate.push_back(TurnByQuarters(point, quarter));
    }
  }
  return MakePlanarDomain({ plate });
}

TEST(TMeshSymmetry, SeparatricesThatArriveAtTheSameTimePassThroughEachOther)
{
  const PlanarDomain plate = SlottedPlate();
  for (const double meshSize : { 0.0, 0.05, 0.03 })
  {
    const TMesh mesh = LinesOf(plate, {}, meshSize);
    ExpectSound(mesh, 1);
    EXPECT_EQ(mesh.headOn, 4);
    EXPECT_EQ(CountSymmetries(mesh, plate), 8);
  }
}

TEST(TMeshSymmetry, ConfigurationsOnAxesKeepTheirSymmetries)
{
  Loop ellipse = RegularPolygon(64);
  for (Point& point : ellipse)
  {
    point.x() *= 2.0;
  }
  const PlanarDomain domain = MakePlanarDomain({ ellipse });
  const Configuration four = { { { 1.2, 0.4 }, 1 }, { { -1.2, 0.4 }, 1 }, { { -1.2, -0.4 }, 1 },
    { { 1.2, -0.4 }, 1 } };
  const Configuration six = { { { 1.5, 0.0 }, 1 }, { { -1.5, 0.0 }, 1 }, { { 0.0, 0.6 }, 1 },
    { { 0.0, -0.6 }, 1 }, { { 0.5, 0.0 }, 1 }, { { -0.5, 0.0 }, 1 }, { { 1.0, 0.0 }, -1 },
    { { -1.0, 0.0 }, -1 } };
  for (const Configuration& singularities : { four, six })
  {
    const TMesh mesh = LinesOf(domain, singularities, 0.0);
    ExpectSound(mesh, 1);
    EXPECT_EQ(CountSymmetries(mesh, domain), 4);
  }
  Configuration moved = four;
  moved[0].position.x() += 0.1;
  EXPECT_EQ(CountSymmetries(LinesOf(domain, moved, 0.0), domain), 1);
}
}
}
