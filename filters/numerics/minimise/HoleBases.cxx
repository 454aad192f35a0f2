#include "HoleBases.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

namespace crossfield
{
namespace
{
/// Number of random columns in excess of the values of a hole, so that their span contains all
/// couplings except in improbable cases. These would only cost additional couplings, not
/// correctness, because the norm of the couplings left out is measured.
constexpr Eigen::Index MoreColumns = 8;

/// Returns reproducible random numbers between −1 and 1.
Eigen::MatrixXd RandomColumns(Eigen::Index rows, Eigen::Index columns)
{
  std::mt19937 generator(1);
  const double scale = 2.0 / static_cast<double>(std::mt19937::max());
  return Eigen::MatrixXd::NullaryExpr(
    rows, columns, [&] { return scale * static_cast<double>(generator()) - 1.0; });
}

/// Returns A_i over the values of its hole, in their order.
Eigen::MatrixXcd HessianOf(DegreeConstraint constraint)
{
  std::iota(constraint.unknowns.begin(), constraint.unknowns.end(), 0);
  return constraint.Hessian(static_cast<Eigen::Index>(constraint.unknowns.size()));
}
}

HoleBases::HoleBases(const ReducedProblem& problem)
  : Problem(problem)
  , MeanDiagonal(problem.matrix.Trace() / static_cast<double>(problem.matrix.Rows()))
{
  const GramMatrix& matrix = problem.matrix;
  const auto holes = static_cast<Eigen::Index>(problem.constraints.size());
  DualProblem& dual = this->Complete;
  dual.targets.resize(holes);
  dual.sizes.resize(holes);
  Eigen::Index largest = 0;
  for (int i = 0; i < matrix.BlockCount(); ++i)
  {
    const DegreeConstraint& constraint = problem.constraints[i];
    dual.targets[i] = constraint.target;
    dual.sizes[i] = static_cast<double>(matrix.Size(i));
    dual.unknowns.push_back(constraint.unknowns);
    largest = std::max(largest, matrix.Size(i));
  }

  // 1. Compute the bases by a QR decomposition with pivoting, whose remainder decreases like the
  // singular values up to a small factor. It is applied not to the couplings of a hole to all
  // others, but to their product with a few random columns.
  const Eigen::MatrixXd random =
    RandomColumns(matrix.Rows(), std::min(matrix.Rows(), largest + MoreColumns));
  const Eigen::MatrixXd product = matrix * random;
  for (int i = 0; i < matrix.BlockCount(); ++i)
  {
    const Eigen::MatrixXd own = matrix.Block(i);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(
      product.middleRows(matrix.First(i), matrix.Size(i)) -
      own * random.middleRows(matrix.First(i), matrix.Size(i)));
    const Eigen::MatrixXd strongestFirst = decomposition.householderQ();
    const Eigen::MatrixXd basis = strongestFirst.rowwise().reverse();
    dual.matrix.blocks.push_back(basis.transpose() * own * basis);
    dual.constraints.push_back(basis.transpose() * HessianOf(problem.constraints[i]) * basis);
    dual.bases.push_back(basis);
  }

  // 2. Transform S to these bases, and measure how strongly each member is coupled to other holes.
  this->InBases = matrix.Congruence(dual.bases);
  this->Couplings = this->InBases.SquaredCouplings().cwiseSqrt();
  dual.load = dual.InBases(problem.load);
}

DualProblem HoleBases::InFewBlocks(Eigen::Index members) const
{
  constexpr Eigen::Index ManyHoles = 300;
  const Eigen::Index holes = std::max<Eigen::Index>(1, this->InBases.BlockCount());
  return this->InBlocks(Strong, std::max(members, members * ManyHoles / holes));
}

HoleBases::LeftOut HoleBases::CountLeftOut(
  int hole, double tolerance, Eigen::Index maximumMembers) const
{
  const Eigen::Index size = this->InBases.Size(hole);
  LeftOut left;
  for (; left.members < size; ++left.members)
  {
    const double more =
      std::hypot(left.norm, this->Couplings[this->InBases.First(hole) + left.members]);
    if (more > tolerance * this->MeanDiagonal && size - left.members <= maximumMembers)
    {
      break;
    }
    left.norm = more;
  }
  return left;
}

Eigen::Index HoleBases::CoupledMembers(double tolerance) const
{
  Eigen::Index count = 0;
  for (int hole = 0; hole < this->InBases.BlockCount(); ++hole)
  {
    count += this->InBases.Size(hole) -
      this->CountLeftOut(hole, tolerance, std::numeric_limits<Eigen::Index>::max()).members;
  }
  return count;
}

DualProblem HoleBases::InBlocks(double tolerance, Eigen::Index maximumMembers) const
{
  DualProblem dual = this->Complete;
  double leftOut = 0.0;
  std::vector<Eigen::MatrixXd> kept; // for every hole, the last columns of the identity
  for (int i = 0; i < this->InBases.BlockCount(); ++i)
  {
    const Eigen::Index size = this->InBases.Size(i);
    const LeftOut left = this->CountLeftOut(i, tolerance, maximumMembers);
    leftOut += 2.0 * left.norm * left.norm;
    dual.matrix.coupled.push_back(size - left.members);
    kept.emplace_back(Eigen::MatrixXd::Identity(size, size).rightCols(size - left.members));
  }
  dual.leftOut = std::sqrt(leftOut);
  dual.matrix.coupling = this->InBases.Congruence(kept).Dense();
  Eigen::Index row = 0;
  for (const Eigen::Index count : dual.matrix.coupled)
  {
    dual.matrix.coupling.block(row, row, count, count).setZero();
    row += count;
  }
  return dual;
}
}
