#pragma once

#include "QuadMesh.h"
#include "SeamlessMap.h"
#include "Singularity.h"

#include <cstddef>
#include <string>
#include <vector>

namespace crossfield
{
/// A node that is elsewhere than the position given for its singularity.
struct SingularityMove
{
  std::size_t row = 0; ///< Row of the configuration.
  Point from;
  Point to;
  double Distance() const { return (this->to - this->from).norm(); }
};

/// Returns the moves from one configuration to the same at other positions, without those that are
/// rounding. `extent` is the extent of the domain.
std::vector<SingularityMove> FindMoves(
  const Configuration& from, const Configuration& to, double extent);

/// Where the nodes of singularities are, and how far these are from where they started.
struct NodePlaces
{
  std::vector<SpacePoint> places;
  double moved = 0.0; ///< Maximum distance.
  /// A sentence for every singularity that moved by more than a tenth of the edges at its node.
  std::vector<std::string> events;
};

/// Finds the nodes of the singularities of a map in its quad mesh. `places` are those of its rows, `start` where
/// these were given or chosen.
NodePlaces FindNodePlaces(const SeamlessMap& map, const QuadMesh& mesh,
  std::vector<SpacePoint> places, const std::vector<SpacePoint>& start);

/// Singularities at the positions of their nodes, and how far these are from where they started.
struct NodePositions
{
  Configuration singularities;
  double moved = 0.0; ///< Maximum distance.
  /// A sentence for every singularity that moved by more than a tenth of the edges at its node.
  std::vector<std::string> events;
};

/// Returns those of singularities in the plane.
NodePositions FindNodePositions(const SeamlessMap& map, const QuadMesh& mesh,
  const Configuration& singularities, const Configuration& start);
}
