/**
 * @class   vtkPerforatedCrossField
 * @brief   the smoothest boundary-aligned cross field with prescribed singularities in holes
 *
 * A cross is represented by u = e^{4iθ}. The field lives in the Crouzeix-Raviart space of the
 * drilled mesh (values at the midpoints of edges) with u = e^{4iτ} on every outer and inner boundary
 * edge, τ its direction angle. By Method:
 * - UnitNorm, the default, minimises ½ ∫ |∇φ|² over u = e^{iφ} whose phase turns k times around every
 *   hole: a linear problem without iterations, |u| = 1 everywhere. The field has exactly the
 *   singularities that are asked for.
 * - Constrained, the method of the paper, minimises ½ ∫ |∇u|² over complex u with, on every hole, the degree constraint
 *     Σ_j Im(conj(u_j) u_{j+1}) = Σ_j sin(k Δα_j)
 *   over its edge midpoints, counter-clockwise, where k is the hole's quarter index and Δα_j the
 *   angle between neighbouring midpoints seen from the centre. |u| is free, and may vanish: there the
 *   field has singularities that nobody asked for, which is a warning.
 *
 * Port 0, a mesh made by vtkDrillHoles (vtkUnstructuredGrid with its three cell arrays). Where it
 * has imprinted circles or triangles instead of holes, they carry the constraints and the field goes
 * on inside: there it must vanish somewhere, and any other singularities may appear as well, so the
 * quarter indices need not add up to what the domain asks for. Points that no cell uses are ignored,
 * wherever they are; the arrays hold zeros there.
 * Port 1, optional, corners: points with the point array `QuarterIndex` (integers), each at a vertex
 * of an outer or inner loop, for example from vtkBoundaryCornerClassifier. They replace the smallest
 * rotations of the cross: UnitNorm takes these indices; Constrained is held only to the sum that
 * they leave to the holes.
 *
 * Output 0: the mesh, and
 * - `CrossFieldCR` (cells, double, 6): triangle (p0, p1, p2): Re, Im of u at the midpoints of p0p1,
 *   p1p2, p2p0, the exact discrete field; lines: u of that edge, three times;
 * - `Representation` (cells and points, float, 3): (Re u, Im u, 0) at the centre; at a point the
 *   mean of the field's one-sided values, weighted by area; u refers to the coordinates of the
 *   mesh's plane (see vtkDrillHoles), whichever that is;
 * - `Cross`, `Cross2` (cells and points, float, 3): a unit branch (cos θ, sin θ, 0) of the cross
 *   with θ = arg(u) / 4, and the branch at +90°, as directions of space in the mesh's plane;
 * - `CrossNorm` (cells and points, float, 1): |u|; not 1, the minimisation is over the plane.
 * All but the first follow from it, are in single precision, and can be left out: see Arrays.
 *
 * Output 1 (vtkTable): one column, `Summary`, with one row, a text for a view: how many singularities nobody asked for, or why there is
 * no field; its field data `Alarm` (int) is 1 where there are some, or no field.
 *
 * Field data, one value each unless said: `Energy` (½ ∫ |∇u|², or ½ ∫ |∇φ|²), `Iterations`,
 * `Residual` (of the optimality conditions, relative; UnitNorm: largest deviation of the integrated
 * phase from the prescribed crosses), `Converged` (0 or 1), `HoleDegree` (int per hole: the degree
 * reached), `HoleDegreeReliable` (int per hole: 0 where |u| comes close to zero or u turns by more than
 * π/2 from one edge to the next, so that another field next to it has another degree),
 * `StartedFromUnitNorm` and `UnitHoles` (0 or 1: what led to the field that was kept; see
 * Start), `HoleNormRange` (2 components per hole: least and largest |u| on it),
 * `DegreesReached` (0 or 1: every degree is the one asked for; with GlobalConstraint, their sum is),
 * `UnwantedSingularities` (int: Σ |k| over the singularities off holes, corners and chosen vertices,
 * beyond those of imprinted circles), with a penalty `Epsilon`, `GradientEnergy` and `PenaltyEnergy` (the two terms
 * of `Energy`), `EulerCharacteristic`, `Valence`, `TangentTurning`,
 * `RequiredInteriorQuarters`, `GivenInteriorQuarters`, `Consistent` (of the generalised
 * Poincaré-Hopf theorem), `HolonomyDefect` (UnitNorm, per inner loop, radians in (−π, π]: the phase
 * that a single-valued potential carries to it minus that of its alignment; absorbed by adding a
 * harmonic field).
 *
 * An empty mesh gives empty outputs. Failure, with an empty field: a mesh without the arrays of
 * vtkDrillHoles; a hole with too few edges for its quarter index; quarter indices that violate the
 * Poincaré-Hopf theorem on a perforated domain without a penalty (GetErrorCode() is then
 * vtkCrossFieldErrorCodes::Inconsistent); a unit hole that the mesh does not have; options of
 * the constrained method or imprinted circles with UnitNorm; unit holes together with a penalty. An
 * iteration that does not converge is a warning and `Converged` 0, and so is, with `Converged` 1, a
 * field of Constrained with unwanted singularities.
 *
 * Cost: one sparse Cholesky factorisation with one unknown per vertex; the iterations work on a
 * dense matrix over the edges of the holes only. With imprinted circles, GlobalConstraint or chosen
 * unit holes one unknown per edge takes the place of one per vertex; with a penalty every iteration is
 * a factorisation with two unknowns per edge.
 *
 * Paper: "Singularity placements via perforation strategy". Differences from it: the constraint
 * sums over all edges of a hole and its target is that of unit vectors on the polygon, not 2πk; the
 * Hessian carries the multipliers; everything but the holes is eliminated once, from the Laplacian
 * of the conjugate potentials; the iteration maximises the dual.
 *
 * @sa vtkDrillHoles, vtkCrossGlyphs, crossfield::SolvePerforated
 */

#ifndef vtkPerforatedCrossField_h
#define vtkPerforatedCrossField_h

#include "vtkCrossFieldErrorCodes.h"    // for InconsistentError
#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkCrossFieldSolver.h"

#include <vector> // for the rows of holes

class VTKCROSSFIELDFILTERS_EXPORT vtkPerforatedCrossField : public vtkCrossFieldSolver
{
public:
  static vtkPerforatedCrossField* New();
  vtkTypeMacro(vtkPerforatedCrossField, vtkCrossFieldSolver);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Another name of vtkCrossFieldErrorCodes::Inconsistent. */
  enum
  {
    InconsistentError = vtkCrossFieldErrorCodes::Inconsistent
  };

  ///@{
  /** Connects port 1, the corners, or sets it to a data object. */
  vtkCrossFieldPortMacro(Corners, 1);
  ///@}

  /** How the field is computed. */
  enum
  {
    MethodConstrained = 0,
    MethodUnitNorm = 1
  };

  ///@{
  /** The method; see the class comment. Default: MethodUnitNorm. */
  vtkSetClampMacro(Method, int, MethodConstrained, MethodUnitNorm);
  vtkGetMacro(Method, int);
  void SetMethodToConstrained() { this->SetMethod(MethodConstrained); }
  void SetMethodToUnitNorm() { this->SetMethod(MethodUnitNorm); }
  ///@}

  /** Where the iteration of the constrained method starts. */
  enum
  {
    StartBest = 0,
    StartHarmonic = 1,
    StartUnitNorm = 2
  };

  ///@{
  /**
   * Constrained method: the start. Harmonic leads to the global minimum of the energy, UnitNorm to a
   * local one near the unit-norm field. Best tries both if the first has a wrong degree or an
   * unwanted singularity, keeps the better one, and forces |u| = 1 on the holes if a degree is still
   * wrong. With imprinted circles, a global constraint, chosen unit holes or a penalty, UnitNorm starts
   * from unit crosses on the holes where no unit-norm field exists, and Best forces nothing.
   * Default: StartBest.
   */
  vtkSetClampMacro(Start, int, StartBest, StartUnitNorm);
  vtkGetMacro(Start, int);
  void SetStartToBest() { this->SetStart(StartBest); }
  void SetStartToHarmonic() { this->SetStart(StartHarmonic); }
  void SetStartToUnitNorm() { this->SetStart(StartUnitNorm); }
  ///@}

  ///@{
  /** Constrained method: force |u| = 1 on every hole. Default: off. */
  vtkSetMacro(UnitHoles, bool);
  vtkGetMacro(UnitHoles, bool);
  vtkBooleanMacro(UnitHoles, bool);
  ///@}

  ///@{
  /**
   * Constrained method: the same on chosen holes or imprinted circles, by their rows in the
   * configuration. Default: none.
   */
  void AddUnitHole(int row);
  void RemoveAllUnitHoles();
  ///@}

  ///@{
  /**
   * Constrained method: one constraint on the sum over all holes in place of one per hole; how it is
   * shared is up to the field. Default: off.
   */
  vtkSetMacro(GlobalConstraint, bool);
  vtkGetMacro(GlobalConstraint, bool);
  vtkBooleanMacro(GlobalConstraint, bool);
  ///@}

  ///@{
  /**
   * Constrained method: ε of the penalty 1/(4ε²) ∫ (|u|² − 1)² that is added to the energy, a length
   * in the units of the domain. It keeps |u| near 1, and admits any quarter indices: singularities
   * that make up for a wrong sum appear and are reported. Default: 0, no penalty.
   */
  vtkSetClampMacro(Epsilon, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Epsilon, double);
  ///@}

protected:
  vtkPerforatedCrossField();
  ~vtkPerforatedCrossField() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
#ifndef __VTK_WRAP__
  void Compute(const DrilledMeshConversion::DrilledMesh& cells, vtkInformationVector** inputVector,
    const crossfield::Progress& progress, vtkInformationVector* outputVector) override;
  void ReportFailure(const char* sentence, vtkInformationVector* outputVector) override;
#endif

private:
  vtkPerforatedCrossField(const vtkPerforatedCrossField&) = delete;
  void operator=(const vtkPerforatedCrossField&) = delete;

  int Method = MethodUnitNorm;
  int Start = StartBest;
  bool UnitHoles = false;
  std::vector<int> UnitHoleRows;
  bool GlobalConstraint = false;
  double Epsilon = 0.0;
};

#endif
