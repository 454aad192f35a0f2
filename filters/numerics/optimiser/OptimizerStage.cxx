#include "OptimizerStage.h"

#include "BoundarySingularities.h"
#include "DomainQueries.h"
#include "DrillHoles.h"
#include "Error.h"
#include "Parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
std::string TrackedConfiguration::Name(std::size_t row) const
{
  const int origin = this->origins[row];
  return origin == BoundaryOrigin ? "the singularity from the boundary"
    : origin == AddedOrigin       ? "an added singularity"
                                  : "singularity " + std::to_string(origin + 1);
}

void TrackedConfiguration::Erase(std::size_t row)
{
  const auto offset = static_cast<std::ptrdiff_t>(row);
  this->singularities.erase(this->singularities.begin() + offset);
  this->origins.erase(this->origins.begin() + offset);
}

TrackedConfiguration OptimizerStage::At(const Eigen::VectorXd& positions) const
{
  TrackedConfiguration moved = this->tracked;
  const Configuration interior = this->objective->At(positions);
  for (std::size_t i = 0; i < interior.size(); ++i)
  {
    moved.singularities[this->placed.rows[i]].position = interior[i].position;
  }
  return moved;
}

double OptimizerStage::CoreEnergy(const OptimizerState& state) const
{
  const double radius = CoreRadius(this->potential->GetDomain());
  double coefficient = 0.0;
  for (const Singularity& singularity : this->placed.interior)
  {
    coefficient += Pi * singularity.quarterIndex * singularity.quarterIndex;
  }
  for (const LogSource& corner : this->potential->GetBoundaryLogs())
  {
    coefficient += 0.5 * corner.angle * corner.strength * corner.strength;
  }
  return state.fullEnergy - coefficient * std::log(radius) +
    CoreOverlapEnergy(this->objective->At(state.positions), radius);
}

double QuadsOfDefaultMesh(const PlanarDomain& domain)
{
  return domain.Diagonal() / 40.0;
}

double CoreRadius(const PlanarDomain& domain)
{
  return domain.Diagonal() / 400.0;
}

OptimizerStage MakeStage(const PlanarDomain& domain, const TrackedConfiguration& tracked,
  const StageOptions& options, const Progress& progress)
{
  const Configuration& singularities = tracked.singularities;
  const PlanarDomain refined = InsertBoundarySingularities(domain, singularities);
  DrillOptions drill;
  drill.meshSize = options.meshSize;
  const double reach = BoundaryReach * refined.Diagonal();
  for (const Singularity& singularity : singularities)
  {
    const double distance = SignedDistance(singularity.position, refined);
    // Edge lengths grow by a quarter of the distance, to half the distance at the boundary, so that
    // the distance may halve before the domain has to be meshed again.
    if (distance > reach)
    {
      drill.refinements.push_back(
        { singularity.position, 0.25 * std::max(distance, options.objective.clearance) });
    }
  }
  options.objective.budget->Spend(SolvesOfFactorisation);
  const SharedPlanarTopology topology = ShareTopology(DrillHoles(refined, {}, drill, progress));
  OptimizerStage stage;
  stage.tracked = tracked;
  stage.corners = options.corners;
  stage.quadSize = options.quadSize > 0.0 ? options.quadSize : QuadsOfDefaultMesh(domain);
  stage.placed = PlaceConfiguration(*topology, singularities, options.corners);
  Alignment alignment =
    AlignWithBoundary(*topology, stage.placed.corners, TotalQuarters(stage.placed.interior));
  RequireConsistent(alignment.count); // before the mesh is factored
  const auto solver = std::make_shared<const PotentialSolver>(topology);
  // What the objective needs of the mesh, and the logarithms of the boundary.
  ForParts(3,
    [&](std::size_t part)
    {
      if (part == 0)
      {
        stage.potential = std::make_shared<const PointPotential>(solver, std::move(alignment));
      }
      else if (part == 1)
      {
        solver->GetDirichlet();
      }
      else
      {
        solver->GetPeriodResponse();
      }
    });
  stage.potential->RequireSolvable(stage.placed.interior);
  ObjectiveOptions objective = options.objective;
  objective.clearanceFactors = FactorsOfParts(domain, refined, objective.clearanceFactors);
  stage.objective = std::make_shared<const OptimizerObjective>(
    stage.potential, refined, stage.placed.interior, objective);
  return stage;
}
}
