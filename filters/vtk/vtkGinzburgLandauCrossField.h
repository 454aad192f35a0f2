/**
 * @class   vtkGinzburgLandauCrossField
 * @brief   the boundary-aligned cross field that minimises the Ginzburg-Landau energy
 *
 * A cross is represented by u = e^{4iθ}. The field minimises
 *   E(u) = ½ ∫ w |∇u|² + 1/(4ε²) ∫ (|u|² − f²)²
 * over Crouzeix-Raviart fields (values at the midpoints of edges) with u = e^{4iτ} on every outer
 * and inner boundary edge, τ its direction angle. f = w = 1, unless NormArrayName or
 * GradientWeightArrayName give other values to pin singularities where they are small.
 * Singularities come by themselves, as zeros of u with a core of about ε: the method to compare
 * others with. The penalty is integrated by the midpoints of edges, an error of second order in the
 * mesh size.
 *
 * The minimum is a local one, and depends on Start: on a ring, Harmonic keeps the radial field
 * without singularities while Constant ends with four of either sign and twice the energy.
 *
 * Port 0, a mesh made by vtkDrillHoles without singularities (vtkUnstructuredGrid with its three
 * cell arrays). Optional cell arrays (1 component, read on triangles): those named by NormArrayName
 * (≥ 0) and GradientWeightArrayName (> 0); `CrossFieldCR` for StartGiven.
 *
 * Output: the mesh, and the cell and point arrays of vtkPerforatedCrossField: `CrossFieldCR`,
 * `Representation`, `Cross`, `Cross2`, `CrossNorm`.
 *
 * Field data: that of vtkPerforatedCrossField, where `Energy` = `GradientEnergy` + `PenaltyEnergy`,
 * the two terms of E; `Residual` is the norm of the gradient of E relative to the terms that cancel
 * in it; `HoleDegree` and `HoleNormRange` are empty; `GivenInteriorQuarters` is the sum of the
 * singularities found inside, to be compared with `RequiredInteriorQuarters` (with corners of the
 * boundary the field may choose other indices for them, and `Consistent` is then 0);
 * `UnwantedSingularities` is what the field has beyond the least that the Poincaré-Hopf theorem
 * asks for, Σ |k| − |required sum|. Besides: `Epsilon` (double, the length used) and
 * `ConvexifiedSteps` (int, iterations in which the Hessian was not positive definite).
 *
 * Epsilon is a length in the units of the domain; well below the edge length the mesh holds
 * singularities wherever they happen to be, well above the size of the domain there are none. Any
 * domain is allowed.
 *
 * An empty mesh gives an empty output. Failure, with an empty output: a mesh without the arrays of
 * vtkDrillHoles, or with holes; a named array that is missing, has several components or values out
 * of range; StartGiven without `CrossFieldCR`. An iteration that does not converge is a warning and
 * `Converged` 0.
 *
 * Cost: one sparse Cholesky factorisation with two unknowns per edge in every iteration, some ten
 * to a hundred iterations. On a disk of fine triangles nearly nothing holds the four singularities
 * against a common turn, and that takes most of them.
 *
 * Paper: "Ginzburg-Landau", "Pinning strategy". Difference from it: u is in the Crouzeix-Raviart
 * space there and here, but the iteration has a line search, and leaves critical points that are no
 * minimum.
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

  /** The field that the iteration starts from. */
  enum
  {
    StartHarmonic = 0,
    StartConstant = 1,
    StartZero = 2,
    StartGiven = 3
  };

  ///@{
  /**
   * The length ε, in the units of the domain. Default: 0, which means the mean edge length, weighted by area, of the
   * mesh.
   */
  vtkSetClampMacro(Epsilon, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Epsilon, double);
  ///@}

  ///@{
  /**
   * Start: the field without penalty, crosses along the axes (u = 1), u = 0, or the field in the
   * input's array `CrossFieldCR`. Default: StartHarmonic.
   */
  vtkSetClampMacro(Start, int, StartHarmonic, StartGiven);
  vtkGetMacro(Start, int);
  void SetStartToHarmonic() { this->SetStart(StartHarmonic); }
  void SetStartToConstant() { this->SetStart(StartConstant); }
  void SetStartToZero() { this->SetStart(StartZero); }
  void SetStartToGiven() { this->SetStart(StartGiven); }
  ///@}

  ///@{
  /** Cell array with f, the norm that the penalty asks for. Default: empty, f = 1. */
  vtkSetMacro(NormArrayName, std::string);
  vtkGetMacro(NormArrayName, std::string);
  ///@}

  ///@{
  /** Cell array with w, the weight of the gradient term. Default: empty, w = 1. */
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
