/**
 * @class   vtkPoincareHopfCheck
 * @brief   say whether a cross field with given singularities can exist on a planar domain, and why
 *
 * Counts by the generalised Poincaré-Hopf theorem: the quarter indices of the interior
 * singularities must add up to
 *   4 (V + (1/2π) ∫_{∂G minus corners} dφ) = 4χ − Σ k_i,   χ = 1 − number of inner loops,
 * where V = (1/2π) Σ of the smallest rotations of the cross, in (−π/4, π/4], that keep it aligned
 * at the corners; k_i is the quarter index that this leaves at corner i, or the one chosen on port
 * 2. With inner loops, the potential of a consistent configuration of points is solved for as well, and
 * the phase that a single-valued one carries to each of them: where it does not fit the alignment there
 * is a holonomy defect, and no aligned field with single-valued H.
 *
 * Port 0, the domain (vtkPolyData or vtkUnstructuredGrid): as for vtkDrillHoles. Or a solved field,
 * a drilled mesh with the cell array `CrossFieldCR` (6 components): then the field itself is
 * checked, and port 1 is ignored.
 * Port 1, optional, the singularities (points): point arrays `QuarterIndex` (integers) and
 * optionally `Radius`, which matters for the holonomy only. Without it there are no singularities.
 * Port 2, optional, corners (points): point array `QuarterIndex` (integers), each point at a vertex
 * of the boundary, for example from vtkBoundaryCornerClassifier.
 *
 * Output 0: the domain of port 0, passed through, with field data, 1 value each unless said:
 * - `EulerCharacteristic` (int), `Valence`, `TangentTurning` (double): χ, V and the integral;
 * - `RequiredInteriorQuarters`, `GivenInteriorQuarters` (int): the sum above, and that of port 1;
 * - `Consistent` (int): 1 when they are equal;
 * - `HolonomyDefect` (double, one per inner loop, radians in (−π, π]): absent without inner loops
 *   or when the configuration is inconsistent;
 * - `Reason` (string): one sentence, when inconsistent with what to add or remove.
 * Of a solved field: the indices that it takes at corners and the singularities that it has; they
 * always agree, so `Consistent` is 1 when all degrees of holes (`HoleDegree`, int per hole,
 * with `HoleDegreeReliable`) and chosen corners are as prescribed and there are no others
 * (`UnwantedSingularities`, int; without holes those that the boundary asks for do not count, nor those
 * that an H field was asked for).
 *
 * Output 1 (vtkTable), one row per boundary loop, the outer one first: `BoundaryLoop` (int),
 * `Valence`, `TangentTurning` (double), `CornerQuarters` (int, Σ k_i), `RequiredPart` (int, its
 * part of the required sum), `HolonomyDefect` (double, NaN where there is none).
 *
 * Output 2 (vtkPolyData): the corners, points with `Angle` (double, radians inside the domain),
 * `QuarterIndex` (int, as counted or, of a field, as taken) and `Cancellable` (int, 1 in [3π/4, π):
 * interior singularities can make them regular points of the boundary).
 *
 * Output 3 (vtkTable, field data `Alarm` 1 unless all is well): the column `Summary` with one entry, a text for the 3D view: whether it is
 * consistent, and the reason; after a failure its sentence, so that a view never shows a result that
 * is out of date. For this the filter goes on after a failure, with empty outputs.
 *
 * An inconsistent configuration is not a failure. An empty domain gives empty outputs. Failure,
 * with empty outputs: a domain that vtkDrillHoles refuses; a singularity outside of it; arrays that
 * are missing or not integer; a corner that is no vertex of the boundary.
 *
 * Paper: "Generalized Poincaré-Hopf theorem". Difference from it: the holonomy condition, which a
 * count of indices cannot see.
 *
 * @sa vtkBoundaryCornerClassifier, vtkConfigurationProposal, crossfield::CountQuarters
 */

#ifndef vtkPoincareHopfCheck_h
#define vtkPoincareHopfCheck_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkDataSetAlgorithm.h"

class VTKCROSSFIELDFILTERS_EXPORT vtkPoincareHopfCheck : public vtkDataSetAlgorithm
{
public:
  static vtkPoincareHopfCheck* New();
  vtkTypeMacro(vtkPoincareHopfCheck, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Port 1, the singularities, and port 2, the corners: connections or data objects. */
  vtkCrossFieldPortMacro(Singularities, 1);
  vtkCrossFieldPortMacro(Corners, 2);
  ///@}

  ///@{
  /**
   * A boundary vertex that turns by more is a corner, others stand for a curve; degrees. The
   * required sum does not depend on it. Default: 30. Range: 1 to 45.
   */
  vtkSetClampMacro(CornerAngle, double, 1.0, 45.0);
  vtkGetMacro(CornerAngle, double);
  ///@}

  ///@{
  /** Compute the holonomy defects, which takes a mesh and a linear system. Default: on. */
  vtkSetMacro(Holonomy, bool);
  vtkGetMacro(Holonomy, bool);
  vtkBooleanMacro(Holonomy, bool);
  ///@}

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
  bool Holonomy = true;
};

#endif
