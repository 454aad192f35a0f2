/**
 * @class   vtkConfigurationProposal
 * @brief   propose a consistent starting configuration of singularities for a planar domain
 *
 * Places singularities so that the Poincaré-Hopf theorem holds. Three starts are tried: the
 * singularities of a coarse Ginzburg-Landau field, corrected to the sum that vtkPoincareHopfCheck
 * requires; the same without pairs of opposite signs; and positions spread over the domain. If all
 * holes are round and there are two or more, they are the best of a search among several hundred
 * places instead. Each takes a few steps of vtkSingularityOptimizer, and the one with the minimum
 * energy at 1/400 of the diagonal, less a reward for symmetry, is output. Where singularities are given or flat corners are cancelled, nothing is moved.
 * The result is a start, not an optimum. With Automatic the singularities are then moved to a
 * minimum of the renormalised energy, as vtkSingularityOptimizer does. For quads, vtkQuadMesher
 * chooses singularities itself.
 *
 * On a surface in space, closed or open, they are those of smooth crosses (docs/method.md §22.11): output 0 has
 * `QuarterIndex` only, the other outputs are empty, and the properties do not apply.
 *
 * Port 0, the domain (vtkPolyData or vtkUnstructuredGrid): as for vtkDrillHoles, or a surface in space; then ports 1 and 2 must be
 * empty.
 * Port 1, optional, singularities to keep (points): point arrays `QuarterIndex` (integers) and
 * optionally `Radius`.
 * Port 2, optional, corners (points) with `QuarterIndex` (integers), as for vtkPoincareHopfCheck.
 *
 * Output port 0 (vtkPolyData): vertices, first those of port 1, then those that cancel flat
 * corners, then the others. Point arrays `QuarterIndex` (int) and `Radius` (double): a third of the
 * distance to the boundary or the next singularity, at most 1/40 of the domain's diagonal; for
 * those of port 1 as given. If one of port 1 has no radius, the others have none either. With
 * Automatic, `Radius` exists only if port 1 has it, and the output has the field data of
 * vtkSingularityOptimizer and `Events` (strings: one sentence for each decision). Output port 1
 * (vtkPolyData): the corners whose quarter index was prescribed or chosen, with `QuarterIndex`.
 * Output port 2 (vtkTable): the proposal and the Alternatives, the best first, with `Alternative`
 * (int), `Origin` (text), `Singularities` (int), `LogarithmCoefficient`, `RenormalizedEnergy`,
 * `CoreRadius`, `EnergyAtCoreRadius`, by which they are ranked, `HolonomyDefect` (largest, radians)
 * and `SizeSpread` (standard deviation of log size, H, over the area). Empty with Automatic. Output
 * port 3 (vtkPolyData): the points of all rows of the table, with `Alternative` and `QuarterIndex`;
 * corners whose index is not that of the smallest rotation are points, too. Empty with Automatic.
 *
 * An empty domain gives an empty output. Failure, with an empty output: a domain that vtkDrillHoles
 * refuses; a singularity of port 1 outside of it; arrays that are missing or not integer; a corner
 * that is no vertex of the boundary; a domain too thin for the grid. An optimiser that does not
 * converge is a warning and `Converged` 0.
 *
 * Paper: the algorithm that closes "Generalized Poincaré-Hopf theorem".
 *
 * @sa vtkPoincareHopfCheck, vtkSingularityOptimizer, vtkDrillHoles,
 * crossfield::ProposeConfigurations,
 * crossfield::ChooseConfiguration
 */

#ifndef vtkConfigurationProposal_h
#define vtkConfigurationProposal_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkPolyDataAlgorithm.h"

class VTKCROSSFIELDFILTERS_EXPORT vtkConfigurationProposal : public vtkPolyDataAlgorithm
{
public:
  static vtkConfigurationProposal* New();
  vtkTypeMacro(vtkConfigurationProposal, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Connects port 1, the singularities, or port 2, the corners, or sets it to a data object. */
  vtkCrossFieldPortMacro(Singularities, 1);
  vtkCrossFieldPortMacro(Corners, 2);
  ///@}

  ///@{
  /**
   * Sets the turning angle, in degrees, above which a boundary vertex is a corner. Default: 30.
   * Range: 1 to 45.
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
   * Adds a singularity of index 1 for each corner of interior angle in [3π/4, π), one for two
   * consecutive corners, and as many of index −1 elsewhere, so that these corners can be regular
   * points of the boundary. Default: off.
   */
  vtkSetMacro(CancelFlatCorners, bool);
  vtkGetMacro(CancelFlatCorners, bool);
  vtkBooleanMacro(CancelFlatCorners, bool);
  ///@}

  ///@{
  /**
   * Gives quarter index 1 to sharp corners whose smallest rotation has quarter index 2, as
   * vtkQuadMesher requires; singularities make up for the difference. Default: off.
   */
  vtkSetMacro(CapCorners, bool);
  vtkGetMacro(CapCorners, bool);
  vtkBooleanMacro(CapCorners, bool);
  ///@}

  ///@{
  /** Optimises the proposal; interior singularities of port 1 move as well. Default: off. */
  vtkSetMacro(Automatic, bool);
  vtkGetMacro(Automatic, bool);
  vtkBooleanMacro(Automatic, bool);
  ///@}

  ///@{
  /**
   * Sets the number of alternatives listed besides the proposal: other starts, other quarter
   * indices of undecided corners, one by one and together, with the interior singularities that
   * these require, one of ±2 instead of two of ±1, and an additional pair. Default: 0. Range: 0 to
   * 100.
   */
  vtkSetClampMacro(Alternatives, int, 0, 100);
  vtkGetMacro(Alternatives, int);
  ///@}

  ///@{
  /**
   * Sets the target edge length of the mesh of the optimiser. Default: 0, 1/40 of the diagonal of
   * the bounding box. Range: 0 or more.
   */
  vtkSetClampMacro(MeshSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MeshSize, double);
  ///@}

  ///@{
  /**
   * Sets, for Automatic, the minimum distance of interior singularities from the boundary and from
   * each other, as in vtkSingularityOptimizer. Default: 0, 1/400 of the diagonal of the bounding
   * box. Range: 0 or more.
   */
  vtkSetClampMacro(Clearance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Clearance, double);
  ///@}

  ///@{
  /**
   * Preserves, with Automatic, all singularities, as KeepAll of vtkSingularityOptimizer does.
   * Default: off.
   */
  vtkSetMacro(KeepAll, bool);
  vtkGetMacro(KeepAll, bool);
  vtkBooleanMacro(KeepAll, bool);
  ///@}

  ///@{
  /**
   * Sets the core radius of singularities at which energies are compared. Default: 0, 1/100 of the
   * diagonal of the bounding box. Range: 0 or more.
   */
  vtkSetClampMacro(CoreRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CoreRadius, double);
  ///@}

protected:
  vtkConfigurationProposal();
  ~vtkConfigurationProposal() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkConfigurationProposal(const vtkConfigurationProposal&) = delete;
  void operator=(const vtkConfigurationProposal&) = delete;

  double CornerAngle = 30.0;
  double FeatureAngle = 35.0;
  bool CancelFlatCorners = false;
  bool CapCorners = false;
  bool Automatic = false;
  double MeshSize = 0.0;
  double Clearance = 0.0;
  bool KeepAll = false;
  int Alternatives = 0;
  double CoreRadius = 0.0;
};

#endif
