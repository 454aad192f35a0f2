#include "BoundaryOrder.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Points along a loop from one fixed point to the next, or once around a loop without fixed points,
/// with lengths that do not jump at the start of the loop.
struct Run
{
  std::vector<int> points;
  std::vector<double> at;
  std::vector<double> ideal; ///< Its edges in proportion to their target lengths.
  double loop = 0.0;         ///< Length of the loop.
};

/// The boundary edge that starts at a point.
struct Step
{
  int next = -1;
  double target = 0.0;
};

std::vector<Step> StepsOf(const QuadMesh& mesh)
{
  std::vector<Step> steps(mesh.points.size());
  const std::vector<int> twins = mesh.Twins();
  for (std::size_t side = 0; side < twins.size(); ++side)
  {
    if (twins[side] < 0)
    {
      const std::array<int, 4>& quad = mesh.quads[side / 4];
      steps[quad[side % 4]] = { quad[(side + 1) % 4], mesh.targetLengths[side / 4][side % 2] };
    }
  }
  return steps;
}

/// Sets the lengths of a run: forwards from place to place, if that leads around the loop at most
/// once, otherwise those of LengthAlong.
void Unwrap(const std::vector<CurvePlace>& places, Run& run)
{
  const auto forwards = [&run](double length)
  { return length - run.loop * std::floor(length / run.loop); };
  const double once = places.back().at == places.front().at
    ? run.loop
    : forwards(places.back().at - places.front().at);
  run.at = { places.front().at };
  for (std::size_t i = 1; i < places.size(); ++i)
  {
    run.at.push_back(run.at.back() + forwards(places[i].at - places[i - 1].at));
  }
  // Out of order, the edges go around once more for every edge that leads backwards.
  if (run.at.back() - run.at.front() > once + 0.5 * run.loop)
  {
    for (std::size_t i = 1; i < places.size(); ++i)
    {
      run.at[i] = run.at[i - 1] + LengthAlong(places[i - 1], places[i], run.loop);
    }
  }
  run.at.back() = run.at.front() + once;
}

/// Replaces the ideal lengths by equal ones if an ideal edge is too long.
void ShortenIdeal(Run& run)
{
  for (std::size_t i = 1; i < run.ideal.size(); ++i)
  {
    if (run.ideal[i] - run.ideal[i - 1] > LongestPartAtStart * run.loop)
    {
      const double length = run.ideal.back() - run.ideal.front();
      for (std::size_t j = 1; j + 1 < run.ideal.size(); ++j)
      {
        run.ideal[j] = run.ideal.front() +
          length * static_cast<double>(j) / static_cast<double>(run.ideal.size() - 1);
      }
      return;
    }
  }
}

/// Follows the boundary from a point to the next fixed point, or back to it.
Run FollowFrom(
  int start, const std::vector<Step>& steps, const QuadMesh& mesh, const BoundaryCurves& curves)
{
  Run run;
  run.loop = curves.Length(mesh.points[start].curve.loop);
  run.points = { start };
  std::vector<CurvePlace> places = { mesh.points[start].curve };
  std::vector<double> targets = { 0.0 };
  do
  {
    const Step& step = steps[run.points.back()];
    run.points.push_back(step.next);
    places.push_back(mesh.points[step.next].curve);
    targets.push_back(targets.back() + step.target);
  } while (run.points.back() != start && !mesh.points[run.points.back()].fixed);
  Unwrap(places, run);
  for (const double target : targets)
  {
    run.ideal.push_back(
      run.at.front() + (run.at.back() - run.at.front()) * target / targets.back());
  }
  ShortenIdeal(run);
  return run;
}

/// Returns whether every edge of a run is at least a part of its ideal length and, with part > 0, at
/// most LongestPartAtStart.
bool IsSpread(const Run& run, double part)
{
  for (std::size_t i = 1; i < run.at.size(); ++i)
  {
    const double length = run.at[i] - run.at[i - 1];
    if (length < part * (run.ideal[i] - run.ideal[i - 1]) ||
      (part > 0.0 && length > LongestPartAtStart * run.loop))
    {
      return false;
    }
  }
  return true;
}

/// Moves the lengths of a run towards the ideal ones until they are spread. Its ends stay.
void Spread(Run& run)
{
  // Shortest edge, relative to the ideal one, of a run that has to be changed.
  constexpr double Shortest = 0.1;
  const std::vector<double> given = run.at;
  for (double part = 0.1; !IsSpread(run, Shortest) && part < 1.05; part += 0.1)
  {
    for (std::size_t i = 0; i < given.size(); ++i)
    {
      run.at[i] = (1.0 - part) * given[i] + part * run.ideal[i];
    }
  }
}

}

double LengthAlong(const CurvePlace& from, const CurvePlace& to, double loop)
{
  constexpr double Shift = 0.2;
  const double length = to.at - from.at;
  return length - loop * std::floor(length / loop + Shift);
}

bool HasLongEdges(const QuadMesh& mesh, const BoundaryCurves& curves, double part)
{
  return std::any_of(mesh.boundary.begin(), mesh.boundary.end(),
    [&](const QuadBoundaryEdge& edge)
    {
      const CurvePlace& from = mesh.points[edge.points[0]].curve;
      const CurvePlace& to = mesh.points[edge.points[1]].curve;
      const double loop = curves.Length(from.loop);
      return from.loop == to.loop && LengthAlong(from, to, loop) > part * loop;
    });
}

void OrderOnBoundary(QuadMesh& mesh, const BoundaryCurves& curves, double shortest)
{
  const std::vector<Step> steps = StepsOf(mesh);
  std::vector<bool> done(mesh.points.size(), false);
  const auto order = [&](int start)
  {
    Run run = FollowFrom(start, steps, mesh, curves);
    const bool changes = !IsSpread(run, shortest);
    if (changes)
    {
      Spread(run);
    }
    for (std::size_t i = 0; i + 1 < run.points.size(); ++i)
    {
      QuadPoint& point = mesh.points[run.points[i]];
      done[run.points[i]] = true;
      if (changes && i > 0)
      {
        point.curve.at = run.at[i];
        point.MoveToCurve(curves);
      }
    }
  };
  for (const bool fixed : { true, false })
  {
    for (int point = 0; point < static_cast<int>(steps.size()); ++point)
    {
      if (steps[point].next >= 0 && mesh.points[point].fixed == fixed && !done[point])
      {
        order(point);
      }
    }
  }
}
}
