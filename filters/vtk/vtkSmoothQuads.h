/**
 * @class   vtkSmoothQuads
 * @brief   smooths any quad mesh in a plane or on a surface
 *
 * Moves the points of a quad mesh from any program and keeps its cells. Quads come near to right angles
 * and to the size that they have, or to equal sizes, and inverted quads are repaired where possible
 * (docs/method.md, section 14.5). Points of the boundary slide along the polyline of its edges, except
 * for corners, or all of them stay.
 *
 * Input port 0 (vtkPolyData or vtkUnstructuredGrid): VTK_QUAD cells, without a surface in one plane; vertices and lines
 * are allowed. Points that no quad has stay, and so does the order of points in cells. Input port 1 (vtkDataSet),
 * optional: surface cells, one connected part, that the points are moved to and stay on (section 22.8).
 *
 * Output (type of the input): the input with other points, in double precision, and
 * - cell array `ScaledJacobian` (double): minimum over the corners of the sine of the angle, in [−1, 1];
 *   1 in other cells;
 * - field data `ScaledJacobianRange` (double, minimum, mean and maximum), `ScaledJacobianRangeBefore` (the
 *   same of the input) and `Inverted` (int, quads that are not positive).
 *
 * The number of inverted quads never increases, and without UniformSizes the minimum does not decrease if
 * no quad of the input is inverted. Inverted quads are a warning. The filter fails, with an empty output, if there are other cells or no quads, the points are in no plane, a quad has a point
 * twice, an edge has more than two quads, the boundary touches itself in a point, or the surface is not a manifold or has
 * several parts.
 *
 * @sa vtkQuadMesher, crossfield::SmoothMesh
 */

#ifndef vtkSmoothQuads_h
#define vtkSmoothQuads_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkPointSetAlgorithm.h"

class VTKCROSSFIELDFILTERS_EXPORT vtkSmoothQuads : public vtkPointSetAlgorithm
{
public:
  static vtkSmoothQuads* New();
  vtkTypeMacro(vtkSmoothQuads, vtkPointSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Connects port 1, the surface, or sets it to a data object. */
  vtkCrossFieldPortMacro(Surface, 1);
  ///@}

  ///@{
  /** Lets points of the boundary slide along its edges; otherwise they stay. Default: on. */
  vtkSetMacro(SlideOnBoundary, bool);
  vtkGetMacro(SlideOnBoundary, bool);
  vtkBooleanMacro(SlideOnBoundary, bool);
  ///@}

  ///@{
  /** Sets the turning angle of the boundary, in degrees, above which a point is a corner and stays.
   * Default: 30. Range: 1 to 45. */
  vtkSetClampMacro(CornerAngle, double, 1.0, 45.0);
  vtkGetMacro(CornerAngle, double);
  ///@}

  ///@{
  /** Makes sizes as equal as shapes allow; otherwise quads keep their sizes. Default: off. */
  vtkSetMacro(UniformSizes, bool);
  vtkGetMacro(UniformSizes, bool);
  vtkBooleanMacro(UniformSizes, bool);
  ///@}

protected:
  vtkSmoothQuads();
  ~vtkSmoothQuads() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSmoothQuads(const vtkSmoothQuads&) = delete;
  void operator=(const vtkSmoothQuads&) = delete;

  bool SlideOnBoundary = true;
  double CornerAngle = 30.0;
  bool UniformSizes = false;
};

#endif
