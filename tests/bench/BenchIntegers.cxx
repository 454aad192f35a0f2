// Quantisation of random configurations on the unit disk: time of the search and gap to the
// optimum.

#include "Quantisation.h"

#include "BuiltinDomains.h"
#include "MakePlanarDomain.h"
#include "MeshForPoints.h"
#include "SeamlessMapSolve.h"
#include "TMeshPatches.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace crossfield;

/// Returns `count` singularities, four more of index 1 than of index −1, with distances of at least
/// about their mean distance.
Configuration RandomSigns(int count, unsigned int seed)
{
  const double apart = std::min(0.15, 0.9 / std::sqrt(count));
  std::mt19937 random(seed);
  const auto uniform = [&random]
  { return 1.7 * (static_cast<double>(random()) / 4294967296.0 - 0.5); };
  Configuration configuration;
  while (static_cast<int>(configuration.size()) < count)
  {
    const Point place(uniform(), uniform());
    const bool free = place.norm() < 0.85 &&
      std::none_of(configuration.begin(), configuration.end(),
        [&](const Singularity& other) { return (other.position - place).norm() < apart; });
    if (free)
    {
      const int placed = static_cast<int>(configuration.size());
      configuration.push_back({ place, placed < 4 || placed % 2 == 0 ? 1 : -1 });
    }
  }
  return configuration;
}

/// Measures quads of edge length 0.1; the arguments are the number of singularities and the seed.
void Integers(benchmark::State& state)
{
  const Configuration configuration =
    RandomSigns(static_cast<int>(state.range(0)), static_cast<unsigned int>(state.range(1)));
  BuiltinDomain disk;
  disk.edgeLength = 0.03;
  const SeamlessMap map = SolveSeamlessMap(
    ShareTopology(
      MeshThroughPoints(MakePlanarDomain(MakeBuiltinDomain(disk)), configuration, disk.edgeLength)),
    configuration);
  const TMesh mesh = MakeTMesh(map, TraceSeparatrices(map));
  const QuantisationProblem problem = MakeQuantisationProblem(mesh, 0.1);
  EdgeCounts counts;
  for (auto _ : state)
  {
    counts = Quantise(mesh, problem, SearchEffort::Thorough);
  }
  state.counters["arcs"] = static_cast<double>(problem.Count());
  state.counters["cost"] = counts.cost;
  state.counters["gap"] = counts.Gap();
  state.counters["nodes"] = counts.nodes;
}
BENCHMARK(Integers)
  ->ArgsProduct({ { 12, 30, 50, 80, 160 }, { 1, 2, 3 } })
  ->Unit(benchmark::kMillisecond)
  ->Iterations(1)
  ->MeasureProcessCPUTime();
}
