#pragma once

#include "BoundaryCorners.h"
#include "PlanarTopology.h"
#include "Singularity.h"

#include <string>

namespace crossfield
{
/// Contribution of one loop to the count; the sums of PoincareHopfCount are over all loops.
struct LoopCount
{
  double valence = 0.0;        ///< As in PoincareHopfCount, for this loop.
  double tangentTurning = 0.0; ///< As in PoincareHopfCount, for this loop.
  /// Sum of the quarter indices of its corners. The loop contributes 4 minus this to the required
  /// quarters if it is the outer loop, and −4 minus this if it is an inner one.
  int cornerQuarters = 0;
};

/// Corner with the quarter index used in the count.
struct CountedCorner : Corner
{
  int quarterIndex = 0;
  bool chosen = false; ///< Whether the index was chosen, not taken from the smallest rotation.
};

/// Count of quarter indices by the generalised Poincaré-Hopf theorem (docs/method.md §7.1; paper,
/// "Generalized Poincaré-Hopf theorem").
struct PoincareHopfCount
{
  int eulerCharacteristic = 0;
  /// (1/2π) Σ over corners of the smallest rotation of the cross, in [−π/4, π/4], that keeps it
  /// aligned with the boundary. At a corner with a chosen quarter index k, the rotation is the
  /// turning angle − k π/2.
  double valence = 0.0;
  /// 1/2π times the rotation of the tangent along the boundary without its corners.
  double tangentTurning = 0.0;
  /// 4 (valence + tangentTurning) = 4χ − Σ k over the corners, an integer.
  int requiredInteriorQuarters = 0;
  int givenInteriorQuarters = 0;
  bool hasChoices = false; ///< Whether some quarter index was chosen.
  std::vector<LoopCount> loops;
  /// Corners, and other vertices with a chosen index.
  std::vector<CountedCorner> corners;

  bool Consistent() const { return requiredInteriorQuarters == givenInteriorQuarters; }
};

/// Returns the smallest rotation of a cross, in [−π/4, π/4] up to TieRounding, that keeps it aligned where the tangent
/// turns. Of two equal ones, it is the turning itself at ±π/4, so that the boundary is smooth there, and the positive
/// one at ±3π/4.
double SmallestRotation(double turning);

/// Returns the quarter index that the smallest rotation leaves at a corner: (turning − rotation) /
/// (π/2).
int SmallestRotationIndex(double turning);

/// Counts over loops with the domain on their left. `choices` replace the smallest rotations at
/// their vertices, which need not be corners. Throws Error when a choice is not at a vertex.
PoincareHopfCount CountQuarters(const std::vector<Loop>& loops, int givenInteriorQuarters,
  double cornerAngle = DefaultCornerAngle, const std::vector<CornerChoice>& choices = {});

/// Returns the number of corners without a chosen index that are within AmbiguousAngle of a tie.
int CountAmbiguous(const PoincareHopfCount& count);

/// Returns the choices with which a count was made, completed by index 1 for the corners whose
/// smallest rotation has index 2 or more. Such corners have no angle in a seamless map
/// (docs/method.md §12).
std::vector<CornerChoice> CapCorners(
  const PoincareHopfCount& count, const std::vector<CornerChoice>& choices);

/// Counts over the aligned loops of a mesh, and adds up the quarter indices of its holes and
/// imprinted circles.
PoincareHopfCount CountMeshQuarters(
  const PlanarTopology& topology, const std::vector<CornerChoice>& choices = {});

/// Holonomy defect, in radians, below which the defect may be an artefact of the mesh.
constexpr double NoticeableDefect = 1e-2;

/// Returns the angle of the crosses by which grid lines miss, a quarter of a holonomy defect in
/// radians, as text such as "12.5°".
std::string CrossAngle(double defect);

/// Returns one sentence: either that the sums agree, or by how much they differ and what to add. It
/// also suggests what to remove if the given sum shows that there is enough to remove. When the
/// sums agree it names the first inner loop with a NoticeableDefect (HolonomyCheck.h).
std::string ConsistencyReason(
  const PoincareHopfCount& count, const std::vector<double>& holonomyDefects = {});

/// Throws Error with the sentence of ConsistencyReason when the sums differ.
void RequireConsistent(const PoincareHopfCount& count);
}
