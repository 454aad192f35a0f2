#include "SurfaceMap.h"

#include "Error.h"
#include "InjectivityCheck.h"
#include "PhaseSteps.h"
#include "PoincareHopf.h"
#include "TargetSolve.h"

#include <cmath>
#include <string>

namespace crossfield
{
namespace
{
/// Returns the quarter index of each vertex.
std::vector<int> QuartersOf(const MeshTopology& topology, const std::vector<Cone>& cones)
{
  std::vector<int> quarters(static_cast<std::size_t>(topology.VertexCount()), 0);
  for (const Cone& cone : cones)
  {
    RequireAngle(cone, topology.Where(cone.vertex));
    quarters[cone.vertex] += cone.quarterIndex;
  }
  return quarters;
}

/// Throws Error if the phase does not close up around a closed cycle.
void RequireClosed(const MeshTopology& topology, const std::vector<double>& holonomyDefect)
{
  constexpr double Rounding = 1e-6; // as in FrameTriangles
  for (std::size_t k = 0; k < holonomyDefect.size(); ++k)
  {
    if (topology.cycles[k].IsClosed() && std::abs(holonomyDefect[k]) > Rounding)
    {
      const int triangle = topology.cycles[k].steps.front().triangle;
      throw Error("Crosses do not close up around the handle near " +
        topology.Where(topology.mesh.triangles[triangle][0]) + ", by " +
        CrossAngle(holonomyDefect[k]) + "; move singularities to positions where they do.");
    }
  }
}
}

SeamlessMap SolveSurfaceMap(
  const SharedTopology& topology, const std::vector<Cone>& cones, const Progress& progress)
{
  const std::vector<int> quarters = QuartersOf(*topology, cones);
  const VertexPotential potential(topology, progress.Part(0.0, 0.3));
  VertexPotential::Solution solution = potential.Solve(quarters);
  RequireClosed(*topology, solution.holonomyDefect);
  TriangleFrames frames = FrameTriangles(*topology, StepsOf(potential, solution));
  frames.h.array() -= frames.h.mean();
  SeamlessMap map = SolveTargets(
    { topology, frames.jump, TargetGradients(*topology, frames) }, cones, progress.Part(0.3, 1.0));
  if (const auto fault = FindFault(map))
  {
    throw Error(DescribeFault(*fault),
      "use a finer mesh, or move singularities away from each other and from the boundary",
      Error::Kind::CoarseMesh);
  }
  map.holonomyDefect = std::move(solution.holonomyDefect);
  return map;
}
}
