#pragma once

#include "GramMatrix.h"

namespace crossfield
{
/// M⁻¹ B to rounding by the method of conjugate gradients, preconditioned with the blocks of M. For holes that are not
/// very near to each other blocks are coupled weakly, and some dozen products are enough.
///
/// Throws Error when M is not positive definite or so nearly singular that a thousand are not.
Eigen::MatrixXd SolveGram(const GramMatrix& matrix, const Eigen::MatrixXd& rightHandSides);
}
