#include "SurfaceMap.h"

#include "Error.h"
#include "FlatMetric.h"
#include "InjectivityCheck.h"
#include "PoincareHopf.h"
#include "SurfaceFrames.h"
#include "TargetSolve.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// Throws the error of a map that is not injective.
[[noreturn]] void Refuse(
  const MeshTopology& topology, const MapFault& fault, const std::vector<double>& holonomyDefect)
{
  const std::string what = DescribeFault(fault);
  const auto worst = std::max_element(holonomyDefect.begin(), holonomyDefect.end(),
    [](double a, double b) { return std::abs(a) < std::abs(b); });
  constexpr double Harmless = 4.0 * Pi / 180.0; // one degree of the crosses
  if (worst != holonomyDefect.end() && std::abs(*worst) > Harmless)
  {
    const Cycle& cycle = topology.cycles[worst - holonomyDefect.begin()];
    const Cycle::Step& step = cycle.steps.front();
    throw Error(what + ", because crosses do not close up around the " +
        (cycle.IsClosed() ? "handle" : "boundary loop") + " near " +
        topology.Where(topology.mesh.triangles[step.triangle][step.entry]) + ", by " +
        CrossAngle(*worst),
      "move singularities to positions where they do", Error::Kind::CoarseMesh);
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
  SurfaceFrames solved = SolveSurfaceFrames(topology, cones, progress.Part(0.0, 0.3));
  const TriangleFrames& frames = solved.frames;
  SeamlessMap map = SolveTargets(
    { topology, frames.jump, TargetGradients(*topology, frames) }, cones, progress.Part(0.3, 0.6));
  if (const auto fault = FindFault(map))
  {
    FlattenedTargets flat = FlattenFrames(*topology, frames, cones, progress.Part(0.6, 0.8));
    if (flat.report.converged)
    {
      map = SolveTargets(std::move(flat.targets), cones, progress.Part(0.8, 1.0));
      map.flattening = flat.report;
    }
    if (!flat.report.converged || FindFault(map))
    {
      Refuse(*topology, *fault, solved.holonomyDefect);
    }
  }
  map.holonomyDefect = std::move(solved.holonomyDefect);
  if (map.cones.empty() && topology->loops.empty())
  {
    map.cones.push_back({ 0, 0, false, -1 }); // where lines start
  }
  return map;
}
}
