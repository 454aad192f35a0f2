#ifndef MeshReading_h
#define MeshReading_h

#include "vtkType.h"

#include <array>
#include <complex>
#include <map>
#include <vector>

class vtkUnstructuredGrid;

/** Drilled mesh, read from the cells and arrays of an output by their documentation. */
class MeshReading
{
public:
  struct Triangle
  {
    vtkIdType cell;
    std::array<vtkIdType, 3> points;
    double area; ///< Positive if counter-clockwise.
  };
  struct Line
  {
    vtkIdType cell;
    std::array<vtkIdType, 2> points;
    int kind;
    int id;
    int quarterIndex;
  };
  using Place = std::complex<double>;

  /** Reads the mesh. Expects every cell to be a triangle or a line. */
  explicit MeshReading(vtkUnstructuredGrid* mesh);

  std::vector<Place> points;
  std::vector<Triangle> triangles;
  std::vector<Line> lines;
  /** Directed sides of all triangles: the triangle and the number of the side. */
  std::map<std::array<vtkIdType, 2>, std::array<std::size_t, 2>> sides;

  /** Returns the sum of the signed areas of all triangles. */
  double Area() const;

  /** Returns the minimum angle of all triangles in degrees. */
  double MinimumAngle() const;

  /**
   * Returns the lines of one kind and id in their order along the boundary, as indices in `lines`.
   * Expects them to form one closed loop.
   */
  std::vector<std::size_t> OrderedLoop(int kind, int id) const;
};

#endif
