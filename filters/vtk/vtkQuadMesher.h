/**
 * @class   vtkQuadMesher
 * @brief   an all-quad mesh with exactly the chosen irregular nodes, and its blocks
 *
 * A singularity of quarter index k becomes a node of valence 4 − k, a corner of quarter index k a
 * node with 2 − k quads; all other nodes are regular. The separatrices that leave them in the map
 * of vtkCrossFieldMap cut the domain into rectangular patches. Edge counts along the sides of the
 * patches, nearest to the target size, come from a minimum cost flow. Each patch becomes a lattice
 * of quads, and nodes move, on the boundary along its polyline, until the quads have their best
 * shape.
 *
 * Port 0, the domain (vtkDataSet, or blocks of it): as for vtkDrillHoles, but it may have several
 * parts that do not touch, and loops in several blocks may bound one domain. Surface cells that are not in a plane
 * are a surface in space, closed or with a boundary: the quarter indices of its singularities and those
 * of corners add up to 4χ in each part, and of the properties only QuadSize, QuadCount, those of sizes but for sides, HoldSingularities, FeatureAngle, ChordError,
 * MaterialArray, SideNameArray and Merge (none or coarse) apply; others
 * are an error if they are set. Its sharp edges are lines of quads, and each face between them has singularities of its own. Port 1, optional,
 * singularities (points), and port 2, optional, corners: as for vtkHField. If port 1 has no
 * connection, singularities are chosen, on a surface in space those of smooth crosses, otherwise as
 * vtkConfigurationProposal does with Automatic, then moved to suit the requested quads. A connected data set without points means no singularities.
 *
 * Port 3, optional, what is prescribed for sides (vtkTable), one row for each: `Side`, the name (see
 * SideNameArray), and any of the columns `Count`, `Progression`, `Size` and `SizeInside` (see AddSide), `Curve` (circle,
 * ellipse, spline or line; see Curves), `LayerFirst`, `LayerGrowth` and `LayerRows` (see Layers), `Partner`, the
 * side whose nodes match (see Periodic), and `CornerRows` (end, turn or leave; see CornerRows). Columns are
 * strings or numbers; empty strings, 0 and NaN prescribe nothing. The table adds to the properties; what
 * both prescribe for a side is an error.
 *
 * Output 0 (vtkUnstructuredGrid): VTK_QUAD, counter-clockwise, with
 * - cells: `BlockId`, `I`, `J` (int): block, column and row; `ScaledJacobian` (double): the minimum
 *   sine of the angles of a quad; `SizeRatio` (double): actual over target size; `Part` (int): part of
 *   the domain;
 * - points: `Valence` (int): number of quads at the node; `Irregular` (int): the quarter index of a
 *   singularity or corner, else 0; `BoundarySide` (int): number of the boundary loop, −1 inside.
 *
 * Output 1 (vtkMultiBlockDataSet): a right-handed vtkStructuredGrid per block with the cell arrays
 * `BlockId` and `Part`; shared points are equal in every bit. Field data of each block, per side J
 * = 0, I largest, J largest, I = 0: `NeighbourBlock` (the adjacent block, −1: the boundary),
 * `NeighbourSide` (the adjacent side of that block), `NeighbourOrientation` (1: the points of both
 * sides, by increasing I or J, have the same order; −1: the reversed order; 0: boundary), and
 * `SideName` (string): the name of the boundary's side, several of them separated by commas, empty
 * inside. Every side that is not on the boundary is adjacent to exactly one complete side.
 *
 * Output 2 (vtkPolyData): the layout: the sides of the blocks as polylines along edges of quads,
 * with the cell array `Edges` (int): quads along each. A side that two blocks share occurs once.
 *
 * Output 3 (vtkPolyData): the singularities used, as points with `QuarterIndex` (int) and, where
 * port 1 gives one, `Radius` (double): those of port 1 or those chosen, at the positions of their
 * nodes. If they were chosen or moved (also by MergeClean), with the field data `Events`.
 *
 * Output 4 (vtkPolyData): the corners used, as points with `QuarterIndex` (int): all corners of the
 * boundary, and the vertices of the boundary that have a singularity.
 *
 * Output 5 (vtkPolyData): a line for every boundary edge with the domain on its left, edge after edge
 * along each loop, with the cell arrays `BoundaryKind` and `BoundaryId` (int), as for vtkDrillHoles,
 * and `Side` (string), the name of its side (see SideNameArray), and the point array `VertexId` (int),
 * the point of output 0. If the boundary has curves (see Curves), also with the cell array `Curve` (int),
 * the curve that its ends are on, −1 without one, and the field data `CurveKind`, `CurveOffset` and
 * `CurveValues` (docs/curves.md); with Periodic, also with the field data `PeriodicSides` and `PeriodicMotion`.
 *
 * Output 6 (vtkPolyData): the irregular nodes, as points with `QuarterIndex` (int), 4 − valence, and
 * `Valence` (int). Corners and other boundary nodes are not among them.
 *
 * Output 7 (vtkPolyData): the separatrices of the map, from which the quads were built, as one
 * polyline per arc with the cell array `Edges` (int): quads along each, possibly 0.
 *
 * Output 8 (vtkTable): the column `Summary` with one row, a text for a view in lines of at most 60
 * characters: numbers of quads, blocks and irregular nodes, quality, inverted quads and warnings, or
 * after a failure the message. Its field data `Alarm` (int) is 1 after a failure, with inverted quads
 * and with warnings.
 * Its other field data are the report of the mesh: `Quads`, `Blocks`,
 * `BlocksUnmerged`, `BlocksClean` and `BlocksCoarse` (number of blocks with each kind of Merge, as
 * far as it was computed), `IrregularValence`, `IrregularObtained`, `IrregularRequested` (numbers of
 * interior nodes per valence), `ScaledJacobianRange` (minimum, mean), `ScaledJacobianBound`
 * (attainable minimum), on a surface in space `ScaledJacobianBySurface` (minimum, seen along its normal) and
 * `SurfaceDistance` (mean, maximum; of centres of quads from the surface), `MinimumAngle` (degrees), `EtaRange` (minimum, mean; 1 − (2/π) max |π/2
 * − angle|), `SizeRange` (minimum, mean, maximum of the square root of the area), `SizeVariation`
 * (standard deviation over mean of the same), `Size` (side length in the map), `Symmetries`
 * (number of symmetries of the domain that the quads have, 1 for the identity alone), `ZeroArcs`,
 * `IntegerVariables`, `IntegerGap`, `IntegerOptimal`, `Inverted` (number of quads that are not
 * positively oriented), `InvertedPlace` (3, position of the worst one), `Released` (whether
 * singularities had to move), `MoveSingularity`, `MoveFrom`, `MoveTo` and `MoveDistance` (moves of given
 * singularities: number, from 1, places and distance), `Moved` (maximum distance of a node from the position of its
 * singularity that was given or chosen), `HolonomyDefect` (per inner loop, radians),
 * `SideNames`, `SideEdges` and `SideLengths` (name, number of edges and length of each side),
 * `CurveSides`, `CurveEdges` and `CurveMoved` (names of the sides, number of edges and
 * largest distance of a node from the polyline of the domain, per curve),
 * per pair of Periodic `PeriodicSides` (2 names), `PeriodicMotion` (16, the matrix, row by row, that takes
 * points (x, y, z, 1) of the first side to those of the second), `PeriodicKind` (translation or rotation),
 * `PeriodicVector` (3), `PeriodicCentre` (3), `PeriodicAngle` (radians), `PeriodicEdges` and
 * `PeriodicMismatch` (largest distance of a node from the image of its partner),
 * `PredictedStretch` and `StretchReason` (as for vtkCrossFieldMap), `Events` (decisions made in
 * choosing singularities and merging blocks, and their moves by more than a tenth of a quad, one sentence each),
 * `Warnings` (one sentence each), `Attempts` (2 texts each: what was tried, and its outcome),
 * with sizes besides one for all quads `SizeTargetAreaShare` and `SizeTargetQuadShare` (parts of the area and of
 * the quads outside of layers whose size is within 25 % of the target), `SizeTargetFineMedian` (median of size over
 * target size in the tenth of the quads with the smallest targets), `SizeTargetLargestJump` (largest ratio of the sizes of
 * neighbours), `SizeTargetNodesAdded` (singularities beyond those given or required), `SizeTargetFactor` (by which
 * requested sizes were multiplied), `SizeTargetSideName` and `SizeTargetSideMedian` (where sizes are requested, and the
 * median of size over target size there),
 * `AlternativeNodes`, `AlternativeBlocks`, `AlternativeScaledJacobian` and
 * `AlternativeSizeVariation` (one tuple for each of several configurations that were chosen, the preferred one
 * first), and `AmbiguousCorners` (number of corners within 1° of a tie between two quarter
 * indices, if there are any).
 *
 * An empty domain gives empty outputs. Failure, with outputs that are empty except for the text: as
 * for vtkCrossFieldMap and vtkSeparatrices; a size so large that no mesh has the requested irregular nodes. A mesh with
 * inverted quads is output with a warning, and so is one whose minimum scaled Jacobian is below 0.05
 * or below 0.2 times the attainable one; the warning names the place.
 *
 * Paper: quads are left to "Further thoughts".
 *
 * @sa vtkCrossFieldMap, vtkSeparatrices, crossfield::MakeQuadMesh
 */

#ifndef vtkQuadMesher_h
#define vtkQuadMesher_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkNew.h"                     // for names and places of sides
#include "vtkUnstructuredGridAlgorithm.h"

#include <array>  // for rows of texts
#include <string> // for names
#include <vector> // for rows of texts

class vtkDataSet;
class vtkDoubleArray;
class vtkStringArray;
class vtkTable;
class vtkUnstructuredGrid;
struct NamedSurface;
namespace SideText
{
struct Row;
}
struct RegionValues;
namespace crossfield
{
class DomainPlane;
struct QuadRequest;
struct QuadWorkflowResult;
struct SurfaceRequest;
}

class VTKCROSSFIELDFILTERS_EXPORT vtkQuadMesher : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkQuadMesher* New();
  vtkTypeMacro(vtkQuadMesher, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Connects port 1, the singularities, port 2, the corners, or port 3, the table of sides, or sets it to a
   * data object.
   */
  vtkCrossFieldPortMacro(Singularities, 1);
  vtkCrossFieldPortMacro(Corners, 2);
  vtkCrossFieldPortMacro(SideTable, 3);
  ///@}

  ///@{
  /**
   * Sets the side length of quads in the map, whose area is that of the domain: about area / size²
   * quads. Default: 0, derived from QuadCount. Range: 0 or more.
   */
  vtkSetClampMacro(QuadSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(QuadSize, double);
  ///@}

  ///@{
  /**
   * Sets the target number of quads if QuadSize is 0. If the separatrices allow no number within 5
   * % of it, the nearest one found is used, with a warning. Sizes of sides, positions and insides of
   * sides hold if the number permits that, and are multiplied by a common factor otherwise, which the
   * report has. 0: as many quads as these sizes need, or 1000 without any. Default: 1000. Range: 0 or more.
   */
  vtkSetClampMacro(QuadCount, int, 0, VTK_INT_MAX);
  vtkGetMacro(QuadCount, int);
  ///@}

  /** Variation of the size of quads over the domain. */
  enum SizingType
  {
    SizingConformal = 0,
    SizingUniform = 1,
    SizingField = 2,
    SizingAutomatic = 3
  };

  ///@{
  /**
   * Selects the sizes of quads: those of the map, larger where its field spreads, which gives the
   * best shapes (SizingConformal); the same size everywhere, as far as the separatrices allow, for
   * which singularities may move (SizingUniform; see `Moved`); or the lengths in the point array
   * SizeArray of the domain, in the same manner (SizingField). With the last two, chosen
   * singularities are moved to where the sizes of the map are nearest to the target sizes, as with
   * UniformSizes of vtkSingularityOptimizer.
   *
   * SizingAutomatic retains the sizes of the map if the standard deviation of the sizes is at most
   * 0.12 of their mean, or 0.5 if singularities are given, and shapes are good; otherwise it moves nodes
   * towards uniform sizes as far as the worst quad stays good, those of given singularities last.
   * Default: SizingAutomatic.
   */
  vtkSetClampMacro(Sizing, int, SizingConformal, SizingAutomatic);
  vtkGetMacro(Sizing, int);
  void SetSizingToConformal() { this->SetSizing(SizingConformal); }
  void SetSizingToUniform() { this->SetSizing(SizingUniform); }
  void SetSizingToField() { this->SetSizing(SizingField); }
  void SetSizingToAutomatic() { this->SetSizing(SizingAutomatic); }
  ///@}

  ///@{
  /**
   * Sets the point array of the domain with the target length of quads for SizingField, in units of
   * the domain: linear on surface cells, or along curves, from which it is continued inside.
   * QuadSize is then a factor of these lengths; if it is 0, only their proportions matter. Default:
   * none.
   */
  vtkSetMacro(SizeArray, std::string);
  vtkGetMacro(SizeArray, std::string);
  ///@}
  /** Sets the name of the size array; overload for ParaView. */
  void SetSizeArray(const char* name) { this->SetSizeArray(std::string(name ? name : "")); }

  ///@{
  /**
   * Sets the cell array, of strings or integers, with the materials of the domain's surface cells. With
   * several of them, quads are made for each connected region of one material, with singularities and
   * corners of its own, and are one conforming mesh. Sides between two materials are called by both,
   * such as `steel+copper`, with a number if there are several. `none`: the domain is one region.
   * Default: empty, `Material` or `Region` if the domain has that array.
   */
  vtkSetMacro(MaterialArray, std::string);
  vtkGetMacro(MaterialArray, std::string);
  ///@}
  /** Sets the name of the array of materials; overload for ParaView. */
  void SetMaterialArray(const char* name) { this->SetMaterialArray(std::string(name ? name : "")); }

  ///@{
  /**
   * Sets the cell array, of strings or integers, with the names of the domain's sides: of its lines,
   * or, beside surface cells, of lines along their boundary. Lines of equal names are one side.
   * Segments without a name are split at corners into `outer0`, `outer1`, ..., `hole0`, ... Quads
   * have a node wherever the name changes. Default: none, `Side` if the domain has that array.
   */
  vtkSetMacro(SideNameArray, std::string);
  vtkGetMacro(SideNameArray, std::string);
  ///@}
  /** Sets the name of the array of sides; overload for ParaView. */
  void SetSideNameArray(const char* name) { this->SetSideNameArray(std::string(name ? name : "")); }

  ///@{
  /**
   * Sets lines inside of the domain along which quads are aligned, such as welds and lines of measurements: the names of
   * line cells in the array of sides, separated by semicolons. They may end anywhere, meet and cross. Sides may be
   * prescribed for them. Default: empty, lines inside of the domain are ignored.
   */
  vtkSetMacro(Lines, std::string);
  vtkGetMacro(Lines, std::string);
  ///@}
  /** Sets the lines; overload for ParaView. */
  void SetLines(const char* names) { this->SetLines(std::string(names ? names : "")); }

  ///@{
  /**
   * Sets lines and sides between materials that are open, such as cracks and contacts, by their names, separated by
   * semicolons: both sides have nodes of their own at equal places, and are called by the name with `.left` and
   * `.right`, in the direction of the line, or of the first material. Ends of lines inside of the domain have one
   * node. Default: empty.
   */
  vtkSetMacro(OpenLines, std::string);
  vtkGetMacro(OpenLines, std::string);
  ///@}
  /** Sets the open lines; overload for ParaView. */
  void SetOpenLines(const char* names) { this->SetOpenLines(std::string(names ? names : "")); }

  ///@{
  /**
   * Requests a node at a position in the domain: the nearest one that may move is moved there, by at most one quad.
   * Singularities of quarter index 0 are such positions as well.
   */
  void AddNode(double x, double y, double z);
  /** Removes all positions of nodes. */
  void ClearNodes();
  ///@}

  ///@{
  /**
   * Prescribes something for the side of a name; empty texts prescribe nothing.
   * - `count`: the number of edges along the side, a positive whole number.
   * - `progression`: the last edge over the first, in the direction with the domain on the left, of a
   *   geometric sequence on every part of the side between two corners: RATIO, or after `both:` the
   *   same towards both ends, with the middle edge over the first; or FIRST,LAST, the lengths of
   *   these edges, which prescribe their number as well. The lengths continue in the strips of quads
   *   that start at the side.
   * - `size`: the length of all edges of the side, met within 20 %, from which sizes grow by Growth.
   * Numbers of edges that contradict each other are an error.
   */
  void AddSide(const std::string& name, const std::string& count, const std::string& progression,
    const std::string& size);
  /** Removes all prescriptions. */
  void ClearSides();
  ///@}
  /** Prescribes something for a side; overload for ParaView. */
  void AddSide(const char* name, const char* count, const char* progression, const char* size);

  ///@{
  /**
   * Prescribes the target size of quads in what the side of a name encloses, and at its edges; the
   * side is a closed curve. Overload for ParaView, and removal.
   */
  void AddSizeInside(const std::string& name, const std::string& size);
  void AddSizeInside(const char* name, const char* size);
  void ClearSizesInside();
  ///@}

  ///@{
  /**
   * Requests a target size of quads up to a distance `radius` from a position, which may be 0; farther
   * away sizes grow by Growth. The position is in the domain, or not farther from it than the radius.
   */
  void AddSizeNear(double x, double y, double z, double size, double radius);
  /** Removes all sizes near positions. */
  void ClearSizesNear();
  ///@}

  ///@{
  /**
   * Sets the maximum ratio of the target sizes of neighbouring quads: away from where a size is
   * requested, or along the lengths of SizeArray, target sizes grow by at most ln(Growth) times the
   * distance inside the domain. Default: 1.25. Range: above 1.
   */
  vtkSetMacro(Growth, double);
  vtkGetMacro(Growth, double);
  ///@}

  ///@{
  /**
   * Sets the bounds of the target size of quads. Default: 0, no bound. Range: 0 or more.
   */
  vtkSetClampMacro(MinimumSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumSize, double);
  vtkSetClampMacro(MaximumSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumSize, double);
  ///@}

  /** Treatment of separatrices that nearly meet. */
  enum MergeType
  {
    MergeNone = 0,
    MergeClean = 1,
    MergeCoarse = 2
  };

  ///@{
  /**
   * Selects how separatrices that nearly meet are treated: each one bounds blocks of its own
   * (MergeNone); singularities are moved so that separatrices meet, as far as the quads stay as good
   * (MergeClean; docs/quads.md gives the limits); or separatrices are merged without moving
   * singularities, for the smallest number of blocks for which the minimum scaled Jacobian is at
   * least half of that with all blocks (MergeCoarse). Default: MergeNone.
   */
  vtkSetClampMacro(Merge, int, MergeNone, MergeCoarse);
  vtkGetMacro(Merge, int);
  void SetMergeToNone() { this->SetMerge(MergeNone); }
  void SetMergeToClean() { this->SetMerge(MergeClean); }
  void SetMergeToCoarse() { this->SetMerge(MergeCoarse); }
  ///@}

  enum PreferMode
  {
    PreferEnergy = 0,
    PreferNodes = 1,
    PreferBlocks = 2,
    PreferUniform = 3
  };

  ///@{
  /**
   * Selects what matters most where several configurations of singularities are chosen and each has
   * quads as good: a low energy and symmetry (PreferEnergy), few irregular nodes (PreferNodes),
   * few blocks (PreferBlocks), or quads of one size (PreferUniform). Default: PreferEnergy.
   */
  vtkSetClampMacro(Prefer, int, PreferEnergy, PreferUniform);
  vtkGetMacro(Prefer, int);
  ///@}

  ///@{
  /**
   * Selects one of these configurations: 0 is the preferred one, and the others follow in the order of the
   * columns `Alternative*` of the summary. A number that is too large selects the last. Default: 0.
   */
  vtkSetClampMacro(Alternative, int, 0, VTK_INT_MAX);
  vtkGetMacro(Alternative, int);
  ///@}

  ///@{
  /**
   * Sets the target edge length of the triangles on which the map is solved. Default: 0, 1/40 of
   * the diagonal of the bounding box. Range: 0 or more.
   */
  vtkSetClampMacro(MeshSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MeshSize, double);
  ///@}

  ///@{
  /**
   * Sets the minimum distance of chosen singularities from the boundary and from each other.
   * Default: 0, 0.7 of the size of quads, up to 1.5 at holes far from others. Range: 0 or more.
   */
  vtkSetClampMacro(Clearance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Clearance, double);
  ///@}

  ///@{
  /**
   * Sets the maximum number of pairs of quarter indices 1 and −1 that are added to chosen
   * singularities where they reduce the spread of sizes most, as long as each reduces it by 15 %;
   * see vtkSingularityOptimizer. Default: 0. Range: 0 to 100.
   */
  vtkSetClampMacro(Pairs, int, 0, 100);
  vtkGetMacro(Pairs, int);
  ///@}

  ///@{
  /**
   * Gives quarter index 1 to sharp corners whose smallest rotation has quarter index 2 and which
   * therefore have no angle in a seamless map. Given singularities must make up for the difference;
   * chosen ones do. Default: on.
   */
  vtkSetMacro(CapCorners, bool);
  vtkGetMacro(CapCorners, bool);
  vtkBooleanMacro(CapCorners, bool);
  ///@}

  ///@{
  /**
   * Moves the interior singularities by the smallest distances after which no inner loop has a
   * holonomy defect, so that sizes are single-valued. Field data then has `RepairDistance`, the
   * largest distance, `RepairedPositions` (3) and `DefectBefore`. Default: off.
   */
  vtkSetMacro(RepairHolonomy, bool);
  vtkGetMacro(RepairHolonomy, bool);
  vtkBooleanMacro(RepairHolonomy, bool);
  ///@}

  ///@{
  /**
   * Keeps the nodes of singularities where these were given. Otherwise they move where shapes or
   * sizes of quads are poor without this; the report lists their moves. Default: off.
   */
  vtkSetMacro(HoldSingularities, bool);
  vtkGetMacro(HoldSingularities, bool);
  vtkBooleanMacro(HoldSingularities, bool);
  ///@}

  ///@{
  /**
   * Of a surface in space: sets the angle between the normals of two triangles, in degrees, above which their common edge is
   * sharp, so that quads follow it. 180: no edge is. Default: 35.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Sets how far the centres of quads of a surface in space may be from it: their target size is at most
   * √(8 ChordError / (|κ₁| + |κ₂|)) with the principal curvatures, and grows by Growth. Default: 0, sizes do not depend
   * on the curvature. Range: 0 or more.
   */
  vtkSetClampMacro(ChordError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ChordError, double);
  ///@}

  ///@{
  /**
   * Part of the way to the positions without defects that RepairHolonomy moves the singularities, 0
   * to 1: with less, they stay closer to their places and quads are stretched by a part of what they
   * would be. Default: 1.
   */
  vtkSetClampMacro(RepairPart, double, 0.0, 1.0);
  vtkGetMacro(RepairPart, double);
  ///@}

  ///@{
  /**
   * Splits each interior singularity of quarter index k, |k| ≥ 2, into |k| of index ±1 around its
   * position, about 1.5 quads apart: nodes of valence 3 or 5 instead of one of valence 4 − k.
   * Default: off.
   */
  vtkSetMacro(SplitSingularities, bool);
  vtkGetMacro(SplitSingularities, bool);
  vtkBooleanMacro(SplitSingularities, bool);
  ///@}

  ///@{
  /**
   * Sets the boundary layers of named sides: entries NAME:FIRST[,GROWTH[,ROWS]] separated by
   * semicolons, for example "wall:1e-4,1.2; hole:1e-3". The quads beside a side are divided into
   * rows of which the first has the height FIRST, normal to the wall, and each further one grows by
   * at most GROWTH, 1.2 by default, until it is about as high as the quads behind; ROWS prescribes
   * their number. Chosen singularities then stay away from the boundary, and QuadCount includes the
   * rows. Default: empty, none.
   */
  vtkSetMacro(Layers, std::string);
  vtkGetMacro(Layers, std::string);
  ///@}
  ///@{
  /**
   * Sets the curves that sides stand for: entries NAME:circle, NAME:ellipse, NAME:spline or NAME:line
   * separated by semicolons, and `auto`, which recognises arcs of circles on all other sides. The
   * curve of a side is fitted to its points, which it may miss by at most 1e-6 of the diagonal of the
   * domain. Nodes on the boundary are then on the curve, however few points the domain has. Sides that
   * are not listed have the curves of the cell array `Curve` of the domain's lines, if it exists.
   * Default: empty, none.
   */
  vtkSetMacro(Curves, std::string);
  vtkGetMacro(Curves, std::string);
  ///@}
  /** Sets the curves; overload for ParaView. */
  void SetCurves(const char* curves) { this->SetCurves(std::string(curves ? curves : "")); }

  /** Sets the layers; overload for ParaView. */
  void SetLayers(const char* layers) { this->SetLayers(std::string(layers ? layers : "")); }

  ///@{
  /**
   * Sets pairs of sides whose nodes match: entries A:B separated by semicolons, for example
   * "left:right". Side B must be the image of side A under a translation or rotation, within 1e-6 of the
   * diagonal of the domain, with the domain on opposite sides of them, as in the sector of a rotor. Both
   * then have equal numbers of edges, and every node of B is the image of one of A to rounding. Default: empty, none.
   */
  vtkSetMacro(Periodic, std::string);
  vtkGetMacro(Periodic, std::string);
  ///@}
  /** Sets the pairs of sides; overload for ParaView. */
  void SetPeriodic(const char* pairs) { this->SetPeriodic(std::string(pairs ? pairs : "")); }

  ///@{
  /**
   * Sets what rows of quads do at corners: entries WHERE:end, WHERE:turn or WHERE:leave separated by
   * semicolons. WHERE is a position X,Y or X,Y,Z, a range of interior angles in degrees such as
   * 200-300, or the name of a side for all of its corners. Rows end on the next side (one quad at
   * the corner), turn around the corner (two quads), or follow the grid line that leaves it (three
   * or more). Default: empty; corners of sides with a layer then end up to 135°, turn up to 315° and
   * leave above, and all others have the quarter index of their angle.
   */
  vtkSetMacro(CornerRows, std::string);
  vtkGetMacro(CornerRows, std::string);
  ///@}
  /** Sets what rows do at corners; overload for ParaView. */
  void SetCornerRows(const char* rows) { this->SetCornerRows(std::string(rows ? rows : "")); }

  /**
   * Returns the seconds that the last run took for triangles, map, separatrices, edge counts,
   * layout, smoothing and, last, for choosing and repairing singularities. They are not part of the
   * output.
   */
  vtkGetVectorMacro(StageSeconds, double, 8);

  ///@{
  /**
   * Returns the names of the sides of the last mesh, and a point of each, three components: the
   * middle of one of its edges.
   */
  vtkStringArray* GetSideNames();
  vtkDoubleArray* GetSidePlaces();
  ///@}

  /**
   * Copies the result of the last update into one grid, the form of files: quads, then a VTK_LINE
   * for every boundary edge, with the arrays of both and the field data of output 8. On lines
   * `BlockId`, `I` and `J` are −1, `ScaledJacobian` and `SizeRatio` 1; on quads `BoundaryKind` is 0,
   * `BoundaryId` −1 and `Side` empty.
   */
  void CopyMesh(vtkUnstructuredGrid* mesh);

protected:
  vtkQuadMesher();
  ~vtkQuadMesher() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkQuadMesher(const vtkQuadMesher&) = delete;
  void operator=(const vtkQuadMesher&) = delete;

  crossfield::QuadRequest MakeRequest(vtkDataSet* domain, vtkDataSet* singularities,
    vtkDataSet* corners, const crossfield::DomainPlane& plane) const;
  void PrescribeSides(
    vtkTable* table, const crossfield::DomainPlane& plane, crossfield::QuadRequest& request) const;
  void RequireOptionsOfSurfaces(vtkInformationVector** inputVector) const;
  crossfield::SurfaceRequest MakeSurfaceRequest(vtkDataSet* domain, vtkDataSet* singularities,
    vtkTable* table, const NamedSurface& surface) const;
  std::vector<SideText::Row> RowsOfSides(vtkTable* table) const;
  void Warn(const crossfield::QuadWorkflowResult& result);
  void WriteOutputs(const crossfield::QuadWorkflowResult& result,
    const crossfield::DomainPlane& plane, vtkInformationVector* outputVector);
  /** Writes the regions of quads, if there are any. */
  static void WriteRegions(const RegionValues& regions,
    const crossfield::QuadWorkflowResult& result, vtkInformationVector* outputVector);
  void WriteSummary(const crossfield::QuadWorkflowResult& result,
    const crossfield::DomainPlane& plane, vtkTable* summary) const;

  double QuadSize = 0.0;
  int QuadCount = 1000;
  int Sizing = SizingAutomatic;
  std::string SizeArray;
  std::string SideNameArray;
  std::string MaterialArray;
  std::string Lines;
  std::string OpenLines;
  std::vector<std::array<double, 3>> Nodes;
  std::vector<std::array<std::string, 4>> Sides;
  std::vector<std::array<std::string, 2>> SizesInside;
  std::vector<std::array<double, 5>> SizesNear; ///< Position, size and radius.
  double Growth = 1.25;
  double MinimumSize = 0.0;
  double MaximumSize = 0.0;
  int Pairs = 0;
  int Merge = MergeNone;
  int Prefer = PreferEnergy;
  int Alternative = 0;
  double MeshSize = 0.0;
  double Clearance = 0.0;
  bool CapCorners = true;
  bool HoldSingularities = false;
  double FeatureAngle = 35.0;
  double ChordError = 0.0;
  bool RepairHolonomy = false;
  double RepairPart = 1.0;
  bool SplitSingularities = false;
  std::string Layers;
  std::string CornerRows;
  std::string Periodic;
  std::string Curves;
  vtkNew<vtkStringArray> SideNames;
  vtkNew<vtkDoubleArray> SidePlaces;
  double StageSeconds[8] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
};

#endif
