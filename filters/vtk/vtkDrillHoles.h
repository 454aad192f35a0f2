/**
 * @class   vtkDrillHoles
 * @brief   triangulate a planar domain with a small hole at every singularity
 *
 * Computes the perforated domain G_ρ = G \ ∪ B(b_i, ρ_i): a graded constrained Delaunay
 * triangulation in which every singularity is a hole, a regular polygon with its vertices on the
 * circle of radius ρ_i around b_i.
 *
 * Input port 0 (vtkPolyData or vtkUnstructuredGrid): the domain. It is given either as boundary
 * loops, closed polylines or 2-point lines in any order and orientation, or as a surface mesh whose
 * boundary is extracted and remeshed. All points must be in one plane of space. Points that no cell
 * uses and vertex cells are ignored; if there are surface cells, lines are ignored as well.
 *
 * Planes: all computations use coordinates of the domain's plane: (x, y) if z is constant, (y, z)
 * if x is, (x, z) if y is. A tilted plane has the coordinates of the nearest of these three,
 * rotated into it by the shortest rotation. Points and directions of all outputs are in the plane,
 * and the other filters recover the same coordinates. Coordinates in messages are those of the
 * plane.
 *
 * Input port 1: the singularities (points), in the plane of the domain to within 1/1000 of its
 * size; z is ignored if that plane is z = const. Point arrays: `QuarterIndex` (any numeric type,
 * integer values, 1 component) and optionally `Radius` (1 component, a length). Without radii every
 * hole has the mesh size as its radius, or less if it would not fit.
 *
 * Output port 0 (vtkUnstructuredGrid): VTK_TRIANGLE cells, counter-clockwise and ordered along a
 * Hilbert curve, then a VTK_LINE cell for every boundary edge, directed so that the domain is on
 * its left. Cell arrays (int, 1 component):
 * - `BoundaryKind`: 0 triangle, 1 outer loop, 2 inner loop, 3 hole, 4 imprinted circle or triangle;
 * - `BoundaryId`: −1 for triangles; the loop number for kinds 1 (always 0) and 2 (1, 2, …); the row
 *   of the singularity for kinds 3 and 4;
 * - `QuarterIndex`: the prescribed index for kinds 3 and 4, else 0.
 * Field data `BoundarySingularities`, if there are any: (x, y, z, quarter index) of the
 * singularities on the boundary, to within 1e-6 of the diagonal. They get a vertex and no hole;
 * vtkPerforatedCrossField uses their index at that vertex instead of the index of the corner.
 *
 * Lines of kind 4 are inside the domain, with the outside of the circle on their left.
 *
 * The edge length is MeshSize, graded down to the spacing of the boundary and to the edges of the
 * holes. No angle is below 20.7° unless the boundary has sharper corners.
 *
 * @warning The segments of the boundary are used as they are. Where they approximate a curve and
 * are longer than the mesh size, the field follows each of them and its energy increases. Sample
 * curves at the mesh size.
 *
 * An empty domain gives an empty output. The filter fails, with an empty output, in these cases: a
 * curve is open, branches, or crosses or touches itself; there are several outer loops; the
 * boundary is not planar; a singularity is not in the plane; a hole is outside the domain, cuts its
 * boundary or overlaps another hole; a radius or the mesh size is not positive; a number is not
 * finite; a quarter index is not an integer. ModeTriangle also fails if a quarter index is not ±1,
 * if a triangle is at the boundary, or if two triangles share an edge.
 *
 * Paper: "Singularity placements via perforation strategy". Difference from the paper: the mesh is
 * generated here, not by Gmsh.
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

  /** Representation of the singularities in the mesh. */
  enum
  {
    ModePerforate = 0,
    ModeImprint = 1,
    ModeTriangle = 2
  };

  ///@{
  /**
   * Selects how singularities appear in the mesh: as holes (Perforate); as imprinted circles whose
   * inside is meshed (Imprint); or as the three edges of the triangle that contains the point,
   * which is kept and supports quarter indices 1 and −1 only (Triangle). Default: ModePerforate.
   */
  vtkSetClampMacro(Mode, int, ModePerforate, ModeTriangle);
  vtkGetMacro(Mode, int);
  void SetModeToPerforate() { this->SetMode(ModePerforate); }
  void SetModeToImprint() { this->SetMode(ModeImprint); }
  void SetModeToTriangle() { this->SetMode(ModeTriangle); }
  ///@}

  ///@{
  /**
   * Sets the target edge length, in the units of the domain. Default: 0, 1/40 of the diagonal of
   * the bounding box.
   */
  vtkSetMacro(MeshSize, double);
  vtkGetMacro(MeshSize, double);
  ///@}

  ///@{
  /**
   * Sets the minimum number of edges of a hole. A hole of quarter index k has at least 8 |k| edges,
   * none longer than the mesh size. Default: 32. Range: 3 or more.
   */
  vtkSetClampMacro(MinimumHoleEdges, int, 3, VTK_INT_MAX);
  vtkGetMacro(MinimumHoleEdges, int);
  ///@}

  ///@{
  /**
   * Sets the maximum growth of the edge length per unit of distance from fine boundaries and holes.
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
