#include "PoincareHopf.h"

#include "Error.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace crossfield
{
namespace
{
/// Returns, for every vertex of every loop, its chosen quarter index if it has one.
std::vector<std::vector<std::optional<int>>> ChosenIndices(
  const std::vector<Loop>& loops, const std::vector<CornerChoice>& choices)
{
  std::vector<std::vector<std::optional<int>>> chosen;
  std::vector<Point> vertices;
  for (const Loop& loop : loops)
  {
    chosen.emplace_back(loop.size());
    vertices.insert(vertices.end(), loop.begin(), loop.end());
  }
  const std::vector<std::size_t> matches = MatchChoices(vertices, choices);
  for (std::size_t i = 0; i < choices.size(); ++i)
  {
    std::size_t vertex = matches[i];
    std::size_t loop = 0;
    while (vertex >= loops[loop].size())
    {
      vertex -= loops[loop++].size();
    }
    chosen[loop][vertex] = choices[i].quarterIndex;
  }
  return chosen;
}
}

PoincareHopfCount CountQuarters(const std::vector<Loop>& loops, int givenInteriorQuarters,
  double cornerAngle, const std::vector<CornerChoice>& choices)
{
  PoincareHopfCount count;
  count.eulerCharacteristic = 2 - static_cast<int>(loops.size());
  count.givenInteriorQuarters = givenInteriorQuarters;
  count.hasChoices = !choices.empty();
  const auto chosen = ChosenIndices(loops, choices);
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    LoopCount part;
    for (std::size_t v = 0; v < loops[l].size(); ++v)
    {
      const Corner vertex = MakeCorner(loops, l, v);
      const double turning = vertex.Turning();
      if (!IsCorner(turning, cornerAngle) && !chosen[l][v])
      {
        part.tangentTurning += turning;
        continue;
      }
      CountedCorner corner;
      static_cast<Corner&>(corner) = vertex;
      corner.quarterIndex = chosen[l][v].value_or(SmallestRotationIndex(turning));
      corner.chosen = chosen[l][v].has_value();
      part.valence += turning - 0.5 * Pi * corner.quarterIndex;
      part.cornerQuarters += corner.quarterIndex;
      count.corners.push_back(corner);
    }
    part.valence /= 2.0 * Pi;
    part.tangentTurning /= 2.0 * Pi;
    count.valence += part.valence;
    count.tangentTurning += part.tangentTurning;
    count.loops.push_back(part);
  }
  count.requiredInteriorQuarters =
    static_cast<int>(std::lround(4.0 * (count.valence + count.tangentTurning)));
  return count;
}

double SmallestRotation(double turning)
{
  // Rounding of the coordinates may put an angle of exactly π/4 on either side.
  if (!IsTie(turning))
  {
    return std::remainder(turning, 0.5 * Pi);
  }
  if (std::abs(turning) < 0.5 * Pi)
  {
    return turning; // smooth
  }
  return turning - 0.5 * Pi * (turning > 0.0 ? 1.0 : -2.0);
}

int SmallestRotationIndex(double turning)
{
  return static_cast<int>(std::lround((turning - SmallestRotation(turning)) / (0.5 * Pi)));
}

int CountAmbiguous(const PoincareHopfCount& count)
{
  return static_cast<int>(std::count_if(count.corners.begin(), count.corners.end(),
    [](const CountedCorner& corner)
    { return !corner.chosen && IsTie(corner.Turning(), AmbiguousAngle); }));
}

std::vector<CornerChoice> CapCorners(
  const PoincareHopfCount& count, const std::vector<CornerChoice>& choices)
{
  std::vector<CornerChoice> capped = choices;
  for (const CountedCorner& corner : count.corners)
  {
    if (!corner.chosen && corner.quarterIndex > 1)
    {
      capped.push_back({ corner.position, 1 });
    }
  }
  return capped;
}

PoincareHopfCount CountMeshQuarters(
  const PlanarTopology& topology, const std::vector<CornerChoice>& choices)
{
  int given = 0;
  for (const BoundaryLoop& circle : topology.imprinted)
  {
    given += circle.quarterIndex;
  }
  for (const BoundaryLoop& loop : topology.loops)
  {
    given += loop.kind == BoundaryKind::Hole ? loop.quarterIndex : 0;
  }
  return CountQuarters(topology.AlignedLoops(), given, DefaultCornerAngle, choices);
}

std::string CrossAngle(double defect)
{
  std::ostringstream text;
  text.precision(3);
  text << 0.25 * std::abs(defect) * 180.0 / Pi << "°";
  return text.str();
}

std::string ConsistencyReason(
  const PoincareHopfCount& count, const std::vector<double>& holonomyDefects)
{
  const std::string sums = "The quarter indices of the singularities add up to " +
    std::to_string(count.givenInteriorQuarters);
  const std::string domain = std::string(" on this domain") +
    (count.hasChoices ? " with the chosen quarter indices of corners" : "");
  if (count.Consistent())
  {
    const auto defect = std::find_if(holonomyDefects.begin(), holonomyDefects.end(),
      [](double value) { return std::abs(value) > NoticeableDefect; });
    return sums + ", as the Poincaré-Hopf theorem requires" + domain +
      (defect == holonomyDefects.end() ? "."
                                       : ", but the grid lines around inner loop " +
            std::to_string(defect - holonomyDefects.begin() + 1) + " do not close up by " +
            CrossAngle(*defect) + "; move singularities until they do.");
  }
  const int missing = count.requiredInteriorQuarters - count.givenInteriorQuarters;
  const std::string difference = sums + " but the Poincaré-Hopf theorem requires " +
    std::to_string(count.requiredInteriorQuarters) + domain + "; add singularities of total " +
    std::to_string(missing);
  // Removal is certain to be possible only where the remaining sum has the sign of the given one.
  const bool removable = missing * count.givenInteriorQuarters < 0 &&
    std::abs(missing) <= std::abs(count.givenInteriorQuarters);
  return difference +
    (removable ? " or remove some of total " + std::to_string(-missing) + "." : ".");
}

void RequireConsistent(const PoincareHopfCount& count)
{
  if (!count.Consistent())
  {
    throw Error(ConsistencyReason(count), Error::Kind::Inconsistent);
  }
}
}
