#include "RequestedSingularities.h"

#include "LayerSteps.h"
#include "MeshGrade.h"
#include "OptimizerReport.h"
#include "PoincareHopf.h"
#include "QuadClearance.h"
#include "SizedChoice.h"

#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns the options of the choice for the quads of a request.
AutomaticOptions OptionsFor(const PlanarDomain& domain, const ResolvedRequest& request)
{
  AutomaticOptions options;
  options.proposal.corners = CompleteCorners(domain, request);
  if (request.capCorners)
  {
    CapCorners(domain, options);
  }
  options.optimizer.meshSize = request.meshSize;
  options.optimizer.clearance = request.clearance;
  // A singularity that moved into a layered side would change what rows do there.
  options.optimizer.keepAll |= !request.layers.empty();
  options.optimizer.pairs = request.pairs;
  options.optimizer.sizes.sizing = request.sizing.value_or(Sizing::Conformal);
  if (IsSizingFree(request))
  {
    options.acceptedSpread = GoodVariation; // H is the logarithm of sizes
  }
  options.quadSize = request.quadSize;
  options.quadCount = request.quadCount;
  // Rows of layers and prescribed counts of sides are made for the first one only.
  constexpr std::size_t Configurations = 5;
  const bool isFirstOnly =
    !request.layers.empty() || (!request.targets && !request.prescribed.empty());
  options.configurations = isFirstOnly ? 1 : Configurations;
  if (request.targets)
  {
    RelativeSizes sizes = RelativeTo(*request.targets);
    options.optimizer.sizes.field = std::move(sizes.field);
    options.quadSize *= sizes.mean;
  }
  const double quadSize =
    options.quadSize > 0.0 ? options.quadSize : std::sqrt(domain.Area() / request.quadCount);
  const SizeFunction& relative = options.optimizer.sizes.field;
  options.optimizer.clearanceFactors = ClearanceForLayers(domain, request,
    request.clearance > 0.0 ? request.clearance : ClearanceForQuads(quadSize),
    [&](const Point& place) { return relative ? quadSize * relative(place) : quadSize; });
  return options;
}
}

AutomaticConfiguration ChooseSingularities(
  const PlanarDomain& domain, const ResolvedRequest& request, const Progress& progress)
{
  return ChooseConfiguration(domain, OptionsFor(domain, request), progress);
}

std::optional<SizedConfiguration> WithPairs(
  const PlanarDomain& domain, const ResolvedRequest& request, const Progress& progress)
{
  AutomaticOptions options = OptionsFor(domain, request);
  options.proposal.given = *request.singularities;
  return AddPairsForSizes(domain, options, progress);
}

std::string DescribeOthersForSizes(const PlanarDomain& domain, const ResolvedRequest& request)
{
  // Less is no visible change of sizes.
  constexpr double Better = 0.8;
  constexpr int MostPairs = 100; // those that --pairs permits
  AutomaticOptions options = OptionsFor(domain, request);
  options.proposal.given = *request.singularities;
  options.optimizer.pairs = MostPairs;
  const double present = SpreadOfGiven(domain, options);
  const std::optional<SizedConfiguration> paired = AddPairsForSizes(domain, options);
  const AutomaticConfiguration chosen = ChooseSingularities(domain, request);
  const std::string spread = "the standard deviation of the logarithm of size over target size";
  std::string text;
  if (request.pairs == 0 && paired && paired->spread < Better * present)
  {
    const std::size_t pairs = (paired->singularities.size() - request.singularities->size()) / 2;
    text = std::to_string(pairs) + (pairs == 1 ? " pair" : " pairs") +
      " of singularities (Pairs, --pairs " + std::to_string(pairs) + ") would bring " + spread +
      " from " + FormatShort(present) + " to " + FormatShort(paired->spread);
  }
  const AutomaticConfiguration* best = &chosen;
  for (const AutomaticConfiguration& other : chosen.others)
  {
    best = other.optimum.sizeSpread < best->optimum.sizeSpread ? &other : best;
  }
  if (best->optimum.sizeSpread < Better * present)
  {
    text += (text.empty() ? "With " : "; with ") + std::to_string(best->singularities.size()) +
      " singularities that are chosen without any given, " +
      (text.empty() ? spread + " would be " : "it would be ") +
      FormatShort(best->optimum.sizeSpread);
  }
  return text.empty() ? text : text + ".";
}

OptimizerResult MinimiseEnergy(const PlanarDomain& domain, const ResolvedRequest& request,
  const Configuration& given, const Progress& progress)
{
  const AutomaticOptions options = OptionsFor(domain, request);
  OptimizerOptions minimum = options.optimizer;
  minimum.corners = options.proposal.corners;
  minimum.keepAll = true;
  minimum.pairs = 0;
  minimum.maximumSolves = options.maximumSolves;
  minimum.quadSize =
    options.quadSize > 0.0 ? options.quadSize : std::sqrt(domain.Area() / options.quadCount);
  if (minimum.clearance == 0.0)
  {
    minimum.clearance = ClearanceForQuads(minimum.quadSize);
  }
  Configuration start = given;
  for (Singularity& singularity : start)
  {
    singularity.radius = 0.0; // may not fit after a move
  }
  return OptimizeSingularities(domain, start, minimum, progress);
}

HolonomyRepair RepairForMap(const PlanarDomain& domain, const Configuration& singularities,
  const SeamlessMapOptions& options, double meshSize, const Progress& progress)
{
  std::vector<CornerChoice> corners = options.corners;
  if (options.capCorners)
  {
    corners = CapCorners(CountQuarters(domain.loops, 0, DefaultCornerAngle, corners), corners);
  }
  return RepairHolonomy(domain, singularities, corners, meshSize, progress);
}
}
