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
}
