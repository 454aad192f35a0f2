/**
 * @class   vtkSingularityOptimizer
 * @brief   move singularities to where the renormalised energy of their cross field is least
 *
 * Moves the interior singularities downhill on W, see vtkSingularityEnergy, until its derivatives
 * vanish. With inner loops the holonomy defects are equality constraints: the result has an aligned
 * field of norm one with a single-valued H. Sequential quadratic programming with exact derivatives;
 * one mesh without holes, factored once.
 *
 * Port 0, the domain (vtkPolyData or vtkUnstructuredGrid): as for vtkDrillHoles.
 * Port 1, the singularities to start from (points): point arrays `QuarterIndex` (integers) and
 * optionally `Radius`, inside or on the boundary as for vtkHField.
 * Port 2, optional, corners (points) with `QuarterIndex` (integers), as for vtkHField.
 *
 * Output port 0 (vtkPolyData): the singularities in their order, point arrays `QuarterIndex` (int) and
 * `Radius` (double, as given or shrunk to fit, 0 if not given). Field data: `RenormalizedEnergyBefore`,
 * `RenormalizedEnergyAfter`, `Iterations`, `Converged` (0 or 1), `HolonomyDefect` (per inner loop),
 * `Annihilation` (2 components, int: rows of the input of two singularities of opposite sign that met;
 * none if none), `Reason` (string, one sentence), `Events` (strings: a sentence for whatever happened
 * besides moving). With UniformSizes also `SizeSpreadBefore` and `SizeSpreadAfter`: the standard deviation
 * of log size, H, over the area, where W is least and of the result (with SizingField of the logarithm of size over
 * wanted size); and the front, one value each where W is least,
 * with even sizes, and with every pair that was added: `FrontSingularities` (int), `FrontSizeSpread`,
 * `FrontRenormalizedEnergy`, `FrontHolonomyDefect` (largest, radians).
 * Output port 1 (vtkTable): the history, one row per iteration from the start on: `Iteration` (int),
 * `RenormalizedEnergy`, `GradientNorm` (largest derivative of the Lagrangian, times the diagonal of the
 * domain), `HolonomyDefect` (the largest), `StepLength` (the longest way of a singularity).
 *
 * Singularities of like sign repel each other, and the boundary repels them; opposite signs attract.
 * Two that meet are taken out, or become one of the sum; one that is pressed against the boundary, as
 * at a corner that would rather carry it, becomes one of the boundary, and one on the boundary moves
 * inside where that is cheaper. All others stay at the Clearance, and do not stop the run. Where the
 * singularities do not come to rest, `Converged` is 0, and a warning gives the reason. An abort gives
 * the best configuration so far.
 *
 * An empty domain gives empty outputs. Failure, with empty outputs: a domain that vtkDrillHoles
 * refuses; a singularity outside; quarter indices that violate the Poincaré-Hopf theorem
 * (GetErrorCode() is then vtkCrossFieldErrorCodes::Inconsistent); missing arrays; wanted sizes that are not positive.
 *
 * Paper: "The unifying renormalized Ginzburg-Landau energy", whose minimisation it leaves open.
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
  /** Port 1, the singularities, and port 2, the corners: connections or data objects. */
  vtkCrossFieldPortMacro(Singularities, 1);
  vtkCrossFieldPortMacro(Corners, 2);
  ///@}

  ///@{
  /**
   * Target edge length of the mesh; 0: 1/40 of the diagonal of the bounding box. Default: 0.
   * Range: 0 or more.
   */
  vtkSetClampMacro(MeshSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MeshSize, double);
  ///@}

  ///@{
  /** Most iterations. Default: 200. Range: 0 or more. */
  vtkSetClampMacro(MaximumIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

  ///@{
  /**
   * The iteration stops when the derivatives of the Lagrangian, times the diagonal of the domain, and
   * the holonomy defects are below this. Default: 1e-6. Range: 1e-10 to 1.
   */
  vtkSetClampMacro(Tolerance, double, 1e-10, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Least distance of the singularities inside to the boundary and to each other, in the units of the
   * domain; 0: 1/400 of the diagonal of the bounding box. Default: 0. Range: 0 or more.
   */
  vtkSetClampMacro(Clearance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Clearance, double);
  ///@}

  ///@{
  /**
   * Every singularity stays what it is: none moves into the boundary or out of it, and two of opposite
   * sign that meet are not taken out but stay at the clearance. Default: off.
   */
  vtkSetMacro(KeepAll, bool);
  vtkGetMacro(KeepAll, bool);
  vtkBooleanMacro(KeepAll, bool);
  ///@}

  ///@{
  /**
   * After the least W, move on to where the sizes of quads that follow the field are most even, with the
   * singularities that there are. Default: off.
   */
  vtkSetMacro(UniformSizes, bool);
  vtkGetMacro(UniformSizes, bool);
  vtkBooleanMacro(UniformSizes, bool);
  ///@}

  /** Which sizes are even: the values that vtkQuadMesher has for them. */
  enum SizingType
  {
    SizingUniform = 1,
    SizingField = 2
  };

  ///@{
  /**
   * With UniformSizes or Pairs. SizingUniform: sizes are to be the same everywhere. SizingField: in proportion to the
   * point array SizeArray of the domain. Default: SizingUniform.
   */
  vtkSetClampMacro(Sizing, int, SizingUniform, SizingField);
  vtkGetMacro(Sizing, int);
  void SetSizingToUniform() { this->SetSizing(SizingUniform); }
  void SetSizingToField() { this->SetSizing(SizingField); }
  ///@}

  ///@{
  /**
   * Point array of the domain with the wanted length of quads for SizingField, of which only proportions count: linear on
   * surface cells and along curves, of which it is continued inside, as vtkQuadMesher takes it. Default: none.
   */
  vtkSetMacro(SizeArray, std::string);
  vtkGetMacro(SizeArray, std::string);
  ///@}
  /** As above; what ParaView calls. */
  void SetSizeArray(const char* name) { this->SetSizeArray(std::string(name ? name : "")); }

  ///@{
  /**
   * Then add up to so many pairs of quarter indices 1 and -1 where they make sizes most even, while a pair brings 15 %
   * of the spread or halves a holonomy defect; more than 0 is with UniformSizes. Default: 0. Range: 0 to 100.
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
