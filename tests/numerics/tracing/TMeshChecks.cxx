#include "TMeshChecks.h"

#include "MeshForPoints.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace crossfield::test
{
TMesh LinesOf(const PlanarDomain& domain, const Configuration& configuration, double meshSize,
  const SeamlessMapOptions& options)
{
  const SeamlessMap map = SolveSeamlessMap(
    ShareTopology(MeshThroughPoints(domain, configuration, meshSize)), configuration, options);
  return MakeTMesh(map, TraceSeparatrices(map));
}

double MapArea(const TMesh& mesh)
{
  double area = 0.0;
  for (const TPatch& face : mesh.patches)
  {
    area += mesh.SideLength(face, 0) * mesh.SideLength(face, 1);
  }
  return area;
}

void ExpectSound(const TMesh& mesh, int euler)
{
  int singularities = 0;
  int corners = 0;
  for (const TNode& node : mesh.nodes)
  {
    singularities += node.kind == NodeKind::Singularity ? 1 : 0;
    corners += node.kind == NodeKind::Corner ? 1 : 0;
  }
  EXPECT_EQ(Count(mesh.patches.size()),
    mesh.separatrixCount - mesh.headOn + mesh.ties - singularities + euler);
  EXPECT_EQ(Count(mesh.arcs.size()),
    2 * mesh.separatrixCount + corners + mesh.extraSeparatrices - 3 * mesh.headOn + 2 * mesh.ties -
      mesh.crossings);
  // Lines on one isoline by symmetry only differ by the rounding error of the solve.
  const bool isExact = mesh.headOn == 0 && mesh.crossings == 0 && mesh.ties == 0;
  EXPECT_LE(mesh.Mismatch(), isExact ? 0.0 : 2.0 * SameIsoline * std::sqrt(MapArea(mesh)));
  const double area = MapArea(mesh);
  double domain = 0.0;
  for (const TPatch& face : mesh.patches)
  {
    Loop loop;
    for (const auto& side : face.sides)
    {
      for (const int h : side)
      {
        std::vector<SpacePoint> path = mesh.arcs[static_cast<std::size_t>(h / 2)].polyline;
        if (h % 2 == 1)
        {
          std::reverse(path.begin(), path.end());
        }
        std::transform(path.begin(), path.end() - 1, std::back_inserter(loop),
          [](const SpacePoint& place) { return place.head<2>(); });
      }
    }
    domain += SignedArea(loop);
  }
  // The map has the area of the domain, and the patches fill it.
  EXPECT_NEAR(area, domain, 1e-9 * domain);
}

TMesh LinesOn(const TriangleMesh& mesh, const Configuration& configuration)
{
  const SeamlessMap map = SolveSeamlessMap(ShareTopology(mesh), configuration);
  return MakeTMesh(map, TraceSeparatrices(map));
}
}
