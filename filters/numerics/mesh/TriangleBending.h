#pragma once

#include "MeshTopology.h"

#include <complex>

namespace crossfield
{
/// How a triangle of a surface is bent against its neighbours: sums over its sides inside, of length ℓ, with the angle
/// β between the normals on both and their direction φ in its chart.
struct TriangleBending
{
  std::complex<double> directed =
    0.0; ///< Σ ℓ β e^{2iφ}: the argument is twice the direction of the strongest curvature.
  double sum = 0.0;      ///< Σ ℓ β.
  double absolute = 0.0; ///< Σ ℓ |β|.
  int sides = 0;         ///< Number of sides inside.
};

TriangleBending BendingOf(const MeshTopology& topology, int triangle);
}
