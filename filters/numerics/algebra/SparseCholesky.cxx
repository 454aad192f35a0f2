#include "SparseCholesky.h"

#include "DenseProduct.h"
#include "MemoryBudget.h"
#include "SerialBlas.h"
#include "SerialRegions.h"

#include <cholmod.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace crossfield
{
struct SparseCholesky::Factor
{
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  std::vector<int> order;

  Factor()
  {
    cholmod_start(&this->common);
    this->common.print = 0; // errors are thrown, not printed
    this->common.supernodal = CHOLMOD_SUPERNODAL;
    this->common.final_ll = 1;
    this->common.nmethods = 1;
    this->common.method[0].ordering = CHOLMOD_GIVEN;
    // A postorder would move trailing unknowns when the other part of the matrix is disconnected.
    this->common.postorder = 0;
    // Always merge supernodes of up to 16 columns, and those of up to 32 and 64 columns if this
    // adds few zeros. Planar meshes have small supernodes, and fewer BLAS calls save a tenth of the
    // time (CHOLMOD's defaults: 4, 16, 48).
    this->common.nrelax[0] = 16;
    this->common.nrelax[1] = 32;
    this->common.nrelax[2] = 64;
  }
  ~Factor()
  {
    cholmod_free_factor(&this->factor, &this->common);
    cholmod_finish(&this->common);
  }
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;
};

namespace
{
std::atomic<long> countOfAll = 0;

/// Workspace of CHOLMOD for one solve. CHOLMOD writes its status and memory statistics into it, so
/// concurrent solves with one factor need one workspace each.
struct SolveWorkspace
{
  cholmod_common common{};

  SolveWorkspace()
  {
    cholmod_start(&this->common);
    this->common.print = 0;
  }
  ~SolveWorkspace() { cholmod_finish(&this->common); }
  SolveWorkspace(const SolveWorkspace&) = delete;
  SolveWorkspace& operator=(const SolveWorkspace&) = delete;
};
}

long SparseCholesky::CountOfAll()
{
  return countOfAll;
}

SparseCholesky::SparseCholesky(
  const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& order)
  : Data(std::make_unique<Factor>())
{
  if (matrix.rows() != matrix.cols() || order.size() != static_cast<std::size_t>(matrix.rows()) ||
    !matrix.isCompressed())
  {
    throw Error("A factorisation needs a square compressed matrix and an order of all unknowns.");
  }
  const auto* values = matrix.valuePtr();
  if (!std::all_of(values, values + matrix.nonZeros(), [](double v) { return std::isfinite(v); }))
  {
    throw Error("The matrix has entries that are not finite; the mesh has degenerate triangles, "
                "remesh it.");
  }
  this->Data->order = order;
  ++countOfAll;

  cholmod_sparse view = {};
  view.nrow = view.ncol = order.size();
  view.nzmax = static_cast<std::size_t>(matrix.nonZeros());
  view.p = const_cast<int*>(matrix.outerIndexPtr());
  view.i = const_cast<int*>(matrix.innerIndexPtr());
  view.x = const_cast<double*>(values);
  view.stype = -1; // only the lower triangle is read
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;

  const SerialBlas serial;
  const SerialRegions regions;
  cholmod_common* common = &this->Data->common;
  this->Data->factor = cholmod_analyze_p(&view, this->Data->order.data(), nullptr, 0, common);
  if (this->Data->factor != nullptr)
  {
    const cholmod_factor& factor = *this->Data->factor;
    RequireMemory(static_cast<double>(factor.xsize + factor.maxcsize) * sizeof(double),
      "The factorisation of " + std::to_string(order.size()) + " unknowns",
      "use a larger mesh size, fewer holes or fewer edges on them");
    cholmod_factorize(&view, this->Data->factor, common);
  }
  if (common->status == CHOLMOD_TOO_LARGE)
  {
    throw Error("The factor of a matrix with " + std::to_string(order.size()) +
      " unknowns has more entries than can be numbered; use a larger mesh size or fewer holes.");
  }
  if (common->status == CHOLMOD_OUT_OF_MEMORY)
  {
    throw Error("There is not enough memory to factor a matrix with " +
      std::to_string(order.size()) + " unknowns; use a larger mesh size.");
  }
  if (this->Data->factor == nullptr || common->status != CHOLMOD_OK)
  {
    throw NotPositiveDefinite();
  }
}

SparseCholesky::~SparseCholesky() = default;

Eigen::MatrixXd SparseCholesky::Solve(int system, const Eigen::MatrixXd& rightHandSides) const
{
  const SerialBlas serial;
  const SerialRegions regions;
  cholmod_dense view = {};
  view.nrow = static_cast<std::size_t>(rightHandSides.rows());
  view.ncol = static_cast<std::size_t>(rightHandSides.cols());
  view.nzmax = view.nrow * view.ncol;
  view.d = view.nrow;
  view.x = const_cast<double*>(rightHandSides.data());
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  SolveWorkspace workspace;
  cholmod_dense* solution = cholmod_solve(system, this->Data->factor, &view, &workspace.common);
  if (solution == nullptr)
  {
    throw Error("There is not enough memory to solve the linear system; use a larger mesh size.");
  }
  Eigen::MatrixXd result = Eigen::Map<Eigen::MatrixXd>(
    static_cast<double*>(solution->x), rightHandSides.rows(), rightHandSides.cols());
  cholmod_free_dense(&solution, &workspace.common);
  return result;
}

Eigen::MatrixXd SparseCholesky::Solve(const Eigen::MatrixXd& rightHandSides) const
{
  Eigen::MatrixXd result = this->Solve(CHOLMOD_A, rightHandSides);
  if (!result.allFinite())
  {
    throw Error("The solution of the linear system is not finite; the mesh has degenerate "
                "triangles, remesh the domain.");
  }
  return result;
}

Eigen::MatrixXd SparseCholesky::SolveLower(const Eigen::MatrixXd& rightHandSides) const
{
  return this->Solve(CHOLMOD_L, this->Solve(CHOLMOD_P, rightHandSides));
}

Eigen::MatrixXd SparseCholesky::SolveUpper(const Eigen::MatrixXd& rightHandSides) const
{
  return this->Solve(CHOLMOD_Pt, this->Solve(CHOLMOD_Lt, rightHandSides));
}

std::vector<std::vector<SparseCholesky::Rows>> SparseCholesky::SolveLowerSparse(
  const std::vector<Eigen::SparseMatrix<double>>& blocks) const
{
  const cholmod_factor& factor = *this->Data->factor;
  const auto* columnStarts = static_cast<const int*>(factor.super);
  const auto* rowStarts = static_cast<const int*>(factor.pi);
  const auto* valueStarts = static_cast<const int*>(factor.px);
  const auto* rows = static_cast<const int*>(factor.s);
  const auto* values = static_cast<const double*>(factor.x);
  std::vector<int> nodeOf(factor.n);
  for (int node = 0; node < static_cast<int>(factor.nsuper); ++node)
  {
    std::fill(nodeOf.begin() + columnStarts[node], nodeOf.begin() + columnStarts[node + 1], node);
  }
  const SerialBlas serial;
  std::vector<int> placeOf(factor.nsuper); // first row of each supernode in `work`
  std::vector<std::vector<Rows>> solutions;
  for (const Eigen::SparseMatrix<double>& block : blocks)
  {
    // 1. Collect the supernodes on the paths to the root. The parent of a supernode is the one that
    // contains its first row below the diagonal block; parents have larger numbers.
    std::set<int> path;
    const auto parentOf = [&](int node)
    {
      const int below = rowStarts[node] + columnStarts[node + 1] - columnStarts[node];
      return below < rowStarts[node + 1] ? nodeOf[static_cast<std::size_t>(rows[below])] : -1;
    };
    for (Eigen::Index column = 0; column < block.cols(); ++column)
    {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(block, column); entry; ++entry)
      {
        int node = nodeOf[static_cast<std::size_t>(entry.row())];
        while (node >= 0 && path.insert(node).second)
        {
          node = parentOf(node);
        }
      }
    }
    int size = 0;
    for (const int node : path)
    {
      placeOf[static_cast<std::size_t>(node)] = size;
      size += columnStarts[node + 1] - columnStarts[node];
    }

    // 2. Substitute along these paths.
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> work(size, block.cols());
    work.setZero();
    const auto placeOfRow = [&](Eigen::Index row)
    {
      const int node = nodeOf[static_cast<std::size_t>(row)];
      return placeOf[static_cast<std::size_t>(node)] + row - columnStarts[node];
    };
    for (Eigen::Index column = 0; column < block.cols(); ++column)
    {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(block, column); entry; ++entry)
      {
        work(placeOfRow(entry.row()), column) += entry.value();
      }
    }
    std::vector<Rows>& solution = solutions.emplace_back();
    for (const int node : path)
    {
      const int first = columnStarts[node];
      const Eigen::Index width = columnStarts[node + 1] - first;
      const Eigen::Index height = rowStarts[node + 1] - rowStarts[node];
      const Eigen::Map<const Eigen::MatrixXd> lower(values + valueStarts[node], height, width);
      Eigen::MatrixXd part = work.middleRows(placeOf[static_cast<std::size_t>(node)], width);
      SolveLowerInPlace(lower.topRows(width), part);
      const Eigen::MatrixXd below = DenseProduct(lower.bottomRows(height - width), part);
      for (Eigen::Index k = 0; k < below.rows(); ++k)
      {
        work.row(placeOfRow(rows[rowStarts[node] + width + k])) -= below.row(k);
      }
      solution.push_back({ first, std::move(part) });
    }
  }
  return solutions;
}

Eigen::MatrixXd SparseCholesky::TrailingFactor(int count) const
{
  const cholmod_factor& factor = *this->Data->factor;
  const auto n = static_cast<int>(factor.n);
  const int begin = n - count;
  Eigen::MatrixXd trailing = Eigen::MatrixXd::Zero(count, count);
  const auto* columnStarts = static_cast<const int*>(factor.super);
  const auto* rowStarts = static_cast<const int*>(factor.pi);
  const auto* valueStarts = static_cast<const int*>(factor.px);
  const auto* rows = static_cast<const int*>(factor.s);
  const auto* values = static_cast<const double*>(factor.x);
  for (std::size_t s = factor.nsuper; s-- > 0 && columnStarts[s + 1] > begin;)
  {
    const int rowCount = rowStarts[s + 1] - rowStarts[s];
    for (int column = std::max(columnStarts[s], begin); column < columnStarts[s + 1]; ++column)
    {
      const int local = column - columnStarts[s];
      // The rows of a supernode start with its own columns; entries above the diagonal are
      // undefined.
      for (int k = local; k < rowCount; ++k)
      {
        trailing(rows[rowStarts[s] + k] - begin, column - begin) =
          values[static_cast<std::ptrdiff_t>(valueStarts[s]) +
            static_cast<std::ptrdiff_t>(local) * rowCount + k];
      }
    }
  }
  return trailing;
}
}
