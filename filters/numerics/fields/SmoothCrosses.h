#pragma once

#include "MeshTopology.h"
#include "Progress.h"

#include <Eigen/Core>

namespace crossfield
{
/// Returns smooth crosses on the triangles of a connected mesh (docs/method.md §22.11), as angles θ in the charts,
/// radians. With z = e^{4iθ} and the hinges ρ,
///   E(z) = Σ_e w_e |z_s − e^{4iρ} z_t|² + Σ_boundary w_e |z_t − e^{4id}|²,
/// w_e = 3/2 |e|² over the areas of the triangles at an edge, d the direction of a boundary edge. From the minimum of E, on a
/// closed surface the least eigenvector, heat flows of decreasing time τ, each step
///   z ← (M + τ E)⁻¹ (M z/|z| + τ b),
/// lead to crosses whose singularities repel each other (Merriman, Bence, Osher; Viertel and Osting 2019). M has the areas, b
/// the directions of the boundary.
///
/// Throws Error as DissectedCholesky does. Cost: five factorisations with two unknowns per triangle.
Eigen::VectorXd SmoothCrosses(const MeshTopology& topology, const Progress& progress = {});
}
