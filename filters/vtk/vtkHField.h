/**
 * @class   vtkHField
 * @brief   the scalar H of singularities inside and on the boundary, its size map and cross field
 *
 * H is the real part of the analytic function H + iθ, θ the angle of the cross (mod π/2):
 *   ΔH = 2π Σ_j (k_j / 4) δ_{b_j} inside, ∂H/∂ν = curvature − Σ_c (k_c π/2) δ_{p_c} on the boundary,
 * for singularities of quarter indices k_j at b_j, and k_c at points p_c of the boundary. e^H is the
 * local length of the edges of quads that follow the crosses, up to a factor. The logarithms of the
 * singularities are subtracted analytically: the rest is smooth and is solved for with continuous
 * piecewise linear functions, one linear system. The cross follows from ∇θ = rot ∇H by summation
 * along edges, without cuts; there is no iteration.
 *
 * Port 0, the domain (vtkPolyData or vtkUnstructuredGrid): as for vtkDrillHoles, meshed here without
 * holes; or a mesh made by vtkDrillHoles, which is kept. On a mesh with holes the singularities are
 * its holes, on which H is constant, and the cross is that of vtkPerforatedCrossField (UnitNorm).
 * Port 1, optional, singularities (points): point arrays `QuarterIndex` (integers) and optionally
 * `Radius`, inside or on the boundary. A singularity within 1e-6 of the diagonal of a vertex of the
 * boundary is one of the boundary; elsewhere on the boundary of a domain a vertex is inserted. On a
 * mesh with holes they must be those of the holes, or on the boundary.
 * Port 2, optional, corners (points) with `QuarterIndex` (integers), as for vtkPerforatedCrossField.
 * Other corners make the smallest rotation of the cross; if the sum of quarter indices is then wrong,
 * they take those of vtkBoundaryCornerClassifier, around what was given.
 *
 * Output: the mesh, with the arrays of vtkDrillHoles if it was made here, and
 * - `H` (points, double, 1), with area mean 0; at a point that is a singularity, where H is infinite,
 *   the mean over a disk of half the shortest edge there;
 * - `SizeMap` (points, float, 1): e^H, larger where the lines of the field spread; up to a factor
 *   the local edge length of quads;
 * - the arrays of vtkPerforatedCrossField: `CrossFieldCR` (cells, 6), `Representation`, `Cross`,
 *   `Cross2` (cells and points, 3), `CrossNorm` (cells and points, 1; |u| = 1 at the midpoints of
 *   edges).
 * `H` and `CrossFieldCR` are exact; the others follow from them, are in single precision, and can be left
 * out: see Arrays.
 *
 * Field data: as vtkPerforatedCrossField, with `Iterations` 0. `Energy`: on a mesh with holes ½ ∫ |∇φ|²
 * of the phase φ = 4θ. Without, that is infinite, and Energy is its expansion for holes of the given
 * radii (1/40 of the diagonal where not given) Σ_j π k_j² log(1/ρ_j) + W; `RenormalizedEnergy` is W,
 * not there on a mesh with holes, nor is `PointSingularities` (x, y, z, quarter index of each row of port
 * 1), by which vtkPoincareHopfCheck knows what the field was asked for. `HolonomyDefect` (per inner loop, radians in (−π, π]): where it is not 0
 * the crosses are aligned all the same, but H is multivalued and jumps along a way from the outer loop
 * to the inner one; then there is a warning.
 *
 * An empty domain gives an empty output. Failure, with an empty output: a domain that vtkDrillHoles
 * refuses; a singularity outside of it; quarter indices that violate the Poincaré-Hopf theorem
 * (GetErrorCode() is then vtkCrossFieldErrorCodes::Inconsistent); arrays that are missing or not
 * integer.
 *
 * Paper: "Further thoughts". Differences from it: the logarithms are subtracted; the cross field and
 * the size map, which it leaves open.
 *
 * @sa vtkPerforatedCrossField, vtkSingularityEnergy, crossfield::SolveHField
 */

#ifndef vtkHField_h
#define vtkHField_h

#include "vtkCrossFieldArraySets.h"     // for the values of Arrays
#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory> // for what is kept

class CachedDomain;

class VTKCROSSFIELDFILTERS_EXPORT vtkHField : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkHField* New();
  vtkTypeMacro(vtkHField, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Port 1, the singularities, and port 2, the corners: connections or data objects. */
  vtkCrossFieldPortMacro(Singularities, 1);
  vtkCrossFieldPortMacro(Corners, 2);
  ///@}

  ///@{
  /**
   * Target edge length of the mesh of a domain; 0: 1/40 of the diagonal of the bounding box. A mesh
   * is kept as it is. Default: 0. Range: 0 or more.
   */
  vtkSetClampMacro(MeshSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MeshSize, double);
  ///@}

  ///@{
  /**
   * Meshes and factors a domain once, whatever its singularities, and keeps both until the domain, the mesh size or a singularity on
   * the boundary changes: a moved singularity is then quick. The mesh is not refined at singularities. A mesh is kept in any case. Default: off.
   */
  vtkSetMacro(KeepMesh, bool);
  vtkGetMacro(KeepMesh, bool);
  vtkBooleanMacro(KeepMesh, bool);
  ///@}

  ///@{
  /**
   * Which arrays are written, one of vtkCrossFieldArraySets: Exact, what the other filters need; Display,
   * also what one looks at; All. Default: All.
   */
  vtkSetClampMacro(Arrays, int, vtkCrossFieldArraySets::Exact, vtkCrossFieldArraySets::All);
  vtkGetMacro(Arrays, int);
  void SetArraysToExact() { this->SetArrays(vtkCrossFieldArraySets::Exact); }
  void SetArraysToDisplay() { this->SetArrays(vtkCrossFieldArraySets::Display); }
  void SetArraysToAll() { this->SetArrays(vtkCrossFieldArraySets::All); }
  ///@}

  /**
   * Seconds that the last run spent in meshing, assembling, factoring and solving. Not in the output,
   * so that the same input gives the same output.
   */
  vtkGetVector4Macro(StageSeconds, double);

protected:
  vtkHField();
  ~vtkHField() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHField(const vtkHField&) = delete;
  void operator=(const vtkHField&) = delete;

  double MeshSize = 0.0;
  bool KeepMesh = false;
  std::unique_ptr<CachedDomain> Kept;
  int Arrays = vtkCrossFieldArraySets::All;
  double StageSeconds[4] = { 0.0, 0.0, 0.0, 0.0 };
};

#endif
