#include "ClosingStep.h"

#include "DenseSolvers.h"

#include <algorithm>

namespace crossfield
{
namespace
{
using Decomposition = Eigen::BDCSVD<Eigen::MatrixXd>;

/// Returns the number of singular values above a fraction of the largest one.
Eigen::Index RankOf(const Decomposition& decomposition, double fraction)
{
  const Eigen::VectorXd& values = decomposition.singularValues();
  return values.size() == 0 || values[0] == 0.0 ? 0
                                                : (values.array() > fraction * values[0]).count();
}
}

ClosingStep SolveClosing(const ClosingConditions& conditions)
{
  // Fractions of the largest singular value. Defects that depend on each other have singular values
  // of rounding; rows of lengths that do, of the error of the derivatives, a few per cent.
  constexpr double DefectFraction = 1e-3;
  constexpr double FarDamping = 1e-2;
  constexpr double NearDamping = 3e-3;
  constexpr double ReachableFraction = 5e-3;
  constexpr double NearLength = 0.1; // quads

  ClosingStep step;
  const Eigen::Index columns = conditions.lengths.cols();
  step.moves = Eigen::VectorXd::Zero(columns);
  Eigen::MatrixXd free = Eigen::MatrixXd::Identity(columns, columns);
  if (conditions.defects.rows() > 0)
  {
    const Decomposition svd(conditions.defects, Eigen::ComputeThinU | Eigen::ComputeFullV);
    const Eigen::Index rank = RankOf(svd, DefectFraction);
    const Eigen::VectorXd reduced = svd.matrixU().leftCols(rank).transpose() * conditions.defect;
    step.moves = -(svd.matrixV().leftCols(rank) *
      (reduced.array() / svd.singularValues().head(rank).array()).matrix());
    free = svd.matrixV().rightCols(columns - rank);
  }
  if (conditions.lengths.rows() == 0 || free.cols() == 0)
  {
    return step;
  }
  const Eigen::MatrixXd reduced = conditions.lengths * free;
  const Eigen::VectorXd wanted = -conditions.length - conditions.lengths * step.moves;
  const Decomposition svd(reduced, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& values = svd.singularValues();
  const Eigen::VectorXd coordinates = svd.matrixU().transpose() * wanted;
  const bool isNear = conditions.length.maxCoeff() <= NearLength;
  const double damping = (isNear ? NearDamping : FarDamping) * values[0];
  if (values[0] > 0.0)
  {
    Eigen::ArrayXd factors = values.array() / (values.array().square() + damping * damping);
    if (conditions.exact && isNear)
    {
      factors = (values.array() > ReachableFraction * values[0])
                  .select(values.array().inverse(), Eigen::ArrayXd::Zero(values.size()));
    }
    step.moves += free * (svd.matrixV() * (factors * coordinates.array()).matrix());
  }
  const Eigen::Index rank = RankOf(svd, ReachableFraction);
  const Eigen::VectorXd remaining =
    (wanted - svd.matrixU().leftCols(rank) * coordinates.head(rank)).cwiseAbs();
  for (Eigen::Index row = 0; row < remaining.size(); ++row)
  {
    if (remaining[row] > std::max(0.5 * conditions.length[row], NearLength))
    {
      step.unreachable.push_back(row);
    }
  }
  const double largest = remaining.maxCoeff();
  const auto follows = [&](Eigen::Index row) { return remaining[row] < 0.5 * largest; };
  step.unreachable.erase(std::remove_if(step.unreachable.begin(), step.unreachable.end(), follows),
    step.unreachable.end());
  std::stable_sort(step.unreachable.begin(), step.unreachable.end(),
    [&](Eigen::Index a, Eigen::Index b) { return remaining[a] > remaining[b]; });
  return step;
}
}
