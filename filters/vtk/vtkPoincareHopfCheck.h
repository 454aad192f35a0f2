/**
 * @class   vtkPoincareHopfCheck
 * @brief   check whether a cross field with given singularities can exist on a domain
 *
 * Evaluates the generalised Poincaré-Hopf theorem: the quarter indices of the interior
 * singularities must add up to
 *   4 (V + (1/2π) ∫_{∂G minus corners} dφ) = 4χ − Σ k_i,   χ = 1 − number of inner loops,
 * where V = (1/2π) Σ of the smallest rotations of the cross, in (−π/4, π/4], that keep it aligned
 * at the corners. k_i is the quarter index that results at corner i, or the one prescribed on port
 * 2. With inner loops, the filter also solves for the potential of a consistent configuration of
 * points, and for the phase that a single-valued potential has at each inner loop. If that phase
 * does not fit the alignment, the loop has a holonomy defect, and no aligned field with
 * single-valued H exists.
 *
 * Input port 0 (vtkPolyData or vtkUnstructuredGrid): the domain, as for vtkDrillHoles; or a solved
 * field, a drilled mesh with the cell array `CrossFieldCR` (6 components). Then the field itself is
 * checked, and port 1 is ignored.
 * Input port 1, optional: the singularities (points) with the point arrays `QuarterIndex`
 * (integers) and optionally `Radius`, which affects the holonomy only. Without this input there are
 * no singularities.
 * Input port 2, optional: corners (points) with the point array `QuarterIndex` (integers), each at
 * a vertex of the boundary, for example from vtkBoundaryCornerClassifier.
 *
 * Output port 0: the domain of port 0 with field data, 1 value each unless stated otherwise:
 * - `EulerCharacteristic` (int), `Valence`, `TangentTurning` (double): χ, V and the integral;
 * - `RequiredInteriorQuarters`, `GivenInteriorQuarters` (int): the sum above, and that of port 1;
 * - `Consistent` (int): 1 if they are equal;
 * - `HolonomyDefect` (double, one per inner loop, radians in (−π, π]): absent without inner loops
 *   and for an inconsistent configuration;
 * - `Reason` (string): one sentence; if inconsistent, it states what to add or remove.
 * For a solved field these are the indices that it has at corners and its singularities. They
 * always agree, so `Consistent` is 1 if all degrees of holes (`HoleDegree`, int per hole, with
 * `HoleDegreeReliable`) and all prescribed corners are as prescribed and there are no other
 * singularities (`UnwantedSingularities`, int). Without holes, the singularities that the boundary
 * requires and those prescribed for an H field do not count as unwanted.
 *
 * With several materials (MaterialArray) these are sums over the regions, `Consistent` is 1 if each is
 * consistent, and for each region there are `RegionMaterial` (string), `RegionRequiredInteriorQuarters` and
 * `RegionGivenInteriorQuarters` (int). Indices of corners at nodes of regions are chosen for all regions together;
 * `Reason` names those nodes that are irregular.
 *
 * For a surface in space the singularities inside and the corners of its boundary must add up to 4χ in each
 * part. There is no `Valence`; `TotalCurvature` and `TangentTurning` (double) are the integrals of the curvature and of the
 * turning of the boundary, corners included, over 2π, and add up to χ; `HolonomyDefect` is that of inner loops
 * and handles (two each). Output port 1 is empty.
 *
 * Output port 1 (vtkTable, empty with several materials): one row per boundary loop, the outer one first: `BoundaryLoop` (int),
 * `Valence`, `TangentTurning` (double), `CornerQuarters` (int, Σ k_i), `RequiredPart` (int, the
 * contribution to the required sum), `HolonomyDefect` (double, NaN if there is none).
 *
 * Output port 2 (vtkPolyData): the corners, points with `Angle` (double, radians inside the
 * domain), `QuarterIndex` (int, as counted or, for a field, as found) and `Cancellable` (int, 1 for
 * angles in [3π/4, π), at corners that interior singularities can turn into regular points of the
 * boundary).
 *
 * Output port 3 (vtkTable, field data `Alarm` 1 unless consistent): the column `Summary` with one
 * row, a text for the 3D view: whether the input is consistent, and the reason. After a failure it
 * is the error message, and RequestData still returns 1 with the other outputs empty, so that a
 * view never shows an outdated result.
 *
 * An inconsistent configuration is not a failure. An empty domain gives empty outputs. The filter
 * fails, with empty outputs, if vtkDrillHoles would refuse the domain, if a singularity is outside
 * the domain, if arrays are missing or not integer, or if a corner is at no vertex of the boundary.
 *
 * Paper: "Generalized Poincaré-Hopf theorem". Difference from the paper: the holonomy condition,
 * which a count of indices cannot detect.
 *
 * @sa vtkBoundaryCornerClassifier, vtkConfigurationProposal, crossfield::CountQuarters
 */

#ifndef vtkPoincareHopfCheck_h
#define vtkPoincareHopfCheck_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkDataSetAlgorithm.h"

#include <string>

class VTKCROSSFIELDFILTERS_EXPORT vtkPoincareHopfCheck : public vtkDataSetAlgorithm
{
public:
  static vtkPoincareHopfCheck* New();
  vtkTypeMacro(vtkPoincareHopfCheck, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Connects port 1, the singularities, or port 2, the corners, or sets it to a data object. */
  vtkCrossFieldPortMacro(Singularities, 1);
  vtkCrossFieldPortMacro(Corners, 2);
  ///@}

  ///@{
  /**
   * Sets the turning angle, in degrees, above which a boundary vertex is a corner. Other vertices
   * are samples of a curve. The required sum does not depend on it. Default: 30. Range: 1 to 45.
   */
  vtkSetClampMacro(CornerAngle, double, 1.0, 45.0);
  vtkGetMacro(CornerAngle, double);
  ///@}

  ///@{
  /**
   * Of a surface in space: sets the angle between the normals of two triangles, in degrees, above which their common edge is
   * sharp, so that quads and crosses follow it. 180: no edge is. Default: 35.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Gives very sharp corners, of quarter index 2 or more, index 1, as vtkQuadMesher does by default:
   * with the same setting both require the same sum. Not used for a field. Default: off.
   */
  vtkSetMacro(CapCorners, bool);
  vtkGetMacro(CapCorners, bool);
  vtkBooleanMacro(CapCorners, bool);
  ///@}

  ///@{
  /** Computes the holonomy defects, which needs a mesh and a linear system. Default: on. */
  vtkSetMacro(Holonomy, bool);
  vtkGetMacro(Holonomy, bool);
  vtkBooleanMacro(Holonomy, bool);
  ///@}

  ///@{
  /**
   * Sets the cell array of materials, as in vtkQuadMesher: each region is checked by itself, with the
   * singularities inside of it. Default: empty, `Material` or `Region`. `none`: one material.
   */
  vtkSetMacro(MaterialArray, std::string);
  vtkGetMacro(MaterialArray, std::string);
  ///@}
  /** As above; a null pointer stands for an empty name. */
  void SetMaterialArray(const char* name) { this->SetMaterialArray(std::string(name ? name : "")); }

  ///@{
  /**
   * Sets lines inside of the domain along which crosses are aligned: the names of line cells in the array `Side`, separated
   * by semicolons, as for vtkQuadMesher. Default: empty.
   */
  vtkSetMacro(Lines, std::string);
  vtkGetMacro(Lines, std::string);
  ///@}
  /** Sets the lines; overload for ParaView. */
  void SetLines(const char* names) { this->SetLines(std::string(names ? names : "")); }

protected:
  vtkPoincareHopfCheck();
  ~vtkPoincareHopfCheck() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPoincareHopfCheck(const vtkPoincareHopfCheck&) = delete;
  void operator=(const vtkPoincareHopfCheck&) = delete;

  double CornerAngle = 30.0;
  double FeatureAngle = 35.0;
  bool CapCorners = false;
  bool Holonomy = true;
  std::string MaterialArray;
  std::string Lines;
};

#endif
