#include "AutomaticConfiguration.h"

#include "DrillHoles.h"
#include "MeshBudget.h"

#include <map>
#include <sstream>

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
       << optimum.energyAfter << " in " << optimum.iterations << " steps. " << optimum.reason;
  return text.str();
}
}

AutomaticConfiguration ChooseConfiguration(
  const PlanarDomain& domain, const AutomaticOptions& options, const Progress& progress)
{
  // Before the proposal, which takes its time on a boundary of very many segments.
  DrillOptions drillOptions;
  drillOptions.meshSize = options.optimizer.meshSize;
  RequireMemoryForMesh(domain, {}, ResolveMeshSize(drillOptions, domain), drillOptions.gradation);

  Configuration proposal = ProposeConfiguration(domain, options.proposal, progress.Part(0.0, 0.2));
  for (std::size_t i = options.proposal.given.size(); i < proposal.size(); ++i)
  {
    proposal[i].radius = 0.0; // the place is not yet the last one, so its hole is not, either
  }

  OptimizerOptions optimizerOptions = options.optimizer;
  optimizerOptions.corners = options.proposal.corners;
  AutomaticConfiguration result;
  result.optimum =
    OptimizeSingularities(domain, proposal, optimizerOptions, progress.Part(0.2, 1.0));
  result.singularities = result.optimum.configuration;
  result.corners = options.proposal.corners;
  result.events = { DescribeChoice(result.singularities), DescribeOptimum(result.optimum) };
  return result;
}
}
