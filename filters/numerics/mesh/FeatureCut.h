#pragma once

#include "FeatureEdges.h"

#include <map>

namespace crossfield
{
/// A point of one face of a surface.
struct FacePoint
{
  int face = 0;
  int point = 0;
};

/// A line of sharp edges from one node to another, or a closed one without nodes.
struct FeatureLine
{
  /// Faces on its left and on its right, which may be the same one.
  std::array<int, 2> faces{};
  /// Its points in each, in its direction; the first one of a closed line is not repeated.
  std::array<std::vector<int>, 2> points;
  bool isClosed = false;
  int name = -1; ///< SurfaceMesh::lines of its edges.
};

/// A point where lines end: other than two of them and of the boundary meet there, a face has a corner, or the name of
/// a line or of the boundary changes; also the middle of a line that would return to its node.
struct FeatureNode
{
  bool isOnBoundary = false;
  std::vector<FacePoint> corners; ///< Of the faces that meet there, each a fan of triangles.
};

/// The faces of a surface that is cut along its sharp edges. A point has a copy in each fan of triangles between them.
struct CutSurface
{
  std::vector<SurfaceMesh> faces; ///< The largest area first.
  std::vector<int> faceOf;        ///< Per triangle of the whole.
  std::vector<FeatureLine> lines;
  std::vector<FeatureNode> nodes;
  /// Per face the names (SurfaceMesh::lines) of edges of the boundary of the whole, by the points where they start.
  std::vector<std::map<int, int>> boundaryNames;
};

/// Cuts a connected, oriented manifold surface along its sharp edges (docs/method.md §22.12).
CutSurface CutAlongFeatures(const SurfaceMesh& surface, const FeatureEdges& features);
}
