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
namespace
{
/// Coefficients are sums of π k², 2π k² and 16 e(α, k). The former are exact, and differ by π at least.
/// Angles come from coordinates, which may have gone through single precision: by as much as that may
/// change them, equal corners at other places have other coefficients, which must not decide.
constexpr double CoefficientRounding = 1e-5;

/// In the order of E_ρ for small ρ: by W where the coefficients of the logarithm are equal.
void SortByEnergy(std::vector<ConfigurationEnergy>& energies)
{
  const auto coefficient = [](const ConfigurationEnergy& energy)
  { return energy.renormalized.logarithmCoefficient; };
  std::stable_sort(energies.begin(), energies.end(),
    [&](const auto& a, const auto& b)
    {
      return std::make_tuple(!a.consistent, coefficient(a)) <
        std::make_tuple(!b.consistent, coefficient(b));
    });
  // Runs of equal ones: "nearer than" by itself is no order.
  for (auto first = energies.begin(); first != energies.end() && first->consistent;)
  {
    auto last = first + 1;
    while (last != energies.end() && last->consistent &&
      coefficient(*last) - coefficient(*(last - 1)) <= CoefficientRounding * coefficient(*last))
    {
      ++last;
    }
    std::stable_sort(first, last,
      [](const auto& a, const auto& b) { return a.renormalized.energy < b.renormalized.energy; });
    first = last;
  }
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
  SortByEnergy(energies);
  return energies;
}
}
