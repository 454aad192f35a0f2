#pragma once

#include "QuadMesh.h"

namespace crossfield
{
/// Finds the pairs of points of paired sides, in order from their ends. Throws Error if two sides have
/// different numbers of points, or closed ones fixed points that do not match.
void FindPairs(const BoundaryCurves& curves, QuadMesh& mesh);

/// Moves the points of pairs to positions that match: the image of a fixed point, or of the mean of both
/// along the first side. If one point of a pair is fixed, both are afterwards.
void MatchPairs(const BoundaryCurves& curves, QuadMesh& mesh);

/// Returns the largest distance of a point from the image of its partner.
double LargestMismatch(const PairedSides& pair, const QuadMesh& mesh);
double LargestMismatch(const QuadMesh& mesh);

/// Lets both points of a pair move only if both may.
void MovePairsTogether(const QuadMesh& mesh, std::vector<bool>& moves);

/// Copies the pairs of a mesh to a part of it. `number` gives the number of each point in the part, or
/// −1. Returns the points of the part whose partner it has not.
std::vector<int> CopyPairs(const QuadMesh& mesh, const std::vector<int>& number, QuadMesh& part);
}
