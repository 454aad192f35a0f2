/**
 * Seconds of the seamless map, its separatrices and patches, and quads on the unit disk with eight
 * points, at 10,000, 100,000 and 1,000,000 triangles, and of smoothed quads by their number.
 *
 *   build/bin/benchStages "--benchmark_filter=Map|Quads"
 */
#include "BenchDisk.h"
#include "BuiltinDomains.h"
#include "HField.h"
#include "MakePlanarDomain.h"
#include "MeshForPoints.h"
#include "QuadMesher.h"
#include "SeamlessMapSolve.h"
#include "Stopwatch.h"
#include "TMeshPatches.h"

#include <benchmark/benchmark.h>

#include <cstdint>

namespace
{
using namespace crossfield;

/// Returns the disk with a vertex at each of the eight points.
SharedPlanarTopology TopologyOnPoints(std::int64_t triangles)
{
  BuiltinDomain disk;
  disk.edgeLength = MeshSizeFor(triangles);
  return ShareTopology(
    MeshThroughPoints(MakePlanarDomain(MakeBuiltinDomain(disk)), EightHoles(), disk.edgeLength));
}

/// Measures the seamless map of eight points, including H, and the separatrices and patches of its
/// T-mesh. The time of the row is the total; the counter H is for assembling, factoring and solving
/// H alone.
void MapAndLines(benchmark::State& state)
{
  const SharedPlanarTopology topology = TopologyOnPoints(state.range(0));
  for (auto _ : state)
  {
    Stopwatch stopwatch;
    const HField h = SolveHField(topology, EightHoles());
    const double alone = stopwatch.Lap();
    const SeamlessMap map = SolveSeamlessMap(topology, EightHoles());
    const double mapped = stopwatch.Lap();
    const TMesh lines = MakeTMesh(map, TraceSeparatrices(map));
    const double traced = stopwatch.Lap();
    state.SetIterationTime(mapped + traced);
    state.counters["triangles"] = static_cast<double>(topology->mesh.triangles.size());
    state.counters["h"] = alone;
    state.counters["map"] = mapped;
    state.counters["trace"] = traced;
    state.counters["faces"] = static_cast<double>(lines.patches.size());
    state.counters["wrong"] = h.field.unwantedSingularities;
  }
}

/// Measures the steps from the mesh to a thousand quads. Compare with SolveH for the same number of
/// triangles, which is a part of it.
void MapToQuads(benchmark::State& state)
{
  const SharedPlanarTopology topology = TopologyOnPoints(state.range(0));
  for (auto _ : state)
  {
    const QuadResult result = MakeQuads(LayoutSet(LayOut(topology, EightHoles(), {}, false)), {});
    state.counters["quads"] = static_cast<double>(result.mesh.quads.size());
  }
}

/// Measures smoothed quads of one map of 10,000 triangles, by their number.
void Quads(benchmark::State& state)
{
  const LayoutSet layouts(LayOut(TopologyOnPoints(10000), EightHoles(), {}, false));
  QuadOptions options;
  options.quadCount = static_cast<int>(state.range(0));
  for (auto _ : state)
  {
    const QuadResult result = MakeQuads(layouts, options);
    state.counters["quads"] = static_cast<double>(result.mesh.quads.size());
    state.counters["iterations"] = result.smoothing.iterations;
    state.counters["layout"] = result.layoutSeconds;
    state.counters["smooth"] = result.smoothSeconds;
  }
}

// CPU time is that of both threads; on a busy machine it is more reliable than elapsed time.
BENCHMARK(MapAndLines)->Apply(Sizes)->MeasureProcessCPUTime()->UseManualTime();
BENCHMARK(MapToQuads)->Apply(Sizes)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(Quads)->Apply(Sizes)->MeasureProcessCPUTime()->UseRealTime();
}
