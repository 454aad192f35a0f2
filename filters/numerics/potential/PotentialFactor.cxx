#include "PotentialFactor.h"

#include "Error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace crossfield
{
namespace
{
DissectedCholesky FactorOperator(
  const PotentialOperator& laplacian, PotentialFactor::Boundary boundary, const Progress& progress)
{
  const MeshTopology& topology = laplacian.GetTopology();
  const TriangleMesh& mesh = topology.mesh;
  std::vector<int> leftOut = {
    topology.loops.empty() ? 0 : mesh.boundary[topology.loops.front().edges.front()].vertices[0]
  };
  if (boundary == PotentialFactor::Boundary::Dirichlet)
  {
    leftOut.clear();
    for (const BoundaryEdge& edge : mesh.boundary)
    {
      if (edge.IsAligned())
      {
        leftOut.push_back(edge.vertices[0]);
      }
    }
  }
  std::vector<int> trailing;
  std::vector<int>& periodRows =
    boundary == PotentialFactor::Boundary::Natural ? trailing : leftOut;
  for (Eigen::Index k = 0; k < laplacian.PeriodCount(); ++k)
  {
    periodRows.push_back(static_cast<int>(laplacian.PeriodRow(k)));
  }

  // Periods have no position; they are trailing or left out, so it is not used.
  std::vector<SpacePoint> places(static_cast<std::size_t>(laplacian.Rows()), SpacePoint::Zero());
  for (int vertex = 0; vertex < topology.VertexCount(); ++vertex)
  {
    places[vertex] = topology.PositionOf(vertex);
  }
  const Eigen::SparseMatrix<double> matrix = laplacian.Assemble();
  progress.Report(0.1);
  return { matrix, places, trailing, leftOut, progress.Part(0.1, 1.0) };
}
}

PotentialFactor::PotentialFactor(
  const PotentialOperator& laplacian, Boundary boundary, const Progress& progress)
  : Operator(laplacian)
  , OnLoops(boundary)
  , Factor(FactorOperator(laplacian, boundary, progress))
{
}

PotentialFactor::Eliminated PotentialFactor::Eliminate(
  const Eigen::MatrixXd& sources, Periods periods) const
{
  // Only with a natural boundary must the sources add up to zero.
  const auto atVertices = sources.topRows(this->Operator.VertexCount());
  for (Eigen::Index column = 0; this->OnLoops == Boundary::Natural && column < sources.cols();
       ++column)
  {
    const double sum = atVertices.col(column).sum();
    // The rounding error of a sum of n terms is at most n ε times the sum of their magnitudes.
    // Sources are differences of angles, with errors of ε even where they are zero.
    const double rounding = static_cast<double>(this->Operator.VertexCount()) *
      std::numeric_limits<double>::epsilon() * std::max(1.0, atVertices.col(column).lpNorm<1>());
    if (!(std::abs(sum) <= rounding))
    {
      throw Error("The sources of the potential add up to " + std::to_string(sum) +
        " instead of zero, so it has no solution; the quarter indices violate Poincaré-Hopf.");
    }
  }
  Eliminated eliminated = this->Factor.Eliminate(sources);
  this->LeaveOutPeriods(eliminated, periods);
  return eliminated;
}

void PotentialFactor::LeaveOutPeriods(Eliminated& eliminated, Periods periods) const
{
  eliminated.border
    .bottomRows(this->Factor.GetTrailingFactor().rows() - this->UnknownPeriodCount(periods))
    .setZero();
}

Eigen::MatrixXd PotentialFactor::PeriodValues(const Eliminated& eliminated, Periods periods) const
{
  const Eigen::Index all = this->Factor.GetTrailingFactor().rows();
  return this->PeriodFactor(periods).transpose().triangularView<Eigen::Upper>().solve(
    eliminated.border.middleRows(
      eliminated.border.rows() - all, this->UnknownPeriodCount(periods)));
}

void PotentialFactor::AddPeriodSources(
  Eliminated& eliminated, const Eigen::MatrixXd& sources, Periods periods) const
{
  const Eigen::Index all = this->Factor.GetTrailingFactor().rows();
  eliminated.border.middleRows(eliminated.border.rows() - all, this->UnknownPeriodCount(periods)) +=
    this->PeriodFactor(periods).triangularView<Eigen::Lower>().solve(sources);
}
}
