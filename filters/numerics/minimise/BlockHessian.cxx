#include "BlockHessian.h"

namespace crossfield
{
void AddEntry(Eigen::MatrixXd& real, Eigen::Index row, Eigen::Index column, const Complex& value)
{
  real(2 * row, 2 * column) += value.real();
  real(2 * row, 2 * column + 1) -= value.imag();
  real(2 * row + 1, 2 * column) += value.imag();
  real(2 * row + 1, 2 * column + 1) += value.real();
}

Eigen::MatrixXd OnParts(const Eigen::MatrixXcd& matrix)
{
  Eigen::MatrixXd real = Eigen::MatrixXd::Zero(2 * matrix.rows(), 2 * matrix.cols());
  for (Eigen::Index column = 0; column < matrix.cols(); ++column)
  {
    for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    {
      AddEntry(real, row, column, matrix(row, column));
    }
  }
  return real;
}

BlockHessian::BlockHessian(const ReducedProblem& problem, double leftOut)
  : Blocks(InBlocks(problem, leftOut))
  , Coupling(OnParts(this->Blocks.matrix.coupling.cast<Complex>()))
  , Place(static_cast<std::size_t>(problem.matrix.rows()))
{
  for (const Eigen::Index coupled : this->Blocks.matrix.coupled)
  {
    this->CoupledParts.push_back(2 * coupled);
  }
  for (std::size_t i = 0; i < this->Blocks.unknowns.size(); ++i)
  {
    int position = 0;
    for (const int unknown : this->Blocks.unknowns[i])
    {
      this->Place[static_cast<std::size_t>(unknown)] = { i, position++ };
    }
  }
}

BlockCholesky<double> BlockHessian::Factor(
  const ConstrainedFunctional::Additions& additions, double margin) const
{
  std::vector<Eigen::MatrixXcd> added;
  for (const Eigen::MatrixXd& block : this->Blocks.matrix.blocks)
  {
    added.emplace_back(Eigen::MatrixXcd::Zero(block.rows(), block.cols()));
  }
  for (const QuadraticConstraint::Entry& entry : additions.constraints)
  {
    const auto& [hole, row] = this->Place[static_cast<std::size_t>(entry.row)];
    added[hole](row, this->Place[static_cast<std::size_t>(entry.column)].second) += entry.value;
  }
  std::vector<Eigen::MatrixXd> hessians;
  for (std::size_t i = 0; i < added.size(); ++i)
  {
    const Eigen::MatrixXd& basis = this->Blocks.bases[i];
    const Eigen::Index size = basis.rows();
    hessians.push_back(OnParts((1.0 + additions.shift) * this->Blocks.matrix.blocks[i] +
      basis.transpose() * added[i] * basis));
    ComplexVector normal(size); // of the hole's constraint, zero elsewhere
    for (Eigen::Index j = 0; j < size; ++j)
    {
      const Eigen::Index row = 2 * this->Blocks.unknowns[i][static_cast<std::size_t>(j)];
      const auto column = static_cast<Eigen::Index>(i);
      normal[j] = { additions.normals(row, column), additions.normals(row + 1, column) };
    }
    const ComplexVector turned = basis.transpose() * normal;
    const Eigen::Map<const Eigen::VectorXd> parts(
      reinterpret_cast<const double*>(turned.data()), 2 * size);
    hessians.back() += additions.weight * parts * parts.transpose();
    hessians.back().diagonal().array() += margin;
  }
  return { hessians, this->CoupledParts, (1.0 + additions.shift) * this->Coupling };
}

Eigen::MatrixXd BlockHessian::Solve(
  const BlockCholesky<double>& factor, const Eigen::MatrixXd& rightHandSides) const
{
  const auto complexOf = [](const Eigen::MatrixXd& columns, Eigen::Index column)
  {
    return Eigen::Map<const ComplexVector>(
      reinterpret_cast<const Complex*>(columns.col(column).data()), columns.rows() / 2);
  };
  Eigen::MatrixXd turned(rightHandSides.rows(), rightHandSides.cols());
  const auto set = [&turned](Eigen::Index column, const ComplexVector& values)
  {
    turned.col(column) = Eigen::Map<const Eigen::VectorXd>(
      reinterpret_cast<const double*>(values.data()), 2 * values.size());
  };
  for (Eigen::Index column = 0; column < turned.cols(); ++column)
  {
    set(column, this->Blocks.InBases(complexOf(rightHandSides, column)));
  }
  const Eigen::MatrixXd solution = factor.Solve(turned);
  for (Eigen::Index column = 0; column < turned.cols(); ++column)
  {
    set(column, this->Blocks.InValues(complexOf(solution, column)));
  }
  return turned;
}
}
