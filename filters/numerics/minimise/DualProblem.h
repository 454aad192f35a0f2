#pragma once

#include "ReducedProblem.h"

#include <Eigen/SparseCore>

#include <vector>

namespace crossfield
{
/// The reduced problem in some orthonormal basis of the values x on the holes, of which every member
/// belongs to one hole.
struct DualProblem
{
  Eigen::MatrixXcd matrix;                               ///< S in this basis, lower half.
  ComplexVector load;                                    ///< b in this basis.
  std::vector<Eigen::SparseMatrix<Complex>> constraints; ///< A_i in this basis.
  std::vector<Eigen::Index> holeOf; ///< Of every member of the basis, the index of its constraint.
  Eigen::VectorXd targets;
  Eigen::VectorXd sizes; ///< Number of edges of every hole.
};

/// In the values themselves.
DualProblem InValues(const ReducedProblem& problem);

/// In the discrete Fourier modes |q| ≤ |d| + extra of every hole, x_j = Σ_q a_q e^{2πi q j/m} / √m over
/// its m edges: A_i is diagonal there, with entries 2 sin(2πq/m).
DualProblem InModes(const ReducedProblem& problem, int extra);
}
