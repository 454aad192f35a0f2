#include "HolonomyCheck.h"

#include "DomainQueries.h"
#include "DrillHoles.h"
#include "UnitNormField.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
std::vector<double> HolonomyDefects(const PlanarDomain& domain, const Configuration& configuration,
  const std::vector<CornerChoice>& corners, const Progress& progress)
{
  if (domain.loops.size() < 2)
  {
    return {};
  }
  const DrillOptions options;
  Configuration holes = configuration;
  for (std::size_t i = 0; i < holes.size(); ++i)
  {
    if (holes[i].radius == 0.0)
    {
      double room = SignedDistance(holes[i].position, domain);
      for (std::size_t j = 0; j < holes.size(); ++j)
      {
        if (j != i)
        {
          room = std::min(room, (holes[j].position - holes[i].position).norm() - holes[j].radius);
        }
      }
      holes[i].radius = std::min(ResolveMeshSize(options, domain), room / 3.0);
    }
  }
  const SharedTopology topology =
    ShareTopology(DrillHoles(domain, holes, options, progress.Part(0.0, 0.5)));
  Alignment alignment = AlignWithBoundary(*topology, corners);
  RequireConsistent(alignment.count);
  const PotentialProblem problem(
    std::make_shared<const PotentialSolver>(topology), std::move(alignment));
  progress.Report(0.9);
  return SolveUnitNorm(problem).holonomyDefect;
}
}
