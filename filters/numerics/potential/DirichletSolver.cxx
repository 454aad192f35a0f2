#include "DirichletSolver.h"

#include "Parts.h"

namespace crossfield
{
namespace
{
/// Minimum number of columns of sparse products in a part.
constexpr Eigen::Index ColumnsOfPart = 16;
}

DirichletSolver::DirichletSolver(const PotentialOperator& laplacian)
  : Factor(laplacian, PotentialFactor::Boundary::Dirichlet)
  , OfIslands(laplacian.Rows(), laplacian.PeriodCount(PotentialOperator::Periods::Islands))
{
  const MeshTopology& topology = laplacian.GetTopology();
  for (const BoundaryEdge& edge : topology.mesh.boundary)
  {
    if (edge.IsAligned())
    {
      this->Prescribed.push_back(edge.vertices[0]);
    }
  }
  for (Eigen::Index k = 0; k < laplacian.PeriodCount(); ++k)
  {
    this->Prescribed.push_back(static_cast<int>(laplacian.PeriodRow(k)));
  }
  std::vector<Eigen::Triplet<double>> selected;
  for (std::size_t i = 0; i < this->Prescribed.size(); ++i)
  {
    selected.emplace_back(this->Prescribed[i], static_cast<int>(i), 1.0);
  }
  Eigen::SparseMatrix<double> selection(
    laplacian.Rows(), static_cast<Eigen::Index>(this->Prescribed.size()));
  selection.setFromTriplets(selected.begin(), selected.end());
  this->Columns = laplacian.Assemble() * selection;
  Eigen::Index k = 0;
  Eigen::MatrixXd ones = Eigen::MatrixXd::Zero(this->OfIslands.rows(), this->OfIslands.cols());
  for (const BoundaryLoop& loop : topology.loops)
  {
    if (loop.kind == BoundaryKind::Inner)
    {
      for (const int edge : loop.edges)
      {
        ones(topology.BoundaryAt(edge).vertices[0], k) = 1.0;
      }
      ++k;
    }
  }
  if (k > 0)
  {
    this->OfIslands = this->HarmonicSources(ones);
  }
  this->Coupling = this->SumAroundIslands(this->OfIslands);
  if (this->Coupling.size() > 0)
  {
    this->CouplingFactor.compute(this->Coupling);
  }
}

Eigen::MatrixXd DirichletSolver::SumAroundIslands(const Eigen::MatrixXd& sources) const
{
  const MeshTopology& topology = this->Factor.GetOperator().GetTopology();
  Eigen::MatrixXd sums =
    Eigen::MatrixXd::Zero(topology.LoopCount(BoundaryKind::Inner), sources.cols());
  Eigen::Index k = 0;
  for (const BoundaryLoop& loop : topology.loops)
  {
    if (loop.kind == BoundaryKind::Inner)
    {
      for (const int edge : loop.edges)
      {
        sums.row(k) += sources.row(topology.BoundaryAt(edge).vertices[0]);
      }
      ++k;
    }
  }
  return sums;
}

Eigen::MatrixXd DirichletSolver::Harmonic(const Eigen::MatrixXd& x) const
{
  Eigen::MatrixXd prescribed(static_cast<Eigen::Index>(this->Prescribed.size()), x.cols());
  for (Eigen::Index i = 0; i < prescribed.rows(); ++i)
  {
    prescribed.row(i) = x.row(this->Prescribed[i]);
  }
  Eigen::MatrixXd sources(x.rows(), x.cols());
  ForRanges(
    x.cols(),
    [&](int begin, int end)
    {
      for (Eigen::Index column = begin; column < end; ++column)
      {
        sources.col(column) = -this->Columns * prescribed.col(column);
      }
    },
    ColumnsOfPart);
  // No period is unknown, so which of them the problem has makes no difference.
  return x + this->Factor.Solve(sources, PotentialOperator::Periods::IslandsAndHoles);
}

Eigen::MatrixXd DirichletSolver::HarmonicSources(const Eigen::MatrixXd& x) const
{
  // The operator is symmetric.
  const Eigen::MatrixXd harmonic = this->Harmonic(x);
  Eigen::MatrixXd sources = Eigen::MatrixXd::Zero(x.rows(), x.cols());
  ForRanges(
    x.cols(),
    [&](int begin, int end)
    {
      for (Eigen::Index column = begin; column < end; ++column)
      {
        const Eigen::VectorXd values = this->Columns.transpose() * harmonic.col(column);
        for (Eigen::Index i = 0; i < values.size(); ++i)
        {
          sources(this->Prescribed[i], column) = values[i];
        }
      }
    },
    ColumnsOfPart);
  return sources;
}
}
