#pragma once

#include "Layout.h"
#include "MeshBoundary.h"
#include "PairedSides.h"
#include "QuantisationProblem.h"
#include "TMesh.h"

#include <vector>

namespace crossfield
{
// The two sides of lines between faces of a surface: pairs with spans, whose sides have numbers 2 i and 2 i + 1.

/// Returns the side of each arc of a T-mesh, −1 if it is on none of a pair.
std::vector<int> SidesOfArcs(
  const std::vector<PairedSides>& pairs, const MeshBoundary& curves, const TMesh& mesh);

/// The names of the sides of a surface, and of the lines between its faces.
struct SurfaceSideNames
{
  std::vector<std::string> ofEntries; ///< Per entry of mesh.boundary.
  std::vector<std::string> ofLoops;   ///< Those of the boundary, in order along its loops.
};

/// Returns the given names of sides, completed by NameBoundary.
SurfaceSideNames NamesOfSides(const LayoutSet& layouts, const std::vector<int>& sideOfArc);

/// Returns the sums that make both sides of each pair equal: Σ n_a of the first − Σ n_a of the second = 0.
std::vector<CountSum> SumsOfPairs(
  const std::vector<PairedSides>& pairs, const std::vector<int>& sideOfArc);

/// Returns the face of each arc: the connected parts of a surface, in the order of their first triangles.
std::vector<int> FacesOfArcs(const MeshTopology& topology, const TMesh& mesh);

/// Multiplies the lengths of the arcs of each face by a constant, so that lengths of lines in both of their faces agree as
/// well as possible, and the area stays (docs/method.md §22.12): the constants c minimise
/// Σ ℓ (log ℓ_left + log c_left − log ℓ_right − log c_right)² over the lines, ℓ the mean of both lengths.
void MatchFaces(const TMesh& mesh, const std::vector<int>& faceOfArc,
  const std::vector<CountSum>& sums, std::vector<double>& lengths);
}
