#include "LayerRuns.h"

#include "LayerSteps.h"
#include "PoincareHopf.h"
#include "QuadAdvice.h"
#include "QuadSteps.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace crossfield
{
namespace
{
/// Runs the steps without singularities if layers or sizes of sides are requested and a domain with
/// inner loops needs none: around a profile that gives a C-grid or an O-grid. Returns nothing if that
/// fails.
std::optional<QuadWorkflowResult> RunWithoutSingularities(
  const PlanarDomain& domain, const QuadRequest& request, const Progress& progress)
{
  const bool isSized = std::any_of(request.prescribed.begin(), request.prescribed.end(),
    [](const SidePrescription& one) { return one.size > 0.0; });
  if (request.singularities || (request.layers.empty() && !isSized) || domain.loops.size() < 2)
  {
    return std::nullopt;
  }
  std::vector<CornerChoice> corners = CompleteCorners(domain, request);
  if (request.capCorners)
  {
    corners = CapCorners(CountQuarters(domain.loops, 0, DefaultCornerAngle, corners), corners);
  }
  if (CountQuarters(domain.loops, 0, DefaultCornerAngle, corners).requiredInteriorQuarters != 0)
  {
    return std::nullopt;
  }
  QuadRequest without = request;
  without.singularities = Configuration();
  try
  {
    QuadWorkflowResult result = RunQuadSteps(domain, without, progress);
    result.events.insert(
      result.events.begin(), "The grid lines around the inner loops need no singularities.");
    return result.quads.quality.inverted == 0 ? std::make_optional(std::move(result))
                                              : std::nullopt;
  }
  catch (const Error&)
  {
    return std::nullopt; // singularities may help
  }
}

/// Runs the steps with singularities that are chosen unless they are given. Chosen ones move farther
/// away from layers that have not enough rows.
QuadWorkflowResult RunWithDistance(
  const PlanarDomain& domain, const QuadRequest& request, const Progress& progress)
{
  // Rows are higher than the quads on average in some places, for example at corners that they turn
  // around.
  constexpr double Farther = 1.3;
  constexpr int MaximumTries = 4;
  QuadRequest tried = request;
  for (int tries = 1;; ++tries)
  {
    try
    {
      QuadWorkflowResult result = RunQuadSteps(domain, tried, progress);
      if (tried.merge != request.merge)
      {
        result.events.push_back(
          "Blocks were not merged, because that leaves too few rows for the layers.");
      }
      return result;
    }
    catch (const LackOfRows& error)
    {
      if (tried.merge == BlockMerge::Clean)
      {
        tried.merge = BlockMerge::None;
        --tries;
        continue;
      }
      if (request.singularities)
      {
        throw LackOfRows(WithAdvice(error.what(), ", or leave them out, and others are chosen"));
      }
      if (tries == MaximumTries)
      {
        throw LackOfRows(
          WithAdvice(WithoutRemedy(error.what()), "; use smaller quads, or a larger growth"));
      }
    }
    tried.layerDistance *= Farther;
  }
}
}

QuadWorkflowResult RunWithLayers(
  const PlanarDomain& domain, const QuadRequest& request, const Progress& progress)
{
  // Part of the attainable minimum scaled Jacobian with which others need not be tried.
  constexpr double GoodPart = 0.6;
  std::optional<QuadWorkflowResult> without =
    RunWithoutSingularities(domain, request, progress.Part(0.0, 0.5));
  if (!without)
  {
    return RunWithDistance(domain, request, progress);
  }
  const auto jacobian = [](const QuadWorkflowResult& result)
  { return result.quads.quality.jacobian.min; };
  if (jacobian(*without) >= GoodPart * without->quads.quality.bound)
  {
    return std::move(*without);
  }
  try
  {
    QuadWorkflowResult with = RunWithDistance(domain, request, progress.Part(0.5, 1.0));
    return jacobian(with) > jacobian(*without) ? with : std::move(*without);
  }
  catch (const Error&)
  {
    return std::move(*without);
  }
}
}
