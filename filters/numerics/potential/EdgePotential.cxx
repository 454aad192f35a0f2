#include "EdgePotential.h"

#include "Parts.h"

namespace crossfield
{
Eigen::MatrixXd EdgePotential::Solve(const Eigen::MatrixXd& fluxes) const
{
  const PlanarTopology& topology = this->Potential.GetTopology();
  // 1. The phase, with the constants on inner loops that make its conjugate single-valued.
  Eigen::MatrixXd phases(this->Potential.Rows(), fluxes.cols());
  constexpr Eigen::Index LeastColumns = 16;
  ForRanges(
    fluxes.cols(),
    [&](int begin, int end)
    {
      for (Eigen::Index column = begin; column < end; ++column)
      {
        phases.col(column) =
          ConformingPhase(this->Potential.GetOperator(), this->Steps, fluxes.col(column)).Get();
      }
    },
    LeastColumns);
  Eigen::MatrixXd sources = this->Dirichlet.HarmonicSources(phases);
  const Eigen::MatrixXd& constants = this->Dirichlet.IslandSources();
  if (constants.cols() > 0)
  {
    sources -= constants *
      this->Dirichlet.GetCouplingFactor().solve(this->Dirichlet.SumAroundIslands(sources));
  }

  // 2. Its conjugate changes by the source of a vertex from one boundary edge to the next, and by
  //    the source of a period along its strip; the potential is minus the conjugate.
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(fluxes.rows(), fluxes.cols());
  const auto follow = [&](const BoundaryLoop& loop, int first)
  {
    const bool forward = loop.kind ==
      BoundaryKind::Outer; // inner loops are listed against the direction of their edges
    const std::size_t count = loop.edges.size();
    std::size_t here = 0;
    while (loop.edges[here] != first)
    {
      ++here;
    }
    for (std::size_t i = 1; i < count; ++i)
    {
      const std::size_t next = forward ? (here + 1) % count : (here + count - 1) % count;
      values.row(loop.edges[next]) = values.row(loop.edges[here]) -
        sources.row(topology.BoundaryAt(loop.edges[next]).vertices[0]);
      here = next;
    }
  };
  Eigen::Index k = 0;
  for (const BoundaryLoop& loop : topology.loops) // the outer one is the first
  {
    if (loop.kind == BoundaryKind::Outer)
    {
      follow(loop, loop.edges.front());
      continue;
    }
    const Cycle& cycle = topology.cycles[k];
    values.row(cycle.lastBoundaryEdge) =
      values.row(cycle.firstBoundaryEdge) + sources.row(this->Potential.PeriodRow(k));
    follow(loop, cycle.lastBoundaryEdge);
    ++k;
  }
  return values;
}
}
