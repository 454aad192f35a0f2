/**
 * @class   vtkBoundarySimplifier
 * @brief   remove detail from the boundary of a domain
 *
 * *Thinning* removes detail that is much shorter than the edges of the mesh and would cause very
 * many triangles. Corners within `ThinningLength` L of each other are merged into one corner
 * halfway between them, which turns by the sum of their turning angles. Between corners, segments
 * are merged up to length L as long as they turn by at most 5°. *Smoothing* removes waves shorter
 * than `SmoothingLength` from ragged curves; a corner stays if no other corner is within that
 * distance. See docs/method.md §10.5 and §10.6.
 *
 * Input port 0: the domain, as for vtkDrillHoles. Input port 1, optional, repeatable: points at
 * which the boundary is kept if they are on it, such as the singularities and corners prescribed
 * for the domain.
 *
 * Output port 0 (same type as the input): if something was removed, one closed polyline per loop,
 * in the plane of the domain, with the point arrays of the nearest points of the input; if the
 * boundary has names of sides or curves, one polyline per piece with the array of names and the array
 * `Curve`. Otherwise the input. Meshes of vtkDrillHoles pass through, and so do, by default, surfaces with point
 * arrays. Field data, only if something was removed:
 * - `BoundaryMoved` (double): the maximum distance of a point of the boundary from the new
 *   boundary. After both thinning and smoothing it is the sum of the two distances, an upper bound;
 * - `BoundaryPoints` (int, two values): the numbers of boundary points before and after;
 * - `BoundaryRemovedCorners` (double, 3 components): the positions of corners that were merged with
 *   others or smoothed, if there are any.
 *
 * The filter fails, with an empty output, if vtkDrillHoles would refuse the domain or if the
 * smoothed boundary would cross itself.
 *
 * @sa vtkDrillHoles, vtkPlanarDomainReader
 */

#ifndef vtkBoundarySimplifier_h
#define vtkBoundarySimplifier_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkPassInputTypeAlgorithm.h"

#include <string>  // for names
#include <utility> // for names with sizes
#include <vector>  // for names with sizes

class VTKCROSSFIELDFILTERS_EXPORT vtkBoundarySimplifier : public vtkPassInputTypeAlgorithm
{
public:
  static vtkBoundarySimplifier* New();
  vtkTypeMacro(vtkBoundarySimplifier, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sets the part of a domain of several parts that the output has: "largest", a number from 1 for the largest,
   * or the name of a side that one part alone has. Default: empty, all parts.
   */
  vtkSetMacro(Part, std::string);
  vtkGetMacro(Part, std::string);
  ///@}
  /** Sets the part; overload for ParaView. */
  void SetPart(const char* part) { this->SetPart(std::string(part ? part : "")); }

  ///@{
  /**
   * Sets the edge length of the mesh for which the domain is simplified. Default: 0, 1/40 of the
   * diagonal of the bounding box of the domain. Range: 0 or more.
   */
  vtkSetClampMacro(MeshSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MeshSize, double);
  ///@}

  ///@{
  /**
   * Sets the length below which detail is thinned; 0 disables thinning. Default: −1, 0.02 of the
   * mesh size or of 1/40 of the diagonal, whichever is smaller.
   */
  vtkSetMacro(ThinningLength, double);
  vtkGetMacro(ThinningLength, double);
  ///@}

  ///@{
  /** Sets the length below which waves are smoothed. Default: 0, no smoothing. Range: 0 or more. */
  vtkSetClampMacro(SmoothingLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SmoothingLength, double);
  ///@}

  ///@{
  /**
   * Sets the turning angle, in degrees, above which a boundary vertex is a corner. Default: 30.
   * Range: 1 to 45.
   */
  vtkSetClampMacro(CornerAngle, double, 1.0, 45.0);
  vtkGetMacro(CornerAngle, double);
  ///@}

  ///@{
  /**
   * Sets the cell array with the materials of the domain, as for vtkQuadMesher. A domain of several
   * materials is passed on as it is.
   */
  vtkSetMacro(MaterialArray, std::string);
  vtkGetMacro(MaterialArray, std::string);
  ///@}
  /** Sets the name of the array of materials; overload for ParaView. */
  void SetMaterialArray(const char* name) { this->SetMaterialArray(std::string(name ? name : "")); }

  ///@{
  /** Sets lines inside of the domain, as for vtkQuadMesher. A domain with lines is passed on as it is. */
  vtkSetMacro(Lines, std::string);
  vtkGetMacro(Lines, std::string);
  ///@}
  /** Sets the lines; overload for ParaView. */
  void SetLines(const char* names) { this->SetLines(std::string(names ? names : "")); }

  ///@{
  /**
   * Sets the cell array with the names of the domain's sides, as for vtkQuadMesher. The boundary is
   * kept at points where the name changes. Default: none, `Side` if the domain has that array.
   */
  vtkSetMacro(SideNameArray, std::string);
  vtkGetMacro(SideNameArray, std::string);
  ///@}
  /** Sets the name of the array of sides; overload for ParaView. */
  void SetSideNameArray(const char* name) { this->SetSideNameArray(std::string(name ? name : "")); }

  ///@{
  /**
   * Sets the target length of edges at a side, as for vtkQuadMesher::AddSide. By default loops with
   * this side are thinned by at most 0.02 of it.
   */
  void AddSideSize(const std::string& name, double size);
  void ClearSideSizes();
  ///@}

  ///@{
  /**
   * Keeps the boundary at all points of a side, such as a side whose image is another one
   * (vtkQuadMesher::SetPeriodic). Names of sides that the boundary has not are ignored.
   */
  void AddKeptSide(const std::string& name);
  void ClearKeptSides();
  ///@}

  ///@{
  /**
   * Sets the curves that sides stand for, as for vtkQuadMesher. They are fitted to the boundary before
   * it is simplified; the output has the array `Curve` of its lines and the field data of the curves
   * (docs/curves.md). Curves that the domain has already are retained. The boundary is kept where
   * a curve begins or ends. Default: empty, none.
   */
  vtkSetMacro(Curves, std::string);
  vtkGetMacro(Curves, std::string);
  ///@}
  /** Sets the curves; overload for ParaView. */
  void SetCurves(const char* curves) { this->SetCurves(std::string(curves ? curves : "")); }

  /** Adds a connection to port 1, points at which the boundary is kept. */
  void AddKeptConnection(vtkAlgorithmOutput* output) { this->AddInputConnection(1, output); }

protected:
  vtkBoundarySimplifier();
  ~vtkBoundarySimplifier() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoundarySimplifier(const vtkBoundarySimplifier&) = delete;
  void operator=(const vtkBoundarySimplifier&) = delete;

  std::string Part;
  double MeshSize = 0.0;
  double ThinningLength = -1.0;
  double SmoothingLength = 0.0;
  double CornerAngle = 30.0;
  std::string SideNameArray;
  std::string MaterialArray;
  std::string Lines;
  std::vector<std::pair<std::string, double>> SideSizes;
  std::vector<std::string> KeptSides;
  std::string Curves;
};

#endif
