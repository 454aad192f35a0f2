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
/// Throws the error of a map that is not injective.
[[noreturn]] void Refuse(
  const MeshTopology& topology, const MapFault& fault, const std::vector<double>& holonomyDefect)
{
  const std::string what = DescribeFault(fault);
  constexpr double Harmless = 4.0 * Pi / 180.0; // one degree of the crosses
  for (std::size_t k = 0; k < holonomyDefect.size(); ++k)
  {
    if (std::abs(holonomyDefect[k]) > Harmless)
    {
      const Cycle::Step& step = topology.cycles[k].steps.front();
      throw Error(what + ", because crosses do not close up around the handle or loop near " +
          topology.Where(topology.mesh.triangles[step.triangle][step.entry]) + ", by " +
          CrossAngle(holonomyDefect[k]),
        "move singularities to positions where they do", Error::Kind::CoarseMesh);
    }
  }
  throw Error(what,
    "use a finer mesh, or move singularities away from each other and from the boundary",
    Error::Kind::CoarseMesh);
}
}

SeamlessMap SolveSurfaceMap(
  const SharedTopology& topology, const std::vector<Cone>& cones, const Progress& progress)
{
  for (const Cone& cone : cones)
  {
    RequireAngle(cone, topology->Where(cone.vertex));
  }
  const VertexPotential potential(topology, progress.Part(0.0, 0.3));
  VertexPotential::Solution solution = potential.Solve(QuartersOfVertices(*topology, cones));
  TriangleFrames frames = FrameTriangles(*topology, StepsOf(potential, solution));
  frames.h.array() -= frames.h.mean();
  SeamlessMap map = SolveTargets(
    { topology, frames.jump, TargetGradients(*topology, frames) }, cones, progress.Part(0.3, 1.0));
  if (const auto fault = FindFault(map))
  {
    Refuse(*topology, *fault, solution.holonomyDefect);
  }
  map.holonomyDefect = std::move(solution.holonomyDefect);
  if (map.cones.empty() && topology->loops.empty())
  {
    map.cones.push_back({ 0, 0, false, -1 }); // where lines start
  }
  return map;
}
}
