#include "SplitAtSides.h"

#include "TMeshSplit.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// Adds the corners that are farther from their neighbours along the boundary than a length.
void AddFreeCorners(const MeshBoundary& curves, double length, std::vector<int>& positions)
{
  std::vector<std::vector<double>> corners(curves.GetArcs().size());
  for (const CurvePlace& corner : curves.Corners())
  {
    corners[corner.loop].push_back(corner.at);
  }
  for (std::size_t loop = 0; loop < corners.size(); ++loop)
  {
    std::vector<double>& at = corners[loop];
    std::sort(at.begin(), at.end());
    const double around = curves.Length(static_cast<int>(loop));
    const auto gap = [&](std::size_t i)
    { return i + 1 < at.size() ? at[i + 1] - at[i] : at[0] + around - at[i]; };
    for (std::size_t i = 0; i < at.size(); ++i)
    {
      if (gap(i) > length && gap((i + at.size() - 1) % at.size()) > length)
      {
        positions.push_back(curves.PositionAt({ static_cast<int>(loop), at[i] }));
      }
    }
  }
}
}

void SplitAtSides(const SeamlessMap& map, const MeshBoundary& curves, const BoundarySides& sides,
  const SidePrescriptions& prescribed, double size, TMesh& mesh)
{
  const auto isPrescribed = [&prescribed](const LoopSide& start)
  {
    return std::any_of(prescribed.begin(), prescribed.end(),
      [&start](const SidePrescription& one) { return one.side == start.side; });
  };
  const SidesAlong along(sides, curves.GetArcs());
  std::vector<int> positions;
  for (std::size_t loop = 0; loop < curves.GetArcs().size(); ++loop)
  {
    const std::vector<LoopSide>& starts = along.On(loop);
    for (std::size_t i = 0; i < starts.size(); ++i)
    {
      const LoopSide& before = starts[(i + starts.size() - 1) % starts.size()];
      if (starts[i].isFixed ||
        (starts.size() > 1 && (isPrescribed(starts[i]) || isPrescribed(before))))
      {
        positions.push_back(curves.PositionAt({ static_cast<int>(loop), starts[i].at }));
      }
    }
  }
  AddFreeCorners(curves, size, positions);
  SplitBoundaryArcs(map, positions, mesh);
}
}
