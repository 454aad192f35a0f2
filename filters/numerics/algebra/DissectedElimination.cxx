#include "BothHalves.h"
#include "DenseProduct.h"
#include "DissectedCholesky.h"
#include "MemoryBudget.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns the rows of a node in the eliminated right-hand sides.
template <typename Parts>
auto RowsAt(
  Parts& parts, const DissectedCholesky::SparseEliminated::Place& place, Eigen::Index count)
{
  auto& part = place.part < 2 ? parts.halves[place.part] : parts.border;
  return part.middleRows(place.first, count);
}

/// Returns the position of every unknown in a list, −1 for unknowns that are not in it.
std::vector<int> PositionsIn(const std::vector<int>& unknowns, Eigen::Index size)
{
  std::vector<int> positions(static_cast<std::size_t>(size), -1);
  for (std::size_t i = 0; i < unknowns.size(); ++i)
  {
    positions[static_cast<std::size_t>(unknowns[i])] = static_cast<int>(i);
  }
  return positions;
}

/// Returns matrices with `rows` rows that hold the rows of each block at their new positions.
std::vector<Eigen::SparseMatrix<double>> SelectRows(
  const std::vector<Eigen::SparseMatrix<double>>& blocks, const std::vector<int>& positions,
  Eigen::Index rows)
{
  std::vector<Eigen::SparseMatrix<double>> parts;
  for (const Eigen::SparseMatrix<double>& block : blocks)
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < block.outerSize(); ++column)
    {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(block, column); entry; ++entry)
      {
        const int row = positions[static_cast<std::size_t>(entry.row())];
        if (row >= 0)
        {
          entries.emplace_back(row, column, entry.value());
        }
      }
    }
    parts.emplace_back(rows, block.cols());
    parts.back().setFromTriplets(entries.begin(), entries.end());
  }
  return parts;
}

/// Adds the rows of all blocks, side by side, to the rows of a dense matrix at their new positions.
void AddSelectedRows(const std::vector<Eigen::SparseMatrix<double>>& blocks,
  const std::vector<int>& positions, const std::vector<Eigen::Index>& firsts, Eigen::MatrixXd& rows)
{
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    for (int column = 0; column < blocks[block].outerSize(); ++column)
    {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(blocks[block], column); entry; ++entry)
      {
        const int row = positions[static_cast<std::size_t>(entry.row())];
        if (row >= 0)
        {
          rows(row, firsts[block] + column) += entry.value();
        }
      }
    }
  }
}

/// L⁻¹ B in one half, by supernodes.
struct EliminatedHalf
{
  std::vector<GramNode> nodes;
  std::vector<DissectedCholesky::SparseEliminated::Place> places;
  Eigen::MatrixXd atBorder; ///< Rows of the half's border unknowns, which a supernode may contain.
};

/// Gathers the rows of all blocks by supernode, and releases them. The half has number `part`,
/// `inner` unknowns of its own and `outer` border unknowns.
EliminatedHalf GatherNodes(std::vector<std::vector<SparseCholesky::Rows>>& solved, std::size_t part,
  Eigen::Index inner, Eigen::Index outer, const std::vector<Eigen::Index>& firsts)
{
  EliminatedHalf half;
  half.atBorder = Eigen::MatrixXd::Zero(outer, firsts.back());
  std::map<Eigen::Index, std::vector<std::pair<int, Eigen::MatrixXd>>> nodes;
  for (std::size_t block = 0; block < solved.size(); ++block)
  {
    for (SparseCholesky::Rows& rows : solved[block])
    {
      const auto inside = std::clamp<Eigen::Index>(inner - rows.first, 0, rows.values.rows());
      const Eigen::Index outside = rows.values.rows() - inside;
      if (outside > 0)
      {
        half.atBorder.block(rows.first + inside - inner, firsts[block], outside,
          rows.values.cols()) = rows.values.bottomRows(outside);
      }
      if (inside > 0)
      {
        nodes[rows.first].emplace_back(
          static_cast<int>(block), Eigen::MatrixXd(rows.values.topRows(inside)));
      }
      rows.values.resize(0, 0);
    }
  }
  for (auto& [first, members] : nodes)
  {
    GramNode node;
    Eigen::Index width = 0;
    for (const auto& [block, values] : members)
    {
      node.blocks.push_back(block);
      width += values.cols();
    }
    node.rows.resize(members.front().second.rows(), width);
    Eigen::Index column = 0;
    for (const auto& [block, values] : members)
    {
      node.rows.middleCols(column, values.cols()) = values;
      column += values.cols();
    }
    half.nodes.push_back(std::move(node));
    half.places.push_back({ part, first });
    members.clear();
  }
  return half;
}
}

Eigen::MatrixXd DissectedCholesky::SparseEliminated::TransposeTimes(
  const Eliminated& eliminated) const
{
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(this->firsts.back(), eliminated.border.cols());
  for (std::size_t i = 0; i < this->nodes.size(); ++i)
  {
    const GramNode& node = this->nodes[i];
    const Eigen::MatrixXd part =
      AdjointProduct(node.rows, RowsAt(eliminated, this->places[i], node.rows.rows()));
    Eigen::Index row = 0;
    for (const int block : node.blocks)
    {
      const Eigen::Index first = this->firsts[static_cast<std::size_t>(block)];
      const Eigen::Index size = this->firsts[static_cast<std::size_t>(block) + 1] - first;
      sums.middleRows(first, size) += part.middleRows(row, size);
      row += size;
    }
  }
  return sums;
}

void DissectedCholesky::SparseEliminated::AddTo(
  Eliminated& eliminated, const Eigen::MatrixXd& x) const
{
  for (std::size_t i = 0; i < this->nodes.size(); ++i)
  {
    const GramNode& node = this->nodes[i];
    Eigen::MatrixXd ofNode(node.rows.cols(), x.cols());
    Eigen::Index row = 0;
    for (const int block : node.blocks)
    {
      const Eigen::Index first = this->firsts[static_cast<std::size_t>(block)];
      const Eigen::Index size = this->firsts[static_cast<std::size_t>(block) + 1] - first;
      ofNode.middleRows(row, size) = x.middleRows(first, size);
      row += size;
    }
    RowsAt(eliminated, this->places[i], node.rows.rows()) += DenseProduct(node.rows, ofNode);
  }
}

DissectedCholesky::SparseEliminated DissectedCholesky::EliminateSparse(
  const std::vector<Eigen::SparseMatrix<double>>& blocks) const
{
  std::vector<Eigen::Index> firsts = { 0 };
  for (const Eigen::SparseMatrix<double>& block : blocks)
  {
    firsts.push_back(firsts.back() + block.cols());
  }
  RequireMemory(3.0 *
      static_cast<double>(firsts.back() * static_cast<Eigen::Index>(this->Border.size())) *
      sizeof(double),
    "The influence of " + std::to_string(firsts.back()) +
      " edges of holes on the cut through the mesh",
    "use a larger mesh size, fewer holes or fewer edges on them");
  std::array<EliminatedHalf, 2> halves;
  std::array<Eigen::MatrixXd, 2> ofBorder;
  ForBothHalves(true,
    [&](std::size_t h)
    {
      const Half& half = this->Halves[h];
      if (half.unknowns.empty())
      {
        return;
      }
      const auto inner = static_cast<Eigen::Index>(half.unknowns.size());
      const auto outer = static_cast<Eigen::Index>(half.border.size());
      std::vector<std::vector<SparseCholesky::Rows>> solved = half.factor->SolveLowerSparse(
        SelectRows(blocks, PositionsIn(half.unknowns, this->Size), inner + outer));
      halves[h] = GatherNodes(solved, h, inner, outer, firsts);
      ofBorder[h] = DenseProduct(half.borderFactor, halves[h].atBorder);
      halves[h].atBorder.resize(0, 0);
    });

  GramNode border;
  border.rows =
    Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(this->Border.size()), firsts.back());
  for (std::size_t h = 0; h < 2; ++h)
  {
    for (Eigen::Index i = 0; i < ofBorder[h].rows(); ++i)
    {
      border.rows.row(this->Halves[h].border[static_cast<std::size_t>(i)]) += ofBorder[h].row(i);
    }
    ofBorder[h].resize(0, 0);
  }
  AddSelectedRows(blocks, PositionsIn(this->Border, this->Size), firsts, border.rows);
  border.blocks.resize(blocks.size());
  std::iota(border.blocks.begin(), border.blocks.end(), 0);
  SolveLowerInPlace(this->BorderFactor.GetLower(), border.rows);
  SparseEliminated result;
  result.firsts = std::move(firsts);
  for (EliminatedHalf& half : halves)
  {
    std::move(half.nodes.begin(), half.nodes.end(), std::back_inserter(result.nodes));
    result.places.insert(result.places.end(), half.places.begin(), half.places.end());
  }
  result.nodes.push_back(std::move(border));
  result.places.push_back({ 2, 0 });
  return result;
}
}
