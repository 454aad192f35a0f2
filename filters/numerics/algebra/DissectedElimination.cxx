#include "BothHalves.h"
#include "DenseProduct.h"
#include "DissectedCholesky.h"
#include "MemoryBudget.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// The rows of a node, in what is eliminated.
template <typename Parts>
auto RowsAt(
  Parts& parts, const DissectedCholesky::SparseEliminated::Place& place, Eigen::Index count)
{
  auto& part = place.part < 2 ? parts.halves[place.part] : parts.border;
  return part.middleRows(place.first, count);
}
}

Eigen::MatrixXd DissectedCholesky::SparseEliminated::Against(const Eliminated& eliminated) const
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
    "What " + std::to_string(firsts.back()) + " edges of holes feel on the cut through the mesh",
    "use a larger mesh size, fewer holes or fewer edges on them");
  std::array<std::vector<GramNode>, 2> ofHalves;
  std::array<std::vector<SparseEliminated::Place>, 2> placesInHalves;
  std::array<Eigen::MatrixXd, 2> ofBorder;
  ForBothHalves(true,
    [&](std::size_t h)
    {
      const Half& half = this->Halves[h];
      if (half.unknowns.empty())
      {
        return;
      }
      // 1. What of the blocks lies in the half, and how it gets on from there.
      std::vector<int> local(static_cast<std::size_t>(this->Size), -1);
      for (std::size_t i = 0; i < half.unknowns.size(); ++i)
      {
        local[static_cast<std::size_t>(half.unknowns[i])] = static_cast<int>(i);
      }
      std::vector<Eigen::SparseMatrix<double>> parts;
      for (const Eigen::SparseMatrix<double>& block : blocks)
      {
        std::vector<Eigen::Triplet<double>> entries;
        for (int column = 0; column < block.outerSize(); ++column)
        {
          for (Eigen::SparseMatrix<double>::InnerIterator entry(block, column); entry; ++entry)
          {
            if (local[static_cast<std::size_t>(entry.row())] >= 0)
            {
              entries.emplace_back(
                local[static_cast<std::size_t>(entry.row())], column, entry.value());
            }
          }
        }
        parts.emplace_back(static_cast<Eigen::Index>(half.unknowns.size()) +
            static_cast<Eigen::Index>(half.border.size()),
          block.cols());
        parts.back().setFromTriplets(entries.begin(), entries.end());
      }
      std::vector<std::vector<SparseCholesky::Rows>> solved = half.factor->SolveLowerSparse(parts);

      // 2. By supernodes. One may have columns of the border, too.
      const auto inner = static_cast<int>(half.unknowns.size());
      Eigen::MatrixXd atBorder =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(half.border.size()), firsts.back());
      std::map<int, std::vector<std::pair<int, Eigen::MatrixXd>>> nodes;
      for (std::size_t block = 0; block < solved.size(); ++block)
      {
        for (SparseCholesky::Rows& rows : solved[block])
        {
          const auto inside = std::clamp<Eigen::Index>(inner - rows.first, 0, rows.values.rows());
          const Eigen::Index outside = rows.values.rows() - inside;
          if (outside > 0)
          {
            atBorder.block(rows.first + inside - inner, firsts[block], outside,
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
        ofHalves[h].push_back(std::move(node));
        placesInHalves[h].push_back({ h, first });
        members.clear();
      }
      ofBorder[h] = DenseProduct(half.borderFactor, atBorder);
    });

  // 3. The border.
  std::vector<int> place(static_cast<std::size_t>(this->Size), -1);
  for (std::size_t i = 0; i < this->Border.size(); ++i)
  {
    place[static_cast<std::size_t>(this->Border[i])] = static_cast<int>(i);
  }
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
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    border.blocks.push_back(static_cast<int>(block));
    for (int column = 0; column < blocks[block].outerSize(); ++column)
    {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(blocks[block], column); entry; ++entry)
      {
        if (place[static_cast<std::size_t>(entry.row())] >= 0)
        {
          border.rows(place[static_cast<std::size_t>(entry.row())], firsts[block] + column) +=
            entry.value();
        }
      }
    }
  }
  SolveLowerInPlace(this->BorderFactor.GetLower(), border.rows);
  SparseEliminated result;
  result.firsts = std::move(firsts);
  result.nodes = std::move(ofHalves[0]);
  std::move(ofHalves[1].begin(), ofHalves[1].end(), std::back_inserter(result.nodes));
  result.nodes.push_back(std::move(border));
  result.places = std::move(placesInHalves[0]);
  result.places.insert(result.places.end(), placesInHalves[1].begin(), placesInHalves[1].end());
  result.places.push_back({ 2, 0 });
  return result;
}
}
