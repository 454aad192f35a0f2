#include "RequestedSingularities.h"

#include "PoincareHopf.h"
#include "SizingChoice.h"

#include <utility>

namespace crossfield
{
AutomaticConfiguration ChooseSingularities(
  const PlanarDomain& domain, const QuadRequest& request, const Progress& progress)
{
  AutomaticOptions options;
  options.proposal.corners = request.corners;
  if (request.capCorners)
  {
    CapCorners(domain, options);
  }
  options.optimizer.meshSize = request.meshSize;
  options.optimizer.clearance = request.clearance;
  options.optimizer.pairs = request.pairs;
  options.optimizer.sizes.sizing = request.sizing.value_or(Sizing::Conformal);
  if (!request.sizing)
  {
    options.acceptedSpread = GoodVariation; // H is the logarithm of sizes
  }
  options.quadSize = request.quadSize;
  options.quadCount = request.quadCount;
  if (request.sizing == Sizing::Field)
  {
    RelativeSizes sizes = ComputeRelativeSizes(request.prescribedSizes, domain, request.meshSize);
    options.optimizer.sizes.field = std::move(sizes.field);
    options.quadSize *= sizes.mean;
  }
  return ChooseConfiguration(domain, options, progress);
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
