/**
 * @class   vtkSingularityOptimizer
 * @brief   move singularities to a minimum of the renormalised energy of their cross field
 *
 * Moves the interior singularities downhill on W (see vtkSingularityEnergy) until its derivatives
 * vanish. With inner loops the holonomy defects are equality constraints: the result has an aligned
 * field of norm one with a single-valued H. The method is sequential quadratic programming with
 * exact derivatives on one mesh without holes, which is factored once.
 *
 * Input port 0 (vtkPolyData or vtkUnstructuredGrid): the domain, as for vtkDrillHoles.
 * Input port 1: the initial singularities (points) with the point arrays `QuarterIndex` (integers)
 * and optionally `Radius`, inside or on the boundary as for vtkHField.
 * Input port 2, optional: corners (points) with `QuarterIndex` (integers), as for vtkHField.
 *
 * Output port 0 (vtkPolyData): the singularities in their order, with the point arrays
 * `QuarterIndex` (int) and `Radius` (double, as given or reduced to fit, 0 if not given). Field
 * data:
 * - `RenormalizedEnergyBefore`, `RenormalizedEnergyAfter`, `Iterations`, `Converged` (0 or 1);
 * - `HolonomyDefect` (for each inner loop);
 * - `Annihilation` (int, 2 components): input rows of the pairs of singularities of opposite sign
 *   that met; empty if none did;
 * - `Reason` (string): one sentence;
 * - `Events` (strings): one sentence for each event other than a movement;
 * - with UniformSizes `SizeSpreadBefore`, `SizeSpreadAfter`: the standard deviation over the area
 *   of H, the logarithm of size, at the minimum of W and of the result; with SizingField that of
 *   the logarithm of size over target size;
 * - with UniformSizes also the front, one value for the minimum of W, one for uniform sizes, and
 *   one for each pair added: `FrontSingularities` (int), `FrontSizeSpread`,
 *   `FrontRenormalizedEnergy`, `FrontHolonomyDefect` (maximum, radians).
 *
 * Output port 1 (vtkTable): the history, one row per iteration including the start: `Iteration`
 * (int), `RenormalizedEnergy`, `GradientNorm` (maximum derivative of the Lagrangian, times the
 * diagonal of the domain), `HolonomyDefect` (maximum), `StepLength` (maximum displacement of a
 * singularity).
 *
 * Singularities of the same sign repel each other, and the boundary repels them; opposite signs
 * attract. Two singularities that meet are removed or merged into one that has the sum of their
 * indices. A singularity pressed against the boundary, for example at a corner where it costs less,
 * becomes a boundary singularity, and one on the boundary moves inside where that costs less. All
 * others stay at the Clearance and do not stop the run. If the singularities do not converge,
 * `Converged` is 0 and a warning gives the reason. An abort returns the best configuration so far.
 *
 * An empty domain gives empty outputs. The filter fails, with empty outputs, if vtkDrillHoles would
 * refuse the domain, if a singularity is outside, if the quarter indices violate the Poincaré-Hopf
 * theorem (GetErrorCode() is then vtkCrossFieldErrorCodes::Inconsistent), if arrays are missing, or
 * if target sizes are not positive.
 *
 * Paper: "The unifying renormalized Ginzburg-Landau energy", which leaves its minimisation open.
 *
 * @sa vtkSingularityEnergy, vtkHField, crossfield::OptimizeSingularities
 */

#ifndef vtkSingularityOptimizer_h
#define vtkSingularityOptimizer_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkPolyDataAlgorithm.h"

#include <string> // for SizeArray

class VTKCROSSFIELDFILTERS_EXPORT vtkSingularityOptimizer : public vtkPolyDataAlgorithm
{
public:
  static vtkSingularityOptimizer* New();
  vtkTypeMacro(vtkSingularityOptimizer, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Connects port 1, the singularities, or port 2, the corners, or sets it to a data object. */
  vtkCrossFieldPortMacro(Singularities, 1);
  vtkCrossFieldPortMacro(Corners, 2);
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
  /** Sets the maximum number of iterations. Default: 200. Range: 0 or more. */
  vtkSetClampMacro(MaximumIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

  ///@{
  /**
   * Sets the tolerance: the iteration stops when the derivatives of the Lagrangian, times the
   * diagonal of the domain, and the holonomy defects are below it. Default: 1e-6. Range: 1e-10 to
   * 1.
   */
  vtkSetClampMacro(Tolerance, double, 1e-10, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Sets the minimum distance of interior singularities from the boundary and from each other, in
   * the units of the domain. Default: 0, 1/400 of the diagonal of the bounding box. Range: 0 or
   * more.
   */
  vtkSetClampMacro(Clearance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Clearance, double);
  ///@}

  ///@{
  /**
   * Preserves all singularities: none moves into the boundary or out of it, and two of opposite
   * sign that meet stay at the clearance. Default: off.
   */
  vtkSetMacro(KeepAll, bool);
  vtkGetMacro(KeepAll, bool);
  vtkBooleanMacro(KeepAll, bool);
  ///@}

  ///@{
  /**
   * Continues after the minimum of W to the most uniform sizes of quads that follow the field, with
   * the same singularities. Default: off.
   */
  vtkSetMacro(UniformSizes, bool);
  vtkGetMacro(UniformSizes, bool);
  vtkBooleanMacro(UniformSizes, bool);
  ///@}

  /** Target of uniform sizes; values as in vtkQuadMesher. */
  enum SizingType
  {
    SizingUniform = 1,
    SizingField = 2
  };

  ///@{
  /**
   * Selects the target with UniformSizes or Pairs: the same size everywhere (SizingUniform) or
   * sizes in proportion to the point array SizeArray of the domain (SizingField). Default:
   * SizingUniform.
   */
  vtkSetClampMacro(Sizing, int, SizingUniform, SizingField);
  vtkGetMacro(Sizing, int);
  void SetSizingToUniform() { this->SetSizing(SizingUniform); }
  void SetSizingToField() { this->SetSizing(SizingField); }
  ///@}

  ///@{
  /**
   * Sets the point array of the domain with the target edge length of quads for SizingField. Only
   * its proportions matter. It is linear on surface cells; values along curves are extended to the
   * inside, as in vtkQuadMesher. Default: none.
   */
  vtkSetMacro(SizeArray, std::string);
  vtkGetMacro(SizeArray, std::string);
  ///@}
  /** Sets the name of the size array; overload for ParaView. */
  void SetSizeArray(const char* name) { this->SetSizeArray(std::string(name ? name : "")); }

  ///@{
  /**
   * Sets the maximum number of pairs of quarter indices 1 and −1 to add where they make sizes most
   * uniform. A pair is added only if it reduces the spread by 15 % or halves a holonomy defect. A
   * value above 0 implies UniformSizes. Default: 0. Range: 0 to 100.
   */
  vtkSetClampMacro(Pairs, int, 0, 100);
  vtkGetMacro(Pairs, int);
  ///@}

protected:
  vtkSingularityOptimizer();
  ~vtkSingularityOptimizer() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSingularityOptimizer(const vtkSingularityOptimizer&) = delete;
  void operator=(const vtkSingularityOptimizer&) = delete;

  double MeshSize = 0.0;
  int MaximumIterations = 200;
  double Tolerance = 1e-6;
  double Clearance = 0.0;
  bool KeepAll = false;
  bool UniformSizes = false;
  int Sizing = SizingUniform;
  std::string SizeArray;
  int Pairs = 0;
};

#endif
