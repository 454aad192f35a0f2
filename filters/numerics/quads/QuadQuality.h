#pragma once

#include "QuadMesh.h"

namespace crossfield
{
struct Range
{
  double min = 0.0;
  double mean = 0.0;
  double max = 0.0;
};

/// Shapes and sizes of quads (docs/method.md §14.6).
struct QuadQuality
{
  std::vector<double> scaledJacobian; ///< Per quad the least over its corners, in [−1, 1].
  std::vector<double> sizeRatio;      ///< √area over the size wanted there.
  Range jacobian;
  /// Attainable: sin(2π / valence) at points inside, sin(α / m) at a corner of angle α with m quads.
  double bound = 1.0;
  Range eta;                   ///< 1 − (2/π) max |π/2 − angle|.
  Range size;                  ///< √area.
  double variation = 0.0;      ///< Standard deviation of √area over its mean.
  int inverted = 0;            ///< Quads whose least scaled Jacobian is not positive,
  Point where = Point::Zero(); ///< and the place of the worst quad.
};

/// The least scaled Jacobian of one quad: the sine of the angle at every corner, with its sign.
double ScaledJacobian(const QuadMesh& mesh, std::size_t quad);

/// `size`: of quads in the map.
QuadQuality MeasureQuads(const QuadMesh& mesh, double size);
}
