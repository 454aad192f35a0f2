#include "DirectReduction.h"

#include "SparseCholesky.h"

namespace crossfield
{
DirectReduction::DirectReduction(
  const PlanarTopology& topology, const std::vector<BoundaryLoop>& loops)
  : Aligned(topology)
{
  std::vector<int> freePosition(static_cast<std::size_t>(topology.edges.Count()), -1);
  for (std::size_t i = 0; i < this->Aligned.free.size(); ++i)
  {
    freePosition[this->Aligned.free[i]] = static_cast<int>(i);
  }
  for (const BoundaryLoop& loop : loops)
  {
    this->Reduced.constraints.push_back(
      ConstrainLoop(topology, loop, static_cast<int>(this->Constrained.size())));
    for (const int edge : EdgesOf(loop, topology.edges))
    {
      this->Constrained.push_back(freePosition[edge]);
    }
  }
  this->Factor = std::make_unique<SparseCholesky>(
    this->Aligned.freeStiffness, this->Aligned.EliminationOrder(this->Constrained));
  std::vector<Eigen::Index> sizes;
  for (const BoundaryLoop& loop : loops)
  {
    sizes.push_back(static_cast<Eigen::Index>(loop.edges.size()));
  }
  this->Reduced.matrix =
    GramMatrix(sizes, this->Factor->TrailingFactor(static_cast<int>(this->Constrained.size())));

  const Eigen::MatrixXd harmonic = this->Factor->Solve(this->Aligned.Load());
  this->Harmonic = this->ValuesOf(this->Aligned.Extend(harmonic));
  this->Reduced.load = this->Reduced.matrix * this->Harmonic;
}

DirectReduction::~DirectReduction() = default;

ComplexVector DirectReduction::ValuesOf(const ComplexVector& u) const
{
  ComplexVector values(static_cast<Eigen::Index>(this->Constrained.size()));
  for (std::size_t i = 0; i < this->Constrained.size(); ++i)
  {
    values[static_cast<Eigen::Index>(i)] = u[this->Aligned.free[this->Constrained[i]]];
  }
  return values;
}

RecoveredField DirectReduction::Recover(const ComplexVector& x) const
{
  // S x − b is the gradient that holds the values in place.
  const ComplexVector gradient = this->Reduced.matrix * x - this->Reduced.load;
  Eigen::MatrixXd load = this->Aligned.Load();
  for (std::size_t i = 0; i < this->Constrained.size(); ++i)
  {
    const Complex entry = gradient[static_cast<Eigen::Index>(i)];
    load.row(this->Constrained[i]) += Eigen::RowVector2d(entry.real(), entry.imag());
  }
  RecoveredField field;
  field.u = this->Aligned.Extend(this->Factor->Solve(load));
  field.energy = 0.5 * field.u.dot(ComplexVector(this->Aligned.stiffness * field.u)).real();
  return field;
}
}
