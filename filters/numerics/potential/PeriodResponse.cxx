#include "PeriodResponse.h"

#include <Eigen/LU>

namespace crossfield
{
PeriodResponse::PeriodResponse(const PotentialFactor& factor)
{
  constexpr auto Islands = PotentialOperator::Periods::Islands;
  const PotentialOperator& laplacian = factor.GetOperator();
  const Eigen::Index periods = laplacian.PeriodCount(Islands);
  this->basis = Eigen::MatrixXd::Zero(laplacian.Rows(), periods);
  this->basis.bottomRows(periods).setIdentity();
  if (periods > 0)
  {
    this->basis = factor.Solve(this->basis, Islands);
  }
  this->inverse = this->basis.bottomRows(periods);
  this->schur = this->inverse.inverse();
}

Eigen::VectorXd PeriodResponse::RemovePeriods(Eigen::VectorXd& solution) const
{
  const Eigen::Index periods = this->basis.cols();
  if (periods == 0)
  {
    return {};
  }
  Eigen::VectorXd sources = -this->schur * solution.tail(periods);
  solution += this->basis * sources;
  solution.tail(periods).setZero();
  return sources;
}
}
