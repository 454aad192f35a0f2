#include "OptimizerObjective.h"

#include "DomainQueries.h"
#include "PositionCurvature.h"
#include "Segment.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
/// μ; see OptimizerGoal.
constexpr double UniformityWeight = 1e4;

Point PositionOf(const Eigen::VectorXd& positions, std::size_t i)
{
  return positions.segment<2>(2 * static_cast<Eigen::Index>(i));
}

std::vector<SegmentSearch::Segment> EdgesOf(const std::vector<BoundaryHalf>& halves)
{
  std::vector<SegmentSearch::Segment> edges;
  for (std::size_t h = 0; h < halves.size(); h += 2)
  {
    edges.push_back({ halves[h].from, halves[h + 1].to });
  }
  return edges;
}
}

OptimizerObjective::OptimizerObjective(std::shared_ptr<const PointPotential> potential,
  const PlanarDomain& domain, const Configuration& configuration, const ObjectiveOptions& options)
  : Points(std::move(potential))
  , Positions(std::make_shared<const PositionEnergy>(Points))
  , Domain(domain)
  , Sides(domain)
  , Edges(EdgesOf(this->Points->GetHalves()))
  , Started(configuration)
  , Length(domain.Diagonal())
  , Solves(options.budget)
  , Barrier(domain, configuration, options.clearance, options.clearanceFactors)
  , Sizes(options.goal == OptimizerGoal::UniformSizes
        ? std::make_shared<const SizeUniformity>(*this->Points, options.sizes)
        : nullptr)
  , Symmetry(options.keepSymmetry
        ? FindKeptSymmetry(*this->Points, domain, configuration, this->SymmetryTest())
        : TrivialSymmetry(*this->Points, configuration))
{
}

IsometryTest OptimizerObjective::SymmetryTest() const
{
  if (!this->Sizes)
  {
    return {};
  }
  return [sizes = this->Sizes, potential = this->Points](const Isometry& map)
  { return sizes->IsInvariantUnder(*potential, map); };
}

OptimizerObjective OptimizerObjective::WithoutSymmetry() const
{
  OptimizerObjective free = *this;
  free.Symmetry = TrivialSymmetry(*this->Points, this->Started);
  return free;
}

std::size_t OptimizerObjective::EvaluationCost() const
{
  return SolvesOfEvaluation(this->Points->GetProblem().Topology().mesh.points.size(), this->Count(),
    static_cast<std::size_t>(this->Positions->PointCount()));
}

std::size_t OptimizerObjective::HessianCost() const
{
  // Two back-substitutions per singularity instead of two per evaluation, measured.
  return this->EvaluationCost() + this->Count() / 2;
}

Configuration OptimizerObjective::At(const Eigen::VectorXd& positions) const
{
  Configuration moved = this->Started;
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    moved[i].position = this->Length * PositionOf(positions, i);
  }
  return moved;
}

Eigen::VectorXd OptimizerObjective::PositionsOf(const Configuration& configuration) const
{
  Eigen::VectorXd positions(2 * static_cast<Eigen::Index>(configuration.size()));
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    positions.segment<2>(2 * static_cast<Eigen::Index>(i)) =
      configuration[i].position / this->Length;
  }
  return positions;
}

Eigen::VectorXd OptimizerObjective::Start() const
{
  return this->PositionsOf(this->Started);
}

ClearanceBarrier::Value OptimizerObjective::EvaluateBarrier(const Eigen::VectorXd& positions) const
{
  ClearanceBarrier::Value value = this->Barrier.Evaluate(this->Length * positions);
  value.gradient = this->Length * this->Symmetry.positions.ProjectDirections(value.gradient);
  value.hessian *= this->Length * this->Length;
  value.negativeHessian *= this->Length * this->Length;
  return value;
}

OptimizerState OptimizerObjective::Evaluate(const Eigen::VectorXd& unprojected) const
{
  Configuration moved = this->At(unprojected);
  this->Symmetry.positions.Project(moved);
  OptimizerState result;
  result.positions = this->PositionsOf(moved);
  const Eigen::VectorXd& positions = result.positions;
  const PositionEnergy::Value evaluated = this->Positions->Evaluate(moved);
  const RenormalizedEnergyValue& value = evaluated.renormalized;
  this->Solves->Spend(this->EvaluationCost());
  result.energy = value.singleValuedEnergy;
  result.fullEnergy = value.energy;
  Eigen::VectorXd gradient =
    Eigen::Map<const Eigen::VectorXd>(value.singleValuedGradient.data(), positions.size());
  if (this->Sizes)
  {
    const SizeUniformity::Value uniformity =
      this->Sizes->Evaluate(*this->Points, evaluated.solution);
    result.energy += UniformityWeight * uniformity.energy;
    result.sizeSpread = uniformity.Spread();
    gradient += UniformityWeight * uniformity.gradient;
  }
  // These are the gradients of the functions of the projected positions.
  result.gradient = this->Length * this->Symmetry.positions.ProjectDirections(gradient);
  result.barrier = this->EvaluateBarrier(positions);
  const auto defects = static_cast<Eigen::Index>(value.holonomyDefect.size());
  result.defects.resize(defects);
  result.defectGradient.resize(defects, positions.size());
  for (Eigen::Index k = 0; k < defects; ++k)
  {
    const auto& derivative = value.defectGradient[k];
    result.defects[k] = value.holonomyDefect[k];
    result.defectGradient.row(k) = this->Length *
      this->Symmetry.positions.ProjectDirections(
        Eigen::Map<const Eigen::VectorXd>(derivative.data(), positions.size()));
  }
  result.defects = (this->Symmetry.defects * result.defects).eval();
  result.defectGradient = (this->Symmetry.defects * result.defectGradient).eval();
  return result;
}

Eigen::MatrixXd OptimizerObjective::Hessian(
  const OptimizerState& current, const Eigen::VectorXd& multipliers) const
{
  const Configuration moved = this->At(current.positions);
  // Dense matrices of all singularities take more time than the back-substitutions where there are
  // hundreds, measured.
  constexpr std::size_t PairsPerSolve = 100;
  this->Solves->Spend(this->HessianCost() + this->Count() * this->Count() / PairsPerSolve);
  const PositionCurvature curvature =
    Differentiate(*this->Positions, moved, this->Symmetry.defects.transpose() * multipliers);
  Eigen::MatrixXd hessian = curvature.hessian;
  if (this->Sizes)
  {
    hessian += UniformityWeight *
      this->Sizes->Differentiate(*this->Points, this->Points->Solve(moved), curvature.regular);
  }
  hessian *= this->Length * this->Length;
  if (this->KeepsSymmetry())
  {
    const Eigen::Index size = hessian.rows();
    Eigen::MatrixXd projection(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
    {
      projection.col(i) = this->ProjectDirections(Eigen::VectorXd::Unit(size, i));
    }
    const double stiffness = hessian.diagonal().lpNorm<Eigen::Infinity>();
    hessian = (projection * hessian * projection).eval();
    hessian += stiffness * (Eigen::MatrixXd::Identity(size, size) - projection);
  }
  return hessian;
}

double OptimizerObjective::BoundaryDistance(const Eigen::VectorXd& positions, std::size_t i) const
{
  return this->Sides.SignedDistance(this->Length * PositionOf(positions, i)) / this->Length;
}

Eigen::VectorXd OptimizerObjective::Clearances(const Eigen::VectorXd& positions) const
{
  Eigen::VectorXd clearances(positions.size());
  for (std::size_t i = 0; i < this->Count(); ++i)
  {
    double clearance = this->BoundaryDistance(positions, i);
    for (std::size_t j = 0; j < this->Count(); ++j)
    {
      const double distance = (PositionOf(positions, j) - PositionOf(positions, i)).norm();
      clearance = i == j ? clearance : std::min(clearance, 0.5 * distance);
    }
    clearances.segment<2>(2 * static_cast<Eigen::Index>(i)).setConstant(clearance);
  }
  return clearances;
}

double OptimizerObjective::LargestFraction(
  const Eigen::VectorXd& positions, const Eigen::VectorXd& step) const
{
  constexpr double MinimumMove = 1e-9; // a smaller step would be of no use
  // Maximum move along the boundary in one step, equal to the length of the first step.
  constexpr double MaximumMove = 0.05;
  double fraction = 1.0;
  for (std::size_t i = 0; i < this->Count(); ++i)
  {
    const Point from = PositionOf(positions, i);
    const Point move = PositionOf(step, i);
    const double distance = this->BoundaryDistance(positions, i);
    const auto isAllowed = [&]
    {
      // No obstacle can be closer than half the distance from the boundary.
      if (fraction * move.norm() > 0.5 * distance)
      {
        const double freeDistance =
          DistanceAlongRay(this->Domain, this->Length * from, move.normalized()) / this->Length;
        const Eigen::VectorXd next = positions + fraction * step;
        if (fraction * move.norm() > MaximumMove || freeDistance < fraction * move.norm() ||
          this->BoundaryDistance(next, i) < 0.5 * distance)
        {
          return false;
        }
      }
      for (std::size_t j = 0; j < i; ++j)
      {
        const double separation = (PositionOf(positions, j) - from).norm();
        if (fraction * std::max(move.norm(), PositionOf(step, j).norm()) > 0.5 * separation)
        {
          return false;
        }
      }
      return true;
    };
    while (fraction * move.norm() > MinimumMove && !isAllowed())
    {
      fraction *= 0.5;
    }
  }
  return fraction;
}

bool OptimizerObjective::NeedsFinerMesh(const Eigen::VectorXd& positions) const
{
  for (std::size_t i = 0; i < this->Started.size(); ++i)
  {
    const SegmentSearch::Segment& edge =
      this->Edges.At(this->Edges.Find(this->Length * PositionOf(positions, i)).segment);
    if ((edge[1] - edge[0]).norm() > this->Length * this->BoundaryDistance(positions, i))
    {
      return true;
    }
  }
  return false;
}
}
