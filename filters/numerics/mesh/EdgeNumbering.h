#pragma once

#include "TriangleMesh.h"

namespace crossfield
{
/// Numbering of the edges of a triangle mesh from 0; edges carry the degrees of freedom of
/// Crouzeix-Raviart functions. All members refer to the numbering of the mesh from which they were
/// computed.
struct EdgeNumbering
{
  /// End points of each edge, vertices[e][0] < vertices[e][1].
  std::vector<std::array<int, 2>> vertices;
  /// Edges p0p1, p1p2, p2p0 of triangle (p0, p1, p2).
  std::vector<std::array<int, 3>> ofTriangle;
  /// One or two triangles at each edge; −1 if there is no second one.
  std::vector<std::array<int, 2>> triangles;
  /// Edge of each entry of mesh.boundary.
  std::vector<int> ofBoundary;
  /// Edge of each entry of mesh.imprinted.
  std::vector<int> ofImprinted;

  int Count() const { return static_cast<int>(this->vertices.size()); }
  /// Returns the triangle across side i of a triangle, from its vertex i to the next one; −1 if there
  /// is none.
  int Neighbour(int triangle, int side) const
  {
    const auto& two = this->triangles[this->ofTriangle[triangle][side]];
    return two[0] == triangle ? two[1] : two[0];
  }
  /// Returns the side of a triangle at an edge.
  int SideOf(int triangle, int edge) const
  {
    const auto& sides = this->ofTriangle[triangle];
    return edge == sides[0] ? 0 : edge == sides[1] ? 1 : 2;
  }
  /// Returns vertices − edges + triangles. Only vertices used by a triangle are counted.
  int EulerCharacteristic(const TriangleMesh& mesh) const;
};

/// Numbers the edges of a mesh.
///
/// Throws Error if an edge has more than two triangles, if a boundary entry is not an edge of the
/// mesh, if an edge with one triangle is missing from mesh.boundary, or if an imprinted entry is
/// repeated or not an edge with two triangles.
EdgeNumbering NumberEdges(const TriangleMesh& mesh);

/// Closed chain of boundary edges.
struct BoundaryLoop
{
  BoundaryKind kind;
  int id;
  int quarterIndex;
  /// Indices into mesh.boundary, counter-clockwise around the region that the loop encloses: along
  /// the direction of the edges for the outer loop, against it for inner loops and holes. For
  /// imprinted circles they are indices into mesh.imprinted.
  std::vector<int> edges;
};

/// Returns the mesh edges of a loop, in its order.
std::vector<int> EdgesOf(const BoundaryLoop& loop, const EdgeNumbering& edges);

/// Returns the centre of mass of a loop as a wire. For a circle this is the centre even if its
/// edges are divided unevenly.
Point CentreOf(const BoundaryLoop& loop, const TriangleMesh& mesh);

/// Returns the loops of the boundary edges, ordered by kind and id. Throws Error if one is not
/// closed.
std::vector<BoundaryLoop> FindBoundaryLoops(const TriangleMesh& mesh);

/// Returns the imprinted circles, ordered by id. Throws Error if one is not closed.
std::vector<BoundaryLoop> FindImprintedLoops(const TriangleMesh& mesh);
}
