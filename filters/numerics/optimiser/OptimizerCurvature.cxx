#include "OptimizerCurvature.h"

#include "DenseSolvers.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace crossfield
{
namespace
{
/// Minimum negative curvature, multiplied by the square of the diagonal. Along directions of less
/// curvature, W decreases by less than 1e-2 over a twentieth of the diagonal; errors of the mesh
/// are about a tenth of that.
constexpr double MinimumCurvature = 10.0;

/// Returns the directions that break the symmetry and change no defect, as orthonormal columns.
Eigen::MatrixXd SymmetryBreakingDirections(
  const OptimizerObjective& objective, const Eigen::MatrixXd& defectGradient, Eigen::Index size)
{
  constexpr double RankTolerance = 1e-3; // smaller changes of a defect count as none
  Eigen::MatrixXd rows(size + defectGradient.rows(), size);
  for (Eigen::Index i = 0; i < size; ++i)
  {
    rows.col(i).head(size) = objective.ProjectDirections(Eigen::VectorXd::Unit(size, i));
  }
  rows.bottomRows(defectGradient.rows()) = defectGradient;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullV);
  const Eigen::Index rank = (svd.singularValues().array() > RankTolerance).count();
  return svd.matrixV().rightCols(size - rank);
}
}

Eigen::VectorXd EstimateMultipliers(const OptimizerState& current)
{
  return current.defects.size() == 0
    ? Eigen::VectorXd()
    : LeastSquares(current.defectGradient.transpose(), -current.ObjectiveGradient());
}

std::optional<Eigen::VectorXd> FindDescent(const OptimizerObjective& objective,
  const OptimizerObjective& free, const Eigen::VectorXd& positions)
{
  const OptimizerState current = free.Evaluate(positions);
  const Eigen::MatrixXd breaking =
    SymmetryBreakingDirections(objective, current.defectGradient, current.positions.size());
  if (breaking.cols() == 0)
  {
    return std::nullopt;
  }
  const Eigen::MatrixXd hessian = free.Hessian(current, EstimateMultipliers(current)) +
    current.barrier.hessian + current.barrier.negativeHessian;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(
    breaking.transpose() * hessian * breaking);
  if (modes.eigenvalues()[0] > -MinimumCurvature)
  {
    return std::nullopt;
  }
  const Eigen::VectorXd direction = breaking * modes.eigenvectors().col(0);
  return direction / LargestDisplacement(direction);
}

double LargestDisplacement(const Eigen::VectorXd& step)
{
  double longest = 0.0;
  for (Eigen::Index i = 0; i < step.size(); i += 2)
  {
    longest = std::max(longest, step.segment<2>(i).norm());
  }
  return longest;
}
}
