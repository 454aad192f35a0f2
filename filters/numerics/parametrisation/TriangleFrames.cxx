#include "TriangleFrames.h"

#include "Error.h"
#include "TriangleSearch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Finds a branch of the phase for every triangle and the jumps between them.
class BranchSearch
{
public:
  BranchSearch(const MeshTopology& topology, const PhaseSteps& steps)
    : Topology(topology)
    , Steps(steps)
    , Phase(topology.TriangleCount())
  {
  }

  /// Continues the phase breadth-first from the outer loop, or on a closed surface from the midpoint of
  /// the first side of its first triangle, where crosses are along it, and returns it at every centre.
  const Eigen::VectorXd& Continue()
  {
    const bool isClosed = this->Topology.loops.empty();
    const int position = isClosed ? -1 : this->Topology.loops.front().edges.front();
    const auto [first, side] =
      isClosed ? std::make_pair(0, 0) : this->Topology.SideOfBoundary(position);
    const double phase =
      isClosed ? 4.0 * this->Topology.DirectionOf(0, 0) : this->BoundaryPhase(position);
    this->Phase[first] = phase - this->StepTo(first, side);
    SearchTriangles(
      this->Topology.TriangleCount(), { first },
      [this](int t, int i) { return this->Topology.Neighbour(t, i); },
      [this](int t, int i, int next) { this->Phase[next] = this->Continued(t, i, next); });
    return this->Phase;
  }

  /// Sets the jumps and the residual of the frames.
  void SetJumps(TriangleFrames& frames) const
  {
    frames.jump.assign(this->Steps.toSide.size(), { 0, 0, 0 });
    for (int t = 0; t < this->Topology.TriangleCount(); ++t)
    {
      for (int i = 0; i < 3; ++i)
      {
        const int other = this->Topology.Neighbour(t, i);
        if (other >= 0)
        {
          const auto [turns, residual] =
            RoundToTurns(this->Continued(t, i, other) - this->Phase[other]);
          frames.jump[t][i] = turns;
          frames.residual = std::max(frames.residual, residual);
        }
      }
    }
    for (int position = 0; position < static_cast<int>(this->Topology.mesh.boundary.size());
         ++position)
    {
      const auto [t, i] = this->Topology.SideOfBoundary(position);
      // On an inner loop with a holonomy defect, a quarter of the defect remains.
      frames.jump[t][i] =
        RoundToTurns(this->BoundaryPhase(position) - this->Phase[t] - this->StepTo(t, i)).first;
    }
  }

private:
  /// Returns the integer nearest to a phase in turns, and the deviation from it in radians of θ.
  static std::pair<int, double> RoundToTurns(double phase)
  {
    const double turn = 2.0 * Pi;
    const double whole = std::round(phase / turn);
    return std::make_pair(static_cast<int>(whole), 0.25 * std::abs(phase - whole * turn));
  }

  double StepTo(int triangle, int side) const { return this->Steps.toSide[triangle][side]; }

  /// Returns the phase of the cross along a boundary edge, at its midpoint, in the chart of its
  /// triangle.
  double BoundaryPhase(int position) const
  {
    const auto [triangle, side] = this->Topology.SideOfBoundary(position);
    return 4.0 * this->Topology.DirectionOf(triangle, side) + this->Steps.boundaryShift[position];
  }

  /// Returns the phase of a triangle, continued to the centre of its neighbour across a side.
  double Continued(int triangle, int side, int neighbour) const
  {
    const int back = this->Topology.SideOf(neighbour, this->Topology.EdgeOf(triangle, side));
    return this->Phase[triangle] + this->StepTo(triangle, side) - this->StepTo(neighbour, back) +
      4.0 * this->Topology.Hinge(triangle, side);
  }

  const MeshTopology& Topology;
  const PhaseSteps& Steps;
  Eigen::VectorXd Phase; ///< At the centres.
};
}

TriangleFrames FrameTriangles(const MeshTopology& topology, PhaseSteps steps)
{
  TriangleFrames frames;
  BranchSearch branches(topology, steps);
  frames.angle = 0.25 * branches.Continue();
  branches.SetJumps(frames);
  // Far above the rounding of as many steps as there are triangles across the domain.
  constexpr double LargestResidual = 1e-6;
  if (!(frames.residual <= LargestResidual))
  {
    throw Error("The cross field does not close around the domain, by " +
      std::to_string(frames.residual) +
      " radians; the mesh may have degenerate triangles, remesh the domain.");
  }
  frames.h = 0.25 * steps.centre;
  frames.near = std::move(steps.near);
  return frames;
}
}
