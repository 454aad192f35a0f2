/**
 * @class   vtkCrossFieldSingularities
 * @brief   find the singularities of a cross field
 *
 * Computes the quarter index of every triangle and vertex of a Crouzeix-Raviart cross field from
 * the rotation of u = e^{4iθ} between neighbouring midpoints of edges. Adjacent singular triangles
 * and vertices count as one singularity whose quarter index is their sum; where they cancel there
 * is none.
 *
 * Input port 0 (vtkUnstructuredGrid): a field of vtkPerforatedCrossField,
 * vtkGinzburgLandauCrossField or another filter of this module, with the cell arrays of
 * vtkDrillHoles and `CrossFieldCR`.
 *
 * Triangles that are in no plane are a surface in space with the cell array `Cross` (3 components, along one direction of the cross),
 * such as the output of vtkHField. The singularities are at its vertices.
 *
 * Output port 0 (vtkPolyData): one vertex for every singularity. Point arrays, 1 component:
 * - `QuarterIndex` (int, not 0): the number of turns of u around the point;
 * - `BoundaryKind` (int): 0 inside, 1 on the outer loop, 2 on an inner loop (a singularity that has
 *   moved into the boundary, or a corner), 3 a hole of the mesh;
 * - `BoundaryId` (int): loop number for kinds 1 and 2, row of the singularity for holes, −1 inside;
 * - `Radius` (double, only with IncludeHoles): radius of a hole, 0 for all others.
 *
 * Interior singularities come first, then those of kinds 1, 2 and 3, each group sorted by x and y.
 * For indices ±1 the position is the zero of the field, if it has one; otherwise it is the weighted
 * centre of the singular triangles and vertices. It is accurate to about one triangle. Two
 * singularities within about two triangles of each other may be found as one.
 *
 * Without IncludeCorners and IncludeHoles the output can be the singularities of vtkDrillHoles,
 * unless one of them has moved into the boundary.
 *
 * An empty input gives an empty output. The filter fails, with an empty output, if an array is
 * missing, if values are not finite, or if the indices inside, on the boundary and on holes do not
 * add up to 4χ because the field is not aligned with the boundary of its mesh.
 *
 * @sa vtkGinzburgLandauCrossField, vtkPoincareHopfCheck, crossfield::FindFieldSingularities
 */

#ifndef vtkCrossFieldSingularities_h
#define vtkCrossFieldSingularities_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VTKCROSSFIELDFILTERS_EXPORT vtkCrossFieldSingularities : public vtkPolyDataAlgorithm
{
public:
  static vtkCrossFieldSingularities* New();
  vtkTypeMacro(vtkCrossFieldSingularities, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Includes the corners of the boundary at which the field has a quarter index other than 0.
   * Default: off.
   */
  vtkSetMacro(IncludeCorners, bool);
  vtkGetMacro(IncludeCorners, bool);
  vtkBooleanMacro(IncludeCorners, bool);
  ///@}

  ///@{
  /**
   * Includes the holes of the mesh on which the field has a degree other than 0, at their centres.
   * Default: off.
   */
  vtkSetMacro(IncludeHoles, bool);
  vtkGetMacro(IncludeHoles, bool);
  vtkBooleanMacro(IncludeHoles, bool);
  ///@}

  ///@{
  /**
   * Sets the turning angle, in degrees, above which a boundary vertex is a corner. Other vertices
   * are samples of a curve. Default: 30. Range: 1 to 45.
   */
  vtkSetClampMacro(CornerAngle, double, 1.0, 45.0);
  vtkGetMacro(CornerAngle, double);
  ///@}

protected:
  vtkCrossFieldSingularities();
  ~vtkCrossFieldSingularities() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCrossFieldSingularities(const vtkCrossFieldSingularities&) = delete;
  void operator=(const vtkCrossFieldSingularities&) = delete;

  bool IncludeCorners = false;
  bool IncludeHoles = false;
  double CornerAngle = 30.0;
};

#endif
