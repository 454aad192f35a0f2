#include "OptimizerCurvature.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>

namespace crossfield
{
namespace
{
/// Times the square of the diagonal. Along weaker ones W falls by less than 1e-2 on a twentieth of the
/// diagonal; meshes bend it by a tenth of that.
constexpr double LeastCurvature = 10.0;

/// Directions that leave the symmetric places and change no defect: orthonormal columns.
Eigen::MatrixXd LeavingDirections(
  const OptimizerObjective& objective, const Eigen::MatrixXd& defectGradient, Eigen::Index size)
{
  constexpr double Independent = 1e-3; // a defect that changes by less does not change
  Eigen::MatrixXd rows(size + defectGradient.rows(), size);
  for (Eigen::Index i = 0; i < size; ++i)
  {
    rows.col(i).head(size) = objective.ProjectDirections(Eigen::VectorXd::Unit(size, i));
  }
  rows.bottomRows(defectGradient.rows()) = defectGradient;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullV);
  const Eigen::Index rank = (svd.singularValues().array() > Independent).count();
  return svd.matrixV().rightCols(size - rank);
}
}

Eigen::MatrixXd DifferenceHessian(const OptimizerObjective& objective, const OptimizerPlace& here,
  const Eigen::VectorXd& multipliers)
{
  // Of the diagonal: far above rounding, far below any distance between singularities.
  constexpr double Step = 1e-6;
  Eigen::MatrixXd hessian(here.place.size(), here.place.size());
  for (Eigen::Index i = 0; i < here.place.size(); ++i)
  {
    Eigen::VectorXd place = here.place;
    place[i] += Step;
    const OptimizerPlace next = objective.Evaluate(place);
    hessian.col(i) = (next.gradient - here.gradient +
                       (next.defectGradient - here.defectGradient).transpose() * multipliers) /
      Step;
  }
  hessian = (0.5 * (hessian + hessian.transpose())).eval();
  // The derivatives do not change across the symmetric places; no step goes there.
  const double stiffness = hessian.diagonal().lpNorm<Eigen::Infinity>();
  for (Eigen::Index i = 0; i < here.place.size(); ++i)
  {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(here.place.size(), i);
    hessian.col(i) += stiffness * (unit - objective.ProjectDirections(unit));
  }
  return hessian + here.barrier.bend;
}

std::optional<Eigen::VectorXd> FindDescent(
  const OptimizerObjective& objective, const OptimizerObjective& free, const Eigen::VectorXd& place)
{
  const OptimizerPlace here = free.Evaluate(place);
  const Eigen::MatrixXd leaving =
    LeavingDirections(objective, here.defectGradient, here.place.size());
  if (leaving.cols() == 0)
  {
    return std::nullopt;
  }
  Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(here.defects.size());
  if (multipliers.size() > 0)
  {
    multipliers = Eigen::MatrixXd(here.defectGradient.transpose())
                    .completeOrthogonalDecomposition()
                    .solve(-here.ObjectiveGradient());
  }
  const Eigen::MatrixXd hessian = DifferenceHessian(free, here, multipliers) + here.barrier.hessian;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(
    leaving.transpose() * hessian * leaving);
  if (modes.eigenvalues()[0] > -LeastCurvature)
  {
    return std::nullopt;
  }
  const Eigen::VectorXd direction = leaving * modes.eigenvectors().col(0);
  return direction / LongestMove(direction);
}

double LongestMove(const Eigen::VectorXd& step)
{
  double longest = 0.0;
  for (Eigen::Index i = 0; i < step.size(); i += 2)
  {
    longest = std::max(longest, step.segment<2>(i).norm());
  }
  return longest;
}
}
