#pragma once

#include "PotentialFactor.h"

namespace crossfield
{
/// Potentials for a unit source at each period of a mesh without holes. They
/// depend on the mesh alone and are shared by all configurations on it.
struct PeriodResponse
{
  Eigen::MatrixXd basis;   ///< Solutions, a column per period; rows of PotentialOperator.
  Eigen::MatrixXd inverse; ///< Their values at the periods, the inverse of the Schur complement.
  Eigen::MatrixXd schur;   ///< Schur complement on the periods.

  explicit PeriodResponse(const PotentialFactor& factor);

  /// Removes the periods of a potential. Returns the sources at the periods that this adds: without
  /// others, the phase that the result carries.
  Eigen::VectorXd RemovePeriods(Eigen::VectorXd& solution) const;
};
}
