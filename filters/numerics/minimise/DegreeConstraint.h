#pragma once

#include "CrouzeixRaviart.h"

namespace crossfield
{
/// Degree constraint of one hole (docs/method.md §3.1; paper, "Definition of the constraint for
/// holed singularities"). With u_j the values at the m edges of the hole, counter-clockwise and
/// cyclic,
///   C(u) = ½ Σ_j Im(conj(u_j) (u_{j+1} − u_{j−1})) = Σ_j Im(conj(u_j) u_{j+1}).
/// It equals ½ uᴴ A u for the Hermitian matrix A with A_{j,j+1} = −i, A_{j,j−1} = i.
///
/// Difference from the paper: the sum is over all m edges, and the target is not 2πd but the value
/// of C for unit vectors whose phase is d times the angle seen from the centre.
struct DegreeConstraint
{
  std::vector<int> unknowns; ///< Positions of the u_j in the vector of all hole unknowns.
  int degree = 0;
  double target = 0.0;
  /// Unit values e^{i d α_j}, where α_j is the angle of edge j seen from the centre. Their C is the
  /// target.
  std::vector<Complex> turning;

  double Value(const ComplexVector& u) const;
  /// Returns A u at the positions of the u_j, and zero elsewhere.
  ComplexVector Gradient(const ComplexVector& u) const;
  /// Returns A over `size` unknowns.
  Eigen::SparseMatrix<Complex> Hessian(Eigen::Index size) const;
};

/// Builds the constraint for edges with the given midpoints, counter-clockwise, seen from the given
/// centre. The centre is CentreOf the loop, which is the centre of the circle even where the mesher
/// has divided some edges. Throws Error as DegreeTarget does.
DegreeConstraint MakeDegreeConstraint(
  std::vector<int> unknowns, const std::vector<Point>& midpoints, const Point& centre, int degree);

/// Returns Σ_j sin(d Δα_j), where Δα_j is the angle between the midpoints of edges j and j + 1 seen
/// from the centre; m sin(2πd/m) on a regular polygon. Throws Error unless |d| < m/2.
double DegreeTarget(const std::vector<Point>& midpoints, const Point& centre, int degree);
}
