#include "EdgeReduction.h"

#include "SparseCholesky.h"

#include <utility>

namespace crossfield
{
namespace
{
Point Midpoint(const TriangleMesh& mesh, const EdgeNumbering& edges, int edge)
{
  const auto& [from, to] = edges.vertices[static_cast<std::size_t>(edge)];
  return 0.5 *
    (mesh.points[static_cast<std::size_t>(from)] + mesh.points[static_cast<std::size_t>(to)]);
}
}

EdgeReduction::EdgeReduction(
  const TriangleMesh& mesh, const EdgeNumbering& edges, const std::vector<BoundaryLoop>& loops)
  : Aligned(mesh, edges)
{
  std::vector<int> freePosition(static_cast<std::size_t>(edges.Count()), -1);
  for (std::size_t i = 0; i < this->Aligned.free.size(); ++i)
  {
    freePosition[static_cast<std::size_t>(this->Aligned.free[i])] = static_cast<int>(i);
  }
  for (const BoundaryLoop& loop : loops)
  {
    std::vector<int> unknowns;
    std::vector<Point> midpoints;
    for (const int edge : EdgesOf(loop, edges))
    {
      unknowns.push_back(static_cast<int>(this->Constrained.size()));
      this->Constrained.push_back(freePosition[static_cast<std::size_t>(edge)]);
      midpoints.push_back(Midpoint(mesh, edges, edge));
    }
    this->Reduced.constraints.push_back(MakeDegreeConstraint(
      std::move(unknowns), midpoints, CentreOf(loop, mesh), loop.quarterIndex));
  }
  this->Factor = std::make_unique<SparseCholesky>(
    this->Aligned.freeStiffness, this->Aligned.EliminationOrder(this->Constrained));
  const Eigen::MatrixXd root =
    this->Factor->TrailingFactor(static_cast<int>(this->Constrained.size()));
  const auto lower = root.triangularView<Eigen::Lower>();
  this->Reduced.matrix = lower * Eigen::MatrixXd(root.transpose());

  const Eigen::MatrixXd harmonic = this->Factor->Solve(this->Aligned.Load());
  this->Harmonic = this->ValuesOf(this->Aligned.Extend(harmonic));
  this->Reduced.load = this->Reduced.matrix * this->Harmonic;
}

EdgeReduction::~EdgeReduction() = default;

ComplexVector EdgeReduction::ValuesOf(const ComplexVector& u) const
{
  ComplexVector values(static_cast<Eigen::Index>(this->Constrained.size()));
  for (std::size_t i = 0; i < this->Constrained.size(); ++i)
  {
    values[static_cast<Eigen::Index>(i)] =
      u[this->Aligned.free[static_cast<std::size_t>(this->Constrained[i])]];
  }
  return values;
}

ComplexVector EdgeReduction::Recover(const ComplexVector& x) const
{
  // S x − b are the forces that hold the values.
  const ComplexVector forces = this->Reduced.matrix * x - this->Reduced.load;
  Eigen::MatrixXd load = this->Aligned.Load();
  for (std::size_t i = 0; i < this->Constrained.size(); ++i)
  {
    const Complex force = forces[static_cast<Eigen::Index>(i)];
    load.row(this->Constrained[i]) += Eigen::RowVector2d(force.real(), force.imag());
  }
  return this->Aligned.Extend(this->Factor->Solve(load));
}
}
