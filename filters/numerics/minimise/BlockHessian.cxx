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

Eigen::MatrixXd ToRealMatrix(const Eigen::MatrixXcd& matrix)
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

BlockHessian::BlockHessian(DualProblem blocks)
  : Blocks(std::move(blocks))
  , Coupling(ToRealMatrix(this->Blocks.matrix.coupling.cast<Complex>()))
{
  for (std::size_t i = 0; i < this->Blocks.unknowns.size(); ++i)
  {
    this->CoupledParts.push_back(2 * this->Blocks.matrix.coupled[i]);
    this->Elastic.push_back(ToRealMatrix(this->Blocks.matrix.blocks[i].cast<Complex>()));
    this->Constraints.push_back(ToRealMatrix(this->Blocks.constraints[i]));
  }
}

BlockCholesky<double> BlockHessian::Factor(
  const ConstrainedFunctional::Additions& additions, double margin) const
{
  const ComplexVector normals = this->NormalsInBases(additions.normals);
  const DualProblem::Margin bound = this->Blocks.MarginOfLeftOut();
  const double scale = (1.0 + additions.shift) * margin;
  std::vector<Eigen::MatrixXd> hessians;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < this->Elastic.size(); ++i)
  {
    const Eigen::Index size = this->Elastic[i].rows() / 2;
    const Eigen::Map<const Eigen::VectorXd> normal(
      reinterpret_cast<const double*>(normals.data() + row), 2 * size);
    hessians.push_back((1.0 + additions.shift) * this->Elastic[i] +
      additions.multipliers[static_cast<Eigen::Index>(i)] * this->Constraints[i]);
    hessians.back() += additions.weight * normal * normal.transpose();
    const Eigen::Index uncoupled = 2 * size - this->CoupledParts[i];
    hessians.back().diagonal().head(uncoupled).array() += scale * bound.uncoupled;
    hessians.back().diagonal().tail(this->CoupledParts[i]).array() += scale * bound.coupled;
    row += size;
  }
  return { hessians, this->CoupledParts, (1.0 + additions.shift) * this->Coupling };
}

ComplexVector BlockHessian::NormalsInBases(const Eigen::SparseMatrix<double>& normals) const
{
  const Eigen::VectorXd sum = normals * Eigen::VectorXd::Ones(normals.cols());
  return this->Blocks.InBases(
    Eigen::Map<const ComplexVector>(reinterpret_cast<const Complex*>(sum.data()), sum.size() / 2));
}

Eigen::MatrixXd BlockHessian::Forms(
  const BlockCholesky<double>& factor, const Eigen::SparseMatrix<double>& normals) const
{
  const ComplexVector inBases = this->NormalsInBases(normals);
  return factor.Forms(Eigen::Map<const Eigen::VectorXd>(
    reinterpret_cast<const double*>(inBases.data()), 2 * inBases.size()));
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
