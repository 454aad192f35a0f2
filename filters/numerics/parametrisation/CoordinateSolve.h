#pragma once

#include "Progress.h"
#include "SeamlessPoisson.h"

#include <Eigen/SparseCore>

namespace crossfield
{
/// Minimises the least-squares problem of a seamless map under its seam equations, by one Cholesky
/// factorisation and iterative refinement. Returns the free unknowns. `prolongation`, from
/// EliminateSeams, maps them to u and v of every vertex of the cut mesh and the translations of the seams.
///
/// Throws Error when every vertex is on the boundary or on a seam.
Eigen::VectorXd SolveCoordinates(const SeamlessMap& map, const SeamlessPoisson& poisson,
  const Eigen::SparseMatrix<double, Eigen::RowMajor>& prolongation, const Progress& progress = {});
}
