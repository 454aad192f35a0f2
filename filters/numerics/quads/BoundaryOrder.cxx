#include "BoundaryOrder.h"

#include "Index.h"

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
  int loop = 0;
  std::vector<int> points;
  std::vector<double> at;
};

/// Follows the boundary from a point to the next fixed point, or back to it.
Run FollowFrom(
  int start, const std::vector<int>& next, const QuadMesh& mesh, const BoundaryCurves& curves)
{
  const CurvePlace& first = mesh.points[Index(start)].curve;
  const double loop = curves.Length(first.loop);
  Run run{ first.loop, { start }, { first.at } };
  for (int point = start;;)
  {
    const int following = next[Index(point)];
    run.at.push_back(run.at.back() +
      LengthAlong(mesh.points[Index(point)].curve, mesh.points[Index(following)].curve, loop));
    run.points.push_back(following);
    point = following;
    if (point == start || mesh.points[Index(point)].fixed)
    {
      break;
    }
  }
  if (run.points.back() == start)
  {
    run.at.back() = run.at.front() + loop;
  }
  return run;
}

/// Puts the lengths of a run in order. Its ends stay. Returns whether it had to change them.
bool Order(Run& run)
{
  const std::vector<double> given = run.at;
  const auto edges = static_cast<double>(given.size() - 1);
  const double mean = (given.back() - given.front()) / edges;
  // Shortest edge, relative to the mean, of a run that has to be changed.
  constexpr double Shortest = 0.1;
  const auto isOrdered = [&run](double shortest)
  {
    return std::adjacent_find(run.at.begin(), run.at.end(),
             [&](double a, double b) { return b - a < shortest; }) == run.at.end();
  };
  if (isOrdered(0.0))
  {
    return false;
  }
  for (double part = 0.1; !isOrdered(Shortest * mean) && part < 1.05; part += 0.1)
  {
    for (std::size_t i = 0; i < given.size(); ++i)
    {
      run.at[i] = (1.0 - part) * given[i] + part * (given.front() + mean * static_cast<double>(i));
    }
  }
  return true;
}
}

double LengthAlong(const CurvePlace& from, const CurvePlace& to, double loop)
{
  constexpr double Shift = 0.2;
  const double length = to.at - from.at;
  return length - loop * std::floor(length / loop + Shift);
}

void OrderOnBoundary(QuadMesh& mesh, const BoundaryCurves& curves)
{
  std::vector<int> next(mesh.points.size(), -1);
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    next[Index(edge.points[0])] = edge.points[1];
  }
  std::vector<bool> done(mesh.points.size(), false);
  const auto order = [&](int start)
  {
    Run run = FollowFrom(start, next, mesh, curves);
    const bool changed = Order(run);
    for (std::size_t i = 0; i + 1 < run.points.size(); ++i)
    {
      QuadPoint& point = mesh.points[Index(run.points[i])];
      done[Index(run.points[i])] = true;
      if (changed && i > 0)
      {
        point.curve.at = run.at[i];
        point.place = curves.At(point.curve);
      }
    }
  };
  for (const bool fixed : { true, false })
  {
    for (int point = 0; point < static_cast<int>(next.size()); ++point)
    {
      if (next[Index(point)] >= 0 && mesh.points[Index(point)].fixed == fixed &&
        !done[Index(point)])
      {
        order(point);
      }
    }
  }
}
}
