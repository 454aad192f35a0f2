#include "CholmodWorkspace.h"

#include "Error.h"

#include <numeric>
#include <string>

namespace crossfield
{
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
}

CholmodFactor AnalyseInOrder(const Eigen::SparseMatrix<double>& matrix, CholmodWorkspace& workspace,
  const std::vector<int>* order)
{
  std::vector<int> own;
  if (order == nullptr)
  {
    own.resize(static_cast<std::size_t>(matrix.rows()));
    std::iota(own.begin(), own.end(), 0);
    order = &own;
  }
  cholmod_sparse view = LowerView(matrix);
  cholmod_common* const common = workspace.Get();
  CholmodFactor factor(
    cholmod_analyze_p(&view, const_cast<int*>(order->data()), nullptr, 0, common), { common });
  RequireSuccess(*common, matrix.rows());
  if (factor == nullptr)
  {
    throw Error("The matrix could not be analysed; the mesh is damaged, remesh the domain.");
  }
  return factor;
}
}
