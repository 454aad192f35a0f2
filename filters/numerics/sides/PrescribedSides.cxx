#include "PrescribedSides.h"

#include "Error.h"
#include "SideArcs.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Throws Error unless a first and a last edge fit on a part of a side.
void RequireRoom(const std::string& name, const Progression& progression, double length)
{
  const double available = progression.both ? 0.5 * length : length;
  if (progression.first + progression.last > available)
  {
    throw Error("Edges of lengths " + FormatNumber(progression.first) + " and " +
      FormatNumber(progression.last) + " do not fit on side '" + name +
      "', which has a part of length " + FormatNumber(length) +
      (progression.both ? " for both ends" : "") + "; give smaller lengths.");
  }
}

/// Returns the range of counts with which all edges of a part have a size within the tolerance.
std::pair<int, int> RangeFor(double length, double size)
{
  const auto least = static_cast<int>(std::ceil(length / ((1.0 + SizeTolerance) * size)));
  const auto most = static_cast<int>(std::floor(length / ((1.0 - SizeTolerance) * size)));
  const int nearest = std::max(1, static_cast<int>(std::lround(length / size)));
  return least <= most && most > 0 ? std::pair(std::max(1, least), most)
                                   : std::pair(nearest, nearest);
}

/// Returns the sum of the counts of arcs, within bounds.
CountSum SumOf(const std::vector<int>& arcs, int minimum, int maximum, std::string name)
{
  CountSum sum;
  for (const int arc : arcs)
  {
    sum.terms.emplace_back(arc, 1);
  }
  sum.minimum = minimum;
  sum.maximum = maximum;
  sum.name = std::move(name);
  return sum;
}
}

std::vector<CountSum> PrescribedSums(const SeamlessMap& map, const MeshBoundary& curves,
  const BoundarySides& sides, const SidePrescriptions& prescribed, const TMesh& mesh)
{
  std::vector<CountSum> sums;
  if (prescribed.empty())
  {
    return sums;
  }
  const SideArcs arcs(map, curves, sides, mesh);
  for (const SidePrescription& one : prescribed)
  {
    const std::string& name = sides.names[one.side];
    if (one.count > 0)
    {
      sums.push_back(
        SumOf(arcs.Of(one.side), one.count, one.count, name + ":" + std::to_string(one.count)));
    }
    const bool hasLengths = one.isGraded && one.progression.HasLengths();
    if (one.size <= 0.0 && !hasLengths)
    {
      continue;
    }
    for (const std::vector<int>& part : arcs.PartsOf(one.side))
    {
      const double length = arcs.LengthOf(part);
      if (hasLengths)
      {
        RequireRoom(name, one.progression, length);
        const int count = CountForLengths(length, one.progression);
        sums.push_back(SumOf(part, count, count,
          "the lengths " + FormatNumber(one.progression.first) + "," +
            FormatNumber(one.progression.last) + " on " + name));
      }
      else
      {
        const auto [minimum, maximum] = RangeFor(length, one.size);
        sums.push_back(
          SumOf(part, minimum, maximum, "the size " + FormatNumber(one.size) + " at " + name));
      }
    }
  }
  return sums;
}
}
