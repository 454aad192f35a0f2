#include "PartialCholesky.h"

#include "CholmodWorkspace.h"
#include "DenseProduct.h"
#include "Lapack.h"
#include "SerialBlas.h"
#include "SparseCholesky.h"

#include <algorithm>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
constexpr double One = 1.0;
constexpr double MinusOne = -1.0;
constexpr double Zero = 0.0;

/// Computes result = factor × A B + before × result, or with Aᵀ.
void Multiply(const char* turned, int rows, int inner, const double* a, int leadingOfA,
  const Eigen::Ref<const Eigen::MatrixXd>& b, double factor, double before,
  Eigen::Ref<Eigen::MatrixXd> result)
{
  const auto count = static_cast<int>(result.cols());
  if (count == 1)
  {
    const bool isTurned = *turned == 'T';
    const int height = isTurned ? inner : rows;
    const int width = isTurned ? rows : inner;
    const int step = 1;
    dgemv_(turned, &height, &width, &factor, a, &leadingOfA, b.data(), &step, &before,
      result.data(), &step, 1);
    return;
  }
  const auto leadingOfB = static_cast<int>(b.outerStride());
  const auto leading = static_cast<int>(result.outerStride());
  dgemm_(turned, "N", &rows, &count, &inner, &factor, a, &leadingOfA, b.data(), &leadingOfB,
    &before, result.data(), &leading, 1, 1);
}

/// Returns the columns of the inner unknowns, then one with a negative pivot, then empty ones.
Eigen::SparseMatrix<double> WithLastPivot(const Eigen::SparseMatrix<double>& lower, int inner)
{
  Eigen::SparseMatrix<double> matrix(lower.rows() + 1, lower.cols() + 1);
  matrix.reserve(lower.outerIndexPtr()[inner] + 1);
  for (Eigen::Index j = 0; j < matrix.cols(); ++j)
  {
    matrix.startVec(j);
    if (j == inner)
    {
      matrix.insertBack(j, j) = -1.0;
    }
    else if (j < inner)
    {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, j); entry; ++entry)
      {
        matrix.insertBack(entry.row() + (entry.row() < inner ? 0 : 1), j) = entry.value();
      }
    }
  }
  matrix.finalize();
  return matrix;
}
}

struct PartialCholesky::Factor
{
  CholmodWorkspace workspace;
  CholmodFactor factor;
};

PartialCholesky::PartialCholesky(
  const Eigen::SparseMatrix<double>& lower, int inner, Eigen::Ref<Eigen::MatrixXd> border)
  : Inner(inner)
  , Data(std::make_unique<Factor>())
{
  RequireFinite(lower);
  this->Data->factor = FactorInOrder(WithLastPivot(lower, inner), this->Data->workspace);
  if (this->Data->factor->minor < static_cast<std::size_t>(inner))
  {
    throw NotPositiveDefinite();
  }
  this->ReadNodes();
  this->UpdateBorder(border);
}

PartialCholesky::~PartialCholesky() = default;

void PartialCholesky::ReadNodes()
{
  cholmod_factor& factor = *this->Data->factor;
  const auto* columnStarts = static_cast<const int*>(factor.super);
  const auto* rowStarts = static_cast<const int*>(factor.pi);
  const auto* valueStarts = static_cast<const int*>(factor.px);
  const auto* rows = static_cast<const int*>(factor.s);
  // No supernode has inner unknowns and others: the inserted column is the root of its own tree.
  std::size_t count = 0;
  while (columnStarts[count] < this->Inner)
  {
    ++count;
  }
  this->NodeOf.resize(static_cast<std::size_t>(this->Inner));
  this->RowList.assign(rows, rows + rowStarts[count]);
  for (int& row : this->RowList)
  {
    row -= row > this->Inner ? 1 : 0; // the inserted row
  }
  for (std::size_t s = 0; s < count; ++s)
  {
    Node node;
    node.first = columnStarts[s];
    node.width = columnStarts[s + 1] - node.first;
    node.height = rowStarts[s + 1] - rowStarts[s];
    node.rows = static_cast<std::size_t>(rowStarts[s]);
    node.values = static_cast<std::size_t>(valueStarts[s]);
    const int* const own = this->RowsOf(node);
    node.inner = static_cast<int>(std::lower_bound(own, own + node.height, this->Inner) - own);
    std::fill_n(
      this->NodeOf.begin() + node.first, node.width, static_cast<int>(this->Nodes.size()));
    this->Nodes.push_back(node);
  }
  for (Node& node : this->Nodes)
  {
    node.parent = node.inner > node.width ? this->NodeOf[this->RowsOf(node)[node.width]] : -1;
  }

  // Release the columns of the border, which are dense and empty, and the workspace.
  cholmod_common* const common = this->Data->workspace.Get();
  factor.x = cholmod_realloc(
    static_cast<std::size_t>(valueStarts[count]), sizeof(double), factor.x, &factor.xsize, common);
  cholmod_free_work(common);
  this->Values = static_cast<const double*>(factor.x);
}

void PartialCholesky::UpdateBorder(Eigen::Ref<Eigen::MatrixXd> border) const
{
  const SerialBlas serial;
  const auto leadingOfBorder = static_cast<int>(border.outerStride());
  Eigen::MatrixXd product;
  for (const Node& node : this->Nodes)
  {
    const int size = node.height - node.inner;
    if (size == 0)
    {
      continue;
    }
    const double* const values = this->Values + node.values + node.inner;
    const int* const rows = this->RowsOf(node) + node.inner;
    if (rows[size - 1] - rows[0] == size - 1)
    {
      const int first = rows[0] - this->Inner;
      dsyrk_("L", "N", &size, &node.width, &MinusOne, values, &node.height, &One,
        &border(first, first), &leadingOfBorder, 1, 1);
      continue;
    }
    product.resize(size, size);
    dsyrk_("L", "N", &size, &node.width, &MinusOne, values, &node.height, &Zero, product.data(),
      &size, 1, 1);
    for (int j = 0; j < size; ++j)
    {
      double* const column = &border(0, rows[j] - this->Inner);
      for (int i = j; i < size; ++i)
      {
        column[rows[i] - this->Inner] += product(i, j);
      }
    }
  }
}

void PartialCholesky::SolveLower(Eigen::MatrixXd& columns) const
{
  const SerialBlas serial;
  Eigen::MatrixXd below;
  for (const Node& node : this->Nodes)
  {
    const auto factor = this->ValuesOf(node);
    auto own = columns.middleRows(node.first, node.width);
    SolveLowerInPlace(factor.topRows(node.width), own);
    const int rest = node.height - node.width;
    if (rest > 0)
    {
      below.resize(rest, columns.cols());
      Multiply(
        "N", rest, node.width, factor.data() + node.width, node.height, own, 1.0, 0.0, below);
      const int* const rows = this->RowsOf(node) + node.width;
      for (Eigen::Index column = 0; column < columns.cols(); ++column)
      {
        for (int k = 0; k < rest; ++k)
        {
          columns(rows[k], column) -= below(k, column);
        }
      }
    }
  }
}

void PartialCholesky::SolveUpper(Eigen::MatrixXd& columns) const
{
  const SerialBlas serial;
  Eigen::MatrixXd below;
  for (auto node = this->Nodes.rbegin(); node != this->Nodes.rend(); ++node)
  {
    const auto factor = this->ValuesOf(*node);
    auto own = columns.middleRows(node->first, node->width);
    const int rest = node->height - node->width;
    if (rest > 0)
    {
      below.resize(rest, columns.cols());
      const int* const rows = this->RowsOf(*node) + node->width;
      for (Eigen::Index column = 0; column < columns.cols(); ++column)
      {
        for (int k = 0; k < rest; ++k)
        {
          below(k, column) = columns(rows[k], column);
        }
      }
      Multiply(
        "T", node->width, rest, factor.data() + node->width, node->height, below, -1.0, 1.0, own);
    }
    SolveLowerAdjointInPlace(factor.topRows(node->width), own);
  }
}

std::vector<PartialCholesky::Rows> PartialCholesky::SolveLowerSparse(
  const Eigen::SparseMatrix<double>& block, Eigen::Ref<Eigen::MatrixXd> atBorder) const
{
  // 1. Collect the nodes on the paths to the root. Parents have larger numbers.
  std::set<int> path;
  for (Eigen::Index column = 0; column < block.outerSize(); ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(block, column); entry; ++entry)
    {
      int node = this->NodeOf[entry.row()];
      while (node >= 0 && path.insert(node).second)
      {
        node = this->Nodes[node].parent;
      }
    }
  }
  std::vector<int> placeOf(this->Nodes.size()); // first row of each node in `work`
  int size = 0;
  for (const int node : path)
  {
    placeOf[node] = size;
    size += this->Nodes[node].width;
  }

  // 2. Substitute along these paths.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> work(size, block.cols());
  work.setZero();
  const auto placeOfRow = [&](int row)
  {
    const int node = this->NodeOf[row];
    return placeOf[node] + row - this->Nodes[node].first;
  };
  for (Eigen::Index column = 0; column < block.outerSize(); ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(block, column); entry; ++entry)
    {
      work(placeOfRow(static_cast<int>(entry.row())), column) += entry.value();
    }
  }
  std::vector<Rows> solution;
  for (const int n : path)
  {
    const Node& node = this->Nodes[n];
    const auto factor = this->ValuesOf(node);
    Eigen::MatrixXd part = work.middleRows(placeOf[n], node.width);
    SolveLowerInPlace(factor.topRows(node.width), part);
    const int rest = node.height - node.width;
    const Eigen::MatrixXd below = DenseProduct(factor.bottomRows(rest), part);
    const int* const rows = this->RowsOf(node) + node.width;
    for (int k = 0; k < rest; ++k)
    {
      if (rows[k] < this->Inner)
      {
        work.row(placeOfRow(rows[k])) -= below.row(k);
      }
      else
      {
        atBorder.row(rows[k] - this->Inner) -= below.row(k);
      }
    }
    solution.push_back({ node.first, std::move(part) });
  }
  return solution;
}
}
