#include "Layout.h"

#include "Error.h"
#include "Stopwatch.h"
#include "TMeshPatches.h"

#include <algorithm>
#include <string>
#include <utility>

namespace crossfield
{
LayoutSet::LayoutSet(Layout region, std::vector<PairedSides> matching)
  : pairs(std::move(matching))
{
  this->regions.push_back(std::move(region));
}

const Layout& LayoutSet::Single() const
{
  if (this->regions.size() != 1)
  {
    throw Error("The domain has " + std::to_string(this->regions.size()) +
      " regions, and quads are made for one; mesh each region by itself.");
  }
  return this->regions.front();
}

Layout LayOut(const SharedPlanarTopology& topology, const Configuration& singularities,
  const SeamlessMapOptions& options, bool retainsFactor, const Progress& progress)
{
  Layout layout;
  layout.singularities = singularities;
  Stopwatch clock;
  if (retainsFactor)
  {
    layout.potential = std::make_shared<const PotentialSolver>(topology, progress.Part(0.0, 0.3));
  }
  layout.map = SolveSeamlessMap(topology, singularities, options,
    progress.Part(retainsFactor ? 0.3 : 0.0, 0.8), layout.potential);
  layout.mapSeconds = clock.Lap();
  layout.separatrices = TraceSeparatrices(layout.map, progress.Part(0.8, 1.0));
  layout.tMesh = MakeTMesh(layout.map, layout.separatrices);
  layout.traceSeconds = clock.Lap();
  return layout;
}

double LargestMove(const Configuration& from, const Configuration& to)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    largest = std::max(largest, (to[i].position - from[i].position).norm());
  }
  return largest;
}
}
