#include "QuadWorkflow.h"

#include "CurveSteps.h"
#include "HeldNodes.h"
#include "LayerSteps.h"
#include "MeshGrade.h"
#include "Outcome.h"
#include "PeriodicSteps.h"
#include "PoincareHopf.h"
#include "QuadAdvice.h"
#include "QuadAttempts.h"
#include "QuadBudget.h"
#include "SharpTips.h"
#include "SizeTargets.h"

#include <optional>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// Throws Error if singularities are to be held and moved.
void RequireHoldOrRepair(const QuadRequest& request)
{
  if (request.hold && request.repairHolonomy)
  {
    throw Error("The repair of the holonomy moves singularities, which cannot be held at the same "
                "time; turn off one of both (RepairHolonomy, --repair-holonomy; "
                "HoldSingularities, --hold).");
  }
}

/// Returns whether the choice of the singularities was so slow that it is not repeated for advice.
bool IsChoiceSlow(const QuadWorkflowResult& result)
{
  constexpr std::size_t SlowSolves = 600; // five seconds on a mesh of usual size
  return result.optimum && result.optimum->solves > SlowSolves;
}

/// Adds warnings about the choice, the number of quads, their sizes and area, and nearly degenerate
/// quads.
void AddWarnings(const ResolvedRequest& request, QuadWorkflowResult& result)
{
  if (result.optimum && !result.optimum->converged && !result.optimum->aborted)
  {
    result.warnings.push_back(result.optimum->reason);
  }
  const bool isPrescribed =
    !request.prescribed.empty() || request.minimumSize > 0.0 || request.maximumSize > 0.0;
  for (const std::string& warning :
    { request.isPart ? std::string() : DescribeCount(request, isPrescribed, result.quads),
      result.sizes ? std::string() : DescribeSizes(request, result.quads),
      DescribeArea(result.quads), DescribeLostSides(result.quads.mesh),
      DescribeMissedPlaces(request.nodes, result.quads.mesh),
      DescribeWorstQuad(result.quads.mesh, result.quads.quality) })
  {
    if (!warning.empty())
    {
      result.warnings.push_back(warning);
    }
  }
}

/// A domain and a request with everything that attempts need.
struct PreparedRequest
{
  PlanarDomain polygons;
  PlanarDomain domain;     ///< With curves sampled.
  ResolvedRequest given;   ///< With periodic sides.
  ResolvedRequest request; ///< With target sizes as well.
};

PreparedRequest Prepare(const PlanarDomain& polygons, const QuadRequest& requested)
{
  const ResolvedRequest resolved = Resolve(polygons, requested);
  RequireQuadBudget(polygons, resolved);
  CurvedRequest curved = WithCurves(polygons, resolved);
  PreparedRequest result;
  result.polygons = polygons;
  result.domain = std::move(curved.domain);
  result.given = WithPeriodicSides(result.domain, curved.request);
  result.request = WithSizeTargets(result.domain, result.given);
  return result;
}

bool HasValidQuads(const Outcome<QuadWorkflowResult>& outcome)
{
  return outcome.value && outcome.value->quads.quality.inverted == 0;
}

/// Makes quads of a domain with its sharp tips cut off, if the outcome so far has no valid quads
/// and this leads to some.
void TryWithoutTips(const PlanarDomain& polygons, const QuadRequest& requested,
  const Progress& progress, PreparedRequest& prepared, Outcome<QuadWorkflowResult>& outcome)
{
  if (HasValidQuads(outcome) || !requested.capCorners ||
    (outcome.error && outcome.error->GetKind() != Error::Kind::CoarseMesh))
  {
    return;
  }
  for (const double part : TipLengths)
  {
    const std::optional<CutDomain> cut =
      CutSharpTips(polygons, requested, part * polygons.Diagonal());
    if (!cut)
    {
      return;
    }
    PreparedRequest other;
    Outcome<QuadWorkflowResult> made = Try(
      [&]
      {
        other = Prepare(cut->domain, cut->request);
        return MakeAttempts(other.domain, other.request, progress);
      });
    if (HasValidQuads(made))
    {
      made.value->warnings.push_back(cut->warning);
      prepared = std::move(other);
      outcome = std::move(made);
      return;
    }
  }
}
}

QuadWorkflowResult MakeQuadMesh(
  const PlanarDomain& polygons, const QuadRequest& requested, const Progress& progress)
{
  RequireHoldOrRepair(requested);
  PreparedRequest prepared = Prepare(polygons, requested);
  const Progress trial = progress.Part(1.0, 1.0);
  Outcome<QuadWorkflowResult> outcome =
    Try([&] { return MakeAttempts(prepared.domain, prepared.request, progress); });
  TryWithoutTips(polygons, requested, trial, prepared, outcome);
  const PlanarDomain& domain = prepared.domain;
  const ResolvedRequest& given = prepared.given;
  const ResolvedRequest& request = prepared.request;
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
    // Not for given singularities, which the attempts have moved already: four more runs take
    // minutes.
    const double length = request.singularities
      ? 0.0
      : FindSmoothing(domain, kept,
          [&](const PlanarDomain& smooth)
          { MakeAttempts(smooth, WithSizeTargets(smooth, given), trial); });
    throw WithSmoothing(*outcome.error, length, request.singularities.has_value());
  }
  QuadWorkflowResult result = std::move(*outcome.value);
  if (result.quads.quality.inverted > 0 && DescribeFlatNodes(domain, result.singularities).empty())
  {
    SizeTrials smaller;
    if (request.sizing != Sizing::Field) // whose sizes are factors
    {
      const bool keeps = IsChoiceSlow(result);
      smaller = TrySmallerSizes(result.quads,
        [&](double size)
        {
          ResolvedRequest other = request;
          other.quadSize = size;
          if (!keeps)
          {
            return MakeAttempts(domain, other, trial).quads;
          }
          other.singularities = result.singularities;
          return MakeFirstAttempt(domain, other, trial).quads; // others would move them
        });
      if (smaller.valid)
      {
        smaller.valid->keepsSingularities = keeps;
      }
    }
    result.warnings.push_back(
      DescribeInverted(result.quads.quality, smaller, request.singularities.has_value()));
  }
  AddWarnings(given, result);
  result.ambiguousCorners =
    CountAmbiguous(CountQuarters(domain.loops, 0, DefaultCornerAngle, request.corners));
  result.boundary = given.curves;
  result.curves = MeasureCurves(prepared.polygons, given.curves, result.quads.mesh);
  return result;
}
}
