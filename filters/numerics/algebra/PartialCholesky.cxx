#include "PartialCholesky.h"

#include "CholmodWorkspace.h"
#include "DenseProduct.h"
#include "Lapack.h"
#include "SerialBlas.h"
#include "SerialRegions.h"
#include "SparseCholesky.h"

#include <cmath>
#include <memory>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
constexpr double One = 1.0;
constexpr double MinusOne = -1.0;

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
}

PartialCholesky::PartialCholesky(
  const Eigen::SparseMatrix<double>& lower, int inner, Eigen::Ref<Eigen::MatrixXd> border)
  : Inner(inner)
{
  const double* const values = lower.valuePtr();
  if (!std::all_of(
        values, values + lower.nonZeros(), [](double value) { return std::isfinite(value); }))
  {
    throw Error("The matrix has entries that are not finite; the mesh has degenerate triangles, "
                "remesh it.");
  }
  const SerialBlas serial;
  this->Analyse(lower);
  this->Eliminate(lower, border);
}

void PartialCholesky::Analyse(const Eigen::SparseMatrix<double>& lower)
{
  const SerialRegions regions;
  CholmodWorkspace workspace;
  const CholmodFactor factor = AnalyseInOrder(lower, workspace);
  const auto* columnStarts = static_cast<const int*>(factor->super);
  const auto* rowStarts = static_cast<const int*>(factor->pi);
  const auto* rows = static_cast<const int*>(factor->s);
  this->NodeOf.resize(static_cast<std::size_t>(this->Inner));
  std::size_t size = 0;
  for (std::size_t s = 0; s < factor->nsuper && columnStarts[s] < this->Inner; ++s)
  {
    Node node;
    node.first = columnStarts[s];
    node.width = std::min(columnStarts[s + 1], this->Inner) - node.first; // may include the border
    node.height = rowStarts[s + 1] - rowStarts[s];
    node.rows = static_cast<std::size_t>(rowStarts[s]);
    node.values = size;
    size += static_cast<std::size_t>(node.width) * static_cast<std::size_t>(node.height);
    std::fill_n(
      this->NodeOf.begin() + node.first, node.width, static_cast<int>(this->Nodes.size()));
    this->Nodes.push_back(node);
  }
  this->RowList.assign(rows,
    rows +
      (this->Nodes.empty()
          ? 0
          : this->Nodes.back().rows + static_cast<std::size_t>(this->Nodes.back().height)));
  for (Node& node : this->Nodes)
  {
    const int below = node.height > node.width ? this->RowsOf(node)[node.width] : this->Inner;
    node.parent = below < this->Inner ? this->NodeOf[static_cast<std::size_t>(below)] : -1;
  }
  this->Values.resize(size);
}

void PartialCholesky::Eliminate(
  const Eigen::SparseMatrix<double>& lower, Eigen::Ref<Eigen::MatrixXd> border)
{
  const std::size_t count = this->Nodes.size();
  // −M Mᵀ of each node below its own columns, until its parent has added it, and the lists of the
  // nodes with the same parent.
  std::vector<std::unique_ptr<double[]>> updates(count);
  std::vector<int> firstChild(count, -1);
  std::vector<int> nextChild(count, -1);
  std::vector<int> place(static_cast<std::size_t>(lower.rows())); // of a row in the present node
  for (std::size_t n = 0; n < count; ++n)
  {
    const Node& node = this->Nodes[n];
    const int* const rows = this->RowsOf(node);
    for (int k = 0; k < node.height; ++k)
    {
      place[static_cast<std::size_t>(rows[k])] = k;
    }

    // 1. Add the entries of the matrix, and the updates of the nodes below.
    double* const values = this->Values.data() + node.values;
    for (int j = 0; j < node.width; ++j)
    {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, node.first + j); entry; ++entry)
      {
        values[place[static_cast<std::size_t>(entry.row())] +
          static_cast<std::ptrdiff_t>(j) * node.height] += entry.value();
      }
    }
    const int rest = node.height - node.width;
    const auto square = static_cast<std::size_t>(rest) * static_cast<std::size_t>(rest);
    std::unique_ptr<double[]> update(rest > 0 ? new double[square]() : nullptr);
    for (int child = firstChild[n]; child >= 0; child = nextChild[static_cast<std::size_t>(child)])
    {
      const Node& below = this->Nodes[static_cast<std::size_t>(child)];
      const int* const ofChild = this->RowsOf(below) + below.width;
      const int size = below.height - below.width;
      const double* source = updates[static_cast<std::size_t>(child)].get();
      for (int j = 0; j < size; ++j, source += size)
      {
        const int column = place[static_cast<std::size_t>(ofChild[j])];
        double* const target = column < node.width
          ? values + static_cast<std::ptrdiff_t>(column) * node.height
          : update.get() + static_cast<std::ptrdiff_t>(column - node.width) * rest - node.width;
        for (int i = j; i < size; ++i)
        {
          target[place[static_cast<std::size_t>(ofChild[i])]] += source[i];
        }
      }
      updates[static_cast<std::size_t>(child)].reset();
    }

    // 2. Eliminate the columns.
    int info = 0;
    dpotrf_("L", &node.width, values, &node.height, &info, 1);
    if (info != 0)
    {
      throw NotPositiveDefinite();
    }
    if (rest == 0)
    {
      continue;
    }
    double* const below = values + node.width;
    dtrsm_("R", "L", "T", "N", &rest, &node.width, &One, values, &node.height, below, &node.height,
      1, 1, 1, 1);
    dsyrk_("L", "N", &rest, &node.width, &MinusOne, below, &node.height, &One, update.get(), &rest,
      1, 1);

    // 3. Pass the update on.
    if (node.parent >= 0)
    {
      updates[n] = std::move(update);
      int& first = firstChild[static_cast<std::size_t>(node.parent)];
      nextChild[n] = std::exchange(first, static_cast<int>(n));
      continue;
    }
    const int* const outer = rows + node.width;
    for (int j = 0; j < rest; ++j)
    {
      for (int i = j; i < rest; ++i)
      {
        border(outer[i] - this->Inner, outer[j] - this->Inner) +=
          update[static_cast<std::size_t>(i) +
            static_cast<std::size_t>(j) * static_cast<std::size_t>(rest)];
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
      int node = this->NodeOf[static_cast<std::size_t>(entry.row())];
      while (node >= 0 && path.insert(node).second)
      {
        node = this->Nodes[static_cast<std::size_t>(node)].parent;
      }
    }
  }
  std::vector<int> placeOf(this->Nodes.size()); // first row of each node in `work`
  int size = 0;
  for (const int node : path)
  {
    placeOf[static_cast<std::size_t>(node)] = size;
    size += this->Nodes[static_cast<std::size_t>(node)].width;
  }

  // 2. Substitute along these paths.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> work(size, block.cols());
  work.setZero();
  const auto placeOfRow = [&](int row)
  {
    const int node = this->NodeOf[static_cast<std::size_t>(row)];
    return placeOf[static_cast<std::size_t>(node)] + row -
      this->Nodes[static_cast<std::size_t>(node)].first;
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
    const Node& node = this->Nodes[static_cast<std::size_t>(n)];
    const auto factor = this->ValuesOf(node);
    Eigen::MatrixXd part = work.middleRows(placeOf[static_cast<std::size_t>(n)], node.width);
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
