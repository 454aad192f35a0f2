#include "SeamlessMapSolve.h"

#include "CoordinateSolve.h"
#include "DomainQueries.h"
#include "Error.h"
#include "Index.h"
#include "InjectivityCheck.h"
#include "PoincareHopf.h"
#include "SeamEquations.h"
#include "TriangleFrames.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Returns the vertex nearest to a position, within `reach`; −1 if there is none.
int VertexAt(const MeshTopology& topology, const Point& position, double reach)
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
  const MeshTopology& topology, const PlacedConfiguration& placed, const PoincareHopfCount& count)
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
    if (singularity.quarterIndex > 2)
    {
      throw Error("The singularity at " + where + " has quarter index " +
        std::to_string(singularity.quarterIndex) +
        ", which no node of a quad mesh has; split it into several of index 1.");
    }
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
    if (corner.quarterIndex > 1)
    {
      throw Error("The corner at " + Describe(corner.position) + " has quarter index " +
        std::to_string(corner.quarterIndex) +
        " and so no angle in a seamless map; cap corners, or choose index 1 for it, and add the "
        "difference to the singularities inside.");
    }
    if (corner.quarterIndex != 0)
    {
      cones.push_back({ topology.VertexOf(corner), corner.quarterIndex, true, -1 });
    }
  }
  return cones;
}

/// Solves for H and the crosses. Frees their factor before that of the map is made, which takes
/// twice as much memory.
TriangleFrames SolveFrames(
  Alignment alignment, const Configuration& interior, SeamlessMap& map, const Progress& progress)
{
  const PointPotential potential(
    std::make_shared<const PotentialSolver>(map.topology, progress.Part(0.0, 0.7)),
    std::move(alignment));
  const PointPotential::Solution solution = potential.Solve(interior);
  map.holonomyDefect = solution.holonomyDefect;
  TriangleFrames frames = FrameTriangles(potential, solution);
  frames.h.array() -= frames.h.mean();
  progress.Report(1.0);
  return frames;
}

/// Shifts the branches of the frames so that they are continuous except across the cut.
void ContinueBranches(const MeshTopology& topology, const CutGraph& cut, TriangleFrames& frames)
{
  std::vector<int> shift(frames.jump.size(), 0);
  std::vector<bool> known(frames.jump.size(), false);
  std::vector<int> queue = { 0 };
  known[0] = true;
  const auto neighbour = [&topology](int t, std::size_t side)
  {
    const auto& two = topology.edges.triangles[Index(topology.edges.ofTriangle[Index(t)][side])];
    return two[0] == t ? two[1] : two[0];
  };
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    const int t = queue[next];
    for (std::size_t side = 0; side < 3; ++side)
    {
      const int other = neighbour(t, side);
      if (other >= 0 && !known[Index(other)] &&
        !cut.isCut[Index(topology.edges.ofTriangle[Index(t)][side])])
      {
        known[Index(other)] = true;
        shift[Index(other)] = shift[Index(t)] + frames.jump[Index(t)][side];
        queue.push_back(other);
      }
    }
  }
  for (int t = 0; t < static_cast<int>(shift.size()); ++t)
  {
    frames.angle[t] += 0.5 * Pi * shift[Index(t)];
    for (std::size_t side = 0; side < 3; ++side)
    {
      int& jump = frames.jump[Index(t)][side];
      const int other = neighbour(t, side);
      jump += other < 0 ? -shift[Index(t)] : shift[Index(t)] - shift[Index(other)];
      if (other >= 0 && jump != 0 && !cut.isCut[Index(topology.edges.ofTriangle[Index(t)][side])])
      {
        throw Error("The cross field has a singularity near " +
          Describe(topology.Midpoint(topology.edges.ofTriangle[Index(t)][side])) +
          " that was not given; use a finer mesh there.");
      }
    }
  }
}

/// Returns the position of an edge in a triangle.
int SideOf(const MeshTopology& topology, int triangle, int edge)
{
  const auto& sides = topology.edges.ofTriangle[Index(triangle)];
  return static_cast<int>(std::find(sides.begin(), sides.end(), edge) - sides.begin());
}

int Modulo4(int quarters)
{
  return ((quarters % 4) + 4) % 4;
}

/// Sets the seams with their rotations, and the directions of boundary edges.
void CollectTransitions(const CutGraph& cut, const TriangleFrames& frames, SeamlessMap& map)
{
  const MeshTopology& topology = *map.topology;
  map.seams.assign(topology.mesh.triangles.size(), { 0, 0, 0 });
  for (std::size_t chain = 0; chain < cut.chains.size(); ++chain)
  {
    const auto& [vertices, edges] = cut.chains[chain];
    const int code = static_cast<int>(chain) + 1;
    for (std::size_t j = 0; j < edges.size(); ++j)
    {
      const int left = TriangleLeftOf(topology, edges[j], vertices[j]);
      const int right = TriangleLeftOf(topology, edges[j], vertices[j + 1]);
      const auto side = static_cast<std::size_t>(SideOf(topology, left, edges[j]));
      map.seams[Index(left)][side] = code;
      map.seams[Index(right)][static_cast<std::size_t>(SideOf(topology, right, edges[j]))] = -code;
      if (j == 0)
      {
        // θ continued across is the neighbour's plus r π/2, so its w turns by i^r.
        map.transitions.push_back({ Modulo4(frames.jump[Index(left)][side]), Point::Zero() });
      }
    }
  }
  for (int position = 0; position < static_cast<int>(topology.mesh.boundary.size()); ++position)
  {
    const int edge = topology.EdgeOfBoundary(position);
    const int t = topology.edges.triangles[Index(edge)][0];
    map.directions.push_back(
      Modulo4(frames.jump[Index(t)][static_cast<std::size_t>(SideOf(topology, t, edge))]));
  }
}

double MapArea(const SeamlessMap& map)
{
  double area = 0.0;
  for (int t = 0; t < static_cast<int>(map.corners.size()); ++t)
  {
    area += 0.5 * Cross(map.At(t, 1) - map.At(t, 0), map.At(t, 2) - map.At(t, 0));
  }
  return area;
}

/// Stores the solution, scaled to the area of the domain. `objective` is the minimum of the sum.
void SetPoints(const Eigen::VectorXd& solution, double objective, SeamlessMap& map)
{
  const auto point = [&solution](std::size_t i)
  {
    const auto row = static_cast<Eigen::Index>(2 * i);
    return Point(solution[row], solution[row + 1]);
  };
  map.points.clear();
  for (std::size_t c = 0; c < map.original.size(); ++c)
  {
    map.points.push_back(point(c));
  }
  double area = 0.0;
  for (const Loop& loop : map.topology->AlignedLoops())
  {
    area += SignedArea(loop);
  }
  const double mapped = MapArea(map);
  if (!(mapped > 0.0))
  {
    throw Error("The seamless map has no positive area; use a finer mesh.");
  }
  const double scale = std::sqrt(area / mapped);
  for (Point& w : map.points)
  {
    w *= scale;
  }
  for (std::size_t chain = 0; chain < map.transitions.size(); ++chain)
  {
    map.transitions[chain].translation = scale * point(map.original.size() + chain);
  }
  map.residual = std::sqrt(std::max(0.0, objective) / area);
}
}

PlacedConfiguration PlaceForMap(const MeshTopology& topology, const Configuration& configuration,
  const SeamlessMapOptions& options)
{
  return PlaceConfiguration(topology, configuration,
    options.capCorners ? CapCorners(CountMeshQuarters(topology, options.corners), options.corners)
                       : options.corners);
}

SeamlessMap SolveSeamlessMap(const SharedTopology& topology, const Configuration& configuration,
  const SeamlessMapOptions& options, const Progress& progress)
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
  SeamlessMap map;
  map.topology = topology;
  map.cones = FindCones(*topology, placed, alignment.count);
  progress.Report(0.05);
  TriangleFrames frames =
    SolveFrames(std::move(alignment), placed.interior, map, progress.Part(0.05, 0.4));

  std::vector<int> singular;
  for (const Cone& cone : map.cones)
  {
    if (!cone.onBoundary)
    {
      singular.push_back(cone.vertex);
    }
  }
  const CutGraph cut = CutOpen(*topology, singular);
  ContinueBranches(*topology, cut, frames);
  map.corners = cut.corners;
  map.original = cut.original;
  CollectTransitions(cut, frames, map);
  const auto prolongation =
    EliminateSeams(*topology, cut, map.transitions, map.directions, map.cones);
  const SeamlessPoisson poisson = TargetGradients(map, frames);
  progress.Report(0.5);
  const Eigen::VectorXd w = SolveCoordinates(map, poisson, prolongation, progress.Part(0.5, 0.95));

  SetPoints(w, poisson.ObjectiveAt(map, w), map);
  RequireInjective(map);
  progress.Report(1.0);
  return map;
}
}
