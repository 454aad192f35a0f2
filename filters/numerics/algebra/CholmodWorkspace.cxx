#include "CholmodWorkspace.h"

#include "Error.h"
#include "MemoryBudget.h"
#include "SerialBlas.h"
#include "SerialRegions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace crossfield
{
namespace
{
/// Returns a view of a compressed matrix, of which only the lower triangle is read.
cholmod_sparse LowerView(const Eigen::SparseMatrix<double>& matrix)
{
  cholmod_sparse view = {};
  view.nrow = view.ncol = static_cast<std::size_t>(matrix.rows());
  view.nzmax = static_cast<std::size_t>(matrix.nonZeros());
  view.p = const_cast<int*>(matrix.outerIndexPtr());
  view.i = const_cast<int*>(matrix.innerIndexPtr());
  view.x = const_cast<double*>(matrix.valuePtr());
  view.stype = -1; // only the lower triangle is read
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

/// Throws Error if CHOLMOD has failed, for example because it ran out of memory, or of numbers for the entries of the factor of a
/// matrix of the given size.
void RequireSuccess(const cholmod_common& common, Eigen::Index size)
{
  if (common.status == CHOLMOD_TOO_LARGE)
  {
    throw Error("The factor of a matrix with " + std::to_string(size) +
      " unknowns has more entries than can be numbered; use a larger mesh size or fewer holes.");
  }
  if (common.status == CHOLMOD_OUT_OF_MEMORY)
  {
    throw Error("There is not enough memory to factor a matrix with " + std::to_string(size) +
      " unknowns; use a larger mesh size.");
  }
  if (common.status < CHOLMOD_OK)
  {
    throw Error("The matrix could not be factored; the mesh is damaged, remesh the domain.");
  }
}
}

void RequireFinite(const Eigen::SparseMatrix<double>& matrix)
{
  const double* const values = matrix.valuePtr();
  if (!std::all_of(
        values, values + matrix.nonZeros(), [](double value) { return std::isfinite(value); }))
  {
    throw Error("The matrix has entries that are not finite; the mesh has degenerate triangles, "
                "remesh it.");
  }
}

CholmodFactor FactorInOrder(const Eigen::SparseMatrix<double>& matrix, CholmodWorkspace& workspace,
  const std::vector<int>* order)
{
  std::vector<int> own;
  if (order == nullptr)
  {
    own.resize(static_cast<std::size_t>(matrix.rows()));
    std::iota(own.begin(), own.end(), 0);
    order = &own;
  }
  const SerialBlas serial;
  const SerialRegions regions;
  cholmod_sparse view = LowerView(matrix);
  cholmod_common* const common = workspace.Get();
  CholmodFactor factor(
    cholmod_analyze_p(&view, const_cast<int*>(order->data()), nullptr, 0, common), { common });
  if (factor != nullptr)
  {
    RequireMemory(static_cast<double>(factor->xsize + factor->maxcsize) * sizeof(double),
      "The factorisation of " + std::to_string(matrix.rows()) + " unknowns",
      "use a larger mesh size, fewer holes or fewer edges on them");
    cholmod_factorize(&view, factor.get(), common);
  }
  RequireSuccess(*common, matrix.rows());
  return factor;
}

void FactorAgain(
  const Eigen::SparseMatrix<double>& matrix, CholmodWorkspace& workspace, cholmod_factor& factor)
{
  const SerialBlas serial;
  const SerialRegions regions;
  cholmod_sparse view = LowerView(matrix);
  cholmod_factorize(&view, &factor, workspace.Get());
  RequireSuccess(*workspace.Get(), matrix.rows());
}
}
