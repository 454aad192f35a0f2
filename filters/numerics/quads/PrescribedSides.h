#pragma once

#include "BoundarySides.h"
#include "QuadMesh.h"
#include "QuantisationProblem.h"
#include "SidePrescription.h"
#include "TMesh.h"

#include "SeamlessMap.h"

namespace crossfield
{
/// Throws Error if prescriptions are out of range, contradict each other on one side, or prescribe a
/// progression on a closed curve, which has no ends.
void RequireConsistent(const BoundarySides& sides, const std::vector<LoopArc>& loops,
  const SidePrescriptions& prescribed);

/// Returns the sums of edge counts that are prescribed, for a T-mesh that is split at the ends of
/// the sides (SplitAtSides). Throws Error if edges are too long for a part of their side.
std::vector<CountSum> PrescribedSums(const SeamlessMap& map, const BoundaryCurves& curves,
  const BoundarySides& sides, const SidePrescriptions& prescribed, const TMesh& mesh);

/// Arcs of a T-mesh along graded sides, with the positions of their ends.
class GradedArcs
{
public:
  GradedArcs(const SeamlessMap& map, const BoundaryCurves& curves, const BoundarySides& sides,
    const SidePrescriptions& prescribed, const TMesh& mesh);

  /// Replaces the target edge counts of the arcs by those of the progressions, so that the numbers
  /// of strips follow them, for the same sum along every side or the prescribed one.
  void SetTargets(std::vector<double>& targets) const;
  /// Raises the weights of the arcs in a problem.
  void SetWeights(QuantisationProblem& problem) const;

private:
  /// A part of a side between corners or ends.
  struct Part
  {
    std::vector<int> arcs;
    std::vector<double> ends; ///< Lengths along the part, one more than arcs.
    std::size_t side = 0;     ///< Index in Prescribed.
  };

  const SidePrescriptions Prescribed;
  std::vector<Part> Parts;
};

/// Moves the points of graded sides and of sides with a prescribed size to their final positions,
/// from one corner or end of the side to the next, and fixes them. The lengths of graded edges
/// become the targets of all quads in their strips (chords): along a strip the target lengths keep
/// their variation and are multiplied by one factor or, if both ends are graded, by a geometric
/// mean of two.
void PlaceOnSides(
  const BoundaryCurves& curves, const SidePrescriptions& prescribed, QuadMesh& mesh);
}
