#include "SeamlessMapSolve.h"

#include "DomainQueries.h"
#include "Error.h"
#include "FlatMetric.h"
#include "InjectivityCheck.h"
#include "PhaseSteps.h"
#include "PoincareHopf.h"
#include "TargetSolve.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace crossfield
{
namespace
{
/// Returns the vertex nearest to a position, within `reach`; −1 if there is none.
int VertexAt(const PlanarTopology& topology, const Point& position, double reach)
{
  int nearest = -1;
  double distance = reach;
  for (int v = 0; v < static_cast<int>(topology.mesh.points.size()); ++v)
  {
    const double here = (topology.PointAt(v) - position).norm();
    if (here <= distance)
    {
      nearest = v;
      distance = here;
    }
  }
  return nearest;
}

/// Finds the cones of singularities, then of corners. Throws Error where one has no cone angle or
/// no vertex.
std::vector<Cone> FindCones(
  const PlanarTopology& topology, const PlacedConfiguration& placed, const PoincareHopfCount& count)
{
  std::vector<Cone> cones;
  const double reach = BoundaryReach * BoundingDiagonal(topology.AlignedLoops());
  for (std::size_t i = 0; i < placed.interior.size(); ++i)
  {
    const Singularity& singularity = placed.interior[i];
    if (singularity.quarterIndex == 0)
    {
      continue;
    }
    const std::string where = Describe(singularity.position);
    RequireAngle({ -1, singularity.quarterIndex, false, -1 }, where);
    const int vertex = VertexAt(topology, singularity.position, reach);
    if (vertex < 0 && SignedDistance(singularity.position, { topology.AlignedLoops() }) < 0.0)
    {
      throw Error("The singularity at " + where + " lies outside the domain; move it inside.");
    }
    if (vertex < 0)
    {
      throw Error("The singularity at " + where +
        " is at no vertex of the mesh; give the domain instead of the mesh, or a mesh with a "
        "vertex there.");
    }
    cones.push_back({ vertex, singularity.quarterIndex, false, static_cast<int>(placed.rows[i]) });
  }
  for (const CountedCorner& corner : count.corners)
  {
    RequireAngle({ -1, corner.quarterIndex, true, -1 }, Describe(corner.position));
    if (corner.quarterIndex != 0)
    {
      cones.push_back({ topology.VertexOf(corner), corner.quarterIndex, true, -1 });
    }
  }
  return cones;
}

/// Solves for H and the crosses. Without a given solver, frees their factor before that of the map is
/// made, which takes twice as much memory. Sets the holonomy defects.
TriangleFrames SolveFrames(const SharedPlanarTopology& topology,
  std::shared_ptr<const PotentialSolver> solver, Alignment alignment, const Configuration& interior,
  std::vector<double>& holonomyDefect, const Progress& progress)
{
  if (!solver)
  {
    solver = std::make_shared<const PotentialSolver>(topology, progress.Part(0.0, 0.7));
  }
  const PointPotential potential(std::move(solver), std::move(alignment));
  const PointPotential::Solution solution = potential.Solve(interior);
  holonomyDefect = solution.holonomyDefect;
  TriangleFrames frames =
    FrameTriangles(potential.GetProblem().Topology(), StepsOf(potential, solution));
  frames.h.array() -= frames.h.mean();
  progress.Report(1.0);
  return frames;
}

/// Returns a number with one decimal.
std::string Rounded(double value)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << value;
  return text.str();
}

/// Throws the error of a map that is not injective.
[[noreturn]] void Refuse(
  const MapFault& fault, const FlatteningReport& report, const std::vector<double>& holonomyDefect)
{
  const std::string what = DescribeFault(fault);
  const auto worst = std::max_element(holonomyDefect.begin(), holonomyDefect.end(),
    [](double a, double b) { return std::abs(a) < std::abs(b); });
  // Radians of the phase: one degree of the crosses.
  constexpr double Harmless = 4.0 * Pi / 180.0;
  if (worst != holonomyDefect.end() && std::abs(*worst) > Harmless)
  {
    throw Error(what + ", because the grid lines around inner loop " +
        std::to_string(worst - holonomyDefect.begin() + 1) + " do not close up by " +
        CrossAngle(*worst) + " and a map that closes them (predicted stretch " +
        Rounded(report.PredictedStretch()) + " : 1) was not found",
      "move singularities to positions where they close up", Error::Kind::CoarseMesh);
  }
  throw Error(what,
    "use a finer mesh, smooth the boundary if it has a thin tip there, or move singularities away "
    "from each other and from the boundary",
    Error::Kind::CoarseMesh);
}
}

PlacedConfiguration PlaceForMap(const PlanarTopology& topology, const Configuration& configuration,
  const SeamlessMapOptions& options)
{
  return PlaceConfiguration(topology, configuration,
    options.capCorners ? CapCorners(CountMeshQuarters(topology, options.corners), options.corners)
                       : options.corners);
}

SeamlessMap SolveSeamlessMap(const SharedPlanarTopology& topology,
  const Configuration& configuration, const SeamlessMapOptions& options, const Progress& progress,
  const std::shared_ptr<const PotentialSolver>& potential)
{
  for (const Singularity& singularity : configuration)
  {
    if (!singularity.position.allFinite())
    {
      throw Error("A singularity has a coordinate that is not a finite number; correct it.");
    }
  }
  const PlacedConfiguration placed = PlaceForMap(*topology, configuration, options);
  Alignment alignment =
    AlignWithBoundary(*topology, placed.corners, TotalQuarters(placed.interior));
  const std::vector<Cone> cones = FindCones(*topology, placed, alignment.count);
  progress.Report(0.05);
  std::vector<double> holonomyDefect;
  const TriangleFrames frames = SolveFrames(topology, potential, std::move(alignment),
    placed.interior, holonomyDefect, progress.Part(0.05, 0.3));
  SeamlessMap map = SolveTargets(
    { topology, frames.jump, TargetGradients(*topology, frames) }, cones, progress.Part(0.3, 0.5));
  if (const auto fault = FindFault(map))
  {
    FlattenedTargets flat = FlattenFrames(*topology, frames, cones, progress.Part(0.5, 0.8));
    if (flat.report.converged)
    {
      map = SolveTargets(std::move(flat.targets), cones, progress.Part(0.8, 1.0));
      map.flattening = flat.report;
    }
    if (!flat.report.converged || FindFault(map))
    {
      Refuse(*fault, flat.report, holonomyDefect);
    }
  }
  map.holonomyDefect = std::move(holonomyDefect);
  progress.Report(1.0);
  return map;
}
}
