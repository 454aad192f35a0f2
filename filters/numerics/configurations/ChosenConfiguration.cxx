#include "ChosenConfiguration.h"

#include "PoincareHopf.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace crossfield
{
namespace
{
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
}

double ResolveQuadSize(const PlanarDomain& domain, const AutomaticOptions& options)
{
  return options.quadSize == 0.0 && options.quadCount > 0
    ? std::sqrt(domain.Area() / options.quadCount)
    : options.quadSize;
}

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

void AddEvents(AutomaticConfiguration& result)
{
  const OptimizerResult& optimum = result.optimum;
  result.events.insert(result.events.end(), optimum.events.begin(), optimum.events.end());
  result.events.push_back(DescribeOptimum(optimum));
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

bool HasConvergedWithoutDefect(const OptimizerResult& optimum)
{
  return optimum.converged && LargestDefect(optimum) < NoticeableDefect;
}

std::optional<std::size_t> SolvesLeft(std::size_t limit, std::size_t made)
{
  return limit == 0 ? std::optional<std::size_t>(0)
    : made < limit  ? std::optional<std::size_t>(limit - made)
                    : std::nullopt;
}
}
