#ifndef MeshReading_h
#define MeshReading_h

#include "vtkType.h"

#include <array>
#include <complex>
#include <map>
#include <vector>

class vtkUnstructuredGrid;

/** A drilled mesh as the tests see it: read from the output's cells and arrays by the contract. */
class MeshReading
{
public:
  struct Triangle
  {
    vtkIdType cell;
    std::array<vtkIdType, 3> points;
    double area; ///< Positive when counter-clockwise.
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

  /** Every cell must be a triangle or a line; anything else fails the test. */
  explicit MeshReading(vtkUnstructuredGrid* mesh);

  std::vector<Place> points;
  std::vector<Triangle> triangles;
  std::vector<Line> lines;
  /** Directed sides of all triangles: the triangle and the number of the side, from its point. */
  std::map<std::array<vtkIdType, 2>, std::array<std::size_t, 2>> sides;

  double Area() const;

  /** Smallest angle of all triangles in degrees. */
  double SmallestAngle() const;

  /**
   * The lines of one kind and id in the order in which they follow each other, as numbers in
   * `lines`. Fails the test unless they form one closed loop.
   */
  std::vector<std::size_t> Walk(int kind, int id) const;
};

#endif
