#include "ImposedSymmetry.h"

#include "CurveSymmetry.h"
#include "OptimizerReport.h"
#include "OptimizerSymmetry.h"

#include <cmath>
#include <sstream>

namespace crossfield
{
void ImposeSymmetry(const PlanarDomain& domain, const OptimizerOptions& options, double distance,
  const Progress& progress, AutomaticConfiguration& result)
{
  const SymmetryGroup group = FindCurveSymmetries(domain);
  const auto kept = [&](const Configuration& singularities, double reach)
  { return MatchSymmetry(singularities, group, reach).elements; };
  const double exact = SymmetryReach * domain.Diagonal();
  const std::vector<Isometry> before = kept(result.singularities, exact);
  Configuration symmetric = result.singularities;
  if (kept(symmetric, distance).size() <= before.size() ||
    !MakeSymmetric(domain, group, distance, symmetric))
  {
    return;
  }
  OptimizerResult tried = OptimizeSingularities(domain, symmetric, options, progress);
  tried.solves += result.optimum.solves;
  result.optimum.solves = tried.solves;
  result.optimum.aborted = tried.aborted;
  const std::vector<Isometry> after = kept(tried.configuration, exact);
  if (tried.aborted || after.size() <= before.size()) // they may be a saddle
  {
    return;
  }
  // Sizes that differ by so much more are not seen in a mesh.
  constexpr double SameSpread = 0.02;
  const double rise = tried.coreEnergy - result.optimum.coreEnergy;
  const bool isBetter =
    HasConvergedWithoutDefect(tried) >= HasConvergedWithoutDefect(result.optimum) &&
    tried.sizeSpread <= result.optimum.sizeSpread + SameSpread &&
    rise < WorthOfSymmetries(after, group) - WorthOfSymmetries(before, group);
  std::ostringstream text;
  text << "Positions with " << after.size() << " instead of " << before.size()
       << " symmetries of the domain, counting the identity, " << (isBetter ? "are" : "were not")
       << " used: their energy is " << FormatNumber(std::abs(rise), 3)
       << (rise < 0.0 ? " lower" : " higher") << ", their spread of sizes "
       << FormatNumber(tried.sizeSpread, 3) << " instead of "
       << FormatNumber(result.optimum.sizeSpread, 3) << ".";
  result.events.push_back(text.str());
  if (isBetter)
  {
    result.optimum = std::move(tried);
    result.singularities = result.optimum.configuration;
    AddEvents(result);
  }
}
}
