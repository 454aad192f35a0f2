// Meshes of symmetric domains are symmetric up to rounding, and are meshes of the domain.

#include "MeshForPoints.h"

#include "ConfigurationSymmetry.h"
#include "MakePlanarDomain.h"
#include "MeshTopology.h"
#include "Support.h"

#include <cmath>
#include <map>
#include <set>

namespace crossfield::test
{
namespace
{
/// Returns a disk with holes on a circle and, if `central` is positive, one in the middle.
PlanarDomain Flange(int holes, double central)
{
  std::vector<Loop> loops = { RegularPolygon(12 * holes) };
  for (int i = 0; i < holes; ++i)
  {
    const double angle = 2.0 * Pi * i / holes;
    Loop hole;
    for (const Point& point : RegularPolygon(24, 0.12))
    {
      hole.push_back(Eigen::Rotation2Dd(angle) * Point(point + Point(0.6, 0.0)));
    }
    loops.push_back(hole);
  }
  if (central > 0.0)
  {
    loops.push_back(RegularPolygon(6 * holes, central));
  }
  return MakePlanarDomain(loops);
}

/// Expects that a mesh has the symmetries of a group: images of points are points, and those of
/// triangles are triangles.
void ExpectSymmetric(const TriangleMesh& mesh, const SymmetryGroup& group, double diagonal)
{
  std::map<std::pair<long long, long long>, int> numbers;
  const double cell = 1e-8 * diagonal;
  const auto key = [&](const Point& point)
  { return std::pair(std::llround(point.x() / cell), std::llround(point.y() / cell)); };
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    numbers[key(mesh.points[p])] = static_cast<int>(p);
  }
  const auto find = [&](const Point& point)
  {
    const auto [x, y] = key(point);
    for (const long long dx : { 0, -1, 1 })
    {
      for (const long long dy : { 0, -1, 1 })
      {
        const auto found = numbers.find({ x + dx, y + dy });
        if (found != numbers.end() &&
          (mesh.points[static_cast<std::size_t>(found->second)] - point).norm() < 1e-13 * diagonal)
        {
          return found->second;
        }
      }
    }
    return -1;
  };
  std::set<std::set<int>> triangles;
  for (const auto& triangle : mesh.triangles)
  {
    triangles.insert({ triangle.begin(), triangle.end() });
  }
  ASSERT_EQ(triangles.size(), mesh.triangles.size());
  for (const Isometry& element : group.Elements())
  {
    for (const auto& triangle : mesh.triangles)
    {
      std::set<int> image;
      for (const int corner : triangle)
      {
        image.insert(find(element(mesh.points[static_cast<std::size_t>(corner)])));
      }
      ASSERT_EQ(triangles.count(image), 1U) << element.angle << (element.reflects ? " mirror" : "");
    }
  }
}

/// Expects a mesh of a domain: its area, its Euler characteristic, and boundary edges that are on
/// the loops whose numbers they have.
void ExpectMeshOf(const PlanarDomain& domain, const TriangleMesh& mesh)
{
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const Point& from = mesh.points[static_cast<std::size_t>(a)];
    const double twice = Cross(mesh.points[static_cast<std::size_t>(b)] - from,
      mesh.points[static_cast<std::size_t>(c)] - from);
    EXPECT_GT(twice, 0.0);
    area += 0.5 * twice;
  }
  EXPECT_NEAR(area, domain.Area(), 1e-11 * domain.Area());
  const SharedPlanarTopology topology = ShareTopology(mesh);
  EXPECT_EQ(topology->edges.EulerCharacteristic(topology->mesh), domain.EulerCharacteristic());
  for (const BoundaryEdge& edge : mesh.boundary)
  {
    for (const int vertex : edge.vertices)
    {
      EXPECT_LT(DistanceToLoop(mesh.points[static_cast<std::size_t>(vertex)],
                  domain.loops[static_cast<std::size_t>(edge.id)]),
        1e-12);
    }
  }
}

TEST(MirrorSector, MeshesOfSymmetricDomainsAreSymmetric)
{
  const Loop ell = { { 0.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 1.0 }, { 1.0, 1.0 }, { 1.0, 3.0 },
    { 0.0, 3.0 } };
  struct Case
  {
    PlanarDomain domain;
    int elements; ///< Of the group that the mesh has.
  };
  const std::vector<Case> cases = { { MakePlanarDomain({ RegularPolygon(5) }), 10 },
    { MakePlanarDomain({ ell }), 2 }, { Flange(3, 0.0), 6 }, { Flange(6, 0.2), 12 },
    { Flange(13, 0.0), 2 }, { MakePlanarDomain({ RegularPolygon(64) }), 16 } };
  const Similarity moved = { 0.7, 3.0, { 5.0, -2.0 } };
  for (const Case& one : cases)
  {
    for (const PlanarDomain& domain : { one.domain, moved(one.domain) })
    {
      const TriangleMesh mesh = MeshThroughPoints(domain, {});
      ExpectMeshOf(domain, mesh);
      // The largest subgroup with at most 12 mirror lines is used, in one of several positions.
      const SymmetryGroup whole = FindSymmetries(domain);
      const int order = one.elements / 2;
      ASSERT_EQ(whole.order % order, 0);
      const auto hasImage = [&](const Point& image)
      {
        return std::any_of(mesh.points.begin(), mesh.points.end(),
          [&](const Point& other) { return (other - image).norm() < 1e-9; });
      };
      SymmetryGroup group;
      for (int i = 0; i < whole.order / order && group.IsTrivial(); ++i)
      {
        const SymmetryGroup tried = { whole.centre, order, true,
          whole.axis + Pi * i / whole.order };
        const Isometry mirror = tried.Elements().back();
        group = std::all_of(mesh.points.begin(), mesh.points.end(),
                  [&](const Point& point) { return hasImage(mirror(point)); })
          ? tried
          : group;
      }
      ASSERT_FALSE(group.IsTrivial());
      ExpectSymmetric(mesh, group, domain.Diagonal());
    }
  }
}

TEST(MirrorSector, SingularitiesAreVerticesAndDecideTheGroup)
{
  const PlanarDomain plate = MakePlanarDomain(
    { { { -2.0, -1.0 }, { 2.0, -1.0 }, { 2.0, 1.0 }, { -2.0, 1.0 } }, RegularPolygon(32, 0.3) });
  const Configuration four = { { { 0.6, 0.6 }, -1 }, { { -0.6, 0.6 }, -1 }, { { -0.6, -0.6 }, -1 },
    { { 0.6, -0.6 }, -1 } };
  const Configuration onAxis = { { { 1.0, 0.0 }, -1 }, { { 0.0, 0.7 }, 1 } };
  for (const Configuration& singularities : { four, onAxis })
  {
    const TriangleMesh mesh = MeshThroughPoints(plate, singularities);
    ExpectMeshOf(plate, mesh);
    for (const Singularity& singularity : singularities)
    {
      EXPECT_TRUE(std::any_of(mesh.points.begin(), mesh.points.end(),
        [&](const Point& point) { return (point - singularity.position).norm() < 1e-14; }));
    }
    const ConfigurationSymmetry symmetry =
      MatchSymmetry(singularities, FindSymmetries(plate), 1e-9);
    EXPECT_EQ(symmetry.elements.size(), singularities.size() == 4U ? 4U : 1U);
    ExpectSymmetric(mesh, symmetry.group, plate.Diagonal());
  }
}
}
}
