/**
 * @class   vtkSeparatrices
 * @brief   the lines of a cross field that leave its singularities, and the rectangles between them
 *
 * In the map of vtkCrossFieldMap the lines of the field are straight, so they are followed exactly, from triangle to
 * triangle. From every interior singularity of quarter index k leave 4 − k lines, from every corner 1 − k if
 * that is positive. All advance together, the shortest first; each stops at the first line or side that it meets. Lines on one
 * isoline that meet head-on become one. What they divide the domain into are rectangles of the map: the T-mesh.
 * From a boundary loop that nothing meets, as of a ring without singularities, one line is drawn at right angles.
 *
 * Port 0, the map (vtkUnstructuredGrid): output of vtkCrossFieldMap.
 * Port 1, optional, seeds (points): from each of them four streamlines of the cross field are drawn by the same tracing, as
 * far as the boundary or LongestStreamline; they stop at nothing else and belong to no face.
 *
 * Output 0 (vtkPolyData): a polyline a line, with cell arrays
 * - `Line` (int): its number; −1 of streamlines; `Seed` (int): the seed of a streamline, else −1;
 * - `Singularity` (int): row of the singularity where it starts, −1 at corners and of extra lines; `QuarterIndex` (int) there;
 * - `EndsAt` (int): 1 the side of another line, 2 the boundary, 3 head-on with another line; 0 at LongestStreamline;
 * - `Length` (double): in the map.
 * Output 1 (vtkPolyData): the faces of the T-mesh in triangles, since concave polygons are drawn wrongly. Every face has points of
 * its own, its outline, counter-clockwise from a corner of its rectangle. Cell arrays
 * - `FaceId` (int), from 0; `USize`, `VSize` (double): the lengths of the face's sides in the map;
 * point arrays
 * - `FaceId` (int); `UV` (double, 2): in the rectangle, whose first corner is the origin;
 * - `NodeKind` (int): 1 singularity, 2 corner, 3 on the boundary, 4 a line ends at a line; 0 of other points.
 *
 * Field data of both: `Lines`, `Faces`, `Arcs`, `ExtraLines`, `HeadOn` (pairs), `Flips` (0), `Longest` (line, in the map),
 * `Mismatch` (largest difference of opposite sides of a face).
 *
 * An empty map gives empty outputs. Failure, with empty outputs: arrays of vtkCrossFieldMap are missing; a seed outside
 * the domain; a map in which lines do not make rectangles.
 *
 * @sa vtkCrossFieldMap, crossfield::TraceLines, crossfield::MakeTMesh
 */

#ifndef vtkSeparatrices_h
#define vtkSeparatrices_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkPolyDataAlgorithm.h"

class VTKCROSSFIELDFILTERS_EXPORT vtkSeparatrices : public vtkPolyDataAlgorithm
{
public:
  static vtkSeparatrices* New();
  vtkTypeMacro(vtkSeparatrices, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Port 1, the seeds: a connection or a data object. */
  vtkCrossFieldPortMacro(Seeds, 1);
  ///@}

  ///@{
  /**
   * Longest streamline from a seed, in the map, whose area is that of the domain; 0: ten times the square root of the
   * area. Lines of a cross field may go on for ever. Default: 0. Range: 0 or more.
   */
  vtkSetClampMacro(LongestStreamline, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LongestStreamline, double);
  ///@}

  /** Seconds that the last run spent in tracing. Not in the output. */
  vtkGetMacro(StageSeconds, double);

protected:
  vtkSeparatrices();
  ~vtkSeparatrices() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSeparatrices(const vtkSeparatrices&) = delete;
  void operator=(const vtkSeparatrices&) = delete;

  double LongestStreamline = 0.0;
  double StageSeconds = 0.0;
};

#endif
