#include "TargetSolve.h"

#include "BestAngle.h"
#include "CoordinateSolve.h"
#include "Error.h"
#include "Index.h"
#include "SeamEquations.h"
#include "TriangleArea.h"
#include "TriangleSearch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
int Modulo4(int quarters)
{
  return ((quarters % 4) + 4) % 4;
}

/// Turns the charts of triangles so that they are continuous except across the cut.
void ContinueBranches(const CutGraph& cut, MapTargets& targets)
{
  const MeshTopology& topology = *targets.topology;
  std::vector<int> shift(targets.jumps.size(), 0);
  SearchTriangles(
    topology.TriangleCount(), { 0 },
    [&](int t, int side)
    { return cut.isCut[topology.EdgeOf(t, side)] ? -1 : topology.Neighbour(t, side); },
    [&](int t, int side, int next) { shift[next] = shift[t] + targets.jumps[t][side]; });
  for (int t = 0; t < topology.TriangleCount(); ++t)
  {
    auto& corners = targets.poisson.target[t];
    for (int i = 0; i < 3; ++i)
    {
      // θ grows by the shift, so the target e^{−(H + iθ)} turns back by it.
      corners.row(i) = TurnByQuarters(corners.row(i).transpose(), -shift[t]).transpose();
    }
    for (int side = 0; side < 3; ++side)
    {
      int& jump = targets.jumps[t][side];
      const int other = topology.Neighbour(t, side);
      jump += other < 0 ? -shift[t] : shift[t] - shift[other];
      // Hinges are angles up to whole turns.
      if (other >= 0 && Modulo4(jump) != 0 && !cut.isCut[topology.EdgeOf(t, side)])
      {
        throw Error("The cross field has a singularity near " +
            topology.Where(topology.mesh.triangles[t][side]) + " that was not given",
          "use a finer mesh there", Error::Kind::CoarseMesh);
      }
    }
  }
}

/// Sets the seams with their rotations, and the directions of boundary edges.
void CollectTransitions(
  const CutGraph& cut, const std::vector<std::array<int, 3>>& jumps, SeamlessMap& map)
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
      const std::size_t side = Index(topology.SideOf(left, edges[j]));
      map.seams[left][side] = code;
      map.seams[right][topology.SideOf(right, edges[j])] = -code;
      if (j == 0)
      {
        // θ continued across is the neighbour's plus r π/2, so its w turns by i^r.
        map.transitions.push_back({ Modulo4(jumps[left][side]), Point::Zero() });
      }
    }
  }
  for (int position = 0; position < static_cast<int>(topology.mesh.boundary.size()); ++position)
  {
    const auto [t, side] = topology.SideOfBoundary(position);
    map.directions.push_back(Modulo4(jumps[t][side]));
  }
}

double MapArea(const SeamlessMap& map)
{
  double area = 0.0;
  for (int t = 0; t < map.topology->TriangleCount(); ++t)
  {
    area += TriangleArea(map.At(t, 0), map.At(t, 1), map.At(t, 2));
  }
  return area;
}

/// Stores u and v of every vertex of the cut mesh, and the translations of the seams.
void StorePoints(const Eigen::VectorXd& w, SeamlessMap& map)
{
  const auto point = [&w](std::size_t i) { return w.segment<2>(static_cast<Eigen::Index>(2 * i)); };
  map.points.clear();
  for (std::size_t c = 0; c < map.original.size(); ++c)
  {
    map.points.emplace_back(point(c));
  }
  for (std::size_t chain = 0; chain < map.transitions.size(); ++chain)
  {
    map.transitions[chain].translation = point(map.original.size() + chain);
  }
}

/// Returns the free unknowns rounded to multiples of 2^(e − 46), where 2^e ≥ extent. Other coordinates
/// are sums of a few of these with integer coefficients; with 7 bits to spare they are exact, so that
/// seams and sides are exact to the last bit.
Eigen::VectorXd RoundFree(const Eigen::VectorXd& free, double extent)
{
  constexpr int Bits = 46;
  int exponent = 0;
  std::frexp(extent, &exponent);
  const double unit = std::ldexp(1.0, exponent - Bits);
  return free.unaryExpr([unit](double value) { return std::nearbyint(value / unit) * unit; });
}

/// Returns the free unknowns of a map turned to the best angle.
Eigen::VectorXd TurnedToBestAngle(const Eigen::VectorXd& free,
  const Eigen::SparseMatrix<double, Eigen::RowMajor>& prolongation, SeamlessMap& map)
{
  using Row = Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator;
  Eigen::VectorXd w = prolongation * free;
  StorePoints(w, map);
  const Eigen::Rotation2Dd turn(-BestAngle(map));
  for (Eigen::Index i = 0; i + 1 < w.size(); i += 2)
  {
    w.segment<2>(i) = turn * w.segment<2>(i);
  }
  // Quarter turns of seams commute with it, so the result fulfils their equations as well.
  Eigen::VectorXd turned(free.size());
  // Each free unknown is one of all unknowns, whose row has a single 1.
  for (Eigen::Index i = 0; i < prolongation.outerSize(); ++i)
  {
    const Row first(prolongation, i);
    if (first && !++Row(first) && first.value() == 1.0)
    {
      turned[first.col()] = w[i];
    }
  }
  return turned;
}

/// Stores the solution for the free unknowns, scaled to the area of the domain.
void StoreScaled(const Eigen::VectorXd& free,
  const Eigen::SparseMatrix<double, Eigen::RowMajor>& prolongation, SeamlessMap& map)
{
  StorePoints(prolongation * free, map);
  const double scale = std::sqrt(map.topology->Area() / std::abs(MapArea(map)));
  StorePoints(prolongation * RoundFree(scale * free, scale * map.Extent()), map);
}
}

SeamlessMap SolveTargets(
  MapTargets targets, const std::vector<Cone>& cones, const Progress& progress)
{
  SeamlessMap map;
  map.topology = targets.topology;
  map.cones = cones;
  std::vector<int> singular;
  for (const Cone& cone : cones)
  {
    if (!cone.onBoundary)
    {
      singular.push_back(cone.vertex);
    }
  }
  const CutGraph cut = CutOpen(*map.topology, singular);
  ContinueBranches(cut, targets);
  map.corners = cut.corners;
  map.original = cut.original;
  CollectTransitions(cut, targets.jumps, map);
  const auto prolongation =
    EliminateSeams(*map.topology, cut, map.transitions, map.directions, map.cones);
  Eigen::VectorXd free = SolveCoordinates(map, targets.poisson, prolongation, progress);
  const double objective = targets.poisson.ObjectiveAt(map, prolongation * free);
  map.residual = std::sqrt(std::max(0.0, objective) / map.topology->Area());
  if (map.topology->loops.empty())
  {
    free = TurnedToBestAngle(free, prolongation, map);
  }
  StoreScaled(free, prolongation, map);
  return map;
}
}
