#include "LayoutDesign.h"

#include "CleanBlocks.h"
#include "DomainQueries.h"
#include "DrillHoles.h"
#include "PoincareHopf.h"
#include "Stopwatch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
/// Computes the Poincaré-Hopf count and W.
void EvaluateEnergy(const FactoredDomain& domain, const Configuration& singularities,
  const SeamlessMapOptions& options, LayoutDesign& design)
{
  const PlanarTopology& topology = domain.GetPotential()->GetTopology();
  const PlacedConfiguration placed = PlaceForMap(topology, singularities, options);
  const PointPotential potential(domain.GetPotential(),
    AlignWithBoundary(topology, placed.corners, TotalQuarters(placed.interior)));
  design.energy = EvaluateRenormalizedEnergy(potential, potential.Solve(placed.interior));
  design.reason =
    ConsistencyReason(potential.GetProblem().alignment.count, design.energy.holonomyDefect);
}

/// Replaces layout and quads by those of fewer blocks, if there are any.
void Clean(const FactoredDomain& domain, const LayoutOptions& options, LayoutDesign& design,
  const Progress& progress)
{
  CleanOptions clean;
  clean.map = options.map;
  clean.meshSize = domain.GetMeshSize();
  clean.quads = *options.quads;
  MeshedLayout start{ std::move(design.layouts), std::move(*design.quads) };
  CleanBlocksResult result = CleanBlocks(domain.GetDomain(), std::move(start), clean, progress);
  design.layouts = std::move(result.mesh.layouts);
  design.quads = std::move(result.mesh.quads);
  if (result.accepted)
  {
    EvaluateEnergy(domain, design.layouts.Single().singularities, options.map, design);
  }
}
}

double ShortestArc(const TMesh& mesh)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (const TArc& arc : mesh.arcs)
  {
    shortest = std::min(shortest, arc.length);
  }
  return shortest;
}

LayoutDesign DesignLayout(const FactoredDomain& domain, const Configuration& singularities,
  const LayoutOptions& options, const Progress& progress)
{
  Stopwatch stopwatch;
  RequireInside(domain.GetDomain(), singularities);
  LayoutDesign design;
  EvaluateEnergy(domain, singularities, options.map, design);
  progress.Report(0.1);
  design.layouts = LayoutSet(LayOut(ShareTopology(domain.MeshOn(singularities)), singularities,
    options.map, options.clean, progress.Part(0.1, 0.7)));
  design.nodes.singularities = singularities;
  if (options.quads)
  {
    design.quads =
      MakeQuads(design.layouts, *options.quads, progress.Part(0.7, options.clean ? 0.75 : 1.0));
    if (options.clean)
    {
      Clean(domain, options, design, progress.Part(0.75, 1.0));
    }
    design.nodes = FindNodePositions(
      design.layouts.Single().map, design.quads->mesh, singularities, singularities);
  }
  const Layout& layout = design.layouts.Single();
  design.shortestArc = ShortestArc(layout.tMesh);
  design.colours = ColourPatches(layout.tMesh, options.earlier);
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
