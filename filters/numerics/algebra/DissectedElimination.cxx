#include "DenseProduct.h"
#include "DissectedCholesky.h"
#include "MemoryBudget.h"
#include "Parts.h"

#include <algorithm>
#include <iterator>
#include <map>
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
  auto& part = place.part < parts.parts.size() ? parts.parts[place.part] : parts.border;
  return part.middleRows(place.first, count);
}

/// Entries of one block in the local rows of a part.
struct PartOfBlock
{
  int block = 0;
  std::vector<Eigen::Triplet<double>> entries;
};

/// L⁻¹ B in one part of the tree.
struct EliminatedPart
{
  std::vector<GramNode> nodes;
  std::vector<Eigen::Index> firsts; ///< First row of each node in the part.
  std::vector<int> blocks;          ///< Blocks with entries at the border, in increasing order.
  Eigen::MatrixXd atBorder;         ///< What the part adds to its border, block after block.
};

/// Eliminates the blocks in a leaf, and collects their rows by supernode.
EliminatedPart EliminateInLeaf(const PartialCholesky& leaf, Eigen::Index border,
  const std::vector<PartOfBlock>& parts, const std::vector<Eigen::Index>& firsts)
{
  EliminatedPart result;
  Eigen::Index width = 0;
  for (const PartOfBlock& part : parts)
  {
    const auto block = static_cast<std::size_t>(part.block);
    result.blocks.push_back(part.block);
    width += firsts[block + 1] - firsts[block];
  }
  result.atBorder = Eigen::MatrixXd::Zero(border, width);
  std::map<int, std::vector<std::pair<int, Eigen::MatrixXd>>> nodes; // by first row
  Eigen::Index column = 0;
  for (const PartOfBlock& part : parts)
  {
    const auto block = static_cast<std::size_t>(part.block);
    const Eigen::Index columns = firsts[block + 1] - firsts[block];
    Eigen::SparseMatrix<double> matrix(leaf.InnerCount(), columns);
    matrix.setFromTriplets(part.entries.begin(), part.entries.end());
    for (PartialCholesky::Rows& rows :
      leaf.SolveLowerSparse(matrix, result.atBorder.middleCols(column, columns)))
    {
      nodes[rows.first].emplace_back(part.block, std::move(rows.values));
    }
    column += columns;
  }
  for (auto& [first, members] : nodes)
  {
    GramNode node;
    width = 0;
    for (const auto& [block, values] : members)
    {
      node.blocks.push_back(block);
      width += values.cols();
    }
    node.rows.resize(members.front().second.rows(), width);
    column = 0;
    for (const auto& [block, values] : members)
    {
      node.rows.middleCols(column, values.cols()) = values;
      column += values.cols();
    }
    result.nodes.push_back(std::move(node));
    result.firsts.push_back(first);
    members.clear();
  }
  return result;
}

/// A part below another one, and the rows of that one at its border.
struct PartBelow
{
  EliminatedPart& part;
  const std::vector<int>& places;
};

/// Returns the rows of a part before its elimination, block after block: its own entries and what the
/// parts below add, whose matrices are freed. Sets the numbers of the blocks.
Eigen::MatrixXd LoadRows(Eigen::Index count, const std::vector<PartOfBlock>& own,
  const std::vector<PartBelow>& below, const std::vector<Eigen::Index>& firsts,
  std::vector<int>& active)
{
  for (const PartOfBlock& entries : own)
  {
    active.push_back(entries.block);
  }
  for (const PartBelow& from : below)
  {
    active.insert(active.end(), from.part.blocks.begin(), from.part.blocks.end());
  }
  std::sort(active.begin(), active.end());
  active.erase(std::unique(active.begin(), active.end()), active.end());
  const auto widthOf = [&firsts](int block)
  { return firsts[static_cast<std::size_t>(block) + 1] - firsts[block]; };
  std::vector<Eigen::Index> starts = { 0 }; // columns of the active blocks
  for (const int block : active)
  {
    starts.push_back(starts.back() + widthOf(block));
  }
  const auto startOf = [&](int block)
  { return starts[std::lower_bound(active.begin(), active.end(), block) - active.begin()]; };
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(count, starts.back());
  for (const PartOfBlock& entries : own)
  {
    const Eigen::Index start = startOf(entries.block);
    for (const Eigen::Triplet<double>& entry : entries.entries)
    {
      rows(entry.row(), start + entry.col()) += entry.value();
    }
  }
  for (const PartBelow& from : below)
  {
    Eigen::Index column = 0;
    for (const int block : from.part.blocks)
    {
      const Eigen::Index start = startOf(block);
      for (Eigen::Index c = 0; c < widthOf(block); ++c, ++column)
      {
        for (std::size_t k = 0; k < from.places.size(); ++k)
        {
          rows(from.places[k], start + c) +=
            from.part.atBorder(static_cast<Eigen::Index>(k), column);
        }
      }
    }
    from.part.atBorder.resize(0, 0);
  }
  return rows;
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
      const Eigen::Index first = this->firsts[block];
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
      const Eigen::Index first = this->firsts[block];
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
      static_cast<double>(
        firsts.back() * static_cast<Eigen::Index>(this->Parts.back().unknowns.size())) *
      sizeof(double),
    "The influence of " + std::to_string(firsts.back()) +
      " edges of holes on the cut through the mesh",
    "use a larger mesh size, fewer holes or fewer edges on them");
  // 1. Distribute the entries among the parts.
  std::vector<std::vector<PartOfBlock>> ofParts(this->Parts.size());
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    for (int column = 0; column < blocks[block].outerSize(); ++column)
    {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(blocks[block], column); entry; ++entry)
      {
        const int position = this->Positions[entry.row()];
        if (position < 0)
        {
          continue;
        }
        const auto next = std::upper_bound(this->Parts.begin(), this->Parts.end(), position,
          [](int value, const Part& part) { return value < part.first; });
        const auto part = static_cast<std::size_t>(next - this->Parts.begin()) - 1;
        std::vector<PartOfBlock>& list = ofParts[part];
        if (list.empty() || list.back().block != static_cast<int>(block))
        {
          list.push_back({ static_cast<int>(block), {} });
        }
        list.back().entries.emplace_back(position - this->Parts[part].first, column, entry.value());
      }
    }
  }

  // 2. Eliminate part after part. The root has all blocks.
  std::vector<EliminatedPart> parts(this->Parts.size());
  const auto load = [&](std::size_t i, std::vector<int>& active)
  {
    std::vector<PartBelow> below;
    for (const int part : this->Parts[i].below)
    {
      const auto p = static_cast<std::size_t>(part);
      below.push_back({ parts[p], this->Parts[p].inParent });
    }
    return LoadRows(this->Parts[i].Rows(), ofParts[i], below, firsts, active);
  };
  this->ForParts(true, true,
    [&](std::size_t i)
    {
      const Part& part = this->Parts[i];
      const Eigen::Index border = part.Rows() - part.Size();
      if (part.leaf)
      {
        parts[i] = EliminateInLeaf(*part.leaf, border, ofParts[i], firsts);
        return;
      }
      EliminatedPart& result = parts[i];
      const Eigen::MatrixXd rows = load(i, result.blocks);
      if (result.blocks.empty())
      {
        return;
      }
      GramNode node;
      node.blocks = result.blocks;
      node.rows = rows.topRows(part.Size());
      SolveLowerInPlace(part.lower.topRows(part.Size()), node.rows);
      result.atBorder =
        rows.bottomRows(border) - DenseProduct(part.lower.bottomRows(border), node.rows);
      result.nodes.push_back(std::move(node));
      result.firsts.push_back(0);
    });

  GramNode root;
  for (const Eigen::SparseMatrix<double>& block : blocks)
  {
    root.blocks.push_back(static_cast<int>(&block - blocks.data()));
    ofParts.back().push_back({ root.blocks.back(), {} });
  }
  std::vector<int> all;
  root.rows = load(this->Parts.size() - 1, all);
  SolveLowerInPlace(this->RootFactor.GetLower(), root.rows);

  SparseEliminated result;
  result.firsts = std::move(firsts);
  for (std::size_t i = 0; i + 1 < parts.size(); ++i)
  {
    for (const Eigen::Index first : parts[i].firsts)
    {
      result.places.push_back({ i, first });
    }
    std::move(parts[i].nodes.begin(), parts[i].nodes.end(), std::back_inserter(result.nodes));
  }
  result.nodes.push_back(std::move(root));
  result.places.push_back({ parts.size() - 1, 0 });
  return result;
}
}
