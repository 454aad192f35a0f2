#pragma once

#include "Plane.h"

#include <Eigen/SparseCore>

namespace crossfield
{
/// Returns a fill-reducing elimination order of a symmetric sparse matrix whose unknowns have
/// positions in space. Splits recursively at the median across the direction in which a cut
/// meets fewest points, and numbers the unknowns of the left half that are coupled to the right half
/// last (docs/method.md §10.2).
///
/// `places` has one point per unknown; the unknowns in `trailing` come last, in the given order.
/// Entry i of the result is the unknown that is eliminated i-th.
std::vector<int> NestedDissection(const Eigen::SparseMatrix<double>& matrix,
  const std::vector<SpacePoint>& places, const std::vector<int>& trailing = {});

/// Part of a dissection: a leaf of its tree, whose unknowns are in elimination order, or the
/// separator between the two parts below it.
struct DissectionPart
{
  std::vector<int> unknowns;
  int parent = -1; ///< Number of the part above; −1 for the root.
  bool isLeaf = false;
};

/// Returns the same elimination order, divided along the first separators into a tree of parts. No
/// entry of the matrix couples a part to any other than those above and below it. A part follows the
/// parts below it; the last one is the root, which is not a leaf. It ends with `trailing`. Unknowns
/// in `leftOut` are in no part.
///
/// The number of unknowns determines the tree: a part with up to 1/32 of them, or up to 4096, is a
/// leaf. Parts are divided and ordered in parallel.
///
/// `partners` holds, for every unknown, another one at the same position, or −1; it is empty if
/// there are none. Parts of such a mesh of two sheets may be disconnected, for example into the two
/// sheets; connected components are then separated first, without a separator.
std::vector<DissectionPart> Dissect(const Eigen::SparseMatrix<double>& matrix,
  const std::vector<SpacePoint>& places, const std::vector<int>& trailing,
  const std::vector<int>& leftOut = {}, const std::vector<int>& partners = {});

/// Returns a bound on the number of entries of the factor of a matrix with one unknown per vertex
/// of a planar mesh of n vertices, eliminated by nested dissection: 31/4 n log₂ n to leading order
/// (A. George, Nested dissection of a regular finite element mesh, 1973). The exact memory is
/// known, and checked again, once CHOLMOD has analysed the matrix.
double DissectionFill(double vertices);
}
