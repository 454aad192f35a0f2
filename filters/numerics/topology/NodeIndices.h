#pragma once

#include <optional>
#include <vector>

namespace crossfield
{
/// The corner of a region at a node of regions.
struct NodeCorner
{
  int region = 0;
  double angle = 0.0;            ///< Interior angle in radians.
  std::optional<int> prescribed; ///< Quarter index.
};

/// A point where regions meet.
struct NodeCorners
{
  std::vector<NodeCorner> corners;
  bool isOnBoundary = false;
};

/// Returns the quarter index of a node in a mesh of all regions: 4 − Σ (2 − k_r) inside, 2 − Σ (2 − k_r)
/// on the boundary, for the quarter indices k_r of the regions' corners there.
int IndexOfNode(const std::vector<int>& quarterIndices, bool isOnBoundary);

/// Chooses the quarter indices k_nr of the corners of regions at all nodes n together (docs/method.md
/// §21.2): minimises
///   Σ_nr e(α_nr, k_nr) + π/16 (Σ_n |k_n − κ_n| + Σ_r |Q_r − Σ_n k_nr|)
/// over k_nr ≤ 1, with the corner energy e, the index k_n of a node (IndexOfNode), κ_n inside the one that the sum of the
/// angles suggests, 0 in the plane, and on the
/// boundary the index that the outer boundary has there by the smallest rotation. `required` are the sums
/// Q_r of quarter indices that singularities of a region must have if its corners at nodes have none.
/// Nodes are improved one after the other until none can be; what is found is a local minimum.
/// Returns the indices per node, in the order of its corners.
std::vector<std::vector<int>> ChooseNodeIndices(
  const std::vector<NodeCorners>& nodes, const std::vector<int>& required);
}
