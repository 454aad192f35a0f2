#include "GramSolve.h"

#include "DenseCholesky.h"
#include "Error.h"

#include <vector>

namespace crossfield
{
namespace
{
class BlockDiagonal
{
public:
  explicit BlockDiagonal(const GramMatrix& matrix)
    : Matrix(matrix)
  {
    for (int block = 0; block < matrix.BlockCount(); ++block)
    {
      this->Factors.emplace_back(matrix.Block(block));
      this->PositiveDefinite &= this->Factors.back().IsPositiveDefinite();
    }
  }

  bool IsPositiveDefinite() const { return this->PositiveDefinite; }

  Eigen::MatrixXd Solve(const Eigen::MatrixXd& columns) const
  {
    Eigen::MatrixXd solution(columns.rows(), columns.cols());
    for (int block = 0; block < this->Matrix.BlockCount(); ++block)
    {
      const Eigen::Index first = this->Matrix.First(block);
      const Eigen::Index size = this->Matrix.Size(block);
      solution.middleRows(first, size) =
        this->Factors[static_cast<std::size_t>(block)].Solve(columns.middleRows(first, size));
    }
    return solution;
  }

private:
  const GramMatrix& Matrix;
  std::vector<DenseCholesky<double>> Factors;
  bool PositiveDefinite = true;
};

/// The products of the columns of one matrix with those of another.
Eigen::RowVectorXd Products(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  return a.cwiseProduct(b).colwise().sum();
}

/// a / b where b is not zero, else zero: a column that is solved stays as it is.
Eigen::RowVectorXd Ratios(const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b)
{
  return (b.array() != 0.0).select(a.array() / b.array(), 0.0);
}
}

// Eigen's own method takes one column at a time; products of all are several times as fast.
Eigen::MatrixXd SolveGram(const GramMatrix& matrix, const Eigen::MatrixXd& rightHandSides)
{
  // In units of the right-hand side; what is left there is below the rounding of the products.
  constexpr double Rounding = 1e-15;
  constexpr int Most = 1000;
  const BlockDiagonal blocks(matrix);
  Eigen::MatrixXd solution = Eigen::MatrixXd::Zero(rightHandSides.rows(), rightHandSides.cols());
  Eigen::MatrixXd missing = rightHandSides;
  const Eigen::RowVectorXd wanted = Rounding * missing.colwise().norm();
  const auto done = [&] { return (missing.colwise().norm().array() <= wanted.array()).all(); };
  Eigen::MatrixXd direction;
  Eigen::RowVectorXd before;
  for (int step = 0; blocks.IsPositiveDefinite() && step < Most; ++step)
  {
    if (done())
    {
      return solution;
    }
    const Eigen::MatrixXd preconditioned = blocks.Solve(missing);
    const Eigen::RowVectorXd now = Products(missing, preconditioned);
    direction = step == 0
      ? preconditioned
      : Eigen::MatrixXd(preconditioned + direction * Ratios(now, before).asDiagonal());
    before = now;
    const Eigen::MatrixXd product = matrix * direction;
    const Eigen::RowVectorXd length = Ratios(now, Products(direction, product));
    solution += direction * length.asDiagonal();
    missing -= product * length.asDiagonal();
  }
  throw Error(
    "The equations on the edges of holes cannot be solved; holes may touch each other or the "
    "mesh may have degenerate triangles, remesh the domain.");
}
}
