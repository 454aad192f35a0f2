#include "BoundaryPieces.h"

#include "ArcRecognition.h"
#include "BoundaryCorners.h"
#include "CurveEvaluator.h"
#include "CurveFit.h"
#include "Error.h"
#include "SplineThrough.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
const char* NameOf(CurveDeclaration::Kind kind)
{
  constexpr std::array<const char*, 4> Names = { "line", "circle", "ellipse", "spline" };
  return Names[static_cast<std::size_t>(kind)];
}

/// Consecutive segments of a loop.
struct Run
{
  std::size_t loop = 0;
  std::size_t first = 0; ///< Vertex.
  std::size_t count = 0; ///< Number of segments.
};

/// A fitted curve and its largest distance from the points.
struct Fitted
{
  PlaneCurve curve;
  double distance = 0.0;
  Point farthest = Point::Zero();
};

/// Returns the largest distance of points from a curve.
Fitted Measure(const PlaneCurve& curve, const std::vector<Point>& points)
{
  const CurveEvaluator evaluator(curve);
  Fitted fitted{ curve, 0.0, points.front() };
  for (const Point& point : points)
  {
    const double distance = (evaluator.At(evaluator.Nearest(point)) - point).norm();
    if (distance > fitted.distance)
    {
      fitted.distance = distance;
      fitted.farthest = point;
    }
  }
  return fitted;
}

/// Declares, checks and recognises the curves of a domain.
class CurveFinder
{
public:
  CurveFinder(const PlanarDomain& domain, const BoundarySides& sides)
    : Domain(domain)
    , Sides(sides)
    , Arcs(domain.loops.begin(), domain.loops.end())
    , Reach(CurveReach * domain.Diagonal())
  {
    const SidesAlong along(sides, this->Arcs);
    for (std::size_t l = 0; l < domain.loops.size(); ++l)
    {
      const LoopArc& arc = this->Arcs[l];
      this->SideOf.emplace_back();
      for (std::size_t i = 0; i < domain.loops[l].size(); ++i)
      {
        this->SideOf.back().push_back(along.At(l, 0.5 * (arc.Start(i) + arc.Start(i + 1))));
      }
      this->Result.ofSegment.emplace_back(domain.loops[l].size(), -1);
      this->Taken.emplace_back(domain.loops[l].size(), false);
    }
  }

  void Declare(const CurveDeclaration& declaration)
  {
    RequireSide(this->Sides.names, declaration.side, " for a curve");
    const int side = this->Sides.Find(declaration.side);
    for (std::size_t l = 0; l < this->Domain.loops.size(); ++l)
    {
      for (const Run& run : this->RunsOf(l, side))
      {
        if (declaration.kind != CurveDeclaration::Kind::Line)
        {
          this->FitRun(declaration, run);
        }
        for (std::size_t i = 0; i < run.count; ++i)
        {
          this->Taken[l][(run.first + i) % this->Taken[l].size()] = true;
        }
      }
    }
  }

  /// Adds given curves where nothing is declared.
  void Add(const CurvesOfSegments& given)
  {
    std::vector<int> numbers(given.curves.size(), -1);
    const std::size_t before = this->Result.curves.size();
    std::vector<CurveEvaluator> evaluators;
    for (std::size_t l = 0; l < given.ofSegment.size(); ++l)
    {
      const Loop& loop = this->Domain.loops[l];
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        const int curve = given.ofSegment[l][i];
        if (curve < 0 || this->Taken[l][i])
        {
          continue;
        }
        const PlaneCurve& data = given.curves[curve];
        this->Taken[l][i] = true;
        if (data.kind == PlaneCurve::Kind::Line)
        {
          continue;
        }
        int& number = numbers[curve];
        if (number < 0)
        {
          number = static_cast<int>(this->Result.curves.size());
          this->Result.curves.push_back(data);
          evaluators.emplace_back(data);
        }
        const CurveEvaluator& evaluator = evaluators[static_cast<std::size_t>(number) - before];
        for (const Point& point : { loop[i], loop[(i + 1) % loop.size()] })
        {
          const double distance = (evaluator.At(evaluator.Nearest(point)) - point).norm();
          if (distance > this->Reach)
          {
            throw Error("Curve " + std::to_string(curve) + " of the domain misses the point " +
              Describe(point) + " by " + FormatNumber(distance, 2) +
              "; read its drawing again, or remove the cell array 'Curve'.");
          }
        }
        this->Result.ofSegment[l][i] = number;
      }
    }
  }

  void FindArcs()
  {
    for (std::size_t l = 0; l < this->Domain.loops.size(); ++l)
    {
      const std::size_t count = this->Domain.loops[l].size();
      for (const RecognisedArc& arc : crossfield::FindArcs(this->Domain.loops[l]))
      {
        bool isFree = true;
        for (std::size_t i = 0; i < arc.count; ++i)
        {
          isFree = isFree && !this->Taken[l][(arc.first + i) % count];
        }
        if (isFree)
        {
          this->Assign({ l, arc.first, arc.count }, arc.circle);
        }
      }
    }
  }

  CurvesOfSegments TakeResult() { return std::move(this->Result); }

private:
  /// Returns the maximal runs of segments of a side on a loop.
  std::vector<Run> RunsOf(std::size_t l, int side) const
  {
    const std::vector<int>& sideOf = this->SideOf[l];
    const std::size_t count = sideOf.size();
    if (std::all_of(sideOf.begin(), sideOf.end(), [side](int of) { return of == side; }))
    {
      return { { l, 0, count } };
    }
    std::vector<Run> runs;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (sideOf[i] == side && sideOf[(i + count - 1) % count] != side)
      {
        runs.push_back({ l, i, 0 });
        while (sideOf[(i + runs.back().count) % count] == side)
        {
          ++runs.back().count;
        }
      }
    }
    return runs;
  }

  bool IsLoop(const Run& run) const { return run.count == this->Domain.loops[run.loop].size(); }

  std::vector<Point> PointsOf(const Run& run) const
  {
    const Loop& loop = this->Domain.loops[run.loop];
    std::vector<Point> points;
    for (std::size_t i = 0; i <= run.count; ++i)
    {
      points.push_back(loop[(run.first + i) % loop.size()]);
    }
    return points;
  }

  /// Divides a run at its corners. A whole loop without corners stays whole.
  std::vector<Run> PartsOf(const Run& run) const
  {
    const Loop& loop = this->Domain.loops[run.loop];
    const std::vector<double> turns = this->Arcs[run.loop].Turns();
    std::vector<std::size_t> cuts;
    for (std::size_t i = this->IsLoop(run) ? 0 : 1; i < run.count; ++i)
    {
      if (IsCorner(turns[(run.first + i) % loop.size()]))
      {
        cuts.push_back(i);
      }
    }
    if (cuts.empty())
    {
      return { run };
    }
    std::vector<Run> parts;
    if (this->IsLoop(run))
    {
      cuts.push_back(cuts.front() + run.count);
    }
    else
    {
      cuts.insert(cuts.begin(), 0);
      cuts.push_back(run.count);
    }
    for (std::size_t i = 1; i < cuts.size(); ++i)
    {
      parts.push_back({ run.loop, (run.first + cuts[i - 1]) % loop.size(), cuts[i] - cuts[i - 1] });
    }
    return parts;
  }

  /// Returns whether a run is a loop without a corner at its first vertex, a closed curve.
  bool IsClosedCurve(const Run& run) const
  {
    return this->IsLoop(run) && !IsCorner(this->Arcs[run.loop].Turns()[run.first]);
  }

  Fitted Fit(CurveDeclaration::Kind kind, const Run& run) const
  {
    std::vector<Point> points = this->PointsOf(run);
    const bool isClosed = this->IsLoop(run);
    const FitEnds ends = isClosed ? FitEnds::Free : FitEnds::Fixed;
    if (isClosed)
    {
      points.pop_back(); // the first one again
    }
    return Measure(
      kind == CurveDeclaration::Kind::Circle ? FitCircle(points, ends) : FitEllipse(points, ends),
      points);
  }

  void FitRun(const CurveDeclaration& declaration, const Run& run)
  {
    if (declaration.kind == CurveDeclaration::Kind::Spline)
    {
      for (const Run& part : this->PartsOf(run))
      {
        std::vector<Point> points = this->PointsOf(part);
        const bool isClosed = this->IsClosedCurve(part);
        if (isClosed)
        {
          points.pop_back();
        }
        if (points.size() > 2) // two points are a line
        {
          this->Assign(part, SplineThrough(points, isClosed));
        }
      }
      return;
    }
    try
    {
      // One curve for all of it, also across vertices that turn like corners: a coarse polygon.
      const Fitted whole = this->Fit(declaration.kind, run);
      if (whole.distance <= this->Reach)
      {
        this->Assign(run, whole.curve);
        return;
      }
      const std::vector<Run> parts = this->PartsOf(run);
      std::vector<Fitted> fitted;
      for (const Run& part : parts)
      {
        fitted.push_back(parts.size() == 1 ? whole : this->Fit(declaration.kind, part));
        if (fitted.back().distance > this->Reach)
        {
          throw Error("Side '" + declaration.side + "' is no " + NameOf(declaration.kind) +
            ": the nearest one misses the point " + Describe(fitted.back().farthest) + " by " +
            FormatNumber(fitted.back().distance, 2) + ", and " + FormatNumber(this->Reach, 2) +
            " is the most; declare another curve for it, or spline.");
        }
      }
      for (std::size_t i = 0; i < parts.size(); ++i)
      {
        this->Assign(parts[i], fitted[i].curve);
      }
    }
    catch (const Error& error)
    {
      const std::string message = error.what();
      if (message.rfind("Side '", 0) == 0)
      {
        throw;
      }
      throw Error("Side '" + declaration.side + "' is declared as " + NameOf(declaration.kind) +
        ". " + message.substr(0, message.size() - 1) + "; declare another curve for it, or line.");
    }
  }

  void Assign(const Run& run, const PlaneCurve& curve)
  {
    std::vector<int>& of = this->Result.ofSegment[run.loop];
    for (std::size_t i = 0; i < run.count; ++i)
    {
      of[(run.first + i) % of.size()] = static_cast<int>(this->Result.curves.size());
    }
    this->Result.curves.push_back(curve);
  }

  const PlanarDomain& Domain;
  const BoundarySides& Sides;
  const std::vector<LoopArc> Arcs;
  const double Reach;
  std::vector<std::vector<int>> SideOf; ///< Per loop and segment.
  std::vector<std::vector<bool>> Taken; ///< Segments that are declared or given.
  CurvesOfSegments Result;
};

BoundarySides AsSides(const CurvedBoundary& boundary)
{
  BoundarySides sides;
  for (const CurveStart& start : boundary.starts)
  {
    sides.starts.push_back({ start.place, start.curve, false, start.loop });
  }
  return sides;
}
}

CurvesOfSegments FindCurves(const PlanarDomain& domain, const BoundarySides& sides,
  const CurveRequest& request, const CurvesOfSegments& given)
{
  CurveFinder finder(domain, sides);
  for (std::size_t i = 0; i < request.declared.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if (request.declared[j].side == request.declared[i].side)
      {
        throw Error(
          "The side '" + request.declared[i].side + "' has two curves; give one of them.");
      }
    }
    finder.Declare(request.declared[i]);
  }
  finder.Add(given);
  if (request.findsArcs)
  {
    finder.FindArcs();
  }
  return finder.TakeResult();
}

CurvedBoundary PiecesOf(const PlanarDomain& domain, const CurvesOfSegments& curves)
{
  CurvedBoundary boundary;
  boundary.curves = curves.curves;
  for (std::size_t l = 0; l < curves.ofSegment.size(); ++l)
  {
    const std::vector<int>& of = curves.ofSegment[l];
    const std::size_t count = of.size();
    if (std::all_of(of.begin(), of.end(), [](int curve) { return curve < 0; }))
    {
      continue;
    }
    const std::size_t before = boundary.starts.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      if (of[i] != of[(i + count - 1) % count])
      {
        boundary.starts.push_back({ domain.loops[l][i], of[i] });
      }
    }
    if (boundary.starts.size() == before)
    {
      boundary.starts.push_back({ domain.loops[l][0], of[0] });
    }
  }
  return boundary;
}

CurvesAlong::CurvesAlong(const CurvedBoundary& boundary, const std::vector<LoopArc>& loops)
  : Along(AsSides(boundary), loops)
{
}

std::vector<double> CurvesAlong::StartsOn(std::size_t loop) const
{
  std::vector<double> starts;
  for (const LoopSide& start : this->Along.On(loop))
  {
    starts.push_back(start.at);
  }
  return starts;
}
}
