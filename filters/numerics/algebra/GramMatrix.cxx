#include "GramMatrix.h"

#include "DenseProduct.h"
#include "Parts.h"
#include "SerialBlas.h"

#include <cmath>
#include <numeric>
#include <utility>

namespace crossfield
{
GramMatrix::GramMatrix(const std::vector<Eigen::Index>& sizes, std::vector<GramNode> nodes)
{
  this->SetSizes(sizes);
  for (GramNode& node : nodes)
  {
    if (node.blocks.size() == 1)
    {
      this->AddToBlock(node.blocks[0], AdjointProduct(node.rows, node.rows));
    }
    else if (!node.blocks.empty())
    {
      this->Nodes.push_back(std::move(node));
    }
  }
}

GramMatrix::GramMatrix(const std::vector<Eigen::Index>& sizes, const Eigen::MatrixXd& root)
{
  GramNode node;
  node.blocks.resize(sizes.size());
  std::iota(node.blocks.begin(), node.blocks.end(), 0);
  node.rows = root.transpose();
  std::vector<GramNode> nodes;
  nodes.push_back(std::move(node));
  *this = GramMatrix(sizes, std::move(nodes));
}

void GramMatrix::SetSizes(const std::vector<Eigen::Index>& sizes)
{
  this->Firsts = { 0 };
  for (const Eigen::Index size : sizes)
  {
    this->Firsts.push_back(this->Firsts.back() + size);
    this->Own.emplace_back(Eigen::MatrixXd::Zero(size, size));
  }
}

void GramMatrix::AddToBlock(int block, const Eigen::MatrixXd& matrix)
{
  this->Own[block] += matrix;
}

Eigen::Index GramMatrix::Entries() const
{
  Eigen::Index count = 0;
  for (const Eigen::MatrixXd& own : this->Own)
  {
    count += own.size();
  }
  for (const GramNode& node : this->Nodes)
  {
    count += node.rows.size();
  }
  return count;
}

double GramMatrix::Trace() const
{
  double trace = 0.0;
  for (const Eigen::MatrixXd& own : this->Own)
  {
    trace += own.trace();
  }
  for (const GramNode& node : this->Nodes)
  {
    trace += node.rows.squaredNorm();
  }
  return trace;
}

Eigen::MatrixXd GramMatrix::operator*(const Eigen::MatrixXd& columns) const
{
  Eigen::MatrixXd product(columns.rows(), columns.cols());
  for (int block = 0; block < this->BlockCount(); ++block)
  {
    product.middleRows(this->First(block), this->Size(block)) =
      DenseProduct(this->Own[block], columns.middleRows(this->First(block), this->Size(block)));
  }
  Eigen::MatrixXd part;
  for (const GramNode& node : this->Nodes)
  {
    part.resize(node.rows.cols(), columns.cols());
    Eigen::Index row = 0;
    for (const int block : node.blocks)
    {
      part.middleRows(row, this->Size(block)) =
        columns.middleRows(this->First(block), this->Size(block));
      row += this->Size(block);
    }
    part = AdjointProduct(node.rows, DenseProduct(node.rows, part));
    row = 0;
    for (const int block : node.blocks)
    {
      product.middleRows(this->First(block), this->Size(block)) +=
        part.middleRows(row, this->Size(block));
      row += this->Size(block);
    }
  }
  return product;
}

Eigen::VectorXcd GramMatrix::operator*(const Eigen::VectorXcd& column) const
{
  Eigen::MatrixXd parts(column.size(), 2);
  parts << column.real(), column.imag();
  parts = *this * parts;
  Eigen::VectorXcd product(column.size());
  product.real() = parts.col(0);
  product.imag() = parts.col(1);
  return product;
}

Eigen::MatrixXd GramMatrix::Block(int block) const
{
  Eigen::MatrixXd matrix = this->Own[block];
  for (const GramNode& node : this->Nodes)
  {
    Eigen::Index column = 0;
    for (const int other : node.blocks)
    {
      if (other == block)
      {
        const auto rows = node.rows.middleCols(column, this->Size(block));
        matrix += AdjointProduct(rows, rows);
      }
      column += this->Size(other);
    }
  }
  return matrix;
}

Eigen::MatrixXd GramMatrix::Dense() const
{
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(this->Rows(), this->Rows());
  for (int block = 0; block < this->BlockCount(); ++block)
  {
    dense.block(this->First(block), this->First(block), this->Size(block), this->Size(block)) =
      this->Own[block];
  }
  for (const GramNode& node : this->Nodes)
  {
    const Eigen::MatrixXd part = AdjointProduct(node.rows, node.rows);
    Eigen::Index column = 0;
    for (const int right : node.blocks)
    {
      Eigen::Index row = 0;
      for (const int left : node.blocks)
      {
        dense.block(this->First(left), this->First(right), this->Size(left), this->Size(right)) +=
          part.block(row, column, this->Size(left), this->Size(right));
        row += this->Size(left);
      }
      column += this->Size(right);
    }
  }
  return dense;
}

GramMatrix GramMatrix::Congruence(const std::vector<Eigen::MatrixXd>& ofBlocks) const
{
  std::vector<Eigen::Index> sizes;
  sizes.reserve(ofBlocks.size());
  for (const Eigen::MatrixXd& columns : ofBlocks)
  {
    sizes.push_back(columns.cols());
  }
  GramMatrix result;
  result.SetSizes(sizes);
  for (int block = 0; block < this->BlockCount(); ++block)
  {
    const Eigen::MatrixXd& columns = ofBlocks[block];
    result.Own[block] = AdjointProduct(columns, DenseProduct(this->Own[block], columns));
  }
  for (const GramNode& node : this->Nodes)
  {
    GramNode turned;
    turned.blocks = node.blocks;
    Eigen::Index width = 0;
    for (const int block : node.blocks)
    {
      width += result.Size(block);
    }
    turned.rows.resize(node.rows.rows(), width);
    Eigen::Index from = 0;
    Eigen::Index to = 0;
    for (const int block : node.blocks)
    {
      turned.rows.middleCols(to, result.Size(block)) =
        DenseProduct(node.rows.middleCols(from, this->Size(block)), ofBlocks[block]);
      from += this->Size(block);
      to += result.Size(block);
    }
    result.Nodes.push_back(std::move(turned));
  }
  return result;
}

Eigen::VectorXd GramMatrix::SquaredCouplings() const
{
  struct Place
  {
    const GramNode* node;
    Eigen::Index column;
  };
  std::vector<std::vector<Place>> places(this->Own.size());
  for (const GramNode& node : this->Nodes)
  {
    Eigen::Index column = 0;
    for (const int block : node.blocks)
    {
      places[block].push_back({ &node, column });
      column += this->Size(block);
    }
  }
  const auto add = [&](int block, Eigen::MatrixXd& before, Eigen::VectorXd& squares)
  {
    before.setZero(this->Size(block), this->First(block));
    for (const Place& place : places[block])
    {
      const Eigen::MatrixXd& rows = place.node->rows;
      const Eigen::MatrixXd part = AdjointProduct(
        rows.middleCols(place.column, this->Size(block)), rows.leftCols(place.column));
      Eigen::Index column = 0;
      for (const int other : place.node->blocks)
      {
        if (other >= block)
        {
          break;
        }
        before.middleCols(this->First(other), this->Size(other)) +=
          part.middleCols(column, this->Size(other));
        column += this->Size(other);
      }
    }
    squares.segment(this->First(block), this->Size(block)) += before.rowwise().squaredNorm();
    squares.head(this->First(block)) += before.colwise().squaredNorm().transpose();
  };
  const SerialBlas serial;
  // Later blocks have more blocks before them: the bounds of parts with equal numbers of pairs grow
  // as square roots.
  const int count = this->BlockCount();
  const std::size_t parts = PartCount(count, 1);
  const auto bound = [&](std::size_t part)
  {
    return static_cast<int>(
      count * std::sqrt(static_cast<double>(part) / static_cast<double>(parts)));
  };
  std::vector<Eigen::VectorXd> squares(parts);
  ForParts(parts,
    [&](std::size_t part)
    {
      squares[part] = Eigen::VectorXd::Zero(this->Rows());
      Eigen::MatrixXd before; // rows of a block in the columns of all blocks before it
      for (int block = bound(part); block < bound(part + 1); ++block)
      {
        add(block, before, squares[part]);
      }
    });
  for (std::size_t part = 1; part < parts; ++part)
  {
    squares[0] += squares[part];
  }
  return squares[0];
}
}
