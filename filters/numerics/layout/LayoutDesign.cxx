#include "LayoutDesign.h"

#include "DomainQueries.h"
#include "DrillHoles.h"
#include "Stopwatch.h"
#include "TMeshPatches.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
/// Computes the Poincaré-Hopf count and W.
void EvaluateEnergy(
  const FactoredDomain& domain, const SeamlessMapOptions& options, LayoutDesign& design)
{
  const MeshTopology& topology = domain.GetPotential()->GetTopology();
  const PlacedConfiguration placed = PlaceForMap(topology, design.singularities, options);
  const PointPotential potential(domain.GetPotential(),
    AlignWithBoundary(topology, placed.corners, TotalQuarters(placed.interior)));
  design.count = potential.GetProblem().alignment.count;
  design.energy = EvaluateRenormalizedEnergy(potential, potential.Solve(placed.interior));
}
}

LayoutDesign DesignLayout(const FactoredDomain& domain, const Configuration& singularities,
  const LayoutOptions& options, const Progress& progress)
{
  Stopwatch stopwatch;
  RequireInside(domain.GetDomain(), singularities);
  LayoutDesign design;
  design.singularities = singularities;
  EvaluateEnergy(domain, options.map, design);
  progress.Report(0.1);
  design.map = SolveSeamlessMap(ShareTopology(domain.MeshOn(singularities)), singularities,
    options.map, progress.Part(0.1, 0.6));
  design.separatrices = TraceSeparatrices(design.map, progress.Part(0.6, 0.7));
  design.mesh = MakeTMesh(design.map, design.separatrices);
  design.shortestArc = std::numeric_limits<double>::infinity();
  for (const TArc& arc : design.mesh.arcs)
  {
    design.shortestArc = std::min(design.shortestArc, arc.length);
  }
  if (options.quads)
  {
    design.quads = MakeQuads(design.map, design.mesh, *options.quads, progress.Part(0.7, 1.0));
  }
  design.seconds = stopwatch.Lap();
  progress.Report(1.0);
  return design;
}

double LiveMeshSize(const PlanarDomain& domain, double meshSize)
{
  // A step with this number of triangles takes 20 ms on two cores (docs/speed.md), which leaves
  // more than half of the time for drawing at 20 frames per second.
  constexpr double MaximumTriangles = 4000.0;
  DrillOptions options;
  options.meshSize = meshSize;
  // Equilateral triangles of area √3/4 h² each.
  return std::max(ResolveMeshSize(options, domain),
    std::sqrt(4.0 * domain.Area() / (std::sqrt(3.0) * MaximumTriangles)));
}
}
