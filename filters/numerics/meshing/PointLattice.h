#pragma once

#include "SizeField.h"

namespace crossfield
{
/// Points of a graded triangular lattice over the box of a size field: about h(x) apart, in
/// equilateral triangles where h is constant (docs/method.md §10.1: the bulk of a mesh, inserted at once).
///
/// The lattice of spacing s/2 contains the one of spacing s, so lattices of spacing 2⁻ˡ times the
/// largest size fit together: a point that belongs to spacing 2⁻ˡ but to no larger one is taken
/// where h asks for that spacing. Between two spacings the triangles are halves of equilateral
/// ones. The order of the points follows the rows of the lattice, so that neighbours in the list
/// are neighbours in the plane.
std::vector<Point> GradedLattice(const SizeField& size);
}
