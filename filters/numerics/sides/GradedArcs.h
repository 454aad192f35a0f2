#pragma once

#include "BoundarySides.h"
#include "MeshBoundary.h"
#include "QuantisationProblem.h"
#include "SidePrescription.h"
#include "TMesh.h"

#include "SeamlessMap.h"

namespace crossfield
{
/// Arcs of a T-mesh along sides that are graded or have a prescribed number or length of edges,
/// with the positions of their ends.
class GradedArcs
{
public:
  GradedArcs(const SeamlessMap& map, const MeshBoundary& curves, const BoundarySides& sides,
    const SidePrescriptions& prescribed, const TMesh& mesh);

  /// Replaces the target edge counts of the arcs by those of the progressions, so that the numbers
  /// of strips follow them, for the same sum along every side or the prescribed one. Without a
  /// progression, targets are multiplied so that their sum is the prescribed one, or are those of
  /// edges of the prescribed length: the objective is linear, and to satisfy the sums alone it
  /// would change the numbers of few arcs by much instead of those of all by little.
  void SetTargets(std::vector<double>& targets) const;
  /// Returns the arcs with a prescribed number or length of edges and no progression.
  std::vector<int> ArcsWithCounts() const;
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
}
