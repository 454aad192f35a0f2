/**
 * @class   vtkSeparatrices
 * @brief   trace the separatrices of a cross field and the patches between them
 *
 * In the map of vtkCrossFieldMap the lines of the field are straight, so they are traced exactly,
 * from triangle to triangle. 4 − k separatrices start at every interior singularity of quarter
 * index k, and 1 − k, if positive, at every corner. All advance together, the shortest first; each
 * ends at the first separatrix or side that it meets. Separatrices on one isoline that meet head-on
 * become one. They divide the domain into patches that are rectangles of the map: the T-mesh. From
 * a boundary loop that no separatrix meets, for example on a ring without singularities, one extra
 * line starts at a right angle.
 *
 * Input port 0 (vtkUnstructuredGrid): the map, output of vtkCrossFieldMap.
 * Input port 1, optional: seeds (points). Four streamlines of the cross field start at each seed
 * and are traced to the boundary or up to LongestStreamline. They end at nothing else and are not
 * part of the T-mesh.
 *
 * Output port 0 (vtkPolyData): one polyline for each separatrix and streamline. Cell arrays:
 * - `Line` (int): the number of the separatrix; −1 for streamlines;
 * - `Seed` (int): the seed of a streamline, else −1;
 * - `Singularity` (int): the row of the singularity where it starts; −1 at corners and for extra
 *   lines;
 * - `QuarterIndex` (int): the index where it starts;
 * - `EndsAt` (int): 1 at the side of another separatrix, 2 at the boundary, 3 head-on with another
 *   separatrix; 0 at LongestStreamline;
 * - `Length` (double): the length in the map.
 * Output port 1 (vtkPolyData): the patches of the T-mesh as triangles, since VTK draws concave
 * polygons incorrectly. Every patch has points of its own, its outline, counter-clockwise from one
 * corner of its rectangle. Cell arrays:
 * - `FaceId` (int), from 0;
 * - `USize`, `VSize` (double): the side lengths of the patch in the map.
 * Point arrays:
 * - `FaceId` (int);
 * - `UV` (double, 2): coordinates in the rectangle, with its first corner as the origin;
 * - `NodeKind` (int): 1 singularity, 2 corner, 3 on the boundary, 4 where a separatrix ends at
 *   another one; 0 for other points.
 * On a surface in space the points of a patch are a lattice on it, with `NodeKind` 0.
 *
 * Field data of both outputs: the numbers `Lines`, `Faces`, `Arcs`, `ExtraLines`, `HeadOn` (pairs)
 * and `Flips` (0); `Longest` (length of the longest separatrix in the map); `Mismatch` (maximum
 * difference between opposite sides of a patch).
 *
 * An empty map gives empty outputs. The filter fails, with empty outputs, if arrays of
 * vtkCrossFieldMap are missing, if a seed is outside the domain, or if the separatrices of the map
 * do not form rectangles.
 *
 * @sa vtkCrossFieldMap, crossfield::TraceSeparatrices, crossfield::MakeTMesh
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
  /** Connects port 1, the seeds, or sets it to a data object. */
  vtkCrossFieldPortMacro(Seeds, 1);
  ///@}

  ///@{
  /**
   * Sets the maximum length of a streamline, measured in the map, whose area is that of the domain.
   * Lines of a cross field may be infinitely long. Default: 0, ten times the square root of the
   * area. Range: 0 or more.
   */
  vtkSetClampMacro(LongestStreamline, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LongestStreamline, double);
  ///@}

  /** Returns the seconds that the last run spent in tracing. They are not part of the output. */
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
