#pragma once

#include "BoundarySides.h"
#include "BoundarySymmetry.h"
#include "QuadResult.h"
#include "QuadSizes.h"
#include "SidePrescription.h"

#include "Layout.h"

namespace crossfield
{
/// Points, quads, lattices, energy, and corrections of four numbers per point: 770 bytes per quad
/// were measured with a million quads, 930 with uniform sizes.
constexpr double BytesPerQuad = 1000.0;

struct QuadOptions
{
  /// Target side length of quads in the map, whose area is the domain's; 0: set by quadCount.
  double quadSize = 0.0;
  int quadCount = 1000; ///< Target number of quads if quadSize is 0.
  TargetSizes sizes;    ///< Variation of the size over the domain.
  /// Weight of sizes against shapes in smoothing, between 0 and 1; not used with Sizing::Conformal
  /// unless a side is graded.
  double sizePart = 0.5;
  BoundarySides sides;          ///< Sides of the boundary; none: it has no names.
  CurvedBoundary curves;        ///< Curves that the boundary nodes are placed on.
  SidePrescriptions prescribed; ///< Counts, progressions and sizes of sides.
  /// Arcs of the T-mesh that get no edges, unless no counts permit that: those without edges in
  /// counts of the same arcs for other sizes.
  std::vector<std::size_t> arcsWithoutEdges;
  /// With interfaces, the symmetries of what all regions cover, the identity first; otherwise those of the domain
  /// are used.
  std::vector<Isometry> symmetries;
  std::vector<Point> nodes; ///< Places where the mesh has nodes.
  bool hold = false;        ///< Keeps inner singularities at their positions in smoothing.
  bool smooth = true;       ///< If false, points keep their positions in the map (draft quads).
  /// Uses the fewest blocks that give a good mesh instead of the most accurate sizes; needs `smooth`.
  bool coarse = false;
};

/// Throws Error unless the size is positive, or it is 0 and the count is positive.
void RequireSize(double quadSize, int quadCount);

/// Makes quads of layouts whose nodes are at their places in the map (docs/method.md §14): edge counts,
/// quads and blocks; the quality is not measured. Nodes on paired sides match. Throws Error if there is more than one region, if the size or count
/// is not positive, if more quads would be built than fit into memory, and as Quantise and BuildQuads do.
QuadResult MakeDraftQuads(
  const LayoutSet& layouts, const QuadOptions& options, const Progress& progress = {});

/// Smooths quads of MakeDraftQuads and measures their quality, and uses fewer blocks if QuadOptions::coarse
/// is set. The options may have another sizePart and hold than those of the draft.
void SmoothDraftQuads(const LayoutSet& layouts, const QuadOptions& options, QuadResult& quads,
  const Progress& progress = {});

/// Makes draft quads and smooths them unless QuadOptions::smooth is false. Throws Error as MakeDraftQuads
/// does.
QuadResult MakeQuads(
  const LayoutSet& layouts, const QuadOptions& options, const Progress& progress = {});
}
