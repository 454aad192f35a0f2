/**
 * @class   vtkLayoutDesigner
 * @brief   design block layouts interactively by moving singularities
 *
 * For the interactive design of blocks: every change of a singularity updates the separatrices, the
 * patches between them and their quality. The domain is read, meshed and factored once and cached
 * until it changes. An update after moving a singularity then costs a back-substitution and one map
 * on a mesh that changes only around singularities.
 *
 * The singularities are the rows set here; without rows those of port 1; without either those that
 * vtkConfigurationProposal would choose with Automatic, once per domain. Commands (Propose,
 * Optimise, Snap, AddPair, RemoveSingularity, Undo) take effect in the next update. They replace
 * the rows, which GetRows then returns.
 *
 * Input port 0 (vtkPolyData or vtkUnstructuredGrid): the domain, as for vtkDrillHoles, which is meshed
 * here; or a connected surface in space, as for vtkQuadMesher. On a surface there are no quads while Dragging, no W, no
 * Snap and AddPair, MeshSize, MergeClean and corners do not apply, Optimise makes sizes more even
 * (crossfield::MovedCones), separatrices are given arc by arc, and patches consist of the quads if there are any.
 * Input port 1, optional: initial singularities (points) with `QuarterIndex`.
 * Input port 2, optional: corners (points) with `QuarterIndex`.
 *
 * Output port 0 (vtkPolyData): the separatrices, as output 0 of vtkSeparatrices, and the cell array
 * `Shade` (int) for colours: the sign of the quarter index where a line starts, 0 if the layout is
 * stale.
 * Output port 1 (vtkPolyData): the patches, as output 1 of vtkSeparatrices, and the cell array
 * `Colour` (int): the number of a colour from 0 to 4, which differs between neighbours where
 * possible and which a patch keeps while singularities move; −1 if the layout is stale.
 * Output port 2 (vtkPolyData): the singularities, as points with `QuarterIndex`, where their nodes
 * are; at the positions of the rows without quads or if the layout is stale. Nodes differ from the
 * rows if quads would be inverted with the rows as nodes (`Released` of output 4) or with
 * MergeClean.
 * Output port 3 (vtkUnstructuredGrid): quads, as output 0 of vtkQuadMesher; empty with QuadsNone.
 * Output port 4 (vtkTable): the column `Summary` with one row, the field data `Summary` in lines of
 * at most 60 characters, for a view. Its field data `Alarm` (int) is 1 if it reports an error or
 * warns of bad quads, unless they are drafts; the others are the report of vtkQuadMesher on the
 * quads of output 3.
 * Output port 5 (vtkPolyData): the boundary edges of the quads, as output 5 of vtkQuadMesher.
 *
 * A configuration without a layout, for example one with a wrong sum of quarter indices or with a
 * singularity outside, is not a failure. Outputs 0, 1 and 3 are then those of the last valid
 * configuration, `Stale` is 1, and `Reason` gives the reason.
 *
 * Field data of outputs 0 and 2:
 * - `Reason` (text): one sentence; `Summary` (text): numbers of quads and blocks, minimum angle and
 *   energy in one line, or why there is no layout;
 * - `Stale` (int): 1 if separatrices, patches and quads are those of an earlier configuration;
 * - `Events` (text): after a command its results, one sentence each.
 * If there are separatrices, also
 * - `RenormalizedEnergy`: W;
 * - `Faces` (int): the number of patches;
 * - `ShortestArc`: the length of the shortest arc of the T-mesh, in sides of quads;
 * - `MovedNodes` (int), `Moved`: the number of nodes that are more than a tenth of an edge away from
 *   their rows, and the maximum distance;
 * - `PredictedStretch`, `StretchReason`: as for vtkCrossFieldMap;
 * - `MinimumAngle`: with quads, the minimum angle of a quad, in degrees.
 *
 * An empty domain gives empty outputs. The filter fails if vtkDrillHoles would refuse the domain or
 * if arrays are missing or not integer. The outputs are then empty except for `Stale` 1 and the
 * message in `Reason` and `Summary`.
 *
 * @sa vtkSeparatrices, vtkQuadMesher, vtkConfigurationProposal, crossfield::DesignLayout
 */

#ifndef vtkLayoutDesigner_h
#define vtkLayoutDesigner_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkNew.h"                     // for the rows of the output
#include "vtkPolyDataAlgorithm.h"
#include "vtkQuadMesher.h" // for the kinds of Merge

#include <array>  // for the rows
#include <memory> // for the session
#include <vector> // for the rows

enum class DesignCommand;
class DesignModel;
class DesignSession;
struct DesignRequest;
class vtkDoubleArray;
class vtkIntArray;
class vtkStringArray;

class VTKCROSSFIELDFILTERS_EXPORT vtkLayoutDesigner : public vtkPolyDataAlgorithm
{
public:
  static vtkLayoutDesigner* New();
  vtkTypeMacro(vtkLayoutDesigner, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Connects port 1, the initial singularities, or port 2, the corners, or sets it to a data
   * object.
   */
  vtkCrossFieldPortMacro(Singularities, 1);
  vtkCrossFieldPortMacro(Corners, 2);
  ///@}

  ///@{
  /**
   * Sets the rows x, y, quarter index, and a fourth number. SetSingularity appends
   * rows as needed. Positions are in the coordinates of the plane of the domain
   * (crossfield::DomainPlane): x and y of a domain in z = const. The fourth number is there a radius, as in
   * vtkSingularitySource, which is preserved but not used; on a surface in space it is z. Default: no rows.
   */
  void SetSingularity(int row, double x, double y, double quarterIndex, double fourth);
  void AddSingularity(double x, double y, double quarterIndex, double fourth);
  void RemoveAllSingularities();
  int GetNumberOfSingularities() const;
  ///@}

  /** Returns the rows of the last update, four components each, whatever their source. */
  vtkDoubleArray* GetRows();

  /**
   * Returns the plane of the last domain, in whose coordinates the rows are, as three tuples:
   * origin, first axis and second axis.
   */
  vtkDoubleArray* GetPlane();

  /**
   * Returns the triangles of the last surface on which layouts are computed while Dragging, and handles are placed:
   * nine components each, their points. None for a planar domain.
   */
  vtkDoubleArray* GetTriangles();

  /**
   * Returns the sum that the quarter indices of the rows must have on the last domain: one value, or
   * none if it is unknown.
   */
  vtkIntArray* GetRequiredSum();

  /** Returns for each row of the last update a sentence: why it and its node are where they are. */
  vtkStringArray* GetReasons();

  ///@{
  /**
   * Sets the command for the next update. Propose replaces the singularities by the automatically
   * chosen ones. Optimise moves them to a minimum of W. Snap moves them by at most SnapTolerance so
   * that nearly coincident separatrices coincide. AddPair adds one of quarter index 1 and one of −1
   * where there is the most space. RemoveSingularity removes a row, counted from 0. Undo restores
   * the rows before the last command that changed them.
   */
  void Propose();
  void Optimise();
  void Snap();
  void AddPair();
  void RemoveSingularity(int row);
  void Undo();
  ///@}

  ///@{
  /**
   * Sets the target edge length of the mesh. Default: 0, 1/40 of the diagonal of the bounding box.
   * Range: 0 or more.
   */
  vtkSetClampMacro(MeshSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MeshSize, double);
  ///@}

  ///@{
  /**
   * Of a surface in space: sets the angle between the normals of two triangles, in degrees, above which separatrices
   * follow their common edge. Default: 35. Range: 0 to 180.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Treats sharp corners whose smallest rotation has quarter index 2 as corners of index 1, as in
   * vtkQuadMesher. Default: on.
   */
  vtkSetMacro(CapCorners, bool);
  vtkGetMacro(CapCorners, bool);
  vtkBooleanMacro(CapCorners, bool);
  ///@}

  /** Kinds of quads in output 3. */
  enum QuadsType
  {
    QuadsNone = 0,
    QuadsDraft = 1,
    QuadsSmooth = 2
  };

  ///@{
  /**
   * Selects the quads of output 3: none (QuadsNone), those of the map without smoothing
   * (QuadsDraft), or those of vtkQuadMesher (QuadsSmooth), which are drafts while Dragging.
   * Default: QuadsSmooth.
   */
  vtkSetClampMacro(Quads, int, QuadsNone, QuadsSmooth);
  vtkGetMacro(Quads, int);
  void SetQuadsToNone() { this->SetQuads(QuadsNone); }
  void SetQuadsToDraft() { this->SetQuads(QuadsDraft); }
  void SetQuadsToSmooth() { this->SetQuads(QuadsSmooth); }
  ///@}

  ///@{
  /**
   * Selects how blocks are merged, as in vtkQuadMesher: separatrices that nearly meet are kept apart
   * (MergeNone); singularities are moved so that they meet, as far as the quads stay as good
   * (MergeClean); or they are merged without moving singularities (MergeCoarse). Applies to smooth
   * quads, not while Dragging. Separatrices and patches are those of the moved singularities, the
   * rows stay. Default: MergeNone.
   */
  vtkSetClampMacro(Merge, int, vtkQuadMesher::MergeNone, vtkQuadMesher::MergeCoarse);
  vtkGetMacro(Merge, int);
  void SetMergeToNone() { this->SetMerge(vtkQuadMesher::MergeNone); }
  void SetMergeToClean() { this->SetMerge(vtkQuadMesher::MergeClean); }
  void SetMergeToCoarse() { this->SetMerge(vtkQuadMesher::MergeCoarse); }
  ///@}

  ///@{
  /**
   * Uses a coarser mesh that is fast enough to follow a handle (crossfield::LiveMeshSize), and
   * draft quads. Handles switch it on while they are dragged. Default: off.
   */
  vtkSetMacro(Dragging, bool);
  vtkGetMacro(Dragging, bool);
  vtkBooleanMacro(Dragging, bool);
  ///@}

  ///@{
  /**
   * Sets the target edge length of quads. Default: 0, determined by QuadCount. Range: 0 or more.
   */
  vtkSetClampMacro(QuadSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(QuadSize, double);
  ///@}

  ///@{
  /** Sets the target number of quads if QuadSize is 0. Default: 1000. Range: 1 or more. */
  vtkSetClampMacro(QuadCount, int, 1, VTK_INT_MAX);
  vtkGetMacro(QuadCount, int);
  ///@}

  ///@{
  /**
   * Sets the maximum displacement of a singularity by Snap, and the maximum distance between
   * separatrices that it joins. Default: 0, half the edge length of a quad. Range: 0 or more.
   */
  vtkSetClampMacro(SnapTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SnapTolerance, double);
  ///@}

  /**
   * Returns the seconds that the last layout took, without writing the outputs. They are not part
   * of the output.
   */
  vtkGetMacro(StageSeconds, double);

protected:
  vtkLayoutDesigner();
  ~vtkLayoutDesigner() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkLayoutDesigner(const vtkLayoutDesigner&) = delete;
  void operator=(const vtkLayoutDesigner&) = delete;

  void SetCommand(DesignCommand command);
#ifndef __VTK_WRAP__
  DesignRequest MakeRequest(const DesignModel& model, vtkDataSet* start, vtkDataSet* corners);
#endif

  std::vector<std::array<double, 4>> Rows;
  DesignCommand Command; ///< Command for the next update.
  int RowToRemove = -1;
  double MeshSize = 0.0;
  double FeatureAngle = 35.0;
  bool CapCorners = true;
  int Quads = QuadsSmooth;
  int Merge = vtkQuadMesher::MergeNone;
  bool Dragging = false;
  double QuadSize = 0.0;
  int QuadCount = 1000;
  double SnapTolerance = 0.0;
  double StageSeconds = 0.0;
  vtkNew<vtkDoubleArray> OutputRows;
  vtkNew<vtkDoubleArray> Plane;
  vtkNew<vtkDoubleArray> Triangles;
  vtkNew<vtkIntArray> RequiredSum;
  vtkNew<vtkStringArray> Reasons;
  std::unique_ptr<DesignSession> Session; ///< State kept between updates.
};

#endif
