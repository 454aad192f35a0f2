/**
 * @class   vtkCrossFieldMap
 * @brief   seamless map (u, v) that flattens the cross field of given singularities
 *
 * With H + iθ of vtkHField, dw = e^{−(H + iθ)} dz is closed: w = u + iv maps the domain to a flat
 * surface on which crosses are parallel to the axes and the sides of the boundary are straight. On
 * this surface a singularity of quarter index k is a cone of angle (4 − k) π/2, and a corner one of
 * (2 − k) π/2. The filter solves for w with continuous piecewise linear functions on the mesh cut
 * along seams, which lead from every singularity to the boundary and connect the boundary loops.
 * Across a seam w changes by quarter turns and a translation, exactly. The area of the map equals
 * the area of the domain.
 *
 * Input port 0 (vtkPolyData or vtkUnstructuredGrid): the domain, as for vtkHField, which is meshed
 * with a vertex at every singularity; or a mesh of vtkDrillHoles without holes that has such
 * vertices, which is used as it is. Input port 1, optional: singularities (points), and input port
 * 2, optional: corners (points), both as for vtkHField.
 *
 * Output port 0 (vtkUnstructuredGrid): triangles, then boundary lines, with points duplicated along
 * the seams. Arrays:
 * - `UV` (points, double, 2): the coordinates (u, v);
 * - `VertexId` (points, int): the vertex of the mesh; copies of one vertex have the same value;
 * - `QuarterIndex` (points, int): the index at singularities and corners, elsewhere 0;
 * - `Cone` (points, int): the number of the cone, singularities in the order of port 1 before
 *   corners; elsewhere −1;
 * - `Seam` (cells, int, 3): for the sides p0p1, p1p2, p2p0 of a triangle, 0 or ±(i + 1) where
 *   crossing seam i leads to the neighbour; the sign is negative against the direction of the seam;
 * - `Direction` (cells, int): for boundary lines the direction i^Direction in the chart of their
 *   triangle; −1 for triangles;
 * - `BoundaryKind`, `BoundaryId` (cells, int): as for vtkDrillHoles.
 *
 * Field data: `SeamRotation` r and `SeamTranslation` t (2 components) for each seam, w' = i^r w +
 * t; `ConeRow` (row of port 1 for each singularity, −1 for each corner); `Flips` (0, since a
 * flipped triangle is an error); `MapResidual`, √(∫ e^{2H} |∇w − e^{−(H+iθ)}|² / area);
 * `HolonomyDefect` (for each inner loop, radians of the phase). Where a defect is not 0 the map
 * exists but is not conformal. If the nearest map to the crosses folds over, the output is the layout
 * of a flat metric, its triangles may be others than those of the mesh, and the field data have
 * `PredictedStretch`, the ratio of its singular values to first order, and `StretchReason`, a
 * sentence.
 *
 * An empty domain gives an empty output. The filter fails, with an empty output, where vtkHField
 * does; if a singularity has quarter index 3 or more, or is at no vertex of a given mesh; if a
 * corner has index 2 or more and CapCorners is off; and if every map folds over, as with very coarse
 * meshes or few singularities that only a large stretch could align. The message states where.
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

#include <memory> // for the cached domain

class CachedDomain;

class VTKCROSSFIELDFILTERS_EXPORT vtkCrossFieldMap : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkCrossFieldMap* New();
  vtkTypeMacro(vtkCrossFieldMap, vtkUnstructuredGridAlgorithm);
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
   * map needs one more factorisation, on the mesh with vertices at the singularities. No effect on
   * a given mesh. Default: off.
   */
  vtkSetMacro(KeepMesh, bool);
  vtkGetMacro(KeepMesh, bool);
  vtkBooleanMacro(KeepMesh, bool);
  ///@}

  ///@{
  /**
   * Treats sharp corners whose smallest rotation has quarter index 2 as corners of index 1. The
   * singularities must make up for the difference. Default: off.
   */
  vtkSetMacro(CapCorners, bool);
  vtkGetMacro(CapCorners, bool);
  vtkBooleanMacro(CapCorners, bool);
  ///@}

  ///@{
  /**
   * Moves the interior singularities by the minimum distance that removes the holonomy defects of
   * all inner loops, so that sizes are single-valued. Field data then has `RepairDistance`, the
   * maximum displacement, `RepairedPositions` (3 components), the new positions, and
   * `DefectBefore`. Not available for given meshes. Default: off.
   */
  vtkSetMacro(RepairHolonomy, bool);
  vtkGetMacro(RepairHolonomy, bool);
  vtkBooleanMacro(RepairHolonomy, bool);
  ///@}

  /**
   * Returns the seconds that the last run spent in meshing and in computing the map. They are not
   * part of the output.
   */
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
  std::unique_ptr<CachedDomain> Cache;
  bool CapCorners = false;
  bool RepairHolonomy = false;
  double StageSeconds[2] = { 0.0, 0.0 };
};

#endif
