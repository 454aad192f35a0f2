/**
 * @class   vtkPerforatedCrossField
 * @brief   compute the smoothest boundary-aligned cross field with prescribed singularities in
 * holes
 *
 * A cross is represented by u = e^{4iθ}. The field is in the Crouzeix-Raviart space of the drilled
 * mesh (values at the midpoints of edges) with u = e^{4iτ} on every outer and inner boundary edge,
 * where τ is the direction angle of the edge. There are two methods:
 * - UnitNorm, the default, minimises ½ ∫ |∇φ|² over u = e^{iφ} whose phase turns k times around
 *   every hole. This is a linear problem without iterations, and |u| = 1 everywhere. The field has
 *   exactly the prescribed singularities.
 * - Constrained, the method of the paper, minimises ½ ∫ |∇u|² over complex u with, on every hole,
 *   the degree constraint Σ_j Im(conj(u_j) u_{j+1}) = Σ_j sin(k Δα_j). The sums are over the edge
 *   midpoints of the hole, counter-clockwise; k is the quarter index of the hole and Δα_j the angle
 *   between neighbouring midpoints seen from its centre. |u| is free and may vanish. Where it does,
 *   the field has unwanted singularities, which cause a warning.
 *
 * Input port 0 (vtkUnstructuredGrid): a mesh made by vtkDrillHoles, with its three cell arrays.
 * Imprinted circles or triangles carry the constraints in place of holes, and the field continues
 * inside them. It must vanish somewhere inside, and other singularities may appear as well, so the
 * quarter indices need not have the sum that the domain requires. Points that no cell uses are
 * ignored, wherever they are; the arrays are zero there.
 * Input port 1, optional: corners, points with the point array `QuarterIndex` (integers), each at a
 * vertex of an outer or inner loop, for example from vtkBoundaryCornerClassifier. Their indices
 * replace those of the smallest rotations of the cross. UnitNorm uses each of these indices;
 * Constrained only uses the sum that they leave to the holes.
 *
 * Output port 0 (vtkUnstructuredGrid): the mesh, and
 * - `CrossFieldCR` (cells, double, 6): for a triangle (p0, p1, p2) Re and Im of u at the midpoints
 *   of p0p1, p1p2, p2p0, the exact discrete field; for a line u of its edge, three times;
 * - `Representation` (cells and points, float, 3): (Re u, Im u, 0) at the centre of the cell, or at
 *   a point the mean of the one-sided values of the field, weighted by area. u refers to the
 *   coordinates of the plane of the mesh, whichever plane it is (see vtkDrillHoles);
 * - `Cross`, `Cross2` (cells and points, float, 3): a unit branch (cos θ, sin θ, 0) of the cross
 *   with θ = arg(u) / 4, and the branch at +90°, as directions in space in the plane of the mesh;
 * - `CrossNorm` (cells and points, float, 1): |u|. It is not 1 in general, since Constrained
 *   minimises over the plane and values at centres and points are averages.
 * All but the first are computed from it in single precision and can be omitted; see Arrays.
 *
 * Output port 1 (vtkTable): the column `Summary` with one row, a text for a view: the number of
 * unwanted singularities, or why there is no field. Its field data `Alarm` (int) is 1 if there are
 * unwanted singularities or there is no field.
 *
 * Field data, one value each unless stated otherwise:
 * - `Energy`: ½ ∫ |∇u|² or ½ ∫ |∇φ|²;
 * - `Iterations`; `Converged` (0 or 1);
 * - `Residual`: of the optimality conditions, relative; for UnitNorm the maximum deviation of the
 *   integrated phase from the prescribed crosses;
 * - `HoleDegree` (int for each hole): the degree of the field around the hole;
 * - `HoleDegreeReliable` (int for each hole): 0 where |u| is close to zero or u turns by more than
 *   π/2 from one edge to the next, so that a nearby field has another degree;
 * - `StartedFromUnitNorm`, `UnitHoles` (0 or 1): how the returned field was found; see Start;
 * - `HoleNormRange` (2 components for each hole): minimum and maximum |u| on it;
 * - `DegreesReached` (0 or 1): whether every hole has the prescribed degree; with GlobalConstraint,
 *   whether their sum has;
 * - `UnwantedSingularities` (int): Σ |k| over the singularities that are not at holes, corners or
 *   chosen vertices, beyond those of imprinted circles;
 * - with a penalty `Epsilon`, `GradientEnergy` and `PenaltyEnergy` (the two terms of `Energy`);
 * - `EulerCharacteristic`, `Valence`, `TangentTurning`, `RequiredInteriorQuarters`,
 *   `GivenInteriorQuarters`, `Consistent`: the terms of the generalised Poincaré-Hopf theorem;
 * - `HolonomyDefect` (UnitNorm, for each inner loop, radians in (−π, π]): the phase that a
 *   single-valued potential has at the loop minus the phase of its alignment. Adding a harmonic
 *   field removes the difference.
 *
 * An empty mesh gives empty outputs. The filter fails, with an empty field, if the mesh lacks the
 * arrays of vtkDrillHoles; if a hole has too few edges for its quarter index; if the quarter
 * indices violate the Poincaré-Hopf theorem on a perforated domain without a penalty
 * (GetErrorCode() is then vtkCrossFieldErrorCodes::Inconsistent); if a unit hole does not exist;
 * with UnitNorm, if options of the constrained method are set or the mesh has imprinted circles;
 * and if unit holes are combined with a penalty. An iteration that does not converge is a warning,
 * with `Converged` 0. A field of Constrained with unwanted singularities is a warning, with
 * `Converged` 1.
 *
 * Cost: one sparse Cholesky factorisation with one unknown per vertex; the iterations use a dense
 * matrix over the edges of the holes only. With imprinted circles, GlobalConstraint or chosen unit
 * holes there is one unknown per edge instead of one per vertex. With a penalty every iteration is
 * a factorisation with two unknowns per edge.
 *
 * Paper: "Singularity placements via perforation strategy". Differences from the paper: the
 * constraint sums over all edges of a hole, and its target is that of unit vectors on the polygon,
 * not 2πk; the Hessian includes the multipliers; everything but the holes is eliminated once, from
 * the Laplacian of the conjugate potentials; the iteration maximises the dual.
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

  /** Alias of vtkCrossFieldErrorCodes::Inconsistent. */
  enum
  {
    InconsistentError = vtkCrossFieldErrorCodes::Inconsistent
  };

  ///@{
  /** Connects port 1, the corners, or sets it to a data object. */
  vtkCrossFieldPortMacro(Corners, 1);
  ///@}

  /** Methods of computing the field. */
  enum
  {
    MethodConstrained = 0,
    MethodUnitNorm = 1
  };

  ///@{
  /** Selects the method; see the class comment. Default: MethodUnitNorm. */
  vtkSetClampMacro(Method, int, MethodConstrained, MethodUnitNorm);
  vtkGetMacro(Method, int);
  void SetMethodToConstrained() { this->SetMethod(MethodConstrained); }
  void SetMethodToUnitNorm() { this->SetMethod(MethodUnitNorm); }
  ///@}

  /** Initial fields of the constrained method. */
  enum
  {
    StartBest = 0,
    StartHarmonic = 1,
    StartUnitNorm = 2
  };

  ///@{
  /**
   * Constrained method: selects the initial field. Harmonic leads to the global minimum of the
   * energy, UnitNorm to a local one near the unit-norm field. Best tries both if the first result
   * has a wrong degree or an unwanted singularity, returns the better one, and forces |u| = 1 on
   * the holes if a degree is still wrong. With imprinted circles, a global constraint, chosen unit
   * holes or a penalty, UnitNorm starts from unit crosses on the holes if no unit-norm field
   * exists, and Best never forces |u| = 1. Default: StartBest.
   */
  vtkSetClampMacro(Start, int, StartBest, StartUnitNorm);
  vtkGetMacro(Start, int);
  void SetStartToBest() { this->SetStart(StartBest); }
  void SetStartToHarmonic() { this->SetStart(StartHarmonic); }
  void SetStartToUnitNorm() { this->SetStart(StartUnitNorm); }
  ///@}

  ///@{
  /** Constrained method: forces |u| = 1 on every hole. Default: off. */
  vtkSetMacro(UnitHoles, bool);
  vtkGetMacro(UnitHoles, bool);
  vtkBooleanMacro(UnitHoles, bool);
  ///@}

  ///@{
  /**
   * Constrained method: forces |u| = 1 on chosen holes or imprinted circles, by their rows in the
   * configuration. Default: none.
   */
  void AddUnitHole(int row);
  void RemoveAllUnitHoles();
  ///@}

  ///@{
  /**
   * Constrained method: replaces the constraints of the holes by one constraint on their sum. The
   * field is free to distribute it. Default: off.
   */
  vtkSetMacro(GlobalConstraint, bool);
  vtkGetMacro(GlobalConstraint, bool);
  vtkBooleanMacro(GlobalConstraint, bool);
  ///@}

  ///@{
  /**
   * Constrained method: sets ε, a length in the units of the domain, of the penalty 1/(4ε²) ∫ (|u|²
   * − 1)² added to the energy. The penalty keeps |u| near 1 and allows any quarter indices:
   * singularities that compensate for a wrong sum appear and are reported. Default: 0, no penalty.
   * Range: 0 or more.
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
