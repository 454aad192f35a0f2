#pragma once

#include "Plane.h"
#include "SolverMesh.h"

#include <array>
#include <string>

namespace crossfield
{
/// How quads become hexahedra.
struct Sweep
{
  enum Kind
  {
    Translation, ///< By `height` along the normal of the quads.
    Rotation     ///< By `angle` about a line in the plane of the quads.
  };
  Kind kind = Translation;
  int layers = 1;      ///< Number of layers, positive.
  double height = 1.0; ///< Positive.
  double ratio = 1.0; ///< Height of the last layer of a translation by that of the first, positive.
  double angle = 90.0;             ///< Degrees, more than 0 and at most 360; 360 closes the mesh.
  Point axisPoint = Point::Zero(); ///< A point of the axis, which is at the z of the quads.
  Point axisDirection = Point(1.0, 0.0);                 ///< Direction of the axis, not zero.
  std::array<std::string, 2> ends = { "back", "front" }; ///< Sides at the start and the end.
};

/// Sweeps quads of order 1 or 2 to hexahedra of the same order. Lengths have the unit of the points.
///
/// The heights of the n layers of a translation are h₁ q^l with q = ratio^(1/(n−1)) and the sum `height`, along
/// the unit normal from which quads are counter-clockwise. The rotation begins into the direction of the normal; it goes from
/// 0 to the angle, and with one layer from minus half to half of the angle, as a wedge of OpenFOAM. Sides
/// keep their names. If a side has the name of an end, the end is called `front_2`, or with the next free
/// number. The order of cells is that of the quads in each layer; that of faces is that of the edges in each
/// layer, and the faces of back and front are the last.
/// Periodic sides stay so after a translation, and after a revolution if the motion is along its axis.
///
/// A quad with an edge on the axis becomes a prism: a hexahedron in which the nodes of
/// the edge are also those above them.
///
/// Throws Error if a number is out of its range, there are no quads, the quads are not in a plane, have
/// order 3, or for a rotation have not one z, are on both sides of the axis, or touch it in a node
/// of a quad without an edge on it. Source: docs/method.md, section 20.
SolverMesh SweepQuads(const SolverMesh& quads, const Sweep& sweep);
}
