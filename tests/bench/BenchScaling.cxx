/**
 * Scaling with the number of processors, beyond those of this machine: runs each computation in one
 * thread, records the processor time of its parts (PartsTrace.h), and schedules them on 2 to 16
 * ideal processors, each of which takes the next part that is ready.
 *
 *   build/bin/benchScaling [TRIANGLES] [HOLES] [NUMBER]
 *
 * TRIANGLES of the disk (1000000), HOLES of the plate (40), NUMBER of quads of the large mesh (200000).
 *
 * One row per computation: seconds in one thread, the part outside of all parallel loops, and the
 * ratio of the time in one thread to that on 2, 4, 8 and 16 processors.
 */
#include "AutomaticConfiguration.h"
#include "BenchDisk.h"
#include "BuiltinDomains.h"
#include "DrillHoles.h"
#include "HField.h"
#include "MakePlanarDomain.h"
#include "MeshForPoints.h"
#include "PartsTrace.h"
#include "PerforatedSolve.h"
#include "QuadMesher.h"
#include "QuadWorkflow.h"
#include "SeamlessMapSolve.h"
#include "TMeshPatches.h"

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

namespace
{
using namespace crossfield;

void Measure(const char* name, const std::function<void()>& function)
{
  const PartsTrace alone(function);
  const double total = alone.TotalSeconds();
  std::printf("%-36s %8.3f s   serial %8.3f s  ", name, total, alone.SerialSeconds());
  for (const int processors : { 2, 4, 8, 16 })
  {
    // Searches evaluate some candidates in vain, the more the more processors there are.
    const PartsTrace trace(function, processors);
    std::printf("  %2d: %5.2f", processors, total / trace.SecondsOn(processors));
  }
  std::printf("\n");
  std::fflush(stdout);
}

/// Returns a plate with round holes of 32 edges on a jittered grid, as tests/corpus/many_holes.py,
/// with other positions.
PlanarDomain Plate(int count)
{
  std::uint64_t state = 1;
  const auto uniform = [&state](double from, double to)
  {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return from + (to - from) * static_cast<double>(state >> 11U) / 9007199254740992.0;
  };
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  const double width = columns;
  const double height = (count + columns - 1) / columns;
  std::vector<Loop> loops = { { { 0.0, 0.0 }, { width, 0.0 }, { width, height },
    { 0.0, height } } };
  for (int i = 0; i < count; ++i)
  {
    const double x = i % columns + 0.5 + uniform(-0.15, 0.15);
    const double y = i / columns + 0.5 + uniform(-0.15, 0.15);
    const double radius = uniform(0.12, 0.25);
    Loop loop;
    for (int k = 0; k < 32; ++k)
    {
      const double angle = 2.0 * Pi * k / 32.0;
      loop.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
    }
    loops.push_back(std::move(loop));
  }
  return MakePlanarDomain(std::move(loops));
}

TriangleMesh Disk(std::int64_t triangles, const Configuration& holes)
{
  BuiltinDomain disk;
  disk.edgeLength = MeshSizeFor(triangles);
  DrillOptions options;
  options.meshSize = disk.edgeLength;
  return DrillHoles(MakePlanarDomain(MakeBuiltinDomain(disk)), holes, options);
}

/// Measures all steps from a bare domain to about a thousand quads, those after the choice of
/// singularities, and these again with fewer blocks.
void MeasureDomain(const std::string& name, const PlanarDomain& domain)
{
  QuadRequest request;
  request.quadCount = 1000;
  Configuration chosen;
  Measure((name + ", bare domain to quads").c_str(),
    [&] { chosen = MakeQuadMesh(domain, request).singularities; });
  request.singularities = chosen;
  Measure((name + ", quads").c_str(), [&] { MakeQuadMesh(domain, request); });
  request.merge = BlockMerge::Coarse;
  Measure((name + ", fewer blocks").c_str(), [&] { MakeQuadMesh(domain, request); });
}

/// Measures a large mesh of quads of one map: building, smoothing, blocks and quality.
void MeasureQuads(int quads)
{
  BuiltinDomain disk;
  disk.edgeLength = MeshSizeFor(10000);
  const LayoutSet layouts(
    LayOut(ShareTopology(MeshThroughPoints(
             MakePlanarDomain(MakeBuiltinDomain(disk)), EightHoles(), disk.edgeLength)),
      EightHoles(), {}, false));
  for (const Sizing sizing : { Sizing::Conformal, Sizing::Uniform })
  {
    QuadOptions options;
    options.quadCount = quads;
    options.sizes.sizing = sizing;
    Measure(sizing == Sizing::Conformal ? "many quads" : "many quads of uniform size",
      [&] { MakeQuads(layouts, options); });
  }
}
}

int main(int count, char** arguments)
{
  const std::int64_t triangles = count > 1 ? std::atoll(arguments[1]) : 1000000;
  const int holes = count > 2 ? std::atoi(arguments[2]) : 40;
  {
    TriangleMesh mesh;
    Measure("mesh of a disk with eight holes", [&] { mesh = Disk(triangles, EightHoles()); });
    SharedPlanarTopology topology;
    Measure("topology", [&] { topology = ShareTopology(mesh); });
    PerforatedOptions options;
    options.method = PerforatedMethod::UnitNorm;
    Measure("unit norm", [&] { SolvePerforated(topology, options); });
    Measure("constrained", [&] { SolvePerforated(topology); });
    topology = ShareTopology(Disk(triangles, {}));
    Measure("H and W of eight points", [&] { SolveHField(topology, EightHoles()); });
  }
  MeasureQuads(count > 3 ? std::atoi(arguments[3]) : 200000);
  BuiltinDomain star;
  star.name = "star";
  MeasureDomain("star", MakePlanarDomain(MakeBuiltinDomain(star)));
  MeasureDomain("plate with 9 holes", Plate(9));
  const PlanarDomain plate = Plate(holes);
  AutomaticOptions options;
  options.quadCount = 1000;
  Measure("choosing singularities of the plate", [&] { ChooseConfiguration(plate, options); });
  return 0;
}
