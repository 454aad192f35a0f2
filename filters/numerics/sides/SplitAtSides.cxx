#include "SplitAtSides.h"

#include "TMeshSplit.h"

#include <algorithm>

namespace crossfield
{
void SplitAtSides(const SeamlessMap& map, const MeshBoundary& curves, const BoundarySides& sides,
  const SidePrescriptions& prescribed, TMesh& mesh)
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
  SplitBoundaryArcs(map, positions, mesh);
}
}
