#pragma once

#include "Progress.h"
#include "SeamlessPoisson.h"

#include <Eigen/SparseCore>

namespace crossfield
{
/// The unknowns u and v of every vertex, then the translations, in terms of the free ones of
/// EliminateSeams: one Cholesky factorisation, and iterative refinement.
///
/// Throws Error where every vertex is on the boundary or on a seam.
Eigen::VectorXd SolveSeamless(const SeamlessMap& map, const SeamlessPoisson& poisson,
  const Eigen::SparseMatrix<double, Eigen::RowMajor>& prolongation, const Progress& progress = {});
}
