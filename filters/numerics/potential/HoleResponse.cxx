#include "HoleResponse.h"

#include <iterator>
#include <numeric>
#include <utility>

namespace crossfield
{
namespace
{
/// Splits ∇ᵀ into the columns of every hole.
std::vector<Eigen::SparseMatrix<double>> BlocksByHole(const PotentialOperator& laplacian)
{
  const Eigen::SparseMatrix<double> sources = HoleSources(laplacian);
  std::vector<Eigen::SparseMatrix<double>> blocks;
  Eigen::Index first = 0;
  for (const BoundaryLoop& loop : laplacian.GetTopology().loops)
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      const auto size = static_cast<Eigen::Index>(loop.edges.size());
      blocks.emplace_back(sources.middleCols(first, size));
      first += size;
    }
  }
  return blocks;
}
}

Eigen::SparseMatrix<double> HoleSources(const PotentialOperator& laplacian)
{
  const MeshTopology& topology = laplacian.GetTopology();
  std::vector<Eigen::Triplet<double>> entries;
  auto period = laplacian.PeriodCount(PotentialOperator::Periods::Islands);
  int first = 0;
  for (const BoundaryLoop& loop : topology.loops)
  {
    if (loop.kind != BoundaryKind::Hole)
    {
      continue;
    }
    const Cycle& cycle = topology.cycles[period];
    const auto size = static_cast<int>(loop.edges.size());
    for (int j = 0; j < size; ++j)
    {
      // Edges are directed clockwise around the hole, so edge j starts where edge j + 1 ends.
      const int edge = loop.edges[j];
      const int vertex = topology.BoundaryAt(edge).vertices[0];
      entries.emplace_back(vertex, first + j, 1.0);
      entries.emplace_back(vertex, first + (j + 1) % size, -1.0);
      if (edge == cycle.lastBoundaryEdge)
      {
        entries.emplace_back(static_cast<int>(laplacian.PeriodRow(period)), first + j, -1.0);
      }
    }
    first += size;
    ++period;
  }
  Eigen::SparseMatrix<double> sources(laplacian.Rows(), first);
  sources.setFromTriplets(entries.begin(), entries.end());
  return sources;
}

HoleElimination::HoleElimination(const PotentialFactor& factor)
  : Factor(factor)
  , Columns(factor.EliminateSparse(BlocksByHole(factor.GetOperator())))
{
}

void HoleElimination::AddSources(
  PotentialFactor::Eliminated& eliminated, const Eigen::MatrixXd& x, Periods periods) const
{
  this->Columns.AddTo(eliminated, x);
  this->Factor.LeaveOutPeriods(eliminated, periods);
}

HoleResponse::HoleResponse(const HoleElimination& holes, PotentialOperator::Periods problemPeriods)
{
  const PotentialFactor& factor = holes.GetFactor();
  const DissectedCholesky::SparseEliminated& columns = holes.GetColumns();
  const Eigen::Index periodCount = factor.UnknownPeriodCount(problemPeriods);
  this->periods.resize(0, periodCount);
  if (columns.firsts.back() == 0)
  {
    return;
  }
  std::vector<Eigen::Index> sizes(columns.firsts.size());
  std::adjacent_difference(columns.firsts.begin(), columns.firsts.end(), sizes.begin());
  sizes.erase(sizes.begin());
  // The last rows are the periods; those that the problem does not have are set to zero.
  std::vector<GramNode> nodes = columns.nodes;
  Eigen::MatrixXd& border = nodes.back().rows;
  const Eigen::Index without =
    factor.UnknownPeriodCount(PotentialOperator::Periods::IslandsAndHoles) - periodCount;
  border.conservativeResize(border.rows() - without, Eigen::NoChange);
  this->periods = factor.PeriodFactor(problemPeriods)
                    .transpose()
                    .triangularView<Eigen::Upper>()
                    .solve(border.bottomRows(periodCount))
                    .transpose();
  this->elastic = GramMatrix(sizes, std::move(nodes));
  if (periodCount < factor.GetOperator().PeriodCount())
  {
    // The gauge: any positive weight will do; the mean of the diagonal keeps the matrix well
    // scaled.
    const double mean = this->elastic.Trace() / static_cast<double>(this->elastic.Rows());
    for (int hole = 0; hole < this->elastic.BlockCount(); ++hole)
    {
      const Eigen::Index size = this->elastic.Size(hole);
      this->elastic.AddToBlock(
        hole, Eigen::MatrixXd::Constant(size, size, mean / static_cast<double>(size)));
    }
  }
}
}
