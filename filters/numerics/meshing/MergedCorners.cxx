#include "MergedCorners.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Runs of corners, each at most a length from the last: [begin, end] along the loop, `end` maybe beyond its length.
std::vector<std::pair<double, double>> RunsOf(
  const std::vector<double>& corners, double round, double length)
{
  std::vector<std::pair<double, double>> runs;
  for (const double corner : corners)
  {
    if (!runs.empty() && corner - runs.back().second <= length)
    {
      runs.back().second = corner;
    }
    else
    {
      runs.emplace_back(corner, corner);
    }
  }
  if (runs.size() > 1 && runs.front().first + round - runs.back().second <= length)
  {
    runs.back().second = runs.front().second + round;
    runs.erase(runs.begin());
  }
  return runs;
}

/// What a run of corners, and what is between them, turns by; to the left, into the domain, positive.
double TurnOf(const LoopArc& arc, const std::vector<double>& turns, double begin, double end)
{
  const std::size_t last = arc.NearestVertex(end);
  std::size_t vertex = arc.NearestVertex(begin);
  double turn = turns[vertex];
  while (vertex != last)
  {
    vertex = (vertex + 1) % turns.size();
    turn += turns[vertex];
  }
  return turn;
}

/// A side to a merged corner leads past where the boundary was by half of the run's length; so it is that many times as long
/// as the run where the boundary is smooth enough, and turns by little.
constexpr double SideOfMerged = 8.0;
/// And at least so many times: else corners are not merged.
constexpr double LeastSideOfMerged = 2.0;

/// Of the way from the end of a run of corners on, in one direction.
struct Approach
{
  double absorbed = 0.0; ///< How far the last vertex is that goes.
  double next = 0.0;     ///< How far the first one is that does not.
};

Approach FindApproach(const LoopArc& arc, const std::vector<double>& turns,
  const std::vector<double>& given, double from, bool forward, double reach,
  const Thinning& thinning)
{
  const std::size_t count = turns.size();
  const auto wayTo = [&](double at)
  {
    const double way = forward ? at - from : from - at;
    return way - std::floor((way - thinning.rounding) / arc.Length()) * arc.Length();
  };
  double nearestGiven = arc.Length();
  for (const double at : given)
  {
    nearestGiven = std::min(nearestGiven, wayTo(at));
  }
  std::size_t vertex = arc.NearestVertex(from);
  Approach approach;
  double turn = 0.0;
  for (std::size_t steps = 1; steps < count; ++steps)
  {
    vertex = forward ? (vertex + 1) % count : (vertex + count - 1) % count;
    const double way = wayTo(arc.Start(vertex));
    turn += std::abs(turns[vertex]);
    if (way > reach || turn > thinning.turn || way > nearestGiven - thinning.rounding)
    {
      approach.next = std::min(way, nearestGiven);
      break;
    }
    approach.absorbed = way;
  }
  return approach;
}

}

//------------------------------------------------------------------------------
KeptPlaces FindKeptPlaces(const LoopArc& arc, const std::vector<double>& turns, double cornerAngle,
  const std::vector<double>& given, const Thinning& thinning)
{
  const std::vector<double> corners = arc.Corners(cornerAngle);
  KeptPlaces kept;
  std::vector<bool> isTaken(given.size(), false);
  for (const auto& [begin, end] : RunsOf(corners, arc.Length(), thinning.length))
  {
    std::vector<double> inside;
    for (std::size_t i = 0; i < given.size(); ++i)
    {
      for (const double at : { given[i], given[i] + arc.Length() })
      {
        if (at >= begin - thinning.rounding && at <= end + thinning.rounding)
        {
          inside.push_back(at);
          isTaken[i] = true;
        }
      }
    }
    const double span = end - begin;
    if (span == 0.0)
    {
      kept.places.push_back(begin);
      continue;
    }
    if (span <= thinning.length && inside.size() < 2 &&
      TurnOf(arc, turns, begin, end) <= Pi - cornerAngle)
    {
      const double reach = SideOfMerged * span;
      const Approach before = FindApproach(arc, turns, given, begin, false, reach, thinning);
      const Approach after = FindApproach(arc, turns, given, end, true, reach, thinning);
      if (std::min(before.next, after.next) >= LeastSideOfMerged * span)
      {
        kept.places.push_back(inside.empty() ? 0.5 * (begin + end) : inside[0]);
        kept.merged.emplace_back(begin - before.absorbed, end + after.absorbed);
        continue;
      }
    }
    kept.places.insert(kept.places.end(), inside.begin(), inside.end());
    for (const double start : { 0.0, arc.Length() })
    {
      const auto from = std::lower_bound(corners.begin(), corners.end(), begin - start);
      const auto to = std::upper_bound(corners.begin(), corners.end(), end - start);
      kept.places.insert(kept.places.end(), from, std::max(from, to));
    }
  }
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    if (!isTaken[i])
    {
      kept.places.push_back(given[i]);
    }
  }
  return kept;
}

}
