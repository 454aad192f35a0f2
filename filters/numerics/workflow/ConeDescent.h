#pragma once

#include "Progress.h"
#include "SeamlessMap.h"

#include <vector>

namespace crossfield
{
/// Moves singularities inside a surface from vertex to vertex to a local minimum of
///   F = 1/A ∫ (H − mean H)² + W / 10 + λ Σ δ²
/// (docs/method.md §22.11): the variance of the logarithm of sizes, the energy W of singularities, by which they
/// repel each other, and the holonomy defects δ around handles and loops, in radians of the crosses. λ increases to 30.
/// Corners stay. Returns all cones in the same order.
///
/// Throws Error as VertexPotential does. Cost: one factorisation, and six solutions for each singularity in each sweep.
std::vector<Cone> MovedCones(
  const SharedTopology& topology, const std::vector<Cone>& cones, const Progress& progress = {});
}
