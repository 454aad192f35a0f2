#include "HolonomyCheck.h"

#include "ConfigurationPlacement.h"
#include "MeshForPoints.h"
#include "PointPotential.h"

#include <memory>
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
  constexpr double DefaultSize = 0.0;
  const SharedPlanarTopology topology =
    ShareTopology(MeshForPoints(domain, configuration, DefaultSize, progress.Part(0.0, 0.5)));
  const PlacedConfiguration placed = PlaceConfiguration(*topology, configuration, corners);
  Alignment alignment =
    AlignWithBoundary(*topology, placed.corners, TotalQuarters(placed.interior));
  const PointPotential potential(
    std::make_shared<const PotentialSolver>(topology, progress.Part(0.5, 0.9)),
    std::move(alignment));
  return potential.Solve(placed.interior).holonomyDefect;
}
}
