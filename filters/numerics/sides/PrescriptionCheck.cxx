#include "PrescriptionCheck.h"

#include "Error.h"

#include <cmath>
#include <string>

namespace crossfield
{
namespace
{
std::string Quoted(const std::string& name)
{
  return "'" + name + "'";
}

void RequireInRange(const std::string& name, const SidePrescription& prescribed)
{
  const Progression& progression = prescribed.progression;
  const auto isPositive = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (prescribed.count < 0)
  {
    throw Error("The number of edges of side " + Quoted(name) + " is " +
      std::to_string(prescribed.count) + "; give a positive number.");
  }
  if (prescribed.size != 0.0 && !isPositive(prescribed.size))
  {
    throw Error("The size at side " + Quoted(name) + " is not a positive number; correct it.");
  }
  if (prescribed.inside != 0.0 && !isPositive(prescribed.inside))
  {
    throw Error("The size inside side " + Quoted(name) + " is not a positive number; correct it.");
  }
  if (!prescribed.isGraded)
  {
    return;
  }
  if (!isPositive(progression.ratio) || progression.first < 0.0 || progression.last < 0.0 ||
    (progression.first > 0.0) != (progression.last > 0.0) || !std::isfinite(progression.first) ||
    !std::isfinite(progression.last))
  {
    throw Error("The progression of side " + Quoted(name) +
      " is not positive; give a positive ratio of the last edge to the first, or both lengths.");
  }
}
}

void RequireConsistent(const BoundarySides& sides, const std::vector<LoopArc>& loops,
  const SidePrescriptions& prescribed)
{
  const SidesAlong along(sides, loops);
  for (const SidePrescription& one : prescribed)
  {
    const std::string& name = sides.names[one.side];
    RequireInRange(name, one);
    const bool hasLengths = one.isGraded && one.progression.HasLengths();
    if ((one.count > 0 ? 1 : 0) + (hasLengths ? 1 : 0) + (one.size > 0.0 ? 1 : 0) > 1 ||
      (one.isGraded && one.size > 0.0))
    {
      throw Error("Side " + Quoted(name) + " has more than one of a size, a number of edges and " +
        "lengths of edges, or a size and a progression; leave all but one out.");
    }
    for (std::size_t loop = 0; one.isGraded && loop < loops.size(); ++loop)
    {
      const std::vector<LoopSide>& starts = along.On(loop);
      if (starts.size() == 1 && starts[0].side == one.side &&
        loops[loop].Corners(DefaultCornerAngle).empty())
      {
        throw Error("Side " + Quoted(name) +
          " is a closed curve without a first and a last edge for a progression; divide it into "
          "sides with different names.");
      }
    }
  }
}
}
