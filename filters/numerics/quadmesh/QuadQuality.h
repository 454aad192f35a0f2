#pragma once

#include "QuadMesh.h"
#include "SurfaceQuality.h"

#include <optional>
#include <string>

namespace crossfield
{
/// Minimum, mean and maximum.
struct Range
{
  double min = 0.0;
  double mean = 0.0;
  double max = 0.0;
};

/// Quality measures of a quad mesh (docs/method.md §14.6), on a surface of the projection of each quad to the
/// plane of its diagonals.
struct QuadQuality
{
  std::vector<double> scaledJacobian; ///< Per quad, the minimum over its corners, in [−1, 1].
  std::vector<double> sizeRatio;      ///< Per quad, √area over the target size.
  Range jacobian;                     ///< Scaled Jacobian.
  /// Attainable minimum scaled Jacobian: that of sin(2π / valence) at inner points and sin(α / m)
  /// at corners of angle α with m quads.
  double bound = 1.0;
  Range eta;                             ///< 1 − (2/π) max |π/2 − angle|.
  double minimumAngle = 0.0;             ///< Minimum angle inside a quad, in radians, in [0, 2π).
  Range size;                            ///< √area.
  double variation = 0.0;                ///< Standard deviation of √area over its mean.
  int inverted = 0;                      ///< Number of quads whose scaled Jacobian is not positive.
  SpacePoint where = SpacePoint::Zero(); ///< Centre of the quad with the minimum scaled Jacobian.
  std::optional<SurfaceQuality> surface; ///< On a surface in space.
};

/// Returns the scaled Jacobian of a quad: the minimum over its corners of the signed sine of the
/// angle.
double ScaledJacobian(const QuadMesh& mesh, std::size_t quad);

/// Returns the attainable minimum scaled Jacobian, QuadQuality::bound.
double AttainableJacobian(const QuadMesh& mesh);

/// Returns one sentence that names the place of the worst quad and its cause if the minimum scaled
/// Jacobian is below 0.05 or below 0.2 times the attainable one, otherwise an empty text.
std::string DescribeWorstQuad(const QuadMesh& mesh, const QuadQuality& quality);

/// Measures a mesh of quads of edge length `size` in the map.
QuadQuality MeasureQuads(const QuadMesh& mesh, double size);
}
