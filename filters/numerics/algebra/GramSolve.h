#pragma once

#include "GramMatrix.h"

namespace crossfield
{
/// Returns M⁻¹ B to rounding by the method of conjugate gradients, preconditioned with the diagonal
/// blocks of M. Unless holes are very close to each other, the blocks are weakly coupled and a few
/// dozen products suffice.
///
/// Throws Error when M is not positive definite, or so nearly singular that a thousand iterations
/// do not suffice.
Eigen::MatrixXd SolveGram(const GramMatrix& matrix, const Eigen::MatrixXd& rightHandSides);
}
