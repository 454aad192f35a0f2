/**
 * @class   vtkGinzburgLandauCrossField
 * @brief   compute the boundary-aligned cross field that minimises the Ginzburg-Landau energy
 *
 * A cross is represented by u = e^{4iθ}. The field minimises
 *   E(u) = ½ ∫ w |∇u|² + 1/(4ε²) ∫ (|u|² − f²)²
 * over Crouzeix-Raviart fields (values at the midpoints of edges) with u = e^{4iτ} on every outer
 * and inner boundary edge, where τ is the direction angle of the edge. f = w = 1 unless
 * NormArrayName or GradientWeightArrayName give other values, which pin singularities where they
 * are small. Singularities are not prescribed: they appear as zeros of u with a core of about ε,
 * which makes this method a reference for the others. The penalty is integrated by the midpoints of
 * edges, with an error of second order in the mesh size.
 *
 * The minimum is local and depends on Start: on a ring, Harmonic keeps the radial field without
 * singularities, while Constant ends with four singularities of either sign and twice the energy.
 *
 * Input port 0 (vtkUnstructuredGrid): a mesh made by vtkDrillHoles without singularities, with its
 * three cell arrays. Optional cell arrays (1 component, read on triangles): those named by
 * NormArrayName (values ≥ 0) and GradientWeightArrayName (values > 0); `CrossFieldCR` for
 * StartGiven.
 *
 * Output port 0 (vtkUnstructuredGrid): the mesh with the cell and point arrays of
 * vtkPerforatedCrossField: `CrossFieldCR`, `Representation`, `Cross`, `Cross2`, `CrossNorm`.
 *
 * Field data: as vtkPerforatedCrossField, with these differences.
 * - `Energy` = `GradientEnergy` + `PenaltyEnergy`, the two terms of E.
 * - `Residual` is the norm of the gradient of E relative to the terms that cancel in it.
 * - `HoleDegree` and `HoleNormRange` are empty.
 * - `GivenInteriorQuarters` is the sum of the singularities found inside, for comparison with
 *   `RequiredInteriorQuarters`. At corners of the boundary the field may choose other indices, and
 *   `Consistent` is then 0.
 * - `UnwantedSingularities` counts the singularities beyond the minimum of the Poincaré-Hopf
 *   theorem: Σ |k| − |required sum|.
 * - `Epsilon` (double) is the length used, and `ConvexifiedSteps` (int) the number of iterations in
 *   which the Hessian was not positive definite.
 *
 * Epsilon is a length in the units of the domain. If it is well below the edge length, the mesh
 * holds singularities wherever they happen to be; if it is well above the size of the domain, there
 * are no singularities. Any domain is allowed.
 *
 * An empty mesh gives an empty output. The filter fails, with an empty output, if the mesh lacks
 * the arrays of vtkDrillHoles or has holes; if a named array is missing, has several components or
 * has values out of range; and if StartGiven is used without `CrossFieldCR`. An iteration that does
 * not converge is a warning, with `Converged` 0.
 *
 * Cost: one sparse Cholesky factorisation with two unknowns per edge in every iteration, and ten to
 * a hundred iterations. On a finely meshed disk almost nothing prevents a common rotation of the
 * four singularities, which takes most of the iterations.
 *
 * Paper: "Ginzburg-Landau", "Pinning strategy". Both use the Crouzeix-Raviart space. Difference
 * from the paper: the iteration has a line search and leaves critical points that are not minima.
 *
 * @sa vtkDrillHoles, vtkCrossFieldSingularities, vtkPerforatedCrossField,
 * crossfield::SolveGinzburgLandau
 */

#ifndef vtkGinzburgLandauCrossField_h
#define vtkGinzburgLandauCrossField_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldSolver.h"

#include <string> // for the names of arrays

class VTKCROSSFIELDFILTERS_EXPORT vtkGinzburgLandauCrossField : public vtkCrossFieldSolver
{
public:
  static vtkGinzburgLandauCrossField* New();
  vtkTypeMacro(vtkGinzburgLandauCrossField, vtkCrossFieldSolver);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Initial field of the iteration. */
  enum
  {
    StartHarmonic = 0,
    StartConstant = 1,
    StartZero = 2,
    StartGiven = 3
  };

  ///@{
  /**
   * Sets the length ε, in the units of the domain. Default: 0, the mean edge length of the mesh,
   * weighted by area. Range: 0 or more.
   */
  vtkSetClampMacro(Epsilon, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Epsilon, double);
  ///@}

  ///@{
  /**
   * Selects the initial field: the minimiser without penalty (Harmonic), crosses along the axes, u
   * = 1 (Constant), u = 0 (Zero), or the array `CrossFieldCR` of the input (Given). Default:
   * StartHarmonic.
   */
  vtkSetClampMacro(Start, int, StartHarmonic, StartGiven);
  vtkGetMacro(Start, int);
  void SetStartToHarmonic() { this->SetStart(StartHarmonic); }
  void SetStartToConstant() { this->SetStart(StartConstant); }
  void SetStartToZero() { this->SetStart(StartZero); }
  void SetStartToGiven() { this->SetStart(StartGiven); }
  ///@}

  ///@{
  /** Sets the cell array with f, the target norm of the penalty. Default: empty, f = 1. */
  vtkSetMacro(NormArrayName, std::string);
  vtkGetMacro(NormArrayName, std::string);
  ///@}

  ///@{
  /** Sets the cell array with w, the weight of the gradient term. Default: empty, w = 1. */
  vtkSetMacro(GradientWeightArrayName, std::string);
  vtkGetMacro(GradientWeightArrayName, std::string);
  ///@}

protected:
  vtkGinzburgLandauCrossField();
  ~vtkGinzburgLandauCrossField() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
#ifndef __VTK_WRAP__
  void Compute(const DrilledMeshConversion::DrilledMesh& cells, vtkInformationVector** inputVector,
    const crossfield::Progress& progress, vtkInformationVector* outputVector) override;
#endif

private:
  vtkGinzburgLandauCrossField(const vtkGinzburgLandauCrossField&) = delete;
  void operator=(const vtkGinzburgLandauCrossField&) = delete;

  double Epsilon = 0.0;
  int Start = StartHarmonic;
  std::string NormArrayName;
  std::string GradientWeightArrayName;
};

#endif
