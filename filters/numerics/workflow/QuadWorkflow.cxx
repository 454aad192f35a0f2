#include "QuadWorkflow.h"

#include "CurveSteps.h"
#include "LayerSteps.h"
#include "MeshGrade.h"
#include "Outcome.h"
#include "PeriodicSteps.h"
#include "PoincareHopf.h"
#include "QuadAdvice.h"
#include "QuadAttempts.h"
#include "QuadBudget.h"
#include "SideSizes.h"

#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// Throws Error if singularities are to be held and moved.
void RequireOneWish(const QuadRequest& request)
{
  if (request.hold && request.repairHolonomy)
  {
    throw Error("The repair of the holonomy moves singularities, which cannot be held at the same "
                "time; turn off one of both (RepairHolonomy, --repair-holonomy; "
                "HoldSingularities, --hold).");
  }
}

/// Adds warnings about the choice, the number of quads, their sizes and area, and nearly degenerate
/// quads.
void AddWarnings(const QuadRequest& request, QuadWorkflowResult& result)
{
  if (result.optimum && !result.optimum->converged && !result.optimum->aborted)
  {
    result.warnings.push_back(result.optimum->reason);
  }
  if (CountExcess(result.quads, request.quadSize, request.quadCount) > 0.0)
  {
    result.warnings.push_back("No number of quads within 5 % of " +
      std::to_string(request.quadCount) + " was found for these separatrices; " +
      std::to_string(result.quads.mesh.quads.size()) + " is the nearest; request another number.");
  }
  for (const std::string& warning : { DescribeSizes(request, result.quads.mesh),
         DescribeArea(result.quads), DescribeWorstQuad(result.quads.mesh, result.quads.quality) })
  {
    if (!warning.empty())
    {
      result.warnings.push_back(warning);
    }
  }
}
}

QuadWorkflowResult MakeQuadMesh(
  const PlanarDomain& polygons, const QuadRequest& requested, const Progress& progress)
{
  RequireOneWish(requested);
  RequireQuadBudget(polygons, requested);
  const CurvedRequest curved = WithCurves(polygons, requested);
  const PlanarDomain& domain = curved.domain;
  const QuadRequest given = WithPeriodicSides(domain, curved.request);
  const QuadRequest request = WithSideSizes(domain, given);
  const Progress trial = progress.Part(1.0, 1.0);
  Outcome<QuadWorkflowResult> outcome =
    Try([&] { return MakeAttempts(domain, request, progress); });
  if (!outcome.value)
  {
    if (outcome.error->GetKind() != Error::Kind::CoarseMesh)
    {
      throw Error(*outcome.error);
    }
    std::vector<Point> kept = request.sides.FixedPlaces();
    for (const CornerChoice& corner : CompleteCorners(domain, request))
    {
      kept.push_back(corner.position);
    }
    for (std::size_t l = 0; l < domain.loops.size() && !given.curves.IsEmpty(); ++l)
    {
      kept.insert(kept.end(), domain.loops[l].begin(), domain.loops[l].end());
    }
    const double length = FindSmoothing(domain, kept,
      [&](const PlanarDomain& smooth)
      { MakeAttempts(smooth, WithSideSizes(smooth, given), trial); });
    throw WithSmoothing(*outcome.error, length, request.singularities.has_value());
  }
  QuadWorkflowResult result = std::move(*outcome.value);
  if (result.quads.quality.inverted > 0 && DescribeFlatNodes(domain, result.singularities).empty())
  {
    std::optional<SmallerSize> smaller;
    if (request.sizing != Sizing::Field) // whose sizes are factors
    {
      smaller = FindSmallerSize(result.quads,
        [&](double size)
        {
          QuadRequest other = request;
          other.quadSize = size;
          return MakeAttempts(domain, other, trial).quads;
        });
    }
    result.warnings.push_back(
      DescribeInverted(result.quads.quality, smaller, request.singularities.has_value()));
  }
  AddWarnings(given, result);
  result.ambiguousCorners =
    CountAmbiguous(CountQuarters(domain.loops, 0, DefaultCornerAngle, request.corners));
  result.boundary = given.curves;
  result.curves = MeasureCurves(polygons, given.curves, result.quads.mesh);
  return result;
}
}
