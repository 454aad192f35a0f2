#pragma once

#include "Plane.h"

#include <Eigen/SparseCore>

namespace crossfield
{
/// Fill-reducing elimination order of a symmetric sparse matrix whose unknowns have places in the
/// plane: recursively split at the median across the direction that meets fewer points, number the
/// unknowns of the left half that touch the right half last (docs/method.md §10.2).
///
/// `places` has one point per unknown; the unknowns in `trailing` come at the very end, in the order
/// given. Returns the order: entry i is the unknown that is eliminated i-th.
std::vector<int> NestedDissection(const Eigen::SparseMatrix<double>& matrix,
  const std::vector<Point>& places, const std::vector<int>& trailing = {});

/// The same order by its first separator: `left` and `right` are in elimination order, and no entry
/// of the matrix joins them; `border` is the separator followed by `trailing`. Unknowns in `leftOut` are in
/// none of them. The halves are ordered in two threads.
///
/// `partners`: of every unknown another one at the same place, or −1; empty where there are none. A part of such a
/// mesh of two sheets may fall apart, for example into both sheets: what is not connected is then split first, without a
/// separator.
struct Dissection
{
  std::vector<int> left;
  std::vector<int> right;
  std::vector<int> border;
};
Dissection Dissect(const Eigen::SparseMatrix<double>& matrix, const std::vector<Point>& places,
  const std::vector<int>& trailing, const std::vector<int>& leftOut = {},
  const std::vector<int>& partners = {});

/// Bound on the entries of the factor of a matrix with an unknown at each of n vertices of a planar
/// mesh, eliminated by nested dissection: 31/4 n log₂ n to leading order (A. George, Nested
/// dissection of a regular finite element mesh, 1973). What it takes in fact is known, and checked
/// again, once CHOLMOD has analysed the matrix.
double DissectionFill(double vertices);
}
