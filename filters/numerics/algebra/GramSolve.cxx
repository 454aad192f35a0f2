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
        this->Factors[block].Solve(columns.middleRows(first, size));
    }
    return solution;
  }

private:
  const GramMatrix& Matrix;
  std::vector<DenseCholesky<double>> Factors;
  bool PositiveDefinite = true;
};

/// Returns the dot products of corresponding columns of two matrices.
Eigen::RowVectorXd Products(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  return a.cwiseProduct(b).colwise().sum();
}

/// Returns a / b, or 0 where b is zero, so that columns that have converged stay unchanged.
Eigen::RowVectorXd Ratios(const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b)
{
  return (b.array() != 0.0).select(a.array() / b.array(), 0.0);
}
}

// Eigen's conjugate gradients solve for one column at a time; products with all columns at once are
// several times as fast.
Eigen::MatrixXd SolveGram(const GramMatrix& matrix, const Eigen::MatrixXd& rightHandSides)
{
  // Relative to the right-hand side; smaller residuals are below the rounding of the products.
  constexpr double Rounding = 1e-15;
  constexpr int MaximumIterations = 1000;
  const BlockDiagonal blocks(matrix);
  Eigen::MatrixXd solution = Eigen::MatrixXd::Zero(rightHandSides.rows(), rightHandSides.cols());
  Eigen::MatrixXd residual = rightHandSides;
  const Eigen::RowVectorXd tolerance = Rounding * residual.colwise().norm();
  const auto done = [&] { return (residual.colwise().norm().array() <= tolerance.array()).all(); };
  Eigen::MatrixXd direction;
  Eigen::RowVectorXd before;
  for (int step = 0; blocks.IsPositiveDefinite() && step < MaximumIterations; ++step)
  {
    if (done())
    {
      return solution;
    }
    const Eigen::MatrixXd preconditioned = blocks.Solve(residual);
    const Eigen::RowVectorXd now = Products(residual, preconditioned);
    direction = step == 0
      ? preconditioned
      : Eigen::MatrixXd(preconditioned + direction * Ratios(now, before).asDiagonal());
    before = now;
    const Eigen::MatrixXd product = matrix * direction;
    const Eigen::RowVectorXd length = Ratios(now, Products(direction, product));
    solution += direction * length.asDiagonal();
    residual -= product * length.asDiagonal();
  }
  throw Error(
    "The equations on the edges of holes cannot be solved; holes may touch each other or the "
    "mesh may have degenerate triangles, remesh the domain.");
}
}
