/**
 * @class   vtkExtrudeQuads
 * @brief   hexahedra from quads, by a translation or a revolution
 *
 * A translation moves the quads by Height along their normal, in layers of equal height, or with a given Ratio of
 * the last to the first one. A revolution turns them about a line by Angle, at first towards their normal; with one layer from minus half
 * to half of the angle, as a wedge of OpenFOAM, and with 360° back to the start. A quad with an edge on the axis
 * becomes a prism.
 *
 * Input port 0 (vtkUnstructuredGrid): quads and lines of order 1 or 2: vtkQuadMesher::CopyMesh,
 * vtkQuadsToHigherOrder or a .vtu file of `crossfield quads`; or output 0 of vtkQuadMesher. Input port 1,
 * optional: the boundary edges, output 5 of vtkQuadMesher, if port 0 has no lines; without a connection,
 * those of the vtkQuadMesher upstream whose points and cells port 0 has.
 *
 * Output port 0 (vtkUnstructuredGrid): VTK_HEXAHEDRON and VTK_WEDGE, or VTK_TRIQUADRATIC_HEXAHEDRON
 * and VTK_BIQUADRATIC_QUADRATIC_WEDGE, layer by layer in the order of the quads, then the faces of
 * the boundary: VTK_QUAD and VTK_TRIANGLE, or VTK_BIQUADRATIC_QUAD and VTK_QUADRATIC_TRIANGLE. With
 * all arrays of the quads and
 * - cells: `K` (int), the layer, −1 on faces; `Side` (string), the name of the side of a face: that of the edge,
 *   or `back` at the start and `front` at the end (`front_2`, ... if the quads have a side of that name);
 *   `I` and `J` are −1 on faces, whose other arrays are those of their cell;
 * - field data: `SweepLayers` (int), `SweepEnds` (string, 2: names of back and front, empty if there are none),
 *   `SweepHeight` (double, translation) or `SweepAngle` (double, degrees, revolution), `Hexahedra` (int,
 *   number of cells, with prisms).
 *
 * Output port 1 (vtkMultiBlockDataSet): a right-handed vtkStructuredGrid per block with the cell array
 * `BlockId`; no blocks if the quads have no arrays `BlockId`, `I` and `J`.
 *
 * The filter fails, with empty outputs, if there are no quads or boundary edges, quads of order 3, quads
 * that are not in a plane or, for a revolution, not in a plane z = const, on both sides of the axis, with
 * only a corner on it, or with order 2 and an edge on it.
 *
 * @sa vtkQuadMesher, vtkQuadsToHigherOrder, vtkQuadMeshWriter, crossfield::SweepQuads
 */

#ifndef vtkExtrudeQuads_h
#define vtkExtrudeQuads_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkUnstructuredGridAlgorithm.h"

class VTKCROSSFIELDFILTERS_EXPORT vtkExtrudeQuads : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkExtrudeQuads* New();
  vtkTypeMacro(vtkExtrudeQuads, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Connects port 1, the boundary edges, or sets it to a data object. */
  vtkCrossFieldPortMacro(Boundary, 1);
  ///@}

  /** Kinds of motions. */
  enum Motions
  {
    Translation,
    Revolution
  };
  ///@{
  /** Sets the motion. Default: Translation. */
  vtkSetClampMacro(Motion, int, Translation, Revolution);
  vtkGetMacro(Motion, int);
  void SetMotionToTranslation() { this->SetMotion(Translation); }
  void SetMotionToRevolution() { this->SetMotion(Revolution); }
  ///@}

  ///@{
  /** Sets the number of layers of cells, positive. Default: 1. */
  vtkSetMacro(Layers, int);
  vtkGetMacro(Layers, int);
  ///@}

  ///@{
  /** Sets the height of a translation, positive. Default: 1. */
  vtkSetMacro(Height, double);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /** Sets the angle of a revolution in degrees, more than 0 and at most 360. Default: 90. */
  vtkSetMacro(Angle, double);
  vtkGetMacro(Angle, double);
  ///@}

  ///@{
  /** Sets the height of the last layer of a translation by that of the first, positive. Default: 1. */
  vtkSetMacro(Ratio, double);
  vtkGetMacro(Ratio, double);
  ///@}

  /** Axes of a revolution, at the z of the quads. */
  enum Axes
  {
    AxisX,   ///< y = 0
    AxisY,   ///< x = 0
    AxisLine ///< The line from AxisPoint1 to AxisPoint2.
  };
  ///@{
  /** Sets the axis of a revolution. Default: AxisX. */
  vtkSetClampMacro(Axis, int, AxisX, AxisLine);
  vtkGetMacro(Axis, int);
  ///@}

  ///@{
  /** Sets x and y of two different points of the axis, used with AxisLine. Default: (0, 0) and (1, 0). */
  vtkSetVector2Macro(AxisPoint1, double);
  vtkGetVector2Macro(AxisPoint1, double);
  vtkSetVector2Macro(AxisPoint2, double);
  vtkGetVector2Macro(AxisPoint2, double);
  ///@}

protected:
  vtkExtrudeQuads();
  ~vtkExtrudeQuads() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkExtrudeQuads(const vtkExtrudeQuads&) = delete;
  void operator=(const vtkExtrudeQuads&) = delete;

  int Motion = Translation;
  int Layers = 1;
  double Height = 1.0;
  double Ratio = 1.0;
  double Angle = 90.0;
  int Axis = AxisX;
  double AxisPoint1[2] = { 0.0, 0.0 };
  double AxisPoint2[2] = { 1.0, 0.0 };
};

#endif
