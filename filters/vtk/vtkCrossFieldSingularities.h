/**
 * @class   vtkCrossFieldSingularities
 * @brief   the places where a cross field is singular
 *
 * Reads the quarter index of every triangle and vertex of a Crouzeix-Raviart cross field from the
 * turns of u = e^{4iθ} between neighbouring midpoints of edges. What is singular and next to each
 * other is one singularity: its quarter index is the sum, and neighbours that cancel are none.
 *
 * Port 0, a field of vtkPerforatedCrossField, vtkGinzburgLandauCrossField or another filter of this
 * module (vtkUnstructuredGrid with the cell arrays of vtkDrillHoles and `CrossFieldCR`).
 *
 * Output (vtkPolyData): one vertex for every singularity. Point arrays, 1 component:
 * - `QuarterIndex` (int, not 0): u turns so often around the point;
 * - `BoundaryKind` (int): 0 inside, 1 on the outer loop, 2 on an inner loop (a singularity that has
 *   moved into the boundary, or a corner), 3 a hole of the mesh;
 * - `BoundaryId` (int): loop number on kinds 1 and 2, row of the singularity on holes, −1 inside;
 * - `Radius` (double, only with IncludeHoles): of the hole, 0 for all others.
 *
 * Singularities inside come first, then those of kinds 1, 2 and 3, each sorted by x and y. The
 * position is the zero of the field for indices ±1 where there is one, else the weighted middle of
 * the singular triangles and vertices: within about one triangle. Two singularities within about
 * two triangles of each other may be read as one.
 *
 * Without IncludeCorners and IncludeHoles the output can be given to vtkDrillHoles as its
 * singularities, unless one has moved into the boundary.
 *
 * An empty input gives an empty output. Failure, with an empty output: a missing array; values that
 * are not finite; indices inside, on the boundary and on holes that do not add up to 4χ, because
 * the field is not aligned with the boundary of its mesh.
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
   * Whether corners of the boundary are reported, with the quarter index that the field takes there
   * if it is not 0. Default: off.
   */
  vtkSetMacro(IncludeCorners, bool);
  vtkGetMacro(IncludeCorners, bool);
  vtkBooleanMacro(IncludeCorners, bool);
  ///@}

  ///@{
  /**
   * Whether holes of the mesh are reported, at their centres, with the degree of the field on them
   * if it is not 0. Default: off.
   */
  vtkSetMacro(IncludeHoles, bool);
  vtkGetMacro(IncludeHoles, bool);
  vtkBooleanMacro(IncludeHoles, bool);
  ///@}

  ///@{
  /**
   * A boundary vertex that turns by more is a corner, others stand for a curve; degrees. Default:
   * 30. Range: 1 to 45.
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
