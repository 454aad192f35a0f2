#include "DissectedCholesky.h"

#include "DenseParts.h"
#include "FactorisationCount.h"
#include "MemoryBudget.h"
#include "Parts.h"
#include "SerialBlas.h"
#include "SparseCholesky.h"

#include <algorithm>

namespace crossfield
{
namespace
{
void RequireFinite(const Eigen::MatrixXd& matrix)
{
  if (!matrix.allFinite())
  {
    throw Error("The matrix has entries that are not finite; the mesh has degenerate triangles, "
                "remesh it.");
  }
}
}

DissectedCholesky::DissectedCholesky(const Eigen::SparseMatrix<double>& matrix,
  const std::vector<SpacePoint>& places, const std::vector<int>& trailing,
  const std::vector<int>& leftOut, const Progress& progress, const std::vector<int>& partners)
  : Positions(static_cast<std::size_t>(matrix.rows()), -1)
  , Size(matrix.rows())
{
  CountFactorisation();
  const SerialBlas serial;
  int first = 0;
  for (DissectionPart& from : Dissect(matrix, places, trailing, leftOut, partners))
  {
    Part part;
    part.unknowns = std::move(from.unknowns);
    part.parent = from.parent;
    part.first = first;
    part.height = from.isLeaf ? 0 : 1;
    for (const int unknown : part.unknowns)
    {
      this->Positions[unknown] = first++;
    }
    this->Parts.push_back(std::move(part));
  }
  this->ConnectParts(matrix);
  this->RequireMemoryForFactor();
  progress.Report(0.1);

  std::vector<Eigen::MatrixXd> updates(this->Parts.size());
  WithAllThreads(
    [&]
    {
      this->ForParts(true, true,
        [&](std::size_t i) { updates[i] = this->FactorPart(matrix, this->Parts[i], updates); });
    });
  progress.Report(0.9);
  Eigen::MatrixXd root = this->AssembleFront(matrix, this->Parts.back(), updates);
  RequireFinite(root);
  this->RootFactor = DenseCholesky<double>(std::move(root));
  if (!this->RootFactor.IsPositiveDefinite())
  {
    throw NotPositiveDefinite();
  }
  const auto trailingSize = static_cast<Eigen::Index>(trailing.size());
  this->TrailingFactor = this->RootFactor.GetLower().bottomRightCorner(trailingSize, trailingSize);
}

void DissectedCholesky::ConnectParts(const Eigen::SparseMatrix<double>& matrix)
{
  // 1. The unknowns outside of a part that its own unknowns are coupled to.
  crossfield::ForParts(this->Parts.size(),
    [&](std::size_t i)
    {
      Part& part = this->Parts[i];
      const int end = part.first + static_cast<int>(part.unknowns.size());
      for (const int unknown : part.unknowns)
      {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, unknown); entry; ++entry)
        {
          const int position = this->Positions[entry.row()];
          if (position >= end)
          {
            part.border.push_back(position);
          }
        }
      }
      std::sort(part.border.begin(), part.border.end());
      part.border.erase(std::unique(part.border.begin(), part.border.end()), part.border.end());
    });

  // 2. Those of the parts below.
  for (std::size_t i = 0; i + 1 < this->Parts.size(); ++i)
  {
    const Part& part = this->Parts[i];
    Part& above = this->Parts[part.parent];
    above.height = std::max(above.height, part.height + 1);
    above.below.push_back(static_cast<int>(i));
    const int end = above.first + static_cast<int>(above.unknowns.size());
    const auto outside = std::lower_bound(part.border.begin(), part.border.end(), end);
    std::vector<int> border;
    std::set_union(outside, part.border.end(), above.border.begin(), above.border.end(),
      std::back_inserter(border));
    above.border = std::move(border);
    this->Levels.resize(std::max(this->Levels.size(), static_cast<std::size_t>(part.height) + 1));
    this->Levels[part.height].push_back(static_cast<int>(i));
  }
  for (std::size_t i = 0; i + 1 < this->Parts.size(); ++i)
  {
    Part& part = this->Parts[i];
    for (const int position : part.border)
    {
      part.inParent.push_back(LocalRow(this->Parts[part.parent], position));
    }
  }
}

int DissectedCholesky::LocalRow(const Part& part, int position)
{
  const int size = static_cast<int>(part.unknowns.size());
  if (position < part.first + size)
  {
    return position < part.first ? -1 : position - part.first;
  }
  const auto found = std::lower_bound(part.border.begin(), part.border.end(), position);
  return found == part.border.end() || *found != position
    ? -1
    : size + static_cast<int>(found - part.border.begin());
}

void DissectedCholesky::RequireMemoryForFactor() const
{
  double entries = 0.0;
  for (const Part& part : this->Parts)
  {
    const auto size = static_cast<double>(part.Size());
    const auto border = static_cast<double>(part.border.size());
    // The update on the border exists until the part above has added it.
    entries += border * border + (part.height == 0 ? DissectionFill(size) : size * (size + border));
  }
  RequireMemory(entries * sizeof(double),
    "The factorisation of " + std::to_string(this->Size) + " unknowns, of which " +
      std::to_string(this->Parts.back().unknowns.size()) +
      " on holes and on the cut through the mesh are dense,",
    "use a larger mesh size, fewer holes or fewer edges on them");
}

void DissectedCholesky::ForParts(
  bool parallel, bool upwards, const std::function<void(std::size_t)>& function) const
{
  const std::size_t levels = this->Levels.size();
  for (std::size_t i = 0; i < levels; ++i)
  {
    const std::vector<int>& level = this->Levels[upwards ? i : levels - 1 - i];
    const auto call = [&](std::size_t part) { function(static_cast<std::size_t>(level[part])); };
    if (parallel)
    {
      crossfield::ForParts(level.size(), call);
      continue;
    }
    for (std::size_t part = 0; part < level.size(); ++part)
    {
      call(part);
    }
  }
}

Eigen::MatrixXd DissectedCholesky::AssembleFront(const Eigen::SparseMatrix<double>& matrix,
  const Part& part, std::vector<Eigen::MatrixXd>& updates) const
{
  Eigen::MatrixXd front = Eigen::MatrixXd::Zero(part.Rows(), part.Rows());
  for (Eigen::Index j = 0; j < part.Size(); ++j)
  {
    const int unknown = part.unknowns[j];
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, unknown); entry; ++entry)
    {
      const int position = this->Positions[entry.row()];
      if (position >= part.first + j)
      {
        front(LocalRow(part, position), j) += entry.value();
      }
    }
  }
  for (const int below : part.below)
  {
    const std::vector<int>& rows = this->Parts[below].inParent;
    Eigen::MatrixXd& update = updates[below];
    // Rows of the border keep their order, so the lower triangle stays the lower one.
    for (std::size_t j = 0; j < rows.size(); ++j)
    {
      for (std::size_t i = j; i < rows.size(); ++i)
      {
        front(rows[i], rows[j]) +=
          update(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      }
    }
    update.resize(0, 0);
  }
  return front;
}

Eigen::MatrixXd DissectedCholesky::FactorPart(const Eigen::SparseMatrix<double>& matrix, Part& part,
  std::vector<Eigen::MatrixXd>& updates) const
{
  if (part.height == 0)
  {
    return this->FactorLeaf(matrix, part);
  }
  Eigen::MatrixXd front = this->AssembleFront(matrix, part, updates);
  RequireFinite(front);
  if (!FactorInParts<double>(front, part.Size()))
  {
    throw NotPositiveDefinite();
  }
  part.lower = front.leftCols(part.Size());
  part.lower.triangularView<Eigen::StrictlyUpper>().setZero();
  const auto border = static_cast<Eigen::Index>(part.border.size());
  return front.bottomRightCorner(border, border);
}

Eigen::MatrixXd DissectedCholesky::FactorLeaf(
  const Eigen::SparseMatrix<double>& matrix, Part& part) const
{
  // The columns of the leaf, on and below the diagonal, in its local rows.
  Eigen::SparseMatrix<double> lower(part.Rows(), part.Rows());
  Eigen::Index entries = 0;
  for (const int unknown : part.unknowns)
  {
    entries += matrix.outerIndexPtr()[unknown + 1] - matrix.outerIndexPtr()[unknown];
  }
  lower.reserve(entries);
  std::vector<std::pair<int, double>> column;
  for (Eigen::Index j = 0; j < part.Rows(); ++j)
  {
    lower.startVec(j);
    if (j >= part.Size())
    {
      continue;
    }
    column.clear();
    const int unknown = part.unknowns[j];
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, unknown); entry; ++entry)
    {
      const int position = this->Positions[entry.row()];
      if (position >= part.first + j)
      {
        column.emplace_back(LocalRow(part, position), entry.value());
      }
    }
    std::sort(
      column.begin(), column.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [row, value] : column)
    {
      lower.insertBack(row, j) = value;
    }
  }
  lower.finalize();
  const auto border = static_cast<Eigen::Index>(part.border.size());
  Eigen::MatrixXd update = Eigen::MatrixXd::Zero(border, border);
  part.leaf = std::make_unique<PartialCholesky>(lower, static_cast<int>(part.Size()), update);
  return update;
}
}
