#include "AlignedProblem.h"

#include "NestedDissection.h"
#include "SparseCholesky.h"

namespace crossfield
{
namespace
{
/// Returns the rows and columns of the free edges of a matrix over all edges.
SparseMatrix Restrict(const SparseMatrix& matrix, const std::vector<int>& free)
{
  std::vector<int> unknown(static_cast<std::size_t>(matrix.rows()), -1);
  for (std::size_t i = 0; i < free.size(); ++i)
  {
    unknown[free[i]] = static_cast<int>(i);
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(matrix.nonZeros()));
  for (std::size_t i = 0; i < free.size(); ++i)
  {
    for (SparseMatrix::InnerIterator entry(matrix, free[i]); entry; ++entry)
    {
      const int row = unknown[entry.row()];
      if (row >= 0)
      {
        entries.emplace_back(row, static_cast<int>(i), entry.value());
      }
    }
  }
  const auto size = static_cast<Eigen::Index>(free.size());
  SparseMatrix restricted(size, size);
  restricted.setFromTriplets(entries.begin(), entries.end());
  return restricted;
}
}

AlignedProblem::AlignedProblem(const PlanarTopology& topology, const Eigen::VectorXd& weights)
  : stiffness(CrouzeixRaviartStiffness(topology.mesh, topology.edges, weights))
{
  const EdgeNumbering& edges = topology.edges;
  std::vector<bool> aligned(static_cast<std::size_t>(edges.Count()), false);
  std::vector<Complex> values;
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    const BoundaryEdge& edge = topology.mesh.boundary[i];
    if (edge.IsAligned())
    {
      aligned[edges.ofBoundary[i]] = true;
      this->fixed.push_back(edges.ofBoundary[i]);
      values.push_back(AlignedRepresentation(
        topology.PointAt(edge.vertices[1]) - topology.PointAt(edge.vertices[0])));
    }
  }
  this->prescribed =
    Eigen::Map<const ComplexVector>(values.data(), static_cast<Eigen::Index>(values.size()));
  for (int edge = 0; edge < edges.Count(); ++edge)
  {
    if (!aligned[edge])
    {
      this->free.push_back(edge);
      this->places.push_back(InSpace(topology.Midpoint(edge)));
    }
  }
  this->freeStiffness = Restrict(this->stiffness, this->free);
}

void AlignedProblem::Align(ComplexVector& u) const
{
  for (std::size_t i = 0; i < this->fixed.size(); ++i)
  {
    u[this->fixed[i]] = this->prescribed[static_cast<Eigen::Index>(i)];
  }
}

std::vector<int> AlignedProblem::EliminationOrder(const std::vector<int>& trailing) const
{
  return NestedDissection(this->freeStiffness, this->places, trailing);
}

Eigen::MatrixXd AlignedProblem::Load() const
{
  ComplexVector u = ComplexVector::Zero(this->stiffness.rows());
  this->Align(u);
  const ComplexVector product = this->stiffness * u;
  Eigen::MatrixXd load(static_cast<Eigen::Index>(this->free.size()), 2);
  for (std::size_t i = 0; i < this->free.size(); ++i)
  {
    load.row(static_cast<Eigen::Index>(i)) << -product[this->free[i]].real(),
      -product[this->free[i]].imag();
  }
  return load;
}

ComplexVector AlignedProblem::Extend(const Eigen::MatrixXd& values) const
{
  ComplexVector u(this->stiffness.rows());
  this->Align(u);
  for (std::size_t i = 0; i < this->free.size(); ++i)
  {
    const auto row = static_cast<Eigen::Index>(i);
    u[this->free[i]] = Complex(values(row, 0), values(row, 1));
  }
  return u;
}

ComplexVector AlignedProblem::HarmonicField() const
{
  if (this->free.empty())
  {
    return this->Extend(Eigen::MatrixXd(0, 2));
  }
  return this->Extend(
    SparseCholesky(this->freeStiffness, this->EliminationOrder()).Solve(this->Load()));
}
}
