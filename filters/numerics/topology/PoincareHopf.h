#pragma once

#include "BoundaryCorners.h"
#include "MeshTopology.h"
#include "Singularity.h"

#include <string>

namespace crossfield
{
/// What one loop contributes to the count; all loops together give its sums.
struct LoopCount
{
  double valence = 0.0;        ///< As in PoincareHopfCount, of this loop.
  double tangentTurning = 0.0; ///< Likewise.
  /// Quarter indices of its corners. Its part of the required quarters is 4 minus this for the
  /// outer loop, −4 minus this for an inner one.
  int cornerQuarters = 0;
};

/// A corner with the quarter index that it was counted with.
struct CountedCorner : Corner
{
  int quarterIndex = 0;
  bool chosen = false; ///< Instead of the smallest rotation.
};

/// The count of quarter indices of the generalised Poincaré-Hopf theorem (docs/method.md §7.1; paper,
/// "Generalized Poincaré-Hopf theorem").
struct PoincareHopfCount
{
  int eulerCharacteristic = 0;
  /// (1/2π) Σ over corners of the smallest rotation of the cross, in (−π/4, π/4], that keeps it
  /// aligned with the boundary; where a quarter index k was chosen, of the turning angle − k π/2.
  double valence = 0.0;
  /// (1/2π) of the rotation of the tangent along the boundary without its corners.
  double tangentTurning = 0.0;
  /// 4 (valence + tangentTurning) = 4χ − Σ k over the corners, an integer.
  int requiredInteriorQuarters = 0;
  int givenInteriorQuarters = 0;
  bool hasChoices = false; ///< Some quarter index was chosen.
  std::vector<LoopCount> loops;
  /// Corners, and other vertices with a chosen index.
  std::vector<CountedCorner> corners;

  bool Consistent() const { return requiredInteriorQuarters == givenInteriorQuarters; }
};

/// Smallest rotation of a cross, in (−π/4, π/4], that keeps it aligned where the tangent turns.
double SmallestRotation(double turning);

/// The quarter index that the smallest rotation leaves at a corner: (turning − rotation) / (π/2).
int SmallestRotationIndex(double turning);

/// Counts over loops with the domain on their left. `choices` replace the smallest rotations at
/// their vertices, corners or not; Error when one is not at a vertex.
PoincareHopfCount CountQuarters(const std::vector<Loop>& loops, int givenInteriorQuarters,
  double cornerAngle = DefaultCornerAngle, const std::vector<CornerChoice>& choices = {});

/// The choices that a count was made with, completed by index 1 for the corners whose smallest rotation has
/// index 2 or more, which have no angle in a flat map (docs/method.md §12).
std::vector<CornerChoice> CapCorners(
  const PoincareHopfCount& count, const std::vector<CornerChoice>& choices);

/// Counts over the aligned loops of a mesh, and the quarter indices of its holes and imprinted circles.
PoincareHopfCount CountMeshQuarters(
  const MeshTopology& topology, const std::vector<CornerChoice>& choices = {});

/// Radians; a smaller holonomy defect may come from the mesh.
constexpr double NoticeableDefect = 1e-2;

/// One sentence: the sums agree, or by how much they differ and what to add, or to remove if the sum given
/// says that there is as much. When they
/// agree it also names the first inner loop with a NoticeableDefect (HolonomyCheck.h).
std::string ConsistencyReason(
  const PoincareHopfCount& count, const std::vector<double>& holonomyDefects = {});

/// Throws Error with this sentence when the sums differ.
void RequireConsistent(const PoincareHopfCount& count);
}
