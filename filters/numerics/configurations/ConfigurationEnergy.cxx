#include "ConfigurationEnergy.h"

#include "BoundarySingularities.h"
#include "ConfigurationPlacement.h"
#include "DomainQueries.h"
#include "EnergyMesh.h"
#include "Error.h"
#include "MeshForPoints.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

namespace crossfield
{
double ResolveCoreRadius(double coreRadius, const PlanarDomain& domain)
{
  return coreRadius > 0.0 ? coreRadius : domain.Diagonal() / 100.0;
}

namespace
{
/// Computes E_ρ of a placed configuration.
using Perforate = std::function<PerforatedEnergy(const PlacedConfiguration&, const Progress&)>;

std::vector<ConfigurationEnergy> Compare(const std::shared_ptr<const PotentialSolver>& potential,
  double coreRadius, const std::vector<Configuration>& configurations,
  const std::vector<CornerChoice>& corners, const Perforate& perforate, const Progress& progress)
{
  const PlanarTopology& topology = potential->GetTopology();
  const double count = static_cast<double>(configurations.size());
  std::vector<ConfigurationEnergy> energies;
  for (std::size_t i = 0; i < configurations.size(); ++i)
  {
    const auto index = static_cast<double>(i);
    ConfigurationEnergy energy;
    energy.configuration = static_cast<int>(i);
    try
    {
      const PlacedConfiguration placed = PlaceConfiguration(topology, configurations[i], corners);
      energy.interior = placed.interior;
      const PointPotential points(
        potential, AlignWithBoundary(topology, placed.corners, TotalQuarters(placed.interior)));
      energy.renormalized = EvaluateRenormalizedEnergy(points, points.Solve(placed.interior));
      energy.coreRadius = coreRadius;
      energy.atCoreRadius = energy.renormalized.energy -
        energy.renormalized.logarithmCoefficient * std::log(coreRadius) +
        CoreOverlapEnergy(energy.interior, coreRadius);
      if (perforate)
      {
        energy.perforated =
          perforate(placed, progress.Part((index + 0.1) / count, (index + 0.5) / count));
      }
      energy.consistent = true;
      energy.reason =
        ConsistencyReason(points.GetProblem().alignment.count, energy.renormalized.holonomyDefect);
    }
    catch (const Error& error)
    {
      if (error.GetKind() != Error::Kind::Inconsistent)
      {
        throw;
      }
      energy.reason = error.what();
    }
    energies.push_back(std::move(energy));
    progress.Report((index + 1.0) / count);
  }
  std::stable_sort(energies.begin(), energies.end(),
    [](const auto& a, const auto& b)
    {
      return std::make_tuple(!a.consistent, a.atCoreRadius) <
        std::make_tuple(!b.consistent, b.atCoreRadius);
    });
  return energies;
}
}

std::vector<ConfigurationEnergy> CompareConfigurations(const PlanarDomain& domain,
  const std::vector<Configuration>& configurations, const ConfigurationEnergyOptions& options,
  const Progress& progress)
{
  Configuration all;
  for (const Configuration& configuration : configurations)
  {
    all.insert(all.end(), configuration.begin(), configuration.end());
  }
  const PlanarDomain refined = InsertBoundarySingularities(domain, all);
  const auto perforate = [&](const PlacedConfiguration& placed, const Progress& drilling)
  {
    TriangleMesh drilled = DrillHoles(refined, placed.interior,
      DrillForEnergies(domain, placed.interior, options.meshSize), drilling);
    return ComputePerforatedEnergy(ShareTopology(std::move(drilled)), placed.corners);
  };
  return Compare(std::make_shared<const PotentialSolver>(ShareTopology(MeshForConfigurations(
                   domain, configurations, options.meshSize, progress.Part(0.0, 0.05)))),
    ResolveCoreRadius(options.coreRadius, domain), configurations, options.corners, perforate,
    progress.Part(0.1, 1.0));
}

std::vector<ConfigurationEnergy> CompareRenormalizedEnergies(const FactoredDomain& domain,
  const std::vector<Configuration>& configurations, const ConfigurationEnergyOptions& options,
  const Progress& progress)
{
  for (const Configuration& configuration : configurations)
  {
    RequireInside(domain.GetDomain(), configuration);
  }
  return Compare(domain.GetPotential(), ResolveCoreRadius(options.coreRadius, domain.GetDomain()),
    configurations, options.corners, nullptr, progress);
}
}
