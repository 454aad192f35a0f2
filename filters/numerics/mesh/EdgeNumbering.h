#pragma once

#include "TriangleMesh.h"

namespace crossfield
{
/// The edges of a triangle mesh, numbered from 0; the degrees of freedom of Crouzeix-Raviart
/// functions. All members are in the numbering of the mesh they were made from.
struct EdgeNumbering
{
  /// Edge e joins vertices[e][0] < vertices[e][1].
  std::vector<std::array<int, 2>> vertices;
  /// Edges p0p1, p1p2, p2p0 of triangle (p0, p1, p2).
  std::vector<std::array<int, 3>> ofTriangle;
  /// The one or two triangles at each edge; −1 where there is none.
  std::vector<std::array<int, 2>> triangles;
  /// Edge of each entry of mesh.boundary.
  std::vector<int> ofBoundary;
  /// Edge of each entry of mesh.imprinted.
  std::vector<int> ofImprinted;

  int Count() const { return static_cast<int>(this->vertices.size()); }
  /// Vertices − edges + triangles; only vertices that a triangle uses are counted.
  int EulerCharacteristic(const TriangleMesh& mesh) const;
};

/// Throws Error when an edge has more than two triangles, a boundary entry is not an edge of the
/// mesh, or an edge with one triangle is missing from mesh.boundary; or when an imprinted entry is
/// not an edge with two triangles, or is there twice.
EdgeNumbering NumberEdges(const TriangleMesh& mesh);

/// A closed chain of boundary edges.
struct BoundaryLoop
{
  BoundaryKind kind;
  int id;
  int quarterIndex;
  /// Positions in mesh.boundary, counter-clockwise around what the loop encloses: the outer loop
  /// as its edges are directed, inner loops and holes against it. Of imprinted circles, positions in
  /// mesh.imprinted.
  std::vector<int> edges;
};

/// The edges of the mesh that a loop consists of, in its order.
std::vector<int> EdgesOf(const BoundaryLoop& loop, const EdgeNumbering& edges);

/// Centre of mass of a loop as a wire: that of a circle also where its edges were split unevenly.
Point CentreOf(const BoundaryLoop& loop, const TriangleMesh& mesh);

/// The loops of the marked edges, ordered by kind and id. Throws Error when one is not closed.
std::vector<BoundaryLoop> FindBoundaryLoops(const TriangleMesh& mesh);

/// The imprinted circles likewise, ordered by id.
std::vector<BoundaryLoop> FindImprintedLoops(const TriangleMesh& mesh);
}
