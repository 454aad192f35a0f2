/**
 * @class   vtkDrillHoles
 * @brief   triangulate a planar domain with a small hole at every singularity
 *
 * Computes the perforated domain G_ρ = G \ ∪ B(b_i, ρ_i): a graded constrained Delaunay
 * triangulation in which every singularity is a regular polygon with its vertices on the circle of
 * radius ρ_i around b_i, and a hole of the mesh.
 *
 * Port 0, the domain (vtkPolyData or vtkUnstructuredGrid): either boundary loops, closed polylines
 * or 2-point lines in any order and orientation, or a surface mesh whose boundary is taken and
 * remeshed. All points in one plane of space. Points that no cell uses and vertex cells are ignored,
 * and so are lines when there are surface cells.
 *
 * Planes: computations are done in coordinates of the domain's plane, (x, y) if z is constant,
 * (y, z) if x is, (x, z) if y is; in a tilted plane in those of the nearest of these three, turned
 * into it by the shortest rotation. Points and directions of all outputs lie in the plane, and the
 * other filters find the same coordinates again. Coordinates in messages are those of the plane.
 *
 * Port 1, the singularities (points): in the plane of the domain, within 1/1000 of its size; z is
 * ignored if that plane is z = const. Point arrays `QuarterIndex` (any numeric type, integer values,
 * 1 component) and optionally `Radius` (1 component, a length; without it every hole has the
 * mesh size as radius, or less to fit).
 *
 * Output (vtkUnstructuredGrid): VTK_TRIANGLE cells, counter-clockwise and along Hilbert's curve, then a VTK_LINE cell for
 * every boundary edge, directed so that the domain is on its left. Cell arrays (int, 1 component):
 * - `BoundaryKind`: 0 triangle, 1 outer loop, 2 inner loop, 3 hole, 4 imprinted circle or triangle;
 * - `BoundaryId`: −1 on triangles; loop number on kinds 1 (always 0) and 2 (1, 2, …); on kinds 3 and
 *   4 the row of the singularity;
 * - `QuarterIndex`: prescribed index on kinds 3 and 4, else 0.
 * Field data `BoundarySingularities`, where there are any: (x, y, z, quarter index) of the singularities on
 * the boundary, within 1e-6 of the diagonal. They get a vertex and no hole; vtkPerforatedCrossField gives the
 * vertex this index instead of that of the corner.
 *
 * Lines of kind 4 lie inside the domain, and the outside of the circle is on their left.
 *
 * The edge length is MeshSize, graded down to the boundary's own spacing and to the edges of the
 * holes. No angle is below 20.7° except where the boundary has sharper corners.
 *
 * @warning The segments of the boundary are taken as they are: where they stand for a curve and are
 * longer than the mesh size, the field follows every one of them and its energy rises. Sample curves
 * at the mesh size.
 *
 * An empty domain gives an empty output. Failure, with an empty output: a curve that is open,
 * branches, crosses or touches itself; several outer loops; a boundary that is not in one plane; a
 * singularity that is not in it; a hole outside the domain, cutting its boundary or overlapping
 * another; a radius or mesh size that is not positive; numbers that are not finite; a quarter index
 * that is not an integer. ModeTriangle: a quarter index other than ±1, a triangle at the boundary, two
 * triangles that share an edge.
 *
 * Paper: "Singularity placements via perforation strategy". Difference from it: the mesh is made
 * here, not by Gmsh.
 *
 * @sa vtkPlanarDomainSource, vtkSingularitySource, vtkPerforatedCrossField, crossfield::DrillHoles
 */

#ifndef vtkDrillHoles_h
#define vtkDrillHoles_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkUnstructuredGridAlgorithm.h"

class VTKCROSSFIELDFILTERS_EXPORT vtkDrillHoles : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkDrillHoles* New();
  vtkTypeMacro(vtkDrillHoles, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Connects port 1, the singularities, or sets it to a data object. */
  vtkCrossFieldPortMacro(Singularities, 1);
  ///@}

  /** What becomes of the singularities. */
  enum
  {
    ModePerforate = 0,
    ModeImprint = 1,
    ModeTriangle = 2
  };

  ///@{
  /**
   * Holes; circles imprinted in the mesh, with their inside kept; or the three edges of the one
   * triangle that contains the point, which is kept as well and carries quarter indices 1 and −1
   * only. Default: ModePerforate.
   */
  vtkSetClampMacro(Mode, int, ModePerforate, ModeTriangle);
  vtkGetMacro(Mode, int);
  void SetModeToPerforate() { this->SetMode(ModePerforate); }
  void SetModeToImprint() { this->SetMode(ModeImprint); }
  void SetModeToTriangle() { this->SetMode(ModeTriangle); }
  ///@}

  ///@{
  /**
   * Target edge length, in the units of the domain. Default: 0, which means 1/40 of the diagonal of
   * the domain's bounding box.
   */
  vtkSetMacro(MeshSize, double);
  vtkGetMacro(MeshSize, double);
  ///@}

  ///@{
  /**
   * Fewest edges of a hole; a hole of quarter index k gets at least 8 |k|, and no edge longer than
   * the mesh size. Default: 32. Range: at least 3.
   */
  vtkSetClampMacro(MinimumHoleEdges, int, 3, VTK_INT_MAX);
  vtkGetMacro(MinimumHoleEdges, int);
  ///@}

  ///@{
  /**
   * Largest growth of the edge length per unit of distance, away from fine boundaries and holes.
   * Default: 0.25. Range: 0.01 to 1.
   */
  vtkSetClampMacro(Gradation, double, 0.01, 1.0);
  vtkGetMacro(Gradation, double);
  ///@}

protected:
  vtkDrillHoles();
  ~vtkDrillHoles() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkDrillHoles(const vtkDrillHoles&) = delete;
  void operator=(const vtkDrillHoles&) = delete;

  int Mode = ModePerforate;
  double MeshSize = 0.0;
  int MinimumHoleEdges = 32;
  double Gradation = 0.25;
};

#endif
