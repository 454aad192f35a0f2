#include "PenaltySolve.h"

#include "SparseCholesky.h"

#include <memory>
#include <set>

namespace crossfield
{
namespace
{
class PenaltyFunctional : public ConstrainedFunctional
{
public:
  PenaltyFunctional(const GinzburgLandauEnergy& energy,
    const std::vector<QuadraticConstraint>& constraints, const ComplexVector& start)
    : Energy(energy)
    , Field(start)
  {
    std::set<int> constrained;
    for (const QuadraticConstraint& constraint : constraints)
    {
      for (const QuadraticConstraint::Entry& entry : constraint.entries)
      {
        constrained.insert(entry.row);
      }
    }
    this->Constrained.assign(constrained.begin(), constrained.end());
    this->LastFactor = std::make_unique<SparseCholesky>(energy.UnknownOrder(this->Constrained));
    // For u = 0 and shift 1 the Hessian reduces to the stiffness matrix.
    const Eigen::VectorXd diagonal =
      energy.Hessian(ComplexVector::Zero(start.size()), 1.0).diagonal();
    this->MeanDiagonal = diagonal.size() > 0 ? diagonal.mean() : 1.0;
  }

  /// Returns the field on all edges with these values on the free ones.
  ComplexVector OnAllEdges(const ComplexVector& x) const
  {
    ComplexVector u = this->Field;
    const std::vector<int>& free = this->Energy.FreeEdges();
    for (std::size_t i = 0; i < free.size(); ++i)
    {
      u[free[i]] = x[static_cast<Eigen::Index>(i)];
    }
    return u;
  }

  double Value(const ComplexVector& x) const override
  {
    return this->Energy.Value(this->OnAllEdges(x));
  }
  Eigen::VectorXd Gradient(const ComplexVector& x) const override
  {
    return this->Energy.Gradient(this->OnAllEdges(x));
  }
  double GradientScale(const ComplexVector& x) const override
  {
    return this->Energy.ResidualScale(this->OnAllEdges(x));
  }
  double Stiffness() const override { return this->MeanDiagonal; }

  // Without the additional term of M on the constrained edges. That term is much larger, and the
  // direction of minimum curvature would not be that of the saddle.
  Eigen::VectorXd Metric() const override { return this->Energy.Metric(); }

  bool Factor(const ComplexVector& x, const Additions& additions) override
  {
    if (x.size() == 0)
    {
      return true; // the boundary prescribes everything, and CHOLMOD rejects empty matrices
    }
    Eigen::SparseMatrix<double> hessian =
      this->Energy.Hessian(this->OnAllEdges(x), additions.shift);
    if (!this->Constrained.empty())
    {
      hessian += this->OnConstrained(additions);
    }
    try
    {
      this->LastFactor->Refactor(hessian);
      return true;
    }
    catch (const NotPositiveDefinite&)
    {
      return false;
    }
  }
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& rightHandSides) const override
  {
    return this->LastFactor->Solve(rightHandSides);
  }

private:
  /// Returns Σ λ_i A_i + weight × N Nᵀ + shift × the stiffness part of M, which are zero except on
  /// the constrained edges.
  Eigen::SparseMatrix<double> OnConstrained(const Additions& additions) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (const QuadraticConstraint::Entry& entry : additions.constraints)
    {
      entries.emplace_back(2 * entry.row, 2 * entry.column, entry.value.real());
      entries.emplace_back(2 * entry.row, 2 * entry.column + 1, -entry.value.imag());
      entries.emplace_back(2 * entry.row + 1, 2 * entry.column, entry.value.imag());
      entries.emplace_back(2 * entry.row + 1, 2 * entry.column + 1, entry.value.real());
    }
    for (const int edge : this->Constrained)
    {
      for (const int row : { 2 * edge, 2 * edge + 1 })
      {
        entries.emplace_back(row, row, additions.shift * this->MeanDiagonal);
      }
    }
    for (Eigen::Index i = 0; i < additions.normals.cols(); ++i)
    {
      using Entry = Eigen::SparseMatrix<double>::InnerIterator;
      for (Entry left(additions.normals, i); left; ++left)
      {
        for (Entry right(additions.normals, i); right; ++right)
        {
          entries.emplace_back(static_cast<int>(left.row()), static_cast<int>(right.row()),
            additions.weight * left.value() * right.value());
        }
      }
    }
    const auto size = 2 * static_cast<Eigen::Index>(this->Energy.FreeEdges().size());
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  const GinzburgLandauEnergy& Energy;
  ComplexVector Field;          ///< Field with the values on the aligned edges.
  std::vector<int> Constrained; ///< Positions in FreeEdges.
  double MeanDiagonal;          ///< Mean diagonal entry of the stiffness matrix.
  std::unique_ptr<SparseCholesky> LastFactor;
};
}

MinimiserResult SolveWithPenalty(const GinzburgLandauEnergy& energy,
  const std::vector<QuadraticConstraint>& constraints, const ComplexVector& start,
  const MinimiserOptions& options, const Progress& progress)
{
  ComplexVector aligned = start;
  energy.Align(aligned);
  PenaltyFunctional functional(energy, constraints, aligned);
  ComplexVector x(static_cast<Eigen::Index>(energy.FreeEdges().size()));
  for (std::size_t i = 0; i < energy.FreeEdges().size(); ++i)
  {
    x[static_cast<Eigen::Index>(i)] = aligned[energy.FreeEdges()[i]];
  }
  MinimiserResult result = MinimiseConstrained(functional, constraints, x, options, progress);
  result.x = functional.OnAllEdges(result.x);
  return result;
}
}
