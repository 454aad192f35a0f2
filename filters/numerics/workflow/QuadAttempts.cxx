#include "QuadAttempts.h"

#include "LayerSteps.h"
#include "MeshGrade.h"
#include "OptimizerReport.h"
#include "Outcome.h"
#include "PoincareHopf.h"
#include "QuadAdvice.h"
#include "QuadSteps.h"
#include "SmoothLoops.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// Factor of the distance from layers for the next attempt: rows are higher than the quads on
/// average in some places, for example at corners that they turn around.
constexpr double DistanceFactor = 1.3;
/// Chosen singularities move away from layers three times.
constexpr double LayerDistanceLimit = DistanceFactor * DistanceFactor * DistanceFactor;
/// Refinement of the second triangle mesh.
constexpr double FinerMesh = 2.0;

/// Returns whether a domain has a smooth inner loop, such as a circle or an ellipse, that is too
/// small for EnoughEdges of the target size. Singularities would make it a polygon of few edges.
bool HasSmallSmoothLoop(const PlanarDomain& domain, const QuadRequest& request)
{
  const double size =
    request.quadSize > 0.0 ? request.quadSize : std::sqrt(domain.Area() / request.quadCount);
  return request.sizing.value_or(Sizing::Conformal) == Sizing::Conformal &&
    std::any_of(domain.loops.begin() + 1, domain.loops.end(),
      [&](const Loop& loop)
      {
        const LoopArc arc(loop);
        return arc.Corners(DefaultCornerAngle).empty() && arc.Length() < EnoughEdges * size;
      });
}

/// Returns whether a domain with inner loops needs no singularities, and layers or sizes of sides
/// are requested, or a smooth inner loop is small: around a profile that gives a C-grid or an
/// O-grid.
bool MayDoWithout(const PlanarDomain& domain, const ResolvedRequest& request)
{
  const bool isSized = std::any_of(request.prescribed.begin(), request.prescribed.end(),
    [](const SidePrescription& one) { return one.size > 0.0; });
  if (request.singularities || domain.loops.size() < 2 ||
    (request.layers.empty() && !isSized && !HasSmallSmoothLoop(domain, request)))
  {
    return false;
  }
  std::vector<CornerChoice> corners = CompleteCorners(domain, request);
  if (request.capCorners)
  {
    corners = CapCorners(CountQuarters(domain.loops, 0, DefaultCornerAngle, corners), corners);
  }
  return CountQuarters(domain.loops, 0, DefaultCornerAngle, corners).requiredInteriorQuarters == 0;
}

/// Returns the request for the singularities of an attempt.
ResolvedRequest RequestOf(const ResolvedRequest& request, const QuadAttempt& attempt)
{
  ResolvedRequest result = request;
  if (!attempt.hasSingularities)
  {
    result.singularities = Configuration();
  }
  result.layerDistance *= attempt.layerDistance;
  return result;
}

/// Returns whether two attempts have the same singularities, before the holonomy is repaired
/// without request.
bool HaveSameSingularities(const QuadAttempt& a, const QuadAttempt& b)
{
  return a.hasSingularities == b.hasSingularities && a.layerDistance == b.layerDistance;
}

/// Returns whether inverted quads may be valid after singularities have moved: a node of valence 2
/// has none anywhere.
bool MayBecomeValid(const PlanarDomain& domain, const ResolvedRequest& request)
{
  return !request.hold &&
    (request.split || DescribeFlatNodes(domain, *request.singularities).empty());
}

bool IsOfKind(const std::optional<Error>& error, Error::Kind kind)
{
  return error && error->GetKind() == kind;
}

/// Returns an attempt in words.
AttemptReport ReportOf(const ResolvedRequest& request, const QuadAttemptRecord& record)
{
  const QuadAttempt& attempt = record.attempt;
  std::string what = !attempt.hasSingularities ? "Without singularities"
    : request.singularities                    ? "With the given singularities"
                                               : "With chosen singularities";
  what += attempt.layerDistance > 1.0
    ? ", " + FormatShort(attempt.layerDistance) + " times as far from layers"
    : "";
  what += attempt.motion == SingularityMotion::RepairedHolonomy ? ", with the holonomy repaired"
    : attempt.motion == SingularityMotion::MinimumEnergy ? ", moved towards a minimum of the energy"
                                                         : "";
  what += attempt.refinement > 1.0 ? ", on a finer triangle mesh" : "";
  what += !attempt.mergesBlocks ? ", without merging blocks" : "";
  what += attempt.takesFewRows ? ", with fewer rows for layers" : "";
  if (!record.error)
  {
    return { what, record.quads };
  }
  const std::string& cause = record.error->GetCause();
  return { what, cause.empty() ? record.error->what() : Sentence(cause, {}) };
}

/// Returns the number of quads and blocks, and the shape of quads.
std::string DescribeQuads(const QuadResult& quads)
{
  const int inverted = quads.quality.inverted;
  const std::size_t blocks = quads.blocks.blocks.size();
  return std::to_string(quads.mesh.quads.size()) + " quads in " + std::to_string(blocks) +
    (blocks == 1 ? " block" : " blocks") + ", minimum scaled Jacobian " +
    FormatShort(quads.quality.jacobian.min) +
    (inverted > 0 ? ", " + std::to_string(inverted) + " inverted." : ".");
}

/// The attempts of one request.
class Attempts
{
public:
  Attempts(const PlanarDomain& domain, const ResolvedRequest& request)
    : Domain(domain)
    , Request(request)
  {
  }

  QuadWorkflowResult Run(const Progress& progress)
  {
    double done = 0.0;
    while (const std::optional<QuadAttempt> attempt =
             NextAttempt(this->Domain, this->Request, this->Records))
    {
      // Most requests take one attempt; the others share what it leaves.
      constexpr double Share = 0.9;
      const double end = done + Share * (1.0 - done);
      const Progress part = progress.Part(done, end);
      this->Store(*attempt, Try([&] { return this->Make(*attempt, part); }));
      done = end;
    }
    if (!this->Best)
    {
      throw this->FinalError();
    }
    this->Best->seconds = this->Seconds;
    for (const QuadAttemptRecord& record : this->Records)
    {
      this->Best->attempts.push_back(ReportOf(this->Request, record));
    }
    return std::move(*this->Best);
  }

private:
  /// Makes an attempt. Singularities are placed, and moved, once for all attempts with the same.
  QuadWorkflowResult Make(const QuadAttempt& attempt, const Progress& progress)
  {
    const double placed = this->Request.singularities ? 0.1 : 0.5;
    if (!this->Placed || !HaveSameSingularities(this->Records.back().attempt, attempt))
    {
      this->Placed.reset();
      this->Moved.reset();
      QuadSteps steps(this->Domain, RequestOf(this->Request, attempt), this->Seconds);
      steps.Place(progress.Part(0.0, placed));
      this->Placed.emplace(std::move(steps));
    }
    const bool moves = attempt.motion != SingularityMotion::None;
    if (moves && (!this->Moved || this->Records.back().attempt.motion != attempt.motion))
    {
      this->Moved.reset();
      QuadSteps steps = *this->Placed;
      if (attempt.motion == SingularityMotion::RepairedHolonomy)
      {
        steps.RepairHolonomy(progress.Part(0.0, placed));
      }
      else
      {
        steps.MoveToMinimumEnergy(progress.Part(0.0, placed));
      }
      this->Moved.emplace(std::move(steps));
    }
    if (this->Records.empty() && this->Placed->CountChoices() > 1)
    {
      return this->MakeAlternatives(progress.Part(placed, 1.0));
    }
    QuadSteps steps = moves ? *this->Moved : *this->Placed;
    if (!attempt.mergesBlocks)
    {
      steps.DoNotMerge();
    }
    if (attempt.takesFewRows)
    {
      steps.TakeFewRows();
    }
    return steps.MakeQuads(attempt.refinement, progress.Part(placed, 1.0));
  }

  /// Makes quads of all configurations that were chosen, and continues with the preferred one. Throws
  /// the Error of the first if none has quads.
  QuadWorkflowResult MakeAlternatives(const Progress& progress)
  {
    const std::size_t count = this->Placed->CountChoices();
    std::vector<QuadWorkflowResult> results;
    std::vector<QuadSteps> choices;
    std::vector<Alternative> alternatives;
    std::optional<Error> error;
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto done = static_cast<double>(i);
      const auto all = static_cast<double>(count);
      QuadSteps steps = *this->Placed;
      Outcome<QuadWorkflowResult> outcome = Try(
        [&]
        {
          steps.UseChoice(i);
          QuadSteps making = steps;
          return making.MakeQuads(1.0, progress.Part(done / all, (done + 1.0) / all));
        });
      if (!outcome.value)
      {
        error = error ? error : outcome.error;
        continue;
      }
      alternatives.push_back(AlternativeOf(outcome.value->quads,
        outcome.value->singularities.size(), this->Request.quadSize, this->Request.quadCount));
      alternatives.back().rank = this->Placed->RankOf(i);
      if (outcome.value->sizes)
      {
        alternatives.back().met = outcome.value->sizes->Met();
      }
      results.push_back(std::move(*outcome.value));
      choices.push_back(std::move(steps));
    }
    if (results.empty())
    {
      throw Error(*error);
    }
    const std::vector<std::size_t> order =
      OrderAlternatives(alternatives, this->Request.preference);
    const std::size_t used =
      order[std::min(static_cast<std::size_t>(this->Request.alternative), order.size() - 1)];
    this->Placed.emplace(std::move(choices[used]));
    QuadWorkflowResult result = std::move(results[used]);
    if (error)
    {
      result.events.push_back("Another configuration has no quads. " + std::string(error->what()));
    }
    for (const std::size_t i : order)
    {
      result.alternatives.push_back(alternatives[i]);
    }
    return result;
  }

  /// Stores what an attempt led to, and its quads if they are the best.
  void Store(const QuadAttempt& attempt, Outcome<QuadWorkflowResult> outcome)
  {
    QuadAttemptRecord record{ attempt, std::move(outcome.error), false, false, {} };
    if (outcome.value)
    {
      QuadWorkflowResult& result = *outcome.value;
      const QuadQuality& quality = result.quads.quality;
      record.quads = DescribeQuads(result.quads);
      record.isInverted = quality.inverted > 0;
      record.isAcceptable =
        !record.isInverted && quality.jacobian.min >= AcceptableShape * quality.bound;
      if (!attempt.hasSingularities)
      {
        result.events.insert(
          result.events.begin(), "The grid lines around the inner loops need no singularities.");
      }
      if (attempt.motion != SingularityMotion::None && this->Request.hold)
      {
        this->CanMove |= !record.isInverted;
      }
      else if (!this->Best || this->IsBetter(result, *this->Best))
      {
        this->Best = std::move(result);
      }
    }
    this->Records.push_back(std::move(record));
  }

  bool IsBetter(const QuadWorkflowResult& one, const QuadWorkflowResult& other) const
  {
    const double attainable = std::max(one.quads.quality.bound, other.quads.quality.bound);
    const auto grade = [&](const QuadWorkflowResult& result)
    { return GradeOf(result.quads, this->Request.quadSize, this->Request.quadCount, attainable); };
    return grade(one) < grade(other);
  }

  /// Returns the error of the last attempt, with the remedy that follows from the others. Attempts
  /// that move singularities without request do not count, unless these were chosen and leave too
  /// few rows.
  Error FinalError() const
  {
    const Error& error = *std::find_if(this->Records.rbegin(), this->Records.rend(),
      [&](const QuadAttemptRecord& record)
      {
        return record.error &&
          (record.attempt.motion == SingularityMotion::None ||
            (!this->Request.singularities && IsOfKind(record.error, Error::Kind::LackOfRows)));
      })->error;
    if (this->CanMove)
    {
      return { error.GetCause(),
        "do not hold the singularities (HoldSingularities, --hold): they then move, and there are "
        "quads",
        Error::Kind::BadInput };
    }
    if (error.GetKind() == Error::Kind::LackOfRows)
    {
      const std::string& remedy = error.GetRemedy();
      return { error.GetCause(),
        this->Request.singularities
          ? (remedy.empty() ? "leave the singularities" : remedy + ", or leave them") +
            " out, and others are chosen"
          : "use smaller quads, or a larger growth",
        error.GetKind() };
    }
    return error;
  }

  const PlanarDomain& Domain;
  const ResolvedRequest& Request;
  std::vector<QuadAttemptRecord> Records;
  std::optional<QuadSteps> Placed; ///< With the singularities of the last attempt.
  std::optional<QuadSteps> Moved;  ///< The same, moved without request.
  std::optional<QuadWorkflowResult> Best;
  bool CanMove = false; ///< Whether quads are valid if singularities that are held move.
  QuadSeconds Seconds;
};
}

std::optional<QuadAttempt> NextAttempt(const PlanarDomain& domain, const ResolvedRequest& request,
  const std::vector<QuadAttemptRecord>& made)
{
  if (made.empty())
  {
    QuadAttempt first;
    first.hasSingularities = !MayDoWithout(domain, request);
    return first;
  }
  const QuadAttemptRecord& last = made.back();
  QuadAttempt next = last.attempt;
  const bool isCoarse = IsOfKind(last.error, Error::Kind::CoarseMesh);
  if (isCoarse && next.refinement == 1.0)
  {
    next.refinement = FinerMesh;
    return next;
  }
  if (!next.hasSingularities)
  {
    return last.isAcceptable ? std::nullopt : std::optional<QuadAttempt>(QuadAttempt());
  }
  const bool isMoved = next.motion != SingularityMotion::None;
  if (isCoarse && domain.loops.size() > 1 && !isMoved && !request.repairHolonomy)
  {
    next.motion = SingularityMotion::RepairedHolonomy;
    next.refinement = 1.0;
    return next;
  }
  if (request.singularities && !request.singularities->empty() &&
    next.motion != SingularityMotion::MinimumEnergy &&
    (isCoarse || (isMoved && last.error) || (last.isInverted && MayBecomeValid(domain, request))))
  {
    next.motion = SingularityMotion::MinimumEnergy;
    next.refinement = 1.0;
    return next;
  }
  if (IsOfKind(last.error, Error::Kind::LackOfRows))
  {
    if (next.mergesBlocks && request.merge == BlockMerge::Clean)
    {
      next.mergesBlocks = false;
      return next;
    }
    next.layerDistance *= DistanceFactor;
    next.refinement = 1.0;
    next.motion = SingularityMotion::None;
    if (!request.singularities && next.layerDistance <= LayerDistanceLimit)
    {
      return next;
    }
    if (!request.singularities && !last.attempt.takesFewRows)
    {
      next = last.attempt;
      next.takesFewRows = true;
      return next;
    }
  }
  return std::nullopt;
}

QuadWorkflowResult MakeAttempts(
  const PlanarDomain& domain, const ResolvedRequest& request, const Progress& progress)
{
  return Attempts(domain, request).Run(progress);
}

QuadWorkflowResult MakeFirstAttempt(
  const PlanarDomain& domain, const ResolvedRequest& request, const Progress& progress)
{
  QuadSeconds seconds;
  QuadSteps steps(domain, request, seconds);
  steps.Place(progress.Part(0.0, 0.1));
  return steps.MakeQuads(1.0, progress.Part(0.1, 1.0));
}
}
