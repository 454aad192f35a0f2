#include "CountCheck.h"

#include "Error.h"
#include "QuadQuality.h"
#include "QuadSides.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
void RequireSuitableCounts(const QuadMesh& mesh, double area, const BoundarySides& sides,
  const SidePrescriptions& prescribed)
{
  // On a channel with a cylinder, counts that differ by a factor of 13 are smoothed in five times the usual time, and those
  // that differ by 22 in 25 to 60 times.
  constexpr double LargestFactor = 16.0;
  const double size = std::sqrt(area / static_cast<double>(mesh.quads.size()));
  std::string described;
  std::string suitable;
  std::vector<SideMeasure> measures;
  for (const SidePrescription& one : prescribed)
  {
    if (one.count == 0)
    {
      continue;
    }
    measures = measures.empty() ? MeasureSides(mesh) : measures;
    const std::string& name = sides.names[one.side];
    const auto side = std::find(mesh.sideNames.begin(), mesh.sideNames.end(), name);
    if (side == mesh.sideNames.end())
    {
      continue;
    }
    const double usual = std::max(1.0, measures[side - mesh.sideNames.begin()].length / size);
    if (std::max(one.count / usual, usual / one.count) > LargestFactor)
    {
      described += (described.empty() ? "" : " and ") + std::to_string(one.count) +
        " edges on side '" + name + "'";
      suitable += (suitable.empty() ? "" : " and ") + std::to_string(std::lround(usual));
    }
  }
  if (!described.empty() && MeasureQuads(mesh, size).inverted > 0)
  {
    throw Error("Quads with " + described +
      " would be inverted, because strips of quads lead from there to sides with other numbers; give numbers nearer to " +
      suitable + ", or request more quads.");
  }
}
}
