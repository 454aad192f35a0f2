#include "LocalSolve.h"

#include "BlockHessian.h"
#include "DenseCholesky.h"
#include "UnitSolve.h"

#include <array>
#include <deque>
#include <utility>

namespace crossfield
{
namespace
{
/// Functional ½ xᴴ S x − Re(bᴴ x) for any storage of S.
class Quadratic : public ConstrainedFunctional
{
public:
  double Value(const ComplexVector& x) const final
  {
    return 0.5 * x.dot(this->Product(x)).real() - this->Load.dot(x).real();
  }
  Eigen::VectorXd Gradient(const ComplexVector& x) const final
  {
    const ComplexVector gradient = this->Product(x) - this->Load;
    return Eigen::Map<const Eigen::VectorXd>(
      reinterpret_cast<const double*>(gradient.data()), 2 * gradient.size());
  }
  double GradientScale(const ComplexVector& x) const final
  {
    return this->Product(x).norm() + this->Load.norm();
  }
  double Stiffness() const final { return this->MeanDiagonal; }

protected:
  Quadratic(const ComplexVector& load, double meanDiagonal)
    : Load(load)
    , MeanDiagonal(meanDiagonal)
  {
  }

  /// Returns S x.
  virtual ComplexVector Times(const ComplexVector& x) const = 0;

private:
  /// Returns S x, cached because value, gradient and scale are evaluated at the same point.
  const ComplexVector& Product(const ComplexVector& x) const
  {
    if (this->LastPoint.size() != x.size() || this->LastPoint != x)
    {
      this->LastPoint = x;
      this->LastProduct = this->Times(x);
    }
    return this->LastProduct;
  }

  const ComplexVector& Load;
  double MeanDiagonal;
  mutable ComplexVector LastPoint;
  mutable ComplexVector LastProduct;
};

/// Functional with a dense S.
class DenseFunctional final : public Quadratic
{
public:
  explicit DenseFunctional(const QuadraticProblem& problem)
    : Quadratic(
        problem.load, problem.matrix.trace().real() / static_cast<double>(problem.matrix.rows()))
    , Problem(problem)
    , RealMatrix(ToRealMatrix(problem.matrix))
  {
  }

  bool Factor(const ComplexVector&, const Additions& additions) override
  {
    Eigen::MatrixXd hessian = (1.0 + additions.shift) * this->RealMatrix;
    for (const QuadraticConstraint::Entry& entry : additions.constraints)
    {
      AddEntry(hessian, entry.row, entry.column, entry.value);
    }
    const Eigen::MatrixXd normals = additions.normals;
    hessian += additions.weight * normals * normals.transpose();
    this->LastFactor = DenseCholesky<double>(std::move(hessian));
    return this->LastFactor.IsPositiveDefinite();
  }
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& rightHandSides) const override
  {
    return this->LastFactor.Solve(rightHandSides);
  }

private:
  ComplexVector Times(const ComplexVector& x) const override { return this->Problem.matrix * x; }

  const QuadraticProblem& Problem;
  Eigen::MatrixXd RealMatrix;
  DenseCholesky<double> LastFactor;
};

/// Functional whose steps use only the strongest couplings between holes. Whether its second
/// derivatives are positive definite is decided with all couplings.
class BlockFunctional final : public Quadratic
{
public:
  explicit BlockFunctional(const HoleBases& bases)
    : Quadratic(bases.GetProblem().load,
        bases.GetProblem().matrix.Trace() / static_cast<double>(bases.GetProblem().matrix.Rows()))
    , Problem(bases.GetProblem())
    , Bases(bases)
  {
  }

  bool Factor(const ComplexVector&, const Additions& additions) override
  {
    const std::size_t levels = additions.certain ? 1 + LeftOut.size() : 1;
    for (std::size_t level = 0; level < levels; ++level)
    {
      if (level == this->Levels.size())
      {
        this->Levels.emplace_back(level == 0 ? this->Bases.InFewBlocks(MembersInSteps)
                                             : this->Bases.InBlocks(LeftOut[level - 1]));
      }
      this->Used = &this->Levels[level];
      // The couplings left out may change every eigenvalue by their bound. Where that decides
      // definiteness, the next level leaves out fewer.
      this->LastFactor = this->Used->Factor(additions, additions.certain ? -1.0 : 0.0);
      if (this->LastFactor.IsPositiveDefinite() ||
        (additions.certain && !this->Used->Factor(additions, 1.0).IsPositiveDefinite()))
      {
        break;
      }
    }
    return this->LastFactor.IsPositiveDefinite();
  }
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& rightHandSides) const override
  {
    return this->Used->Solve(this->LastFactor, rightHandSides);
  }
  /// Rotates the values of each hole by a phase, which changes no degree (docs/method.md §3.5).
  ComplexVector Relax(const ComplexVector& x) const override
  {
    return RelaxPhases(this->Problem, x);
  }
  Eigen::MatrixXd Forms(const Eigen::SparseMatrix<double>& normals) const override
  {
    return this->Used->Forms(this->LastFactor, normals);
  }

private:
  /// Members of every hole used in steps when there are many holes: those that turn once and twice
  /// around it.
  static constexpr Eigen::Index MembersInSteps = 4;
  /// Tolerances of the levels after the first, relative to the mean diagonal of S; the last is at
  /// rounding.
  static constexpr std::array<double, 4> LeftOut = { 1e-5, 1e-7, 1e-10, 1e-13 };

  ComplexVector Times(const ComplexVector& x) const override { return this->Problem.matrix * x; }

  const ReducedProblem& Problem;
  const HoleBases& Bases;
  std::deque<BlockHessian> Levels; ///< Each level is built on first use.
  const BlockHessian* Used = nullptr;
  BlockCholesky<double> LastFactor;
};
}

MinimiserResult SolveQuadratic(const QuadraticProblem& problem, const ComplexVector& start,
  const MinimiserOptions& options, const Progress& progress)
{
  DenseFunctional functional(problem);
  return MinimiseConstrained(functional, problem.constraints, start, options, progress);
}

MinimiserResult SolveReducedFrom(const HoleBases& bases, const ComplexVector& start,
  const MinimiserOptions& options, const Progress& progress)
{
  std::vector<QuadraticConstraint> constraints;
  for (const DegreeConstraint& constraint : bases.GetProblem().constraints)
  {
    constraints.push_back(SumOfDegrees({ constraint }));
  }
  BlockFunctional functional(bases);
  return MinimiseConstrained(functional, constraints, start, options, progress);
}
}
