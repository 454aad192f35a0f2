#include "ConfigurationPlacement.h"

#include "CornerClassification.h"
#include "PoincareHopf.h"

#include <algorithm>
#include <iterator>

namespace crossfield
{
PlacedConfiguration PlaceConfiguration(const PlanarTopology& topology,
  const Configuration& configuration, const std::vector<CornerChoice>& corners)
{
  PlacedConfiguration placed;
  const PlanarDomain domain{ topology.AlignedLoops() };
  const double reach = BoundaryReach * domain.Diagonal();
  std::copy_if(corners.begin(), corners.end(), std::back_inserter(placed.corners),
    [&](const CornerChoice& choice)
    {
      return std::none_of(configuration.begin(), configuration.end(),
        [&](const Singularity& singularity)
        { return (choice.position - singularity.position).norm() <= reach; });
    });
  for (std::size_t row = 0; row < configuration.size(); ++row)
  {
    const Singularity& singularity = configuration[row];
    const bool atVertex = std::any_of(domain.loops.begin(), domain.loops.end(),
      [&](const Loop& loop)
      {
        return std::any_of(loop.begin(), loop.end(),
          [&](const Point& point) { return (point - singularity.position).norm() <= reach; });
      });
    if (atVertex)
    {
      placed.corners.push_back({ singularity.position, singularity.quarterIndex });
    }
    else
    {
      placed.interior.push_back(singularity);
      placed.rows.push_back(row);
    }
  }
  PoincareHopfCount count = CountMeshQuarters(topology, placed.corners);
  const bool holes = topology.LoopCount(BoundaryKind::Hole) > 0;
  const int interior = holes ? count.givenInteriorQuarters : TotalQuarters(placed.interior);
  count.givenInteriorQuarters = interior;
  if (count.Consistent())
  {
    return placed;
  }
  // The smallest rotations do not give the required sum: use the cheapest assignment that keeps the
  // given indices.
  ClassificationOptions options;
  const std::vector<Corner> all = FindCorners(domain.loops);
  const auto isAt = [reach](const Point& position)
  {
    return [&position, reach](const auto& other)
    { return (other.position - position).norm() <= reach; };
  };
  for (const CornerChoice& choice : placed.corners)
  {
    if (std::any_of(all.begin(), all.end(), isAt(choice.position)))
    {
      options.overrides.push_back(choice);
    }
  }
  if (!all.empty())
  {
    std::vector<CornerChoice> completed = placed.corners;
    for (const ClassifiedCorner& corner : ClassifyCorners(domain, options).corners)
    {
      if (!corner.overridden)
      {
        completed.push_back({ corner.position, corner.quarterIndex });
      }
    }
    PoincareHopfCount other = CountMeshQuarters(topology, completed);
    other.givenInteriorQuarters = interior;
    if (other.Consistent())
    {
      placed.corners = completed;
      return placed;
    }
  }
  RequireConsistent(count);
  return placed;
}
}
