/**
 * @class   vtkQuadsToHigherOrder
 * @brief   quads of order 2 or 3 whose boundary edges follow the curves of the boundary
 *
 * The nodes inside a boundary edge are the points of its curve nearest to equal steps along the
 * edge; edges without a curve, and edges inside, are straight. Nodes inside a quad follow by transfinite
 * interpolation. Where that leaves det J, at one of the (order + 1)² Gauss points, below half of its
 * minimum in the straight quad, as in thin boundary layers, edges of further rows are curved as well.
 *
 * Input port 0 (vtkUnstructuredGrid): VTK_QUAD and VTK_LINE cells, without a surface in a plane: quads with their boundary
 * edges, as in the .vtu files of `crossfield quads` and vtkQuadMesher::CopyMesh, or output 0 of
 * vtkQuadMesher. Cell array `Side` (string) of the lines; cell array `Curve` of the lines and field data `CurveKind`, `CurveOffset` and
 * `CurveValues`: the curves (docs/curves.md); without them, the edges are straight. Input port 1,
 * optional: the boundary edges, output 5 of vtkQuadMesher, if port 0 has no lines; without a connection,
 * those of the vtkQuadMesher upstream whose points and cells port 0 has.
 *
 * Output port 0 (vtkUnstructuredGrid): VTK_BIQUADRATIC_QUAD or VTK_LAGRANGE_QUADRILATERAL cells
 * and VTK_QUADRATIC_EDGE or VTK_LAGRANGE_CURVE cells in the order of the input's cells, with their
 * cell arrays. The points of the input come first. Point arrays of numbers that are not integers
 * are interpolated; of the others, new points have `Valence` (number of quads), `BoundarySide` (as for
 * vtkQuadMesher), and otherwise 0. Further
 * - cell array `JacobianRatio` (double): minimum over maximum of det J at the Gauss points, 1 on lines;
 * - field data `Order` (int), `JacobianRatioMin` (double, minimum of that array), `CurvedInverted` (int,
 *   quads with det J ≤ 0 at a Gauss point), `CurvedRows` (int, the largest number of rows whose edges
 *   are curved) and `CurveSagitta` (double, per curve: largest distance of a node from the straight
 *   edge).
 *
 * Input port 2 (vtkDataSet), optional: surface cells, one connected part, in no plane (others are ignored): then
 * the quads may be in space, all nodes are points of the surface, those of its boundary and of sharp edges on these (docs/method.md, section
 * 22.10), and there are no curves.
 *
 * With order 1 the output is the input with its boundary edges.
 *
 * Inverted quads are a warning. The filter fails, with an empty output, if there are other cells, boundary edges
 * are missing or have no side, or curves are not valid.
 *
 * @sa vtkQuadMesher, crossfield::RaiseOrder
 */

#ifndef vtkQuadsToHigherOrder_h
#define vtkQuadsToHigherOrder_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkUnstructuredGridAlgorithm.h"

class VTKCROSSFIELDFILTERS_EXPORT vtkQuadsToHigherOrder : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkQuadsToHigherOrder* New();
  vtkTypeMacro(vtkQuadsToHigherOrder, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Connects port 1, the boundary edges, or sets it to a data object. */
  vtkCrossFieldPortMacro(Boundary, 1);
  ///@}

  ///@{
  /** Connects port 2, the surface, or sets it to a data object. */
  vtkCrossFieldPortMacro(Surface, 2);
  ///@}

  ///@{
  /** Sets the order of the quads. Default: 2. Range: 1 to 3; 1 only joins quads and boundary edges. */
  vtkSetClampMacro(Order, int, 1, 3);
  vtkGetMacro(Order, int);
  ///@}

  ///@{
  /**
   * With a surface: sets the angle between the normals of two triangles, in degrees, above which their common edge is
   * sharp, as in vtkQuadMesher: nodes of edges on sharp ones are on these. Default: 35.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

protected:
  vtkQuadsToHigherOrder();
  ~vtkQuadsToHigherOrder() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkQuadsToHigherOrder(const vtkQuadsToHigherOrder&) = delete;
  void operator=(const vtkQuadsToHigherOrder&) = delete;

  int Order = 2;
  double FeatureAngle = 35.0;
};

#endif
