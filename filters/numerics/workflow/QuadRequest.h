#pragma once

#include "Alternatives.h"
#include "AutomaticConfiguration.h"
#include "BoundaryLayers.h"
#include "BoundarySides.h"
#include "CornerRows.h"
#include "HolonomyRepair.h"
#include "InterfaceMeasures.h"
#include "NodePositions.h"
#include "PairedSides.h"
#include "PrescribedSizes.h"
#include "QuadMesher.h"
#include "SeamlessMapSolve.h"
#include "SideRequest.h"
#include "SizeReport.h"

#include <optional>
#include <string>
#include <vector>

namespace crossfield
{
/// How separatrices that nearly meet are treated.
enum class BlockMerge
{
  None,  ///< Each one bounds blocks of its own.
  Clean, ///< Singularities are moved so that they meet, where this costs no quality.
  Coarse ///< They are merged without moving singularities (QuadOptions::coarse).
};

/// Number of quads where neither a size nor a number is requested.
constexpr int DefaultQuads = 1000;

/// Target size of quads near a position.
struct SizeNear
{
  Point place = Point::Zero();
  double size = 0.0;
  double radius = 0.0; ///< Up to this distance; farther away sizes grow.
};

/// Input of MakeQuadMesh besides the domain.
struct QuadRequest
{
  std::optional<Configuration> singularities; ///< Chosen for the domain if absent.
  std::vector<CornerChoice> corners;          ///< Prescribed quarter indices of corners.
  BoundarySides sides; ///< Sides of the boundary; if it has no names, those of NameSides.
  std::vector<SideRequest> sideRequests; ///< What is prescribed for sides.
  std::vector<CornerRule> cornerRows;    ///< What rows do at corners.
  CurvesOfSegments givenCurves;          ///< Curves of the segments of the domain.
  bool findsArcs = false; ///< Recognises arcs of circles on sides and segments without a curve.

  /// Absent: conformal, and uniform where singularities leave sizes too different (SizingChoice.h).
  std::optional<Sizing> sizing;
  PrescribedSizes prescribedSizes; ///< Used with Sizing::Field only.
  /// Side length of quads; with Sizing::Field, a factor of the prescribed sizes. 0: derived from
  /// quadCount.
  double quadSize = 0.0;
  /// Target number of quads if quadSize is 0; 0: as many as prescribed sizes need (SizeTargets.h).
  int quadCount = DefaultQuads;
  std::vector<SizeNear> sizesNear;
  std::vector<Point> nodes; ///< Places where the mesh has nodes.
  double minimumSize = 0.0; ///< Lower bound of the target size; 0: none.
  double maximumSize = 0.0; ///< Upper bound of the target size; 0: none.
  double growth = 1.25;     ///< Maximum ratio of target sizes of neighbours, above 1.

  double meshSize = 0.0; ///< Edge length of triangles, as in DrillOptions.
  /// Minimum distance of chosen singularities from the boundary and from each other; 0: derived
  /// from the size of quads.
  double clearance = 0.0;
  int pairs = 0;          ///< Maximum number of pairs added to chosen singularities.
  bool capCorners = true; ///< As in SeamlessMapOptions.
  bool hold = false;      ///< Keeps the nodes of given singularities where these are.
  bool repairHolonomy = false;
  /// Part of the way to the positions without holonomy defects, 0 to 1, that repairHolonomy moves
  /// the singularities. About 1 − repairPart of the defects remains.
  double repairPart = 1.0;
  /// Splits interior singularities of quarter index ±2 and beyond into ones of index ±1
  /// (IndexSplit.h).
  bool split = false;
  BlockMerge merge = BlockMerge::None;
  /// What matters most where several configurations are chosen; absent: the energy.
  std::optional<MeshPreference> preference;
  int alternative = 0; ///< Which of QuadWorkflowResult::alternatives is used, from 0.

  bool isPart = false; ///< Of a domain with several: the number of quads of all of them matters.

  double layerDistance =
    1.0; ///< Factor of the distance that chosen singularities keep from layers.
};

/// What quads have of a curve.
struct CurveReport
{
  std::vector<int> sides; ///< Sides of its edges, in QuadMesh::sideNames.
  int edges = 0;          ///< Boundary edges on the curve.
  double moved = 0.0;     ///< Largest distance of their nodes from the polyline that was given.
};

/// Numbers of blocks with each kind of merging, as far as they were computed.
struct BlockCounts
{
  std::optional<int> none;
  std::optional<int> clean;
  std::optional<int> coarse;
};

/// Wall-clock time of each step of MakeQuadMesh in all attempts, in seconds.
struct QuadSeconds
{
  double choose = 0.0; ///< Choosing and repairing singularities.
  double mesh = 0.0;
  double map = 0.0;
  double clean = 0.0; ///< 0 unless blocks are merged with BlockMerge::Clean.
  double trace = 0.0;
  double integers = 0.0;
  double layout = 0.0;
  double smooth = 0.0;
};

/// A region of one material in a mesh of several.
struct RegionReport
{
  int material = 0;         ///< Index in QuadWorkflowResult::materials.
  int requiredQuarters = 0; ///< Sum of quarter indices that its singularities must have.
  int givenQuarters = 0;    ///< Sum of those that they have.
  std::size_t quads = 0;
};

/// An attempt to make quads (QuadAttempts.h) in words.
struct AttemptReport
{
  std::string what;
  std::string outcome; ///< A sentence about its quads, or the cause of its error.
};

/// A quad mesh, and the singularities and corners that it was made of.
struct QuadWorkflowResult
{
  Configuration singularities; ///< Given or chosen, at the positions of their nodes.
  double moved = 0.0;          ///< Maximum distance of a node from the position given or chosen.
  /// Moves of given singularities; absent if they were chosen.
  std::optional<std::vector<SingularityMove>> moves;
  std::vector<CornerChoice> corners; ///< All corners of the boundary with the quarter indices used.
  int ambiguousCorners = 0; ///< Corners that are not prescribed and within AmbiguousAngle of a tie.
  /// Decisions made in choosing and in merging blocks, moves of singularities, and whether the mesh
  /// was refined; one sentence each.
  std::vector<std::string> events;
  std::vector<AttemptReport> attempts;
  /// Meshes of the configurations that were chosen, the preferred one first; empty if there is one.
  std::vector<Alternative> alternatives;
  /// Run that chose them; absent if they were given, or the domain has several parts.
  std::optional<OptimizerResult> optimum;
  std::optional<HolonomyRepair> repair;       ///< If it was requested or necessary.
  std::vector<double> holonomyDefect;         ///< Defects of the map per inner loop, radians.
  std::optional<FlatteningReport> flattening; ///< As in SeamlessMap.
  /// What is wrong with the mesh, and what helps where something was found that does: positions of
  /// chosen singularities that are no minimum, another number of quads than requested, nodes of
  /// valence 2, stretched, inverted or nearly degenerate quads. One sentence each.
  std::vector<std::string> warnings;
  QuadResult quads;
  std::optional<SizeReport> sizes; ///< Absent if no sizes are requested but one for all quads.
  std::vector<int> part;           ///< Part of the domain of each quad, from 0 (MakeQuadsOfParts).
  std::vector<std::string> materials; ///< Empty unless the domain has regions (MakeQuadsOfRegions).
  std::vector<RegionReport> regions;
  std::vector<InterfaceMeasure> interfaces;
  std::vector<int> region;         ///< Region of each quad; empty without regions.
  std::vector<LayerReport> layers; ///< One for each layer of the request.
  CurvedBoundary boundary;         ///< The curves that boundary nodes are on.
  std::vector<CurveReport> curves; ///< One for each of these curves.
  BlockCounts blocks;
  QuadSeconds seconds;

  /// Returns the number of parts of the domain.
  int PartCount() const { return this->part.empty() ? 1 : this->part.back() + 1; }
};
}
