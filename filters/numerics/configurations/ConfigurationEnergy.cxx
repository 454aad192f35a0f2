#include "ConfigurationEnergy.h"

#include "BoundarySingularities.h"
#include "ConfigurationPlacement.h"
#include "EnergyMesh.h"
#include "Error.h"
#include "MeshForPoints.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace crossfield
{
double ResolveCoreRadius(double coreRadius, const PlanarDomain& domain)
{
  return coreRadius > 0.0 ? coreRadius : 0.01 * domain.Diagonal();
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
  const auto potential = std::make_shared<const PotentialSolver>(
    ShareTopology(MeshForAll(domain, configurations, options.meshSize, progress.Part(0.0, 0.05))));
  const MeshTopology& topology = potential->GetTopology();
  const double coreRadius = ResolveCoreRadius(options.coreRadius, domain);
  std::vector<ConfigurationEnergy> energies;
  for (std::size_t i = 0; i < configurations.size(); ++i)
  {
    const auto step = [&](double part)
    {
      return 0.1 +
        0.9 * (static_cast<double>(i) + part) / static_cast<double>(configurations.size());
    };
    ConfigurationEnergy energy;
    energy.configuration = static_cast<int>(i);
    try
    {
      const PlacedConfiguration placed =
        PlaceConfiguration(topology, configurations[i], options.corners);
      energy.interior = placed.interior;
      const PointPotential points(
        potential, AlignWithBoundary(topology, placed.corners, TotalQuarters(placed.interior)));
      energy.renormalized = EvaluateRenormalizedEnergy(points, points.Solve(placed.interior));
      energy.coreRadius = coreRadius;
      energy.atCoreRadius = energy.renormalized.AtCoreRadius(coreRadius);
      TriangleMesh drilled = DrillHoles(refined, placed.interior,
        DrillForEnergies(domain, placed.interior, options.meshSize),
        progress.Part(step(0.1), step(0.5)));
      energy.perforated =
        ComputePerforatedEnergy(ShareTopology(std::move(drilled)), placed.corners);
      energy.consistent = true;
      energy.reason =
        Verdict(points.GetProblem().alignment.count, energy.renormalized.holonomyDefect);
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
    progress.Report(step(1.0));
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
