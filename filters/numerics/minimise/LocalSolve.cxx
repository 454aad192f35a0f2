#include "LocalSolve.h"

#include "DenseCholesky.h"

#include <utility>

namespace crossfield
{
namespace
{
/// Adds a complex entry to the real matrix that acts on the parts.
void AddEntry(Eigen::MatrixXd& real, Eigen::Index row, Eigen::Index column, const Complex& value)
{
  real(2 * row, 2 * column) += value.real();
  real(2 * row, 2 * column + 1) -= value.imag();
  real(2 * row + 1, 2 * column) += value.imag();
  real(2 * row + 1, 2 * column + 1) += value.real();
}

/// ½ xᴴ S x − Re(bᴴ x).
class QuadraticFunctional : public ConstrainedFunctional
{
public:
  explicit QuadraticFunctional(const QuadraticProblem& problem)
    : Problem(problem)
    , RealMatrix(Eigen::MatrixXd::Zero(2 * problem.matrix.rows(), 2 * problem.matrix.rows()))
  {
    for (Eigen::Index column = 0; column < problem.matrix.cols(); ++column)
    {
      for (Eigen::Index row = 0; row < problem.matrix.rows(); ++row)
      {
        AddEntry(this->RealMatrix, row, column, problem.matrix(row, column));
      }
    }
  }

  double Value(const ComplexVector& x) const override
  {
    return 0.5 * x.dot(this->Product(x)).real() - this->Problem.load.dot(x).real();
  }
  Eigen::VectorXd Gradient(const ComplexVector& x) const override
  {
    const ComplexVector gradient = this->Product(x) - this->Problem.load;
    return Eigen::Map<const Eigen::VectorXd>(
      reinterpret_cast<const double*>(gradient.data()), 2 * gradient.size());
  }
  double GradientScale(const ComplexVector& x) const override
  {
    return this->Product(x).norm() + this->Problem.load.norm();
  }
  double Stiffness() const override
  {
    return this->Problem.matrix.trace().real() / static_cast<double>(this->Problem.matrix.rows());
  }
  bool Factor(const ComplexVector&, const Additions& additions) override
  {
    Eigen::MatrixXd hessian = (1.0 + additions.shift) * this->RealMatrix;
    for (const QuadraticConstraint::Entry& entry : additions.constraints)
    {
      AddEntry(hessian, entry.row, entry.column, entry.value);
    }
    hessian += additions.weight * additions.normals * additions.normals.transpose();
    this->LastFactor = DenseCholesky<double>(std::move(hessian));
    return this->LastFactor.IsPositiveDefinite();
  }
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& rightHandSides) const override
  {
    return this->LastFactor.Solve(rightHandSides);
  }

private:
  ComplexVector Product(const ComplexVector& x) const { return this->Problem.matrix * x; }

  const QuadraticProblem& Problem;
  Eigen::MatrixXd RealMatrix;
  DenseCholesky<double> LastFactor;
};
}

MinimiserResult SolveQuadratic(const QuadraticProblem& problem, const ComplexVector& start,
  const MinimiserOptions& options, const Progress& progress)
{
  QuadraticFunctional functional(problem);
  return MinimiseConstrained(functional, problem.constraints, start, options, progress);
}

MinimiserResult SolveReducedFrom(const ReducedProblem& problem, const ComplexVector& start,
  const MinimiserOptions& options, const Progress& progress)
{
  QuadraticProblem quadratic{ problem.matrix.cast<Complex>(), problem.load, {} };
  for (const DegreeConstraint& constraint : problem.constraints)
  {
    quadratic.constraints.push_back(SumOfDegrees({ constraint }));
  }
  return SolveQuadratic(quadratic, start, options, progress);
}
}
