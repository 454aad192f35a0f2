#pragma once

#include "EdgeNumbering.h"
#include "PlanarDomain.h"
#include "Singularity.h"

namespace crossfield
{
/// The count of quarter indices of the generalised Poincaré-Hopf theorem (METHOD §7; paper,
/// "Generalized Poincaré-Hopf theorem").
struct PoincareHopfCount
{
  int eulerCharacteristic = 0;
  /// (1/2π) Σ over corners of the smallest rotation of the cross, in (−π/4, π/4], that keeps it
  /// aligned with the boundary.
  double valence = 0.0;
  /// (1/2π) of the rotation of the tangent along the boundary without its corners.
  double tangentTurning = 0.0;
  int requiredInteriorQuarters = 0; ///< 4 (valence + tangentTurning), an integer.
  int givenInteriorQuarters = 0;

  bool Consistent() const { return requiredInteriorQuarters == givenInteriorQuarters; }
};

/// Smallest rotation of a cross, in (−π/4, π/4], that keeps it aligned where the tangent turns.
double SmallestRotation(double turning);

/// Counts over loops with the domain on their left.
PoincareHopfCount CountQuarters(const std::vector<Loop>& loops, int givenInteriorQuarters,
  double cornerAngle = DefaultCornerAngle);

/// Counts over the outer and inner loops of a drilled mesh, and the quarter indices of its holes.
PoincareHopfCount CountMeshQuarters(
  const TriangleMesh& mesh, const std::vector<BoundaryLoop>& loops);

/// Throws Error with both sums when they differ.
void RequireConsistent(const PoincareHopfCount& count);
}
