#include "ConfigurationEnergy.h"

#include "BoundarySingularities.h"
#include "ConfigurationPlacement.h"
#include "DrillHoles.h"
#include "Error.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>
#include <utility>

namespace crossfield
{
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
  DrillOptions drill;
  drill.meshSize = options.meshSize;
  const auto potential = std::make_shared<const PotentialSolver>(
    ShareTopology(DrillHoles(refined, {}, drill, progress.Part(0.0, 0.1))));
  const MeshTopology& topology = potential->GetTopology();
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
      TriangleMesh drilled =
        DrillHoles(refined, placed.interior, drill, progress.Part(step(0.1), step(0.5)));
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
  // Equal but for rounding must not be decided by it.
  const auto rank = [](const ConfigurationEnergy& energy)
  {
    const double coefficient = 1e-9 * std::round(1e9 * energy.renormalized.logarithmCoefficient);
    return std::make_tuple(!energy.consistent, coefficient, energy.renormalized.energy);
  };
  std::stable_sort(energies.begin(), energies.end(),
    [&rank](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return energies;
}
}
