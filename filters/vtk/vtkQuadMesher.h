/**
 * @class   vtkQuadMesher
 * @brief   an all-quad mesh with exactly the chosen irregular nodes, and its blocks
 *
 * A singularity of quarter index k becomes a node of valence 4 − k, a corner one with 2 − k quads; all other nodes are
 * regular. The lines that leave them in the map of vtkCrossFieldMap cut the domain into rectangles; numbers of quads
 * along their sides, which are nearest to the wanted size, come from a minimum cost flow; rectangles become lattices, and
 * points move until quads have their best shape, those on the boundary along its polyline.
 *
 * Port 0, the domain (vtkPolyData or vtkUnstructuredGrid): as for vtkDrillHoles.
 * Port 1, optional, singularities (points), and port 2, optional, corners: as for vtkHField. Where nothing is connected to
 * port 1 the singularities are chosen as vtkConfigurationProposal does with Automatic; points without any are none.
 *
 * Output 0 (vtkUnstructuredGrid): VTK_QUAD, counter-clockwise, then VTK_LINE for every boundary edge with the domain on
 * the left, with
 * - cells: `BlockId`, `I`, `J` (int): block, column and row; −1 of lines; `ScaledJacobian` (double): the least sine of
 *   its angles, `SizeRatio` (double): real over wanted size; both 1 of lines; `BoundaryKind`, `BoundaryId` (int): as for
 *   vtkDrillHoles;
 * - points: `Valence` (int): its quads; `Irregular` (int): the quarter index of a singularity or corner, else 0;
 *   `BoundarySide` (int): the loop it is on, −1 inside.
 * Output 1 (vtkMultiBlockDataSet): a right-handed vtkStructuredGrid per block; shared points are equal in every bit. Field
 * data of each, per side J = 0, I largest, J largest, I = 0: `NeighbourBlock` (the block beyond, −1: the boundary),
 * `NeighbourSide` (which of its sides), `NeighbourOrientation` (1: the points of both sides, by increasing I or J, have the
 * same order; −1: the reversed one; 0: boundary). A side is beside one side as a whole.
 * Output 2 (vtkPolyData): the arcs of the T-mesh as polylines, with the cell array `Edges` (int): quads along each.
 *
 * Field data of output 0: `Quads`, `Blocks`, `IrregularValence`, `IrregularObtained`, `IrregularRequested` (per valence inside),
 * `ScaledJacobianRange` (least, mean), `ScaledJacobianBound` (attainable), `EtaRange` (least, mean; 1 − (2/π) max |π/2 −
 * angle|), `SizeRange` (least, mean, largest root of area), `SizeVariation` (its standard deviation over
 * its mean), `Size` (in the map), `ZeroArcs`, `IntegerVariables`, `IntegerGap`,
 * `IntegerOptimal`, `Inverted` (quads that are not positive), `InvertedPlace` (3, the worst one), `Released` (whether
 * singularities had to move), `Moved` (how far at most), `HolonomyDefect`, `Events` (what was decided where singularities were
 * chosen, a sentence each).
 *
 * An empty domain gives empty outputs. Failure, with empty outputs: as for vtkCrossFieldMap and vtkSeparatrices; a size so
 * large that no mesh has the asked nodes. A mesh with inverted quads is given, with a warning.
 *
 * Paper: "Further thoughts" leaves quads open.
 *
 * @sa vtkCrossFieldMap, vtkSeparatrices, crossfield::MakeQuads
 */

#ifndef vtkQuadMesher_h
#define vtkQuadMesher_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // for the name of an array

class VTKCROSSFIELDFILTERS_EXPORT vtkQuadMesher : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkQuadMesher* New();
  vtkTypeMacro(vtkQuadMesher, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Port 1, the singularities, and port 2, the corners: connections or data objects. */
  vtkCrossFieldPortMacro(Singularities, 1);
  vtkCrossFieldPortMacro(Corners, 2);
  ///@}

  ///@{
  /**
   * Length of the sides of quads, as in the map, whose area is that of the domain: about area / size² quads. 0: by
   * QuadCount. Default: 0. Range: 0 or more.
   */
  vtkSetClampMacro(QuadSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(QuadSize, double);
  ///@}

  ///@{
  /**
   * Wanted number of quads where QuadSize is 0; where the lines allow none within 5 % of it the nearest that was found is
   * taken, with a warning. Default: 1000. Range: 1 or more.
   */
  vtkSetClampMacro(QuadCount, int, 1, VTK_INT_MAX);
  vtkGetMacro(QuadCount, int);
  ///@}

  /** Which quads are larger than others. */
  enum SizingType
  {
    SizingConformal = 0,
    SizingUniform = 1,
    SizingField = 2
  };

  ///@{
  /**
   * SizingConformal: sizes are those of the map, larger where its field spreads, which gives the best shapes.
   * SizingUniform: the same everywhere as far as the lines allow; singularities may move (`Moved`).
   * SizingField: likewise, with the lengths of the point array SizeArray of the domain. With these two, singularities that
   * are chosen are where sizes of the map are most like that, as with UniformSizes of vtkSingularityOptimizer.
   * Default: SizingConformal.
   */
  vtkSetClampMacro(Sizing, int, SizingConformal, SizingField);
  vtkGetMacro(Sizing, int);
  void SetSizingToConformal() { this->SetSizing(SizingConformal); }
  void SetSizingToUniform() { this->SetSizing(SizingUniform); }
  void SetSizingToField() { this->SetSizing(SizingField); }
  ///@}

  ///@{
  /**
   * Point array of the domain with the wanted length of quads for SizingField, in units of the domain: linear on surface
   * cells and along curves, of which it is continued inside. Quads are so long times QuadSize, which is then a factor; where
   * that is 0 only proportions count. Default: none.
   */
  vtkSetMacro(SizeArray, std::string);
  vtkGetMacro(SizeArray, std::string);
  ///@}
  /** As above; what ParaView calls. */
  void SetSizeArray(const char* name) { this->SetSizeArray(std::string(name ? name : "")); }

  ///@{
  /**
   * Merges lines that are nearer to each other than blocks need, for the fewest blocks whose worst quad is at least half
   * as good as that of the mesh with all of them. Default: off.
   */
  vtkSetMacro(Coarse, bool);
  vtkGetMacro(Coarse, bool);
  vtkBooleanMacro(Coarse, bool);
  ///@}

  ///@{
  /**
   * Target edge length of the triangles that the map is solved on; 0: 1/40 of the diagonal of the bounding box.
   * Default: 0. Range: 0 or more.
   */
  vtkSetClampMacro(MeshSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MeshSize, double);
  ///@}

  ///@{
  /**
   * Where singularities are chosen, their least distance to the boundary and to each other; 0: 0.7 of the size of quads.
   * Default: 0. Range: 0 or more.
   */
  vtkSetClampMacro(Clearance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Clearance, double);
  ///@}

  ///@{
  /**
   * Where singularities are chosen, up to so many pairs of quarter indices 1 and -1 more than needed, where they make sizes
   * most even, while each brings 15 % of the spread, as of vtkSingularityOptimizer. Default: 0. Range: 0 to 100.
   */
  vtkSetClampMacro(Pairs, int, 0, 100);
  vtkGetMacro(Pairs, int);
  ///@}

  ///@{
  /**
   * Sharp corners whose smallest rotation has quarter index 2, which have no angle in a flat map, get 1; what is
   * missing must be among the singularities. Default: on.
   */
  vtkSetMacro(CapCorners, bool);
  vtkGetMacro(CapCorners, bool);
  vtkBooleanMacro(CapCorners, bool);
  ///@}

  ///@{
  /**
   * Moves the singularities inside the least way to where no inner loop has a holonomy defect, where a size is
   * single-valued. Field data then has `RepairDistance`, the longest way of one, `RepairedPositions` (3), where they
   * are, and `DefectBefore`. Not for meshes that are given. Default: off.
   */
  vtkSetMacro(RepairHolonomy, bool);
  vtkGetMacro(RepairHolonomy, bool);
  vtkBooleanMacro(RepairHolonomy, bool);
  ///@}

  /** Seconds that the last run spent in triangles, map, lines, integers, layout and smoothing. Not in the output. */
  vtkGetVectorMacro(StageSeconds, double, 6);

protected:
  vtkQuadMesher();
  ~vtkQuadMesher() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkQuadMesher(const vtkQuadMesher&) = delete;
  void operator=(const vtkQuadMesher&) = delete;

  double QuadSize = 0.0;
  int QuadCount = 1000;
  int Sizing = SizingConformal;
  std::string SizeArray;
  int Pairs = 0;
  bool Coarse = false;
  double MeshSize = 0.0;
  double Clearance = 0.0;
  bool CapCorners = true;
  bool RepairHolonomy = false;
  double StageSeconds[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
};

#endif
