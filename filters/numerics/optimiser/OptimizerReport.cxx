#include "OptimizerReport.h"

#include "BoundaryCorners.h"
#include "HoleRadii.h"

#include <cctype>
#include <sstream>

namespace crossfield
{
std::string FormatShort(double value)
{
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}

std::string Capitalised(std::string sentence)
{
  sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
  return sentence;
}

std::string EndReason(
  OptimizerEnd end, const ObjectiveOptions& objective, std::size_t singularities, int iterations)
{
  switch (end)
  {
  case OptimizerEnd::Converged:
    if (singularities == 0)
    {
      return "There is no interior singularity to move.";
    }
    if (objective.goal == OptimizerGoal::Energy)
    {
      return "The singularities are at a stationary point of the renormalised energy.";
    }
    return objective.sizes.sizing == Sizing::Field
      ? "The singularities are at positions where sizes are closest to the target sizes."
      : "The singularities are at positions where sizes are most uniform.";
  case OptimizerEnd::Aborted:
    return "The iteration was aborted; this is the best configuration so far.";
  case OptimizerEnd::IterationLimit:
    return "The iteration stopped after " + std::to_string(iterations) +
      " steps before the singularities converged; allow more steps.";
  case OptimizerEnd::BudgetSpent:
    return "The search ended after " + std::to_string(objective.budget->GetSpent()) +
      " solves, its limit, before the singularities converged; this is the best configuration so "
      "far.";
  default:
    return "No step lowers the renormalised energy any more, although its derivatives are "
           "not zero; choose a larger tolerance or a finer mesh.";
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
