#pragma once

#include "ConeMetric.h"
#include "PlanarTopology.h"

#include <Eigen/Core>

namespace crossfield::test
{
class Random;

/// Returns a mesh of the square [−1, 1]² without a square hole of half that size, turned by `turn`
/// radians.
SharedPlanarTopology SquareFrame(double turn, double meshSize);

/// Returns the metric of the plane, with the charts of the plane: all jumps between triangles are 0,
/// and directions of boundary edges are the nearest quarter turns.
ConeMetric PlaneMetric(const PlanarTopology& topology);

/// Changes the logarithms of all lengths at random, by up to `size`.
void Perturb(Random& random, double size, ConeMetric& metric);

/// Flips and splits edges at random, each flip where it is allowed. Returns the number of flips.
int ChangeAtRandom(Random& random, int count, ConeMetric& metric);

/// Returns random numbers in [−1, 1].
Eigen::VectorXd RandomNumbers(Random& random, std::size_t count);
}
