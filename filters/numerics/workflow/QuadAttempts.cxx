#include "QuadAttempts.h"

#include "LayerSteps.h"
#include "MeshGrade.h"
#include "OptimizerReport.h"
#include "Outcome.h"
#include "PoincareHopf.h"
#include "QuadAdvice.h"
#include "QuadSteps.h"

#include <algorithm>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// Factor of the distance from layers for the next attempt: rows are higher than the quads on average in some
/// places, for example at corners that they turn around.
constexpr double Farther = 1.3;
/// Largest distance that is tried: chosen singularities move away three times.
constexpr double Farthest = Farther * Farther * Farther;
/// Factor of the edges of the second triangle mesh.
constexpr double Finer = 2.0;

/// Returns whether a domain with inner loops needs no singularities, and layers or sizes of sides are
/// requested: around a profile that gives a C-grid or an O-grid.
bool MayDoWithout(const PlanarDomain& domain, const QuadRequest& request)
{
  const bool isSized = std::any_of(request.prescribed.begin(), request.prescribed.end(),
    [](const SidePrescription& one) { return one.size > 0.0; });
  if (request.singularities || (request.layers.empty() && !isSized) || domain.loops.size() < 2)
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
QuadRequest RequestOf(const QuadRequest& request, const QuadAttempt& attempt)
{
  QuadRequest result = request;
  if (!attempt.hasSingularities)
  {
    result.singularities = Configuration();
  }
  result.layerDistance = attempt.layerDistance;
  return result;
}

/// Returns whether two attempts have the same singularities, before the holonomy is repaired without
/// request.
bool HaveSamePlaces(const QuadAttempt& a, const QuadAttempt& b)
{
  return a.hasSingularities == b.hasSingularities && a.layerDistance == b.layerDistance;
}

/// Returns the attempt as words, and its result.
std::string DescribeRecord(const QuadRequest& request, const QuadAttemptRecord& record)
{
  const QuadAttempt& attempt = record.attempt;
  std::string text = !attempt.hasSingularities ? "Without singularities"
    : request.singularities                    ? "With the given singularities"
                                               : "With chosen singularities";
  text += attempt.layerDistance > 1.0
    ? ", " + FormatShort(attempt.layerDistance) + " times as far from layers"
    : "";
  text += attempt.repairsHolonomy ? ", with the holonomy repaired" : "";
  text += attempt.refinement > 1.0 ? ", on a finer triangle mesh" : "";
  text += !attempt.mergesBlocks ? ", without merging blocks" : "";
  return text + ": " + record.result;
}

/// Returns the number of quads, their shape and the number of blocks.
std::string DescribeQuads(const QuadResult& quads)
{
  const int inverted = quads.quality.inverted;
  return std::to_string(quads.mesh.quads.size()) + " quads in " +
    std::to_string(quads.blocks.blocks.size()) + " blocks, minimum scaled Jacobian " +
    FormatShort(quads.quality.jacobian.min) +
    (inverted > 0 ? ", " + std::to_string(inverted) + " inverted." : ".");
}

/// The attempts of one request.
class Attempts
{
public:
  Attempts(const PlanarDomain& domain, const QuadRequest& request)
    : Domain(domain)
    , Request(request)
  {
  }

  QuadWorkflowResult Run(const Progress& progress)
  {
    double done = 0.0;
    while (const std::optional<QuadAttempt> attempt =
             NextAttempt(this->Domain, this->Request, this->Made))
    {
      // Most requests take one attempt; the others share what it leaves.
      constexpr double Most = 0.9;
      const double end = done + Most * (1.0 - done);
      const Progress part = progress.Part(done, end);
      Outcome<QuadWorkflowResult> outcome = Try([&] { return this->Make(*attempt, part); });
      done = end;
      this->Store(*attempt, std::move(outcome));
    }
    if (!this->Best)
    {
      throw this->FinalError();
    }
    this->Best->seconds = this->Seconds;
    for (const QuadAttemptRecord& record : this->Made)
    {
      this->Best->attempts.push_back(DescribeRecord(this->Request, record));
    }
    return std::move(*this->Best);
  }

private:
  /// Makes an attempt. Singularities are placed once for all attempts with the same.
  QuadWorkflowResult Make(const QuadAttempt& attempt, const Progress& progress)
  {
    // Half of it if singularities are chosen.
    const double placed = this->Request.singularities ? 0.1 : 0.5;
    if (!this->Placed || !HaveSamePlaces(this->Made.back().attempt, attempt))
    {
      this->Placed.reset();
      QuadSteps steps(this->Domain, RequestOf(this->Request, attempt), this->Seconds);
      steps.Place(progress.Part(0.0, placed));
      this->Placed.emplace(std::move(steps));
    }
    QuadSteps steps = *this->Placed;
    if (!attempt.mergesBlocks)
    {
      steps.DoNotMerge();
    }
    this->AddEvents(attempt, steps);
    if (attempt.repairsHolonomy)
    {
      steps.RepairHolonomy();
    }
    return steps.MakeQuads(attempt.refinement, progress.Part(placed, 1.0));
  }

  /// Adds why earlier attempts with the same singularities had no layout.
  void AddEvents(const QuadAttempt& attempt, QuadSteps& steps) const
  {
    for (const QuadAttemptRecord& record : this->Made)
    {
      if (!HaveSamePlaces(record.attempt, attempt) || !record.error ||
        record.error->GetKind() != Error::Kind::CoarseMesh)
      {
        continue;
      }
      const std::string why = record.error->what();
      steps.AddEvent(record.attempt.refinement == 1.0
          ? "The triangle mesh was refined once, to edges half as long. With the first mesh: " + why
          : "The singularities were moved so that grid lines close up around the inner loops. "
            "Without this: " +
            why);
    }
  }

  /// Stores what an attempt led to, and its quads if they are the best.
  void Store(const QuadAttempt& attempt, Outcome<QuadWorkflowResult> outcome)
  {
    QuadAttemptRecord record{ attempt, std::move(outcome.error), false, {} };
    if (record.error)
    {
      record.result = record.error->what();
      this->Made.push_back(std::move(record));
      return;
    }
    QuadWorkflowResult& result = *outcome.value;
    const QuadQuality& quality = result.quads.quality;
    record.result = DescribeQuads(result.quads);
    record.isGood =
      quality.inverted == 0 && quality.jacobian.min >= AcceptableShape * quality.bound;
    if (!attempt.hasSingularities)
    {
      result.events.insert(
        result.events.begin(), "The grid lines around the inner loops need no singularities.");
    }
    if (!attempt.mergesBlocks)
    {
      result.events.push_back(
        "Blocks were not merged, because that leaves too few rows for the layers.");
    }
    if (attempt.repairsHolonomy && this->Request.singularities)
    {
      this->Repair = std::move(result.repair); // an offer: given singularities are not moved
    }
    else if ((attempt.hasSingularities || quality.inverted == 0) &&
      (!this->Best || this->GradeOfQuads(result) < this->GradeOfQuads(*this->Best)))
    {
      this->Best = std::move(result);
    }
    this->Made.push_back(std::move(record));
  }

  MeshGrade GradeOfQuads(const QuadWorkflowResult& result) const
  {
    return GradeOf(result.quads, this->Request.quadSize, this->Request.quadCount);
  }

  /// Returns the error of the last attempt that did not repair the holonomy without request, with the
  /// remedy that follows from the other attempts.
  Error FinalError() const
  {
    const Error& error = *std::find_if(this->Made.rbegin(), this->Made.rend(),
      [](const QuadAttemptRecord& record)
      {
        return record.error &&
          (!record.attempt.repairsHolonomy || record.error->GetKind() == Error::Kind::LackOfRows);
      })->error;
    if (this->Repair)
    {
      return { error.GetCause(), RepairAdvice(*this->Repair), Error::Kind::BadInput };
    }
    if (error.GetKind() == Error::Kind::LackOfRows)
    {
      return { error.GetCause(),
        this->Request.singularities
          ? error.GetRemedy() + ", or leave them out, and others are chosen"
          : "use smaller quads, or a larger growth",
        error.GetKind() };
    }
    return error;
  }

  const PlanarDomain& Domain;
  const QuadRequest& Request;
  std::vector<QuadAttemptRecord> Made;
  std::optional<QuadSteps> Placed; ///< After Place, of the last attempt.
  std::optional<QuadWorkflowResult> Best;
  std::optional<HolonomyRepair> Repair; ///< Of given singularities, if it leads to quads.
  QuadSeconds Seconds;
};
}

std::optional<QuadAttempt> NextAttempt(const PlanarDomain& domain, const QuadRequest& request,
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
  const bool isCoarse = last.error && last.error->GetKind() == Error::Kind::CoarseMesh;
  if (isCoarse && next.refinement == 1.0)
  {
    next.refinement = Finer;
    return next;
  }
  const bool hasInnerLoops = domain.loops.size() > 1;
  if (isCoarse && hasInnerLoops && !next.repairsHolonomy && !request.repairHolonomy)
  {
    next.repairsHolonomy = true;
    next.refinement = 1.0;
    return next;
  }
  if (!last.attempt.hasSingularities)
  {
    return last.isGood ? std::nullopt : std::optional<QuadAttempt>(QuadAttempt());
  }
  if (last.error && last.error->GetKind() == Error::Kind::LackOfRows)
  {
    next.refinement = 1.0;
    next.repairsHolonomy = false;
    if (next.mergesBlocks && request.merge == BlockMerge::Clean)
    {
      next.mergesBlocks = false;
      return next;
    }
    next.layerDistance *= Farther;
    if (!request.singularities && next.layerDistance <= Farthest)
    {
      return next;
    }
  }
  return std::nullopt;
}

QuadWorkflowResult MakeAttempts(
  const PlanarDomain& domain, const QuadRequest& request, const Progress& progress)
{
  return Attempts(domain, request).Run(progress);
}
}
