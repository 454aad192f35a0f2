#include "EnergyMesh.h"

#include "BoundaryCorners.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Maximum number of edges on all holes together. A dense factor of this size takes a second and
/// 128 MiB.
constexpr double MaximumHoleEdges = 4096.0;
}

DrillOptions DrillForEnergies(
  const PlanarDomain& domain, const Configuration& configuration, double meshSize)
{
  DrillOptions options;
  options.meshSize = meshSize;
  options.meshSize = ResolveMeshSize(options, domain);
  const double diagonal = domain.Diagonal();
  const double fraction = std::min(1.0, options.meshSize / ResolveMeshSize({}, domain));
  options.gradation *= fraction;
  if (!configuration.empty())
  {
    const double edges = std::min(options.minimumHoleEdges / fraction,
      MaximumHoleEdges / static_cast<double>(configuration.size()));
    options.minimumHoleEdges =
      std::max(options.minimumHoleEdges, static_cast<int>(std::ceil(edges)));
  }
  for (const Corner& corner : FindCorners(domain.loops))
  {
    if (corner.angle > Pi)
    {
      const double size = diagonal * std::pow(options.meshSize / diagonal, corner.angle / Pi);
      options.refinements.push_back({ corner.position, size });
    }
  }
  return options;
}
}
