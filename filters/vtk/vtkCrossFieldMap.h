/**
 * @class   vtkCrossFieldMap
 * @brief   flat coordinates (u, v) along the crosses of chosen singularities
 *
 * With H + iθ of vtkHField, dw = e^{−(H + iθ)} dz is closed: w = u + iv maps the domain to a flat surface on
 * which crosses are along the axes and the sides of the boundary are straight. A singularity of quarter index
 * k is a cone of angle (4 − k) π/2 there, a corner one of (2 − k) π/2. w is solved for with continuous
 * piecewise linear functions on the mesh cut along seams, from every singularity to the boundary and between boundary
 * loops; across a seam w changes by quarter turns and a translation, exactly. The area of the map is that
 * of the domain.
 *
 * Port 0, the domain (vtkPolyData or vtkUnstructuredGrid): as for vtkHField, meshed here with a vertex on every
 * singularity; or a mesh of vtkDrillHoles without holes that has one, which is kept.
 * Port 1, optional, singularities (points), and port 2, optional, corners: as for vtkHField.
 *
 * Output: triangles, then boundary lines, with points doubled along the seams, and
 * - `UV` (points, double, 2);
 * - `VertexId` (points, int): copies of one vertex have the same;
 * - `QuarterIndex` (points, int): of singularities and corners, else 0; `Cone` (points, int): their number,
 *   singularities in the order of port 1 before corners, else −1;
 * - `Seam` (cells, int, 3): per side p0p1, p1p2, p2p0 of a triangle 0, or ±(i + 1) where seam i leads to the neighbour;
 *   minus: against its direction;
 * - `Direction` (cells, int): of boundary lines in the chart of their triangle, i^Direction; −1 of triangles;
 * - `BoundaryKind`, `BoundaryId` (cells): as for vtkDrillHoles.
 *
 * Field data: `SeamRotation` r and `SeamTranslation` (2) t per seam, w' = i^r w + t; `ConeRow` (row of port 1 per
 * singularity, −1 per corner); `Flips` (0: any would be an error); `MapResidual`, √(∫ e^{2H} |∇w − e^{−(H+iθ)}|² / area);
 * `HolonomyDefect` (per inner loop, radians of the phase): where it is not 0, the map exists but is not conformal.
 *
 * An empty domain gives an empty output. Failure, with an empty output: as for vtkHField; a singularity of quarter
 * index 3 or more, or at no vertex; a corner of index 2 or more unless CapCorners; a map that folds over, which large
 * holonomy defects or very coarse meshes make, with the place.
 *
 * Paper: "Further thoughts" leaves the map open.
 *
 * @sa vtkHField, vtkSeparatrices, crossfield::SolveSeamlessMap
 */

#ifndef vtkCrossFieldMap_h
#define vtkCrossFieldMap_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory> // for what is kept

class CachedDomain;

class VTKCROSSFIELDFILTERS_EXPORT vtkCrossFieldMap : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkCrossFieldMap* New();
  vtkTypeMacro(vtkCrossFieldMap, vtkUnstructuredGridAlgorithm);
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
   * the boundary changes: a moved singularity is then quick. The map factors once more, on the mesh with vertices at the singularities. A mesh is kept in any case. Default: off.
   */
  vtkSetMacro(KeepMesh, bool);
  vtkGetMacro(KeepMesh, bool);
  vtkBooleanMacro(KeepMesh, bool);
  ///@}

  ///@{
  /**
   * Sharp corners whose smallest rotation has quarter index 2 get 1; what is missing must be among the
   * singularities. Default: off.
   */
  vtkSetMacro(CapCorners, bool);
  vtkGetMacro(CapCorners, bool);
  vtkBooleanMacro(CapCorners, bool);
  ///@}

  ///@{
  /**
   * Moves the singularities inside the least way to where no inner loop has a holonomy defect, where a size is
   * single-valued. Field data then has `RepairDistance`, the longest way of one, `RepairedPositions` (3), where they
   * are, and `DefectBefore`. Not for meshes that are given. Default: off.
   */
  vtkSetMacro(RepairHolonomy, bool);
  vtkGetMacro(RepairHolonomy, bool);
  vtkBooleanMacro(RepairHolonomy, bool);
  ///@}

  /** Seconds that the last run spent in meshing and in the map. Not in the output. */
  vtkGetVector2Macro(StageSeconds, double);

protected:
  vtkCrossFieldMap();
  ~vtkCrossFieldMap() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCrossFieldMap(const vtkCrossFieldMap&) = delete;
  void operator=(const vtkCrossFieldMap&) = delete;

  double MeshSize = 0.0;
  bool KeepMesh = false;
  std::unique_ptr<CachedDomain> Kept;
  bool CapCorners = false;
  bool RepairHolonomy = false;
  double StageSeconds[2] = { 0.0, 0.0 };
};

#endif
