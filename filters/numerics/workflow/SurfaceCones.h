#pragma once

#include "SeamlessMap.h"
#include "SurfaceMesh.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace crossfield
{
struct SurfaceTopology;

/// A singularity of a surface in space.
struct SurfaceSingularity
{
  SpacePoint place = SpacePoint::Zero();
  int quarterIndex = 1;
};

/// A connected part of a surface with its singularities and the corners of its boundary at vertices.
struct ConedSurface
{
  std::shared_ptr<const SurfaceTopology> topology;
  std::vector<Cone> cones;
  std::vector<std::string> events; ///< One sentence for each singularity that is not at its place.

  /// Returns the sum that the quarter indices of singularities must have: 4χ minus those of corners.
  int RequiredQuarters() const;
  /// Returns that of the singularities.
  int GivenQuarters() const;
};

/// The parts of a surface, the largest area first, and what was repaired.
struct ConedSurfaces
{
  std::vector<ConedSurface> parts;
  std::vector<std::string> events; ///< As in SurfaceParts.
};

/// Finds the parts of a surface and places each singularity on a vertex of the nearest one; corners of the boundary have the
/// quarter index nearest to their angle, at most 1 (docs/method.md §22.6). Throws Error as FindSurfaceParts does, and if a
/// singularity is farther from the surface than its triangle there is long or has no vertex of its own.
ConedSurfaces PlaceCones(SurfaceMesh surface, const std::vector<SurfaceSingularity>& singularities);

/// Returns one sentence about the sums of quarter indices.
std::string DescribeQuarters(const ConedSurface& part);

/// A corner of the boundary of a surface with a quarter index.
struct SurfaceCorner
{
  SpacePoint place = SpacePoint::Zero();
  double angle = 0.0; ///< Inside, radians.
  int quarterIndex = 0;
};

/// Whether a field with given singularities exists on a surface, and why. Numbers are sums over the parts.
struct SurfaceCheck
{
  bool consistent = false;
  std::string reason; ///< One sentence.
  int eulerCharacteristic = 0;
  int requiredQuarters = 0;
  int givenQuarters = 0;
  double totalCurvature = 0.0; ///< Σ K / 2π.
  double tangentTurning = 0.0; ///< Σ τ / 2π; with the curvature it adds up to χ.
  std::vector<SurfaceCorner> corners;
  /// Of each part, one after the other; empty unless consistent.
  std::vector<double> holonomyDefect;
};

/// Compares the quarter indices of singularities with those that each part needs, and finds by how much crosses do not
/// close up around handles and loops. Throws Error as VertexPotential does.
SurfaceCheck CheckSurface(const ConedSurfaces& surfaces);
}
