#include "OptimizerReport.h"

#include "BoundaryCorners.h"
#include "HoleRadii.h"

#include <cctype>

namespace crossfield
{
std::string FormatShort(double value)
{
  return FormatNumber(value, 4);
}

std::string Capitalised(std::string sentence)
{
  sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
  return sentence;
}

std::string EndReason(OptimizerEnd end, const ObjectiveOptions& objective,
  std::size_t singularities, std::size_t held, int iterations)
{
  const std::string holds = "The clearance of " + FormatShort(objective.clearance) + " holds " +
    std::to_string(held) + (held == 1 ? " singularity" : " singularities");
  switch (end)
  {
  case OptimizerEnd::Converged:
    if (singularities == 0)
    {
      return "There is no interior singularity to move.";
    }
    if (objective.goal == OptimizerGoal::Energy)
    {
      return held == 0 ? "The singularities are at a stationary point of the renormalised energy."
                       : holds + "; without it the renormalised energy would decrease further.";
    }
    if (held > 0)
    {
      return holds + "; without it sizes would be closer to the target sizes.";
    }
    return objective.sizes.sizing == Sizing::Field
      ? "The singularities are at positions where sizes are closest to the target sizes."
      : "The singularities are at positions where sizes are most uniform.";
  case OptimizerEnd::Aborted:
    return "The iteration was aborted; this is the best configuration so far.";
  case OptimizerEnd::IterationLimit:
    return "The iteration stopped after " + std::to_string(iterations) +
      " steps, its limit, before the singularities converged; this is the best configuration so "
      "far.";
  case OptimizerEnd::BudgetSpent:
    return "The search ended after " + std::to_string(objective.budget->GetSpent()) +
      " solves, its limit, before the singularities converged; this is the best configuration so "
      "far.";
  default:
    return "No step lowers the renormalised energy any more, although its derivatives are not "
           "zero; this is the best configuration so far.";
  }
}

std::vector<std::string> ShrinkRadii(const PlanarDomain& domain, Configuration& configuration)
{
  std::vector<std::string> events;
  const Configuration given = configuration;
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    const double available = LargestHoleRadius(domain, given, i);
    if (given[i].radius > 0.75 * available && available > BoundaryReach * domain.Diagonal())
    {
      configuration[i].radius = DefaultRadius(domain, given, i, given[i].radius);
      events.push_back("The radius of singularity " + std::to_string(i + 1) +
        " of the result was reduced from " + FormatShort(given[i].radius) + " to " +
        FormatShort(configuration[i].radius) + " to fit.");
    }
  }
  return events;
}
}
