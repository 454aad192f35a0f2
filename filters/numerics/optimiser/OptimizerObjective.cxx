#include "OptimizerObjective.h"

#include "DomainQueries.h"
#include "RenormalizedEnergy.h"
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

Point PlaceOf(const Eigen::VectorXd& place, std::size_t i)
{
  return place.segment<2>(2 * static_cast<Eigen::Index>(i));
}

/// Length of the edge of the boundary that is nearest to a point.
double NearestEdge(const std::vector<BoundaryHalf>& halves, const Point& point)
{
  double nearest = std::numeric_limits<double>::infinity();
  double length = 0.0;
  for (const BoundaryHalf& half : halves)
  {
    const double distance = WayFromSegment(point, half.from, half.to).norm();
    if (distance < nearest)
    {
      nearest = distance;
      length = 2.0 * (half.to - half.from).norm();
    }
  }
  return length;
}
}

OptimizerObjective::OptimizerObjective(std::shared_ptr<const PointPotential> potential,
  const PlanarDomain& domain, const Configuration& configuration, const ObjectiveOptions& options)
  : Points(std::move(potential))
  , Domain(domain)
  , Started(configuration)
  , Length(domain.Diagonal())
  , Barrier(domain, configuration, options.clearance)
  , Sizes(options.goal == OptimizerGoal::UniformSizes
        ? std::make_shared<const SizeUniformity>(*this->Points, options.sizes)
        : nullptr)
  , Symmetry(options.keepSymmetry
        ? FindKeptSymmetry(*this->Points, domain, configuration, this->SymmetryTest())
        : NoSymmetry(*this->Points, configuration))
{
}

IsometryTest OptimizerObjective::SymmetryTest() const
{
  if (!this->Sizes)
  {
    return {};
  }
  return [sizes = this->Sizes, potential = this->Points](const Isometry& map)
  { return sizes->IsKeptBy(*potential, map); };
}

OptimizerObjective OptimizerObjective::WithoutSymmetry() const
{
  OptimizerObjective free = *this;
  free.Symmetry = NoSymmetry(*this->Points, this->Started);
  return free;
}

Configuration OptimizerObjective::At(const Eigen::VectorXd& place) const
{
  Configuration moved = this->Started;
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    moved[i].position = this->Length * PlaceOf(place, i);
  }
  return moved;
}

Eigen::VectorXd OptimizerObjective::PlaceOfAll(const Configuration& configuration) const
{
  Eigen::VectorXd place(2 * static_cast<Eigen::Index>(configuration.size()));
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    place.segment<2>(2 * static_cast<Eigen::Index>(i)) = configuration[i].position / this->Length;
  }
  return place;
}

Eigen::VectorXd OptimizerObjective::Start() const
{
  return this->PlaceOfAll(this->Started);
}

ClearanceBarrier::Value OptimizerObjective::EvaluateBarrier(const Eigen::VectorXd& place) const
{
  ClearanceBarrier::Value value = this->Barrier.Evaluate(this->Length * place);
  value.gradient = this->Length * this->Symmetry.places.ProjectDirections(value.gradient);
  value.hessian *= this->Length * this->Length;
  value.bend *= this->Length * this->Length;
  return value;
}

OptimizerPlace OptimizerObjective::Evaluate(const Eigen::VectorXd& asked) const
{
  Configuration moved = this->At(asked);
  this->Symmetry.places.Project(moved);
  OptimizerPlace result;
  result.place = this->PlaceOfAll(moved);
  const Eigen::VectorXd& place = result.place;
  const PointPotential::Solution solution = this->Points->Solve(moved);
  const RenormalizedEnergyValue value = EvaluateRenormalizedEnergy(*this->Points, solution);
  result.energy = value.singleValuedEnergy;
  result.fullEnergy = value.energy;
  Eigen::VectorXd gradient =
    Eigen::Map<const Eigen::VectorXd>(value.singleValuedGradient.data(), place.size());
  if (this->Sizes)
  {
    const SizeUniformity::Value evenness = this->Sizes->Evaluate(*this->Points, solution);
    result.energy += UniformityWeight * evenness.energy;
    result.sizeSpread = evenness.Spread();
    gradient += UniformityWeight * evenness.gradient;
  }
  // Of the functions of the projected place.
  result.gradient = this->Length * this->Symmetry.places.ProjectDirections(gradient);
  result.barrier = this->EvaluateBarrier(place);
  const auto defects = static_cast<Eigen::Index>(value.holonomyDefect.size());
  result.defects.resize(defects);
  result.defectGradient.resize(defects, place.size());
  for (Eigen::Index k = 0; k < defects; ++k)
  {
    const auto& derivative = value.defectGradient[static_cast<std::size_t>(k)];
    result.defects[k] = value.holonomyDefect[static_cast<std::size_t>(k)];
    result.defectGradient.row(k) = this->Length *
      this->Symmetry.places.ProjectDirections(
        Eigen::Map<const Eigen::VectorXd>(derivative.data(), place.size()));
  }
  result.defects = (this->Symmetry.defects * result.defects).eval();
  result.defectGradient = (this->Symmetry.defects * result.defectGradient).eval();
  return result;
}

double OptimizerObjective::BoundaryDistance(const Eigen::VectorXd& place, std::size_t i) const
{
  return SignedDistance(this->Length * PlaceOf(place, i), this->Domain) / this->Length;
}

double OptimizerObjective::LongestPart(
  const Eigen::VectorXd& place, const Eigen::VectorXd& step) const
{
  constexpr double Least = 1e-9; // of no use
  // In one step along a boundary, as far as the first step goes.
  constexpr double Farthest = 0.05;
  double part = 1.0;
  for (std::size_t i = 0; i < this->Count(); ++i)
  {
    const Point from = PlaceOf(place, i);
    const Point way = PlaceOf(step, i);
    const double room = this->BoundaryDistance(place, i);
    const auto fits = [&]
    {
      // Within half its room it cannot have met anything.
      if (part * way.norm() > 0.5 * room)
      {
        const double clear =
          ClearWay(this->Domain, this->Length * from, way.normalized()) / this->Length;
        const Eigen::VectorXd next = place + part * step;
        if (part * way.norm() > Farthest || clear < part * way.norm() ||
          this->BoundaryDistance(next, i) < 0.5 * room)
        {
          return false;
        }
      }
      for (std::size_t j = 0; j < i; ++j)
      {
        const double apart = (PlaceOf(place, j) - from).norm();
        if (part * std::max(way.norm(), PlaceOf(step, j).norm()) > 0.5 * apart)
        {
          return false;
        }
      }
      return true;
    };
    while (part * way.norm() > Least && !fits())
    {
      part *= 0.5;
    }
  }
  return part;
}

bool OptimizerObjective::OutgrowsMesh(const Eigen::VectorXd& place) const
{
  for (std::size_t i = 0; i < this->Started.size(); ++i)
  {
    const Point here = this->Length * PlaceOf(place, i);
    if (NearestEdge(this->Points->GetHalves(), here) >
      this->Length * this->BoundaryDistance(place, i))
    {
      return true;
    }
  }
  return false;
}
}
