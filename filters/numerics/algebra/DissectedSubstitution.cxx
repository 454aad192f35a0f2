// Solves of DissectedCholesky with dense right-hand sides.
#include "DenseProduct.h"
#include "DissectedCholesky.h"
#include "Error.h"
#include "Parts.h"
#include "SerialBlas.h"

namespace crossfield
{
namespace
{
/// Minimum number of right-hand side values for a substitution in parallel. With fewer, the threads
/// wait for each other longer than they compute when other programs use the processors too, as in
/// an optimiser that solves ten thousand times on a coarse mesh.
constexpr Eigen::Index MinimumValuesInParallel = 20000;

/// Minimum number of columns that are solved for together: enough for dense kernels, and few enough
/// to remain in the cache.
constexpr Eigen::Index ColumnsOfPart = 16;
}

DissectedCholesky::Eliminated DissectedCholesky::Eliminate(
  const Eigen::MatrixXd& rightHandSides) const
{
  const SerialBlas serial;
  Eliminated eliminated;
  for (const Part& part : this->Parts)
  {
    eliminated.parts.emplace_back(part.Size(), rightHandSides.cols());
  }
  eliminated.border = std::move(eliminated.parts.back());
  eliminated.parts.pop_back();
  ForRanges(
    rightHandSides.cols(),
    [&](int begin, int end) { this->EliminateColumns(rightHandSides, begin, end, eliminated); },
    ColumnsOfPart);
  return eliminated;
}

void DissectedCholesky::EliminateColumns(const Eigen::MatrixXd& rightHandSides, Eigen::Index begin,
  Eigen::Index end, Eliminated& eliminated) const
{
  const Eigen::Index count = end - begin;
  // What the elimination of a part adds to its border.
  std::vector<Eigen::MatrixXd> ofBorders(this->Parts.size());
  const auto load = [&](const Part& part)
  {
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(part.Rows(), count);
    for (Eigen::Index column = 0; column < count; ++column)
    {
      for (Eigen::Index i = 0; i < part.Size(); ++i)
      {
        columns(i, column) = rightHandSides(part.unknowns[i], begin + column);
      }
    }
    for (const int below : part.below)
    {
      const std::vector<int>& rows = this->Parts[below].inParent;
      const Eigen::MatrixXd& added = ofBorders[below];
      for (Eigen::Index column = 0; column < count; ++column)
      {
        for (std::size_t i = 0; i < rows.size(); ++i)
        {
          columns(rows[i], column) += added(static_cast<Eigen::Index>(i), column);
        }
      }
    }
    return columns;
  };
  this->ForParts(count * this->Size >= MinimumValuesInParallel, true,
    [&](std::size_t i)
    {
      const Part& part = this->Parts[i];
      Eigen::MatrixXd columns = load(part);
      const Eigen::Index outside = part.Rows() - part.Size();
      if (part.leaf)
      {
        part.leaf->SolveLower(columns);
      }
      else
      {
        SolveLowerInPlace(part.lower.topRows(part.Size()), columns.topRows(part.Size()));
        columns.bottomRows(outside) -=
          DenseProduct(part.lower.bottomRows(outside), columns.topRows(part.Size()));
      }
      eliminated.parts[i].middleCols(begin, count) = columns.topRows(part.Size());
      ofBorders[i] = columns.bottomRows(outside);
    });
  auto root = eliminated.border.middleCols(begin, count);
  root = load(this->Parts.back());
  SolveLowerInPlace(this->RootFactor.GetLower(), root);
}

Eigen::MatrixXd DissectedCholesky::Substitute(const Eliminated& eliminated) const
{
  const SerialBlas serial;
  Eigen::MatrixXd solution = Eigen::MatrixXd::Zero(this->Size, eliminated.border.cols());
  ForRanges(
    solution.cols(),
    [&](int begin, int end) { this->SubstituteColumns(eliminated, begin, end, solution); },
    ColumnsOfPart);
  if (!solution.allFinite())
  {
    throw Error("The solution of the linear system is not finite; the mesh has degenerate "
                "triangles, remesh the domain.");
  }
  return solution;
}

void DissectedCholesky::SubstituteColumns(const Eliminated& eliminated, Eigen::Index begin,
  Eigen::Index end, Eigen::MatrixXd& solution) const
{
  const Eigen::Index count = end - begin;
  // Solutions in the local rows of all parts.
  std::vector<Eigen::MatrixXd> solved(this->Parts.size());
  const auto store = [&](const Part& part, const Eigen::MatrixXd& local)
  {
    for (Eigen::Index column = 0; column < count; ++column)
    {
      for (Eigen::Index i = 0; i < part.Size(); ++i)
      {
        solution(part.unknowns[i], begin + column) = local(i, column);
      }
    }
  };
  solved.back() = eliminated.border.middleCols(begin, count);
  SolveLowerAdjointInPlace(this->RootFactor.GetLower(), solved.back());
  store(this->Parts.back(), solved.back());
  this->ForParts(count * this->Size >= MinimumValuesInParallel, false,
    [&](std::size_t i)
    {
      const Part& part = this->Parts[i];
      const Eigen::MatrixXd& above = solved[part.parent];
      const Eigen::Index outside = part.Rows() - part.Size();
      Eigen::MatrixXd& local = solved[i];
      local.resize(part.Rows(), count);
      local.topRows(part.Size()) = eliminated.parts[i].middleCols(begin, count);
      for (Eigen::Index column = 0; column < count; ++column)
      {
        for (std::size_t k = 0; k < part.inParent.size(); ++k)
        {
          local(part.Size() + static_cast<Eigen::Index>(k), column) =
            above(part.inParent[k], column);
        }
      }
      if (part.leaf)
      {
        part.leaf->SolveUpper(local);
      }
      else
      {
        local.topRows(part.Size()) -=
          AdjointProduct(part.lower.bottomRows(outside), local.bottomRows(outside));
        SolveLowerAdjointInPlace(part.lower.topRows(part.Size()), local.topRows(part.Size()));
      }
      store(part, local);
      if (part.leaf)
      {
        local.resize(0, 0); // no part is below
      }
    });
}
}
