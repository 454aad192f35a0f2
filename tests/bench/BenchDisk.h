#pragma once

// Singularities on the unit disk and mesh sizes that several benchmarks share.

#include "Plane.h"
#include "Singularity.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>

namespace crossfield
{
/// Returns six k = +1 at radius 0.7 and two k = −1 at (±0.2, 0), radius 0.02 (docs/method.md §9).
inline Configuration EightHoles()
{
  Configuration configuration;
  for (int i = 0; i < 6; ++i)
  {
    const double angle = Pi * i / 3.0;
    configuration.push_back({ 0.7 * Point(std::cos(angle), std::sin(angle)), 1, 0.02 });
  }
  configuration.push_back({ { 0.2, 0.0 }, -1, 0.02 });
  configuration.push_back({ { -0.2, 0.0 }, -1, 0.02 });
  return configuration;
}

/// Returns the edge length for about `triangles` equilateral triangles in a disk of area π.
inline double MeshSizeFor(std::int64_t triangles)
{
  return std::sqrt(4.0 * Pi / (std::sqrt(3.0) * static_cast<double>(triangles)));
}

/// Gives a benchmark one run for each of the three sizes.
inline void Sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond)->Iterations(1);
}
}
