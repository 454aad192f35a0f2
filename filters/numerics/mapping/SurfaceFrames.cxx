#include "SurfaceFrames.h"

#include "PhaseSteps.h"

#include <utility>

namespace crossfield
{
SurfaceFrames SolveSurfaceFrames(
  const SharedTopology& topology, const std::vector<Cone>& cones, const Progress& progress)
{
  const VertexPotential potential(topology, progress);
  VertexPotential::Solution solution = potential.Solve(QuartersOfVertices(*topology, cones));
  SurfaceFrames result;
  result.h = 0.25 * solution.potential.head(topology->VertexCount());
  result.frames = FrameTriangles(*topology, StepsOf(potential, solution));
  result.frames.h.array() -= result.frames.h.mean();
  result.holonomyDefect = std::move(solution.holonomyDefect);
  return result;
}
}
