#include "LaidOutRegion.h"

#include "CurveSteps.h"
#include "Outcome.h"
#include "PeriodicSteps.h"
#include "SizeTargets.h"

#include <array>
#include <string>
#include <utility>

namespace crossfield
{
void PlaceSingularities(const PlanarDomain& polygons, const QuadRequest& request,
  QuadSeconds& seconds, const Progress& progress, LaidOutRegion& region)
{
  CurvedRequest curved = WithCurves(polygons, Resolve(polygons, request));
  region.domain = std::move(curved.domain);
  for (const std::array<std::string, 2>& sides : curved.request.partners)
  {
    if (curved.request.sides.Find(sides[1]) < 0)
    {
      throw Error("The periodic sides '" + sides[0] + "' and '" + sides[1] +
        "' are not both of this region; give sides of one region, or mesh all as one material "
        "(MaterialArray none, --materials none).");
    }
  }
  region.request = WithSizeTargets(region.domain, WithPeriodicSides(region.domain, curved.request));
  region.placed.emplace(region.domain, region.request, seconds);
  region.placed->Place(progress);
}

void LayOutRegion(const Progress& progress, LaidOutRegion& region)
{
  std::optional<Error> error;
  for (const bool repairs : { false, true })
  {
    for (const double refinement : { 1.0, 2.0 })
    {
      Outcome<bool> outcome = Try(
        [&]
        {
          QuadSteps steps = *region.placed;
          if (repairs)
          {
            steps.RepairHolonomy({});
          }
          region.layout = steps.LayOutOnly(refinement, progress);
          region.result = steps.GetResult();
          return true;
        });
      if (outcome.value)
      {
        return;
      }
      error = error ? error : outcome.error;
      if (outcome.error->GetKind() != Error::Kind::CoarseMesh)
      {
        break;
      }
    }
    if (error->GetKind() != Error::Kind::CoarseMesh || region.domain.loops.size() < 2)
    {
      break;
    }
  }
  throw Error(*error);
}
}
