#include "SampledPatch.h"

#include "ArcPosition.h"
#include "ChartWalk.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// A straight path along a side of a patch could leave the surface by rounding where that is its boundary.
constexpr double Inside = 1e-6;

int CellsAlong(double length, double size)
{
  constexpr double Maximum = 100.0;
  return static_cast<int>(std::clamp(std::ceil(length / size), 1.0, Maximum));
}

/// Returns a parameter from `Inside` to 1 − `Inside`.
double ParameterOf(int i, int count)
{
  return Inside + (1.0 - 2.0 * Inside) * static_cast<double>(i) / count;
}

/// Returns the point at a distance along side 0 of a patch. Its rotation is the direction of the side.
ChartPlace StartOf(const TMesh& mesh, const TPatch& patch, double along)
{
  std::size_t i = 0;
  while (i + 1 < patch.sides[0].size() && along > mesh.arcs[patch.sides[0][i] / 2].length)
  {
    along -= mesh.arcs[patch.sides[0][i] / 2].length;
    ++i;
  }
  const int half = patch.sides[0][i];
  const TArc& arc = mesh.arcs[half / 2];
  const ArcPosition at = FindOnArc(arc, half % 2 == 0 ? along : arc.length - along);
  return { at.piece->triangle, at.w, (at.piece->direction + (half % 2 == 0 ? 0 : 2)) % 4 };
}
}

SampledPatch SamplePatch(
  const SeamlessMap& map, const TMesh& mesh, const TPatch& patch, double size)
{
  const double width = mesh.SideLength(patch, 0);
  const double height = mesh.SideLength(patch, 1);
  SampledPatch sample;
  sample.columns = CellsAlong(width, size);
  sample.rows = CellsAlong(height, size);
  const auto count = static_cast<std::size_t>((sample.columns + 1) * (sample.rows + 1));
  sample.places.resize(count);
  sample.positions.resize(count);
  for (int i = 0; i <= sample.columns; ++i)
  {
    const double x = width * ParameterOf(i, sample.columns);
    ChartPlace place = StartOf(mesh, patch, x);
    double from = 0.0;
    for (int j = 0; j <= sample.rows; ++j)
    {
      const double y = height * ParameterOf(j, sample.rows);
      place = WalkStraight(map, place, { 0.0, y - from });
      from = y;
      const auto at = static_cast<std::size_t>(j * (sample.columns + 1) + i);
      sample.places[at] = map.PlaceOf(place.triangle, place.w);
      sample.positions[at] = { x, y };
    }
  }
  return sample;
}
}
