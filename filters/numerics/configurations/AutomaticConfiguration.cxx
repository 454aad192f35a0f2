#include "AutomaticConfiguration.h"

#include "DrillHoles.h"
#include "MeshBudget.h"
#include "OptimizerReport.h"
#include "OptimizerStage.h"
#include "PoincareHopf.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

namespace crossfield
{
namespace
{
/// "6 singularities were chosen: 5 of quarter index 1, 1 of −1."
std::string DescribeChoice(const Configuration& configuration)
{
  std::map<int, int> counts;
  for (const Singularity& singularity : configuration)
  {
    ++counts[singularity.quarterIndex];
  }
  std::ostringstream text;
  if (configuration.empty())
  {
    return "The domain needs no singularities.";
  }
  text << configuration.size()
       << (configuration.size() == 1 ? " singularity was chosen" : " singularities were chosen");
  const char* separator = ": ";
  for (auto count = counts.rbegin(); count != counts.rend(); ++count)
  {
    text << separator << count->second << " of quarter index " << count->first;
    separator = ", ";
  }
  text << ".";
  return text.str();
}

std::string DescribeOptimum(const OptimizerResult& optimum)
{
  std::ostringstream text;
  text << "The renormalised energy went from " << optimum.energyBefore << " to "
       << optimum.energyAfter << " in " << optimum.iterations << " steps";
  if (optimum.sizeSpreads)
  {
    text << ", the spread of sizes from " << optimum.sizeSpreads->before << " to "
         << optimum.sizeSpreads->after;
  }
  text << ". " << optimum.reason;
  return text.str();
}

double LargestDefect(const OptimizerResult& optimum)
{
  double largest = 0.0;
  for (const double defect : optimum.holonomyDefect)
  {
    largest = std::max(largest, std::abs(defect));
  }
  return largest;
}

/// At rest, with a single-valued H.
bool Arrived(const OptimizerResult& optimum)
{
  return optimum.converged && LargestDefect(optimum) < NoticeableDefect;
}

bool IsBetter(const OptimizerResult& one, const OptimizerResult& other)
{
  if (Arrived(one) != Arrived(other))
  {
    return Arrived(one);
  }
  return LargestDefect(one) < LargestDefect(other);
}

/// The clearance that is asked for, 0 if none is.
double AskedClearance(const PlanarDomain& domain, const AutomaticOptions& options)
{
  if (options.optimizer.clearance != 0.0)
  {
    return options.optimizer.clearance;
  }
  return ClearanceForQuads(options.quadSize == 0.0 && options.quadCount > 0
      ? std::sqrt(domain.Area() / options.quadCount)
      : options.quadSize);
}

/// Adds what happened in a run.
void Tell(AutomaticConfiguration& result)
{
  const OptimizerResult& optimum = result.optimum;
  result.events.insert(result.events.end(), optimum.events.begin(), optimum.events.end());
  result.events.push_back(DescribeOptimum(optimum));
}

AutomaticConfiguration Optimize(const PlanarDomain& domain, const ProposedConfiguration& start,
  const AutomaticOptions& options, const Progress& progress)
{
  Configuration singularities = start.singularities;
  for (std::size_t i = options.proposal.given.size(); i < singularities.size(); ++i)
  {
    singularities[i].radius = 0.0; // the place is not yet the last one, so its hole is not, either
  }
  OptimizerOptions optimizerOptions = options.optimizer;
  optimizerOptions.corners = start.corners;
  AutomaticConfiguration result;
  result.optimum = OptimizeSingularities(domain, singularities, optimizerOptions, progress);
  result.singularities = result.optimum.configuration;
  result.corners = start.corners;
  result.events = { DescribeChoice(result.singularities) + " Start: " + start.origin + "." };
  Tell(result);
  return result;
}

/// From the least energy on to the least one at a larger clearance, and to even sizes if they are asked for or far from even.
void FitToQuads(const PlanarDomain& domain, const AutomaticOptions& options, double clearance,
  const Progress& progress, AutomaticConfiguration& result)
{
  OptimizerOptions fit = options.optimizer;
  fit.corners = result.corners;
  fit.clearance = clearance;
  fit.keepAll = true;
  // At 1/4 the largest twentieth of the sizes and the smallest differ by more than e. Below, evening them may cost more shape
  // than it brings (docs/method.md §5.7).
  constexpr double FarFromUniform = 0.25;
  fit.uniformSizes |= result.optimum.sizeSpread > FarFromUniform;
  result.optimum = OptimizeSingularities(domain, result.singularities, fit, progress);
  result.singularities = result.optimum.configuration;
  Tell(result);
  if (!fit.wantedSize && fit.pairs == 0 && result.optimum.sizeSpread > FarFromUniform)
  {
    result.events.push_back(
      "Sizes are far from even, the standard deviation of their logarithm is " +
      Short(result.optimum.sizeSpread) + "; pairs of singularities would even them.");
  }
}
}

double ClearanceForQuads(double quadSize)
{
  // The meshes of the gallery are best at 0.7 to 1.
  return 0.7 * quadSize;
}

void CapCorners(const PlanarDomain& domain, AutomaticOptions& options)
{
  std::vector<CornerChoice>& corners = options.proposal.corners;
  std::vector<CornerChoice> capped =
    CapCorners(CountQuarters(domain.loops, 0, options.proposal.cornerAngle, corners), corners);
  options.optimizer.keepAll |= capped.size() > corners.size();
  corners = std::move(capped);
}

AutomaticConfiguration ChooseConfiguration(
  const PlanarDomain& domain, const AutomaticOptions& options, const Progress& progress)
{
  // Before the proposal, which takes its time on a boundary of very many segments.
  DrillOptions drillOptions;
  drillOptions.meshSize = options.optimizer.meshSize;
  RequireMemoryForMesh(domain, {}, ResolveMeshSize(drillOptions, domain), drillOptions.gradation);

  // What the singularities are is decided by the energy, where they may go next to the boundary: only then the
  // size of quads keeps them off it, and sizes are made even.
  const double clearance = AskedClearance(domain, options);
  const bool fits =
    clearance > CoreRadius(domain) || options.optimizer.uniformSizes || options.optimizer.pairs > 0;
  AutomaticOptions least = options;
  least.optimizer.clearance = fits ? 0.0 : clearance;
  least.optimizer.uniformSizes = false;
  least.optimizer.pairs = 0;

  const std::vector<ProposedConfiguration> starts =
    ProposeConfigurations(domain, options.proposal, progress.Part(0.0, 0.4));
  AutomaticConfiguration best;
  for (std::size_t i = 0; i < starts.size() && !Arrived(best.optimum); ++i)
  {
    const double share = (fits ? 0.4 : 0.6) / static_cast<double>(starts.size());
    const double begin = 0.4 + share * static_cast<double>(i);
    AutomaticConfiguration tried =
      Optimize(domain, starts[i], least, progress.Part(begin, begin + share));
    if (i == 0 || IsBetter(tried.optimum, best.optimum))
    {
      best = std::move(tried);
    }
    if (best.optimum.aborted)
    {
      break;
    }
  }
  if (fits && !best.optimum.aborted)
  {
    FitToQuads(domain, options, clearance, progress.Part(0.8, 1.0), best);
  }
  return best;
}
}
