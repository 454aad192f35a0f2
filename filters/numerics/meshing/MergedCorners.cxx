#include "MergedCorners.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Returns the runs [begin, end] of corners, each at most `length` from the previous one; `end` may
/// exceed the length of the loop.
std::vector<std::pair<double, double>> FindRuns(
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

/// Returns the total turning angle of a run of corners and the vertices between them, positive to
/// the left, into the domain.
double TotalTurning(const LoopArc& arc, const std::vector<double>& turns, double begin, double end)
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

/// Length of the sides next to a merged corner, relative to the length of its run of corners. Such
/// a side deviates from the original boundary by half of the run's length, so it is long and turns
/// by a small angle where the boundary is smooth enough.
constexpr double SideOfMerged = 8.0;
/// Minimum length of these sides relative to the run; otherwise the corners are not merged.
constexpr double MinimumSideOfMerged = 2.0;

/// Distances of the vertices next to a run of corners, in one direction.
struct Approach
{
  double absorbed = 0.0; ///< Distance of the last vertex that is removed.
  double next = 0.0;     ///< Distance of the first vertex that is retained.
};

Approach FindApproach(const LoopArc& arc, const std::vector<double>& turns,
  const std::vector<double>& given, double from, bool forward, double reach,
  const Thinning& thinning)
{
  const std::size_t count = turns.size();
  const auto distanceTo = [&](double at)
  {
    const double distance = forward ? at - from : from - at;
    return distance - std::floor((distance - thinning.rounding) / arc.Length()) * arc.Length();
  };
  double nearestGiven = arc.Length();
  for (const double at : given)
  {
    nearestGiven = std::min(nearestGiven, distanceTo(at));
  }
  std::size_t vertex = arc.NearestVertex(from);
  Approach approach;
  double turn = 0.0;
  for (std::size_t steps = 1; steps < count; ++steps)
  {
    vertex = forward ? (vertex + 1) % count : (vertex + count - 1) % count;
    const double distance = distanceTo(arc.Start(vertex));
    turn += std::abs(turns[vertex]);
    if (distance > reach || turn > thinning.turn || distance > nearestGiven - thinning.rounding)
    {
      approach.next = std::min(distance, nearestGiven);
      break;
    }
    approach.absorbed = distance;
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
  std::vector<bool> isMerged(given.size(), false);
  for (const auto& [begin, end] : FindRuns(corners, arc.Length(), thinning.length))
  {
    std::vector<double> inside;
    for (std::size_t i = 0; i < given.size(); ++i)
    {
      for (const double at : { given[i], given[i] + arc.Length() })
      {
        if (at >= begin - thinning.rounding && at <= end + thinning.rounding)
        {
          inside.push_back(at);
          isMerged[i] = true;
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
      TotalTurning(arc, turns, begin, end) <= Pi - cornerAngle)
    {
      const double reach = SideOfMerged * span;
      const Approach before = FindApproach(arc, turns, given, begin, false, reach, thinning);
      const Approach after = FindApproach(arc, turns, given, end, true, reach, thinning);
      if (std::min(before.next, after.next) >= MinimumSideOfMerged * span)
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
    if (!isMerged[i])
    {
      kept.places.push_back(given[i]);
    }
  }
  return kept;
}

}
