#include "AlignedSources.h"

#include <cmath>

namespace crossfield
{
AlignedSources PiecewiseConstantPhase(const PerforatedProblem& problem)
{
  AlignedSources sources;
  sources.atRows = Eigen::VectorXd::Zero(problem.potential->Rows());
  const auto& mesh = problem.mesh;
  sources.midpointShift = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.boundary.size()));
  const auto direction = [&mesh](const BoundaryEdge& edge)
  {
    return Point(mesh.points[static_cast<std::size_t>(edge.vertices[1])] -
      mesh.points[static_cast<std::size_t>(edge.vertices[0])]);
  };
  const std::vector<int> previous = problem.PreviousBoundaryEdges();
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    const BoundaryEdge& edge = mesh.boundary[i];
    if (edge.kind != BoundaryKind::Hole)
    {
      const BoundaryEdge& before = mesh.boundary[static_cast<std::size_t>(previous[i])];
      const double turning = AngleBetween(direction(before), direction(edge));
      const auto chosen = problem.chosenQuarters.find(edge.vertices[0]);
      sources.atRows[edge.vertices[0]] = chosen == problem.chosenQuarters.end()
        ? 4.0 * SmallestRotation(turning)
        : 4.0 * turning - 2.0 * Pi * chosen->second;
    }
  }
  return sources;
}

AlignedSources LinearPhase(const PerforatedProblem& problem)
{
  const Eigen::VectorXd jump = PiecewiseConstantPhase(problem).atRows;
  AlignedSources sources;
  sources.atRows = Eigen::VectorXd::Zero(jump.size());
  sources.midpointShift =
    Eigen::VectorXd::Zero(static_cast<Eigen::Index>(problem.mesh.boundary.size()));
  for (std::size_t i = 0; i < problem.mesh.boundary.size(); ++i)
  {
    const BoundaryEdge& edge = problem.mesh.boundary[i];
    if (edge.kind != BoundaryKind::Hole)
    {
      const double start = jump[edge.vertices[0]];
      const double end = jump[edge.vertices[1]];
      sources.atRows[edge.vertices[0]] += 0.25 * (start + end);
      sources.atRows[edge.vertices[1]] += 0.25 * (start + end);
      // From 4τ − start / 2 at one end to 4τ + end / 2 at the other.
      sources.midpointShift[static_cast<Eigen::Index>(i)] = 0.25 * (end - start);
    }
  }
  return sources;
}

double WrapAngle(double angle)
{
  const double wrapped = std::remainder(angle, 2.0 * Pi);
  return wrapped == -Pi ? Pi : wrapped;
}

Eigen::VectorXd NearestOffsets(const Eigen::VectorXd& defects, const Eigen::MatrixXd& inverse)
{
  Eigen::VectorXd offsets = defects;
  double best = offsets.dot(inverse * offsets);
  for (bool improved = true; improved;)
  {
    improved = false;
    for (Eigen::Index k = 0; k < offsets.size(); ++k)
    {
      for (double step : { 2.0 * Pi, -2.0 * Pi })
      {
        Eigen::VectorXd trial = offsets;
        trial[k] += step;
        const double energy = trial.dot(inverse * trial);
        // A tie must not be walked around in circles by rounding.
        if (energy < best * (1.0 - 1e-12))
        {
          offsets = trial;
          best = energy;
          improved = true;
        }
      }
    }
  }
  return offsets;
}
}
