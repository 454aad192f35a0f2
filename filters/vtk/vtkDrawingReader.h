/**
 * @class   vtkDrawingReader
 * @brief   read the boundary of a planar domain from a drawing
 *
 * Reads the curves of a drawing, chains them into closed curves and samples them. The format depends
 * on the ending of the file name:
 * - .dxf: an ASCII drawing with LINE, ARC, CIRCLE, ELLIPSE, SPLINE, LWPOLYLINE and POLYLINE, also in
 *   blocks. Layers are names of sides; layer 0 is no name.
 * - .svg: paths and other shapes; names are the ids of shapes or of their groups. y is negated.
 * - .geojson or .json: polygons with their holes.
 * - .msh: the boundary of a mesh of Gmsh, format 2.2 or 4.1; names are its physical groups.
 * - .poly: the segments of a file of Triangle; names are its boundary markers other than 0.
 * - .off: the boundary of a mesh of polygons.
 * - .dat: an aerofoil in Selig's or Lednicer's format, as a spline through its points. Other .dat
 *   files are read by vtkPlanarDomainReader.
 * - .step, .stp or .brep: the largest planar face, or all faces (AllFaces), if Open CASCADE was installed for the build.
 * Coordinates stay in the unit of the drawing.
 *
 * Output port 0 (vtkPolyData): line cells along the loops, in the plane of the drawing, with
 * - cell array `Side` (strings), if any curve has a name; empty for curves without one;
 * - the curves that the lines sample: cell array `Curve` (int) and field data `CurveKind`,
 *   `CurveOffset` and `CurveValues` (CurveConversion.h), unless the file has no curves but chords;
 * - field data `DrawingUnit` (string), if the file has a unit, such as "mm";
 * - field data `LargestGap` (double): maximum distance between ends of curves that were joined.
 * A line turns by at most SamplingAngle and is at most 1e-4 of the extent away from its curve. Ends
 * of curves are exact.
 *
 * If curves branch, cross or end on each other, or a mesh has several physical surfaces, the output also has
 * polygons, which cover the regions between the lines, with the cell array `Material` (strings), empty for lines.
 *
 * The polygons of a .msh or .off file that are in no plane, and all faces of a model (AllFaces), are a surface in space:
 * the output has these, with the names of faces or physical surfaces in the cell array `Material` if there are several,
 * and lines along edges with a name, in the cell array `Side`.
 *
 * Entities that are no curves, repeated curves and closed gaps are reported as warnings. The reader
 * fails, with an empty output and the place, if the file is damaged, if curves do not close, and if they are
 * not in one plane.
 *
 * @sa vtkPlanarDomainReader, vtkPlanarDomainSource
 */

#ifndef vtkDrawingReader_h
#define vtkDrawingReader_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for FileName

class VTKCROSSFIELDFILTERS_EXPORT vtkDrawingReader : public vtkPolyDataAlgorithm
{
public:
  static vtkDrawingReader* New();
  vtkTypeMacro(vtkDrawingReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Sets the name of the file. Default: empty, which is an error. */
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}
  /** Sets the name of the file; overload for ParaView. */
  void SetFileName(const char* fileName)
  {
    this->SetFileName(std::string(fileName ? fileName : ""));
  }

  ///@{
  /**
   * Sets the distance within which open ends of curves are joined, in the unit of the drawing.
   * Default: 0, which is 1e-5 of the diagonal of the drawing's bounding box. Ends at exactly the
   * same point are always joined.
   */
  vtkSetClampMacro(JoinTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(JoinTolerance, double);
  ///@}

  ///@{
  /**
   * Sets the layers whose curves are used, by their names, separated by semicolons; "0" stands for curves without a
   * name. Default: empty, all curves.
   */
  vtkSetMacro(Layers, std::string);
  vtkGetMacro(Layers, std::string);
  ///@}
  /** Sets the layers; overload for ParaView. */
  void SetLayers(const char* layers) { this->SetLayers(std::string(layers ? layers : "")); }

  ///@{
  /**
   * Sets the names of curves that are lines inside of the domain, not parts of its boundary, separated by
   * semicolons. They become line cells of these names beside those of the boundary. Names that no curve has are
   * ignored: vtkQuadMesher refuses them. Default: empty.
   */
  vtkSetMacro(Lines, std::string);
  vtkGetMacro(Lines, std::string);
  ///@}
  /** Sets the lines; overload for ParaView. */
  void SetLines(const char* names) { this->SetLines(std::string(names ? names : "")); }

  ///@{
  /**
   * Makes a region of a material of what each closed curve bounds, except curves whose names begin with `hole`. The
   * material is the name of the curves around a region if not all regions have the same, otherwise `region1`,
   * `region2`, ... by decreasing area. Default: off, closed curves inside of others are holes.
   */
  vtkSetMacro(ClosedCurvesAreRegions, bool);
  vtkGetMacro(ClosedCurvesAreRegions, bool);
  vtkBooleanMacro(ClosedCurvesAreRegions, bool);
  ///@}

  ///@{
  /**
   * Takes all faces of a .step, .stp or .brep model, as triangles of a surface in space, not only the largest planar
   * one. Default: off; models without a planar face are always read so.
   */
  vtkSetMacro(AllFaces, bool);
  vtkGetMacro(AllFaces, bool);
  vtkBooleanMacro(AllFaces, bool);
  ///@}

  ///@{
  /**
   * Sets the maximum turn of a curve along one line, and of a face along one triangle, in degrees from 0.1 to 30.
   * Default: 5.
   */
  vtkSetClampMacro(SamplingAngle, double, 0.1, 30.0);
  vtkGetMacro(SamplingAngle, double);
  ///@}

  /**
   * Returns 1 if a file has one of the endings above, and for .dat if it is an aerofoil, else 0.
   * Called by ParaView.
   */
  static int CanReadFile(const char* fileName);

  /** Returns whether .step, .stp and .brep files can be read. */
  static bool CanReadCad();

protected:
  vtkDrawingReader();
  ~vtkDrawingReader() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkDrawingReader(const vtkDrawingReader&) = delete;
  void operator=(const vtkDrawingReader&) = delete;

  std::string FileName;
  std::string Layers;
  std::string Lines;
  double JoinTolerance = 0.0;
  double SamplingAngle = 5.0;
  bool ClosedCurvesAreRegions = false;
  bool AllFaces = false;
};

#endif
