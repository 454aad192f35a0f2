/**
 * Seconds of the holonomy defects, and of H by the numbers of singularities and of islands: disks
 * in a square, singularities of alternating sign between them.
 *
 *   build/bin/benchStages --benchmark_filter=Islands
 */
#include "HField.h"
#include "HolonomyCheck.h"
#include "MakePlanarDomain.h"
#include "MeshForPoints.h"
#include "Stopwatch.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace crossfield;

struct Plate
{
  PlanarDomain domain;
  Configuration configuration;
};

/// Returns islands of 16 sides at the centres of a lattice of squares, and singularities in rows
/// between them. The last singularity balances the sum: the corners of the frame have index 1 each,
/// and every island requires −4.
Plate MakePlate(int islands, int singularities)
{
  const int across = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(islands))));
  std::vector<Loop> loops = { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } } };
  const double square = 1.0 / across;
  for (int i = 0; i < islands; ++i)
  {
    const Point centre = square * Point(i % across + 0.5, i / across + 0.5);
    Loop island;
    for (int j = 0; j < 16; ++j)
    {
      const double angle = 2.0 * Pi * j / 16;
      island.push_back(centre + 0.2 * square * Point(std::cos(angle), std::sin(angle)));
    }
    loops.push_back(island);
  }
  Plate plate;
  plate.domain = MakePlanarDomain(loops);
  // A lattice of positions along the lines between the squares and the frame.
  const int total = std::max(singularities, 1);
  const int perLine = static_cast<int>(std::ceil(static_cast<double>(total) / across));
  int quarters = -4 * islands;
  for (int i = 0; i < total; ++i)
  {
    const double x = (i % perLine + 0.5) / perLine;
    const double y = square * (i / perLine + 0.1);
    const int index = i + 1 < total ? (i % 2 == 0 ? 1 : -1) : quarters;
    quarters -= index;
    plate.configuration.push_back({ { x, y }, index, 0.0 });
  }
  return plate;
}

void Islands(benchmark::State& state)
{
  const Plate plate = MakePlate(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  for (auto _ : state)
  {
    Stopwatch stopwatch;
    const std::vector<double> defects = HolonomyDefects(plate.domain, plate.configuration);
    state.counters["defects"] = stopwatch.Lap();
    const SharedPlanarTopology topology =
      ShareTopology(MeshForPoints(plate.domain, plate.configuration));
    const HField field = SolveHField(topology, plate.configuration);
    state.counters["h"] = stopwatch.Lap();
    state.counters["triangles"] = static_cast<double>(topology->mesh.triangles.size());
    state.counters["wrong"] =
      defects.size() == static_cast<std::size_t>(state.range(0)) && field.h.allFinite() ? 0 : 1;
  }
}

BENCHMARK(Islands)
  ->ArgsProduct({ { 1, 10, 100 }, { 2, 20, 200 } })
  ->Unit(benchmark::kMillisecond)
  ->Iterations(1)
  ->UseRealTime();
}
