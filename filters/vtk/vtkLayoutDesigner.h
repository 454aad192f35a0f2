/**
 * @class   vtkLayoutDesigner
 * @brief   the layout of singularities that are moved by hand: lines, faces, consistency, quality, quads
 *
 * For the eye of a person who designs blocks: at every change of a singularity the separatrices, the faces between them and what
 * they are good for. The domain is read, meshed and factored once and kept until it changes; a moved singularity then costs a
 * back-substitution and one map on a mesh that is changed only around singularities.
 *
 * The singularities are the rows set here; without rows those of port 1; without either the ones that
 * vtkConfigurationProposal would choose with Automatic, once for a domain. Commands (Propose, Optimise, Snap, AddPair, RemoveSingularity, Undo)
 * take effect in the next update: they replace the rows, which GetRows then returns.
 *
 * Port 0, the domain (vtkPolyData or vtkUnstructuredGrid): as for vtkDrillHoles; it is meshed here.
 * Port 1, optional, singularities to start from (points) with `QuarterIndex`.
 * Port 2, optional, corners (points) with `QuarterIndex`.
 *
 * Output 0 (vtkPolyData): the lines, as output 0 of vtkSeparatrices, and the cell array `Shade` (int): the sign of the quarter index
 * where a line starts, 0 where the layout is stale, for colours.
 * Output 1 (vtkPolyData): the faces, as output 1 of vtkSeparatrices.
 * Output 2 (vtkPolyData): the singularities as points, with `QuarterIndex`, where they are now.
 * Output 3 (vtkUnstructuredGrid): quads, as output 0 of vtkQuadMesher; empty with QuadsNone.
 * Output 4 (vtkTable): one column, `Summary`, with one row: that of the field data in lines of at most 60 characters, for a view; its
 * field data `Alarm` (int) is 1 where it says what is wrong.
 *
 * A configuration that cannot be, as one whose quarter indices have a wrong sum or with a singularity outside, is no failure:
 * outputs 0, 1 and 3 are those of the last one that could be, `Stale` is 1, and `Reason` says why.
 *
 * Field data of outputs 0 and 2:
 * - `Reason` (text): one sentence; `Summary` (text): the numbers below in one line, or why there are none;
 * - `Stale` (int): 1 where lines, faces and quads are those of an earlier configuration;
 * and, where there are lines,
 * - `RenormalizedEnergy`: W; `Faces` (int); `ShortestArc`: of the T-mesh, in sides of quads;
 * - `Events` (text): after a command what it did, one sentence each;
 * - `LeastAngle`: 90° minus the largest deviation of a corner of a quad from it; with quads.
 *
 * An empty domain gives empty outputs. Failure, with outputs that are empty but for `Stale` 1 and the sentence in `Reason` and
 * `Summary`: a domain that vtkDrillHoles refuses; arrays that are missing or not integer.
 *
 * @sa vtkSeparatrices, vtkQuadMesher, vtkConfigurationProposal, crossfield::DesignLayout
 */

#ifndef vtkLayoutDesigner_h
#define vtkLayoutDesigner_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkNew.h"                     // for the rows of the output
#include "vtkPolyDataAlgorithm.h"

#include <array>  // for the rows
#include <memory> // for what is kept
#include <vector> // for the rows

enum class DesignCommand;
class DesignSession;
class vtkDoubleArray;

class VTKCROSSFIELDFILTERS_EXPORT vtkLayoutDesigner : public vtkPolyDataAlgorithm
{
public:
  static vtkLayoutDesigner* New();
  vtkTypeMacro(vtkLayoutDesigner, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Port 1, singularities to start from, and port 2, the corners: connections or data objects. */
  vtkCrossFieldPortMacro(Singularities, 1);
  vtkCrossFieldPortMacro(Corners, 2);
  ///@}

  ///@{
  /**
   * The rows x, y, quarter index, radius, as of vtkSingularitySource. SetSingularity appends rows as needed. The places are in the
   * coordinates of the domain's plane (crossfield::DomainPlane): x and y of a domain in z = const. The radius means nothing here and is kept. Default: no rows.
   */
  void SetSingularity(int row, double x, double y, double quarterIndex, double radius);
  void AddSingularity(double x, double y, double quarterIndex, double radius);
  void RemoveAllSingularities();
  int GetNumberOfSingularities() const;
  ///@}

  /** The rows of the last update, four components each, wherever they are from. */
  vtkDoubleArray* GetRows();

  /** The plane of the last domain, in whose coordinates the rows are, as three tuples: origin, first and second axis. */
  vtkDoubleArray* GetPlane();

  ///@{
  /**
   * Commands for the next update. Propose: the singularities that would be chosen. Optimise: those there are move to where W is
   * least. Snap: they move by at most SnapTolerance to where lines that nearly met do meet. AddPair: one of quarter index 1 and one of −1 where there is most room. RemoveSingularity: takes a row, counted from 0, out. Undo: the rows
   * before the last command that changed them.
   */
  void Propose();
  void Optimise();
  void Snap();
  void AddPair();
  void RemoveSingularity(int row);
  void Undo();
  ///@}

  ///@{
  /** Target edge length of the mesh; 0: 1/40 of the diagonal of the bounding box. Default: 0. Range: 0 or more. */
  vtkSetClampMacro(MeshSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MeshSize, double);
  ///@}

  ///@{
  /** As of vtkQuadMesher. Default: on. */
  vtkSetMacro(CapCorners, bool);
  vtkGetMacro(CapCorners, bool);
  vtkBooleanMacro(CapCorners, bool);
  ///@}

  /** What quads there are. */
  enum QuadsType
  {
    QuadsNone = 0,
    QuadsDraft = 1,
    QuadsSmooth = 2
  };

  ///@{
  /**
   * QuadsNone: none. QuadsDraft: where the map has them. QuadsSmooth: as vtkQuadMesher makes them, or drafts while Dragging.
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
   * Whether a hand is about to move a singularity on: then the mesh is no finer than a hand can be followed with
   * (crossfield::LiveMeshSize), and quads are drafts. Handles set it and take it back. Default: off.
   */
  vtkSetMacro(Dragging, bool);
  vtkGetMacro(Dragging, bool);
  vtkBooleanMacro(Dragging, bool);
  ///@}

  ///@{
  /** Length of the sides of quads; 0: by QuadCount. Default: 0. Range: 0 or more. */
  vtkSetClampMacro(QuadSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(QuadSize, double);
  ///@}

  ///@{
  /** Wanted number of quads where QuadSize is 0. Default: 1000. Range: 1 or more. */
  vtkSetClampMacro(QuadCount, int, 1, VTK_INT_MAX);
  vtkGetMacro(QuadCount, int);
  ///@}

  ///@{
  /** What Snap may move a singularity by, and how near lines must be; 0: half a side of a quad. Default: 0. Range: 0 or more. */
  vtkSetClampMacro(SnapTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SnapTolerance, double);
  ///@}

  /** Seconds of the last layout, without writing the outputs. Not in the output. */
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

  void Ask(DesignCommand command);

  std::vector<std::array<double, 4>> Rows;
  DesignCommand Waiting; ///< For the next update.
  int RowToRemove = -1;
  double MeshSize = 0.0;
  bool CapCorners = true;
  int Quads = QuadsSmooth;
  bool Dragging = false;
  double QuadSize = 0.0;
  int QuadCount = 1000;
  double SnapTolerance = 0.0;
  double StageSeconds = 0.0;
  vtkNew<vtkDoubleArray> OutputRows;
  vtkNew<vtkDoubleArray> Plane;
  std::unique_ptr<DesignSession> Session; ///< What is kept between updates.
};

#endif
