#pragma once

#include "FeatureCut.h"
#include "SeamlessMap.h"
#include "SurfaceMesh.h"

#include <map>
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

/// A connected surface, whole or a face between sharp edges, with its singularities and the corners of its boundary at
/// vertices.
struct ConedSurface
{
  std::shared_ptr<const SurfaceTopology> topology;
  std::vector<Cone> cones;
  std::vector<std::string>
    events = {}; ///< One sentence for each singularity that is not at its place.

  /// Returns the sum that the quarter indices of singularities must have: 4χ minus those of corners.
  int RequiredQuarters() const;
  /// Returns that of the singularities.
  int GivenQuarters() const;
};

/// A connected part of a surface with its sharp edges and the singularities that are nearest to it.
struct FeaturedPart
{
  SurfaceMesh surface;
  FeatureEdges features;
  std::vector<SurfaceSingularity> singularities;
  std::vector<int> rows; ///< Of the singularities in those of the whole.
};

/// The connected parts of a surface, the largest area first, and what was repaired.
struct FeaturedParts
{
  std::vector<FeaturedPart> parts;
  std::vector<std::string> events; ///< As in SurfaceParts and FeatureEdges.
};

/// Finds the parts of a surface and edges that are sharper than an angle, in radians. Throws Error as
/// FindSurfaceParts does.
FeaturedParts FindFeaturedParts(
  SurfaceMesh surface, const std::vector<SurfaceSingularity>& singularities, double featureAngle);

/// A part of a surface, cut along its sharp edges.
struct SurfaceBody
{
  std::vector<ConedSurface> faces; ///< The largest area first; one if there are no sharp edges.
  std::vector<int> faceOf;         ///< Per triangle of the part.
  std::vector<int> regionOf;       ///< Per face: that of the largest part of its area.
  std::vector<FeatureLine> lines;  ///< Points are vertices of the topologies of faces.
  std::vector<FeatureNode> nodes;
  std::vector<std::map<int, int>> boundaryNames; ///< As in CutSurface.
  int eulerCharacteristic = 0;                   ///< Before it was cut.
  double area = 0.0;

  /// Returns whether it is one face without lines, nodes and names of sides.
  bool IsWhole() const;
};

/// Cuts a part along its sharp edges, and places each singularity on a vertex of the nearest face; corners of a
/// boundary have the quarter index nearest to their angle, at most 1, and those of faces at a common node are
/// chosen together (docs/method.md §22.6, §22.12). Singularities on sharp edges are left out: what is there
/// follows from the angles. Throws Error if a singularity is farther from the surface than its triangle there is
/// long or has no vertex of its own.
SurfaceBody PlaceCones(const FeaturedPart& part);

/// The parts of a surface, and what was repaired.
struct ConedSurfaces
{
  std::vector<SurfaceBody> bodies;
  std::vector<std::string> events; ///< As in FeaturedParts.

  std::vector<const ConedSurface*> Faces() const;
};

/// Returns what a face is called in messages: by a place on it.
std::string DescribeFace(const ConedSurface& face);

/// Places the cones of all parts. Throws Error as FindFeaturedParts and PlaceCones do.
ConedSurfaces PlaceCones(SurfaceMesh surface, const std::vector<SurfaceSingularity>& singularities,
  double featureAngle = DefaultFeatureAngle);

/// Returns one sentence about the sums of quarter indices.
std::string DescribeQuarters(const ConedSurface& part);

/// Returns one sentence about quarter indices that add up, and holonomy defects in radians.
std::string DescribeHolonomy(const std::vector<double>& defects);

/// A corner of the boundary of a surface with a quarter index.
struct SurfaceCorner
{
  SpacePoint place = SpacePoint::Zero();
  double angle = 0.0; ///< Inside, radians.
  int quarterIndex = 0;
};

/// Whether a field with given singularities exists on a surface, and why. Numbers are sums over the faces.
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
  /// Of each face, one after the other; empty unless consistent.
  std::vector<double> holonomyDefect;
};

/// Compares the quarter indices of singularities with those that each face needs, and finds by how much crosses do not
/// close up around handles and loops. Throws Error as VertexPotential does.
SurfaceCheck CheckSurface(const ConedSurfaces& surfaces);
}
