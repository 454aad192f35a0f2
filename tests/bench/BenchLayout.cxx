/**
 * Seconds of one step of dragging a singularity: twelve singularities on the unit disk, of which
 * one moves with every iteration; the domain is meshed and factored once.
 *
 *   build/bin/benchStages --benchmark_filter=Drag
 */
#include "HField.h"
#include "LayoutDesign.h"
#include "MakePlanarDomain.h"
#include "Stopwatch.h"
#include "SurfaceDesign.h"
#include "SurfaceRefinement.h"

#include "BuiltinDomains.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace
{
using namespace crossfield;

/// Returns eight k = 1 at radius 0.7 and four k = −1 at radius 0.35; the first moves on a small
/// circle.
Configuration Twelve(std::int64_t step)
{
  Configuration configuration;
  for (int i = 0; i < 12; ++i)
  {
    const bool outside = i < 8;
    const double angle = outside ? Pi * (i + 0.1) / 4.0 : Pi * (i + 0.37) / 2.0;
    configuration.push_back(
      { (outside ? 0.7 : 0.35) * Point(std::cos(angle), std::sin(angle)), outside ? 1 : -1 });
  }
  const double turn = 0.1 * static_cast<double>(step);
  configuration[0].position += 0.05 * Point(std::cos(turn), std::sin(turn));
  return configuration;
}

/// Returns the disk with about `triangles` triangles.
FactoredDomain Disk(std::int64_t triangles)
{
  BuiltinDomain disk;
  disk.edgeLength = std::sqrt(4.0 * Pi / (std::sqrt(3.0) * static_cast<double>(triangles)));
  return { MakePlanarDomain(MakeBuiltinDomain(disk)), {}, disk.edgeLength };
}

/// Measures H and crosses on the cached mesh.
void DragField(benchmark::State& state)
{
  const FactoredDomain domain = Disk(state.range(0));
  std::int64_t step = 0;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(SolveHField(domain.GetPotential(), Twelve(++step)));
  }
}

/// Measures W, mesh, map, separatrices and patches; with 1 also edge counts and blocks of quads,
/// not smoothed; with 2 smoothed quads.
void DragLayout(benchmark::State& state)
{
  const FactoredDomain domain = Disk(state.range(0));
  LayoutOptions options;
  if (state.range(1) > 0)
  {
    options.quads.emplace();
    options.quads->smooth = state.range(1) > 1;
  }
  std::int64_t step = 0;
  double inserted = 0.0;
  for (auto _ : state)
  {
    Stopwatch stopwatch;
    domain.MeshOn(Twelve(step + 1));
    inserted += stopwatch.Lap();
    const LayoutDesign design = DesignLayout(domain, Twelve(++step), options);
    state.counters["faces"] = static_cast<double>(design.layouts.Single().tMesh.patches.size());
    if (design.quads)
    {
      state.counters["integers"] = design.quads->counts.seconds;
      state.counters["layout"] = design.quads->layoutSeconds;
      state.counters["smooth"] = design.quads->smoothSeconds;
    }
  }
  state.counters["insert"] = inserted / static_cast<double>(step);
}

/// Measures the layout of a ring with four k = 1 and four k = −1, turned against each other by 0 (no
/// holonomy defect, the nearest map) or 0.6 (34 degrees, a flat metric).
void DragRing(benchmark::State& state)
{
  BuiltinDomain ring;
  ring.name = "ring";
  const double area = Pi * (1.0 - ring.innerRadius * ring.innerRadius);
  ring.edgeLength = std::sqrt(4.0 * area / (std::sqrt(3.0) * static_cast<double>(state.range(0))));
  const FactoredDomain domain(MakePlanarDomain(MakeBuiltinDomain(ring)), {}, ring.edgeLength);
  const double turn = state.range(1) == 0 ? 0.0 : 0.6;
  std::int64_t step = 0;
  for (auto _ : state)
  {
    Configuration configuration;
    for (int i = 0; i < 4; ++i)
    {
      const double angle = 0.5 * Pi * i;
      configuration.push_back({ 0.8 * Point(std::cos(angle), std::sin(angle)), 1 });
      configuration.push_back({ 0.55 * Point(std::cos(angle + turn), std::sin(angle + turn)), -1 });
    }
    configuration[0].position.x() += 1e-3 * std::sin(0.1 * static_cast<double>(++step));
    const LayoutDesign design = DesignLayout(domain, configuration);
    const SeamlessMap& map = design.layouts.Single().map;
    state.counters["triangles"] = static_cast<double>(map.corners.size());
    state.counters["stretch"] = map.flattening ? map.flattening->PredictedStretch() : 1;
    state.counters["iterations"] = map.flattening ? map.flattening->iterations : 0;
  }
}

/// Measures the layout of eight k = 1 on an ellipsoid of about as many triangles: with 0 as while a handle is dragged, with
/// 1 that of the surface itself.
void DragSurface(benchmark::State& state)
{
  SurfaceMesh ellipsoid;
  for (int axis = 0; axis < 3; ++axis)
  {
    ellipsoid.points.emplace_back(SpacePoint::Unit(axis));
    ellipsoid.points.emplace_back(-SpacePoint::Unit(axis));
  }
  ellipsoid.triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 },
    { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } };
  constexpr double Area = 6.93; // of the octahedron
  ellipsoid =
    Refined(std::move(ellipsoid), std::sqrt(Area / (0.32 * static_cast<double>(state.range(0)))));
  const SpacePoint axes(1.5, 1.0, 0.8);
  for (SpacePoint& point : ellipsoid.points)
  {
    point = point.normalized().cwiseProduct(axes);
  }
  const DesignSurface surface(ellipsoid, {}, Pi);
  std::int64_t step = 0;
  for (auto _ : state)
  {
    std::vector<SurfaceSingularity> eight;
    for (int corner = 0; corner < 8; ++corner)
    {
      const SpacePoint direction(
        corner % 2 * 2 - 1, corner / 2 % 2 * 2 - 1, corner / 4 * 2 - 1 + 0.1 * corner);
      eight.push_back({ direction.normalized().cwiseProduct(axes), 1 });
    }
    eight[0].place.x() += 1e-3 * std::sin(0.1 * static_cast<double>(++step));
    const LayoutDesign design =
      state.range(1) == 0 ? surface.DesignCoarse(eight) : surface.Design(eight, 0.1, std::nullopt);
    state.counters["triangles"] = static_cast<double>(design.layouts.Single().map.corners.size());
    state.counters["faces"] = static_cast<double>(design.layouts.Single().tMesh.patches.size());
  }
  state.counters["given"] = static_cast<double>(ellipsoid.triangles.size());
}

BENCHMARK(DragSurface)
  ->ArgsProduct({ { 2000, 20000 }, { 0, 1 } })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK(DragField)
  ->Arg(2000)
  ->Arg(10000)
  ->Arg(30000)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK(DragLayout)
  ->ArgsProduct({ { 2000, 4000, 10000, 30000 }, { 0, 1, 2 } })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK(DragRing)
  ->ArgsProduct({ { 2000, 4000, 20000 }, { 0, 1 } })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
}
