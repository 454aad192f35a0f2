#ifndef FieldReading_h
#define FieldReading_h

#include "MeshReading.h"

#include "vtkSmartPointer.h"

class vtkDataArray;

/** Cross field of a mesh, computed from `CrossFieldCR` only. */
class FieldReading : public MeshReading
{
public:
  using Complex = std::complex<double>;
  /**
   * Values of u at the midpoints of the sides of a triangle, or three times the value of a line.
   */
  using Sides = std::array<Complex, 3>;

  explicit FieldReading(vtkUnstructuredGrid* mesh);

  /** Returns the values of a cell. */
  Sides At(vtkIdType cell) const;

  /** Returns the value of a line. */
  Complex OnLine(std::size_t line) const;

  /**
   * Returns the values at the corners of a triangle of the linear function with the given values at
   * the midpoints.
   */
  Sides AtCorners(std::size_t triangle) const;

  /** Returns ½ ∫ |∇u|², summed over triangles. */
  double Energy() const;

  /**
   * Returns ½ ∫ |∇φ|² over one triangle, where φ is the argument of u, whose steps are at most half
   * a turn.
   */
  double PhaseEnergy(std::size_t triangle) const;

  /** Returns the number of triangles and inner vertices around which u turns. */
  int CountSingular() const;

  /** Returns the number of turns of u around a hole, counter-clockwise. */
  double Degree(int row) const;

private:
  /** Returns ½ ∫ |∇w|² of the linear function with the given differences from the first corner. */
  double Dirichlet(std::size_t triangle, Complex toSecond, Complex toThird) const;

  vtkSmartPointer<vtkDataArray> Exact; // may outlive the output of the filter
};

#endif
