/**
 * @class   vtkHField
 * @brief   compute the scalar H of singularities inside and on the boundary, its size map and cross
 * field
 *
 * H is the real part of the analytic function H + iθ, where θ is the angle of the cross (mod π/2):
 *   ΔH = 2π Σ_j (k_j / 4) δ_{b_j} inside, ∂H/∂ν = curvature − Σ_c (k_c π/2) δ_{p_c} on the boundary,
 * for singularities of quarter indices k_j at b_j inside and k_c at boundary points p_c. Up to a
 * factor, e^H is the local edge length of quads that follow the crosses. The logarithms of the
 * singularities are subtracted analytically. The remainder is smooth and is computed with
 * continuous piecewise linear functions from one linear system. The cross follows from ∇θ = rot ∇H
 * by summation along edges, without cuts and without iterations.
 *
 * Input port 0 (vtkPolyData or vtkUnstructuredGrid): the domain, as for vtkDrillHoles, which is
 * meshed without holes; or a mesh made by vtkDrillHoles, which is used as it is. On a mesh with
 * holes the singularities are its holes, on which H is constant, and the cross is that of
 * vtkPerforatedCrossField (UnitNorm).
 * Input port 1, optional: singularities (points) with the point arrays `QuarterIndex` (integers)
 * and optionally `Radius`, inside or on the boundary. A singularity within 1e-6 of the diagonal of
 * a boundary vertex is at that vertex; elsewhere on the boundary of a domain a vertex is inserted.
 * On a mesh with holes the singularities must be those of the holes or be on the boundary.
 * Input port 2, optional: corners (points) with `QuarterIndex` (integers), as for
 * vtkPerforatedCrossField. All other corners have the index of the smallest rotation of the cross.
 * If the sum of quarter indices is then wrong, they have the indices of vtkBoundaryCornerClassifier
 * with the given ones fixed.
 *
 * A surface in space on port 0, connected, is used with its triangles: singularities are moved to vertices, and H is computed without
 * logarithms. The output has `H`, `SizeMap`, `Cross` and `Cross2` (cells), and the field data `HolonomyDefect` (of inner loops, then
 * two for each handle), `Converged` and `UnwantedSingularities`; energies are for planes.
 *
 * Output port 0 (vtkUnstructuredGrid): the mesh, with the arrays of vtkDrillHoles if it was made
 * here, and
 * - `H` (points, double, 1), with area mean 0. At a singular point, where H is infinite, the value
 *   is the mean over a disk whose radius is half of the shortest edge there;
 * - `SizeMap` (points, float, 1): e^H, which is larger where the lines of the field diverge; up to
 *   a factor the local edge length of quads;
 * - the arrays of vtkPerforatedCrossField: `CrossFieldCR` (cells, 6), `Representation`, `Cross`,
 *   `Cross2` (cells and points, 3), `CrossNorm` (cells and points, 1; |u| = 1 at the midpoints of
 *   edges).
 * `H` and `CrossFieldCR` are exact. The others are computed from them in single precision and can
 * be omitted; see Arrays.
 *
 * Field data: as for vtkPerforatedCrossField, with `Iterations` 0, and
 * - `Energy`: on a mesh with holes ½ ∫ |∇φ|² of the phase φ = 4θ. Without holes this is infinite,
 *   and Energy is its expansion Σ_j π k_j² log(1/ρ_j) + W for holes of the given radii (1/40 of the
 *   diagonal if not given);
 * - `RenormalizedEnergy`: W; absent on a mesh with holes;
 * - `PointSingularities` (x, y, z, quarter index of each row of port 1), which lets
 *   vtkPoincareHopfCheck compare the field with the prescribed singularities; absent on a mesh with
 *   holes;
 * - `HolonomyDefect` (for each inner loop, radians in (−π, π]). Where it is not 0 the crosses are
 *   still aligned, but H is multivalued and jumps along a path from the outer loop to the inner
 *   loop; the filter then warns.
 *
 * An empty domain gives an empty output. The filter fails, with an empty output, if vtkDrillHoles
 * would refuse the domain, if a singularity is outside the domain, if the quarter indices violate
 * the Poincaré-Hopf theorem (GetErrorCode() is then vtkCrossFieldErrorCodes::Inconsistent), or if
 * arrays are missing or not integer.
 *
 * Paper: "Further thoughts". Differences from the paper: the logarithms are subtracted; the paper
 * leaves the cross field and the size map open.
 *
 * @sa vtkPerforatedCrossField, vtkSingularityEnergy, crossfield::SolveHField
 */

#ifndef vtkHField_h
#define vtkHField_h

#include "vtkCrossFieldArraySets.h"     // for the values of Arrays
#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory> // for the cached domain

class CachedDomain;

class VTKCROSSFIELDFILTERS_EXPORT vtkHField : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkHField* New();
  vtkTypeMacro(vtkHField, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Connects port 1, the singularities, or port 2, the corners, or sets it to a data object. */
  vtkCrossFieldPortMacro(Singularities, 1);
  vtkCrossFieldPortMacro(Corners, 2);
  ///@}

  ///@{
  /**
   * Sets the target edge length of the mesh of a domain; a given mesh is not changed. Default: 0,
   * 1/40 of the diagonal of the bounding box. Range: 0 or more.
   */
  vtkSetClampMacro(MeshSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MeshSize, double);
  ///@}

  ///@{
  /**
   * Meshes and factors a domain only once and reuses both until the domain, the mesh size or a
   * singularity on the boundary changes, so that an update after moving a singularity is fast. The
   * mesh is then not refined at singularities. No effect on a given mesh. Default: off.
   */
  vtkSetMacro(KeepMesh, bool);
  vtkGetMacro(KeepMesh, bool);
  vtkBooleanMacro(KeepMesh, bool);
  ///@}

  ///@{
  /**
   * Selects the arrays of the output by a value of vtkCrossFieldArraySets: Exact (those that other
   * filters need), Display (also those for viewing) or All. Default: All.
   */
  vtkSetClampMacro(Arrays, int, vtkCrossFieldArraySets::Exact, vtkCrossFieldArraySets::All);
  vtkGetMacro(Arrays, int);
  void SetArraysToExact() { this->SetArrays(vtkCrossFieldArraySets::Exact); }
  void SetArraysToDisplay() { this->SetArrays(vtkCrossFieldArraySets::Display); }
  void SetArraysToAll() { this->SetArrays(vtkCrossFieldArraySets::All); }
  ///@}

  /**
   * Returns the seconds that the last run spent in meshing, assembling, factoring and solving. They
   * are not part of the output, so that equal inputs give equal outputs.
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
  std::unique_ptr<CachedDomain> Cache;
  int Arrays = vtkCrossFieldArraySets::All;
  double StageSeconds[4] = { 0.0, 0.0, 0.0, 0.0 };
};

#endif
