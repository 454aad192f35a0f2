#pragma once

#include "PotentialFactor.h"

namespace crossfield
{
/// Potentials for a unit source at each period of a mesh without holes, one per inner loop. They
/// depend on the mesh alone and are shared by all configurations on it.
struct PeriodResponse
{
  Eigen::MatrixXd basis;   ///< Solutions, a column per inner loop; rows of PotentialOperator.
  Eigen::MatrixXd inverse; ///< Their values at the periods, the inverse of the Schur complement.
  Eigen::MatrixXd schur;   ///< Schur complement on the periods.

  explicit PeriodResponse(const PotentialFactor& factor);
};
}
