#ifndef FieldReading_h
#define FieldReading_h

#include "MeshReading.h"

#include "vtkSmartPointer.h"

class vtkDataArray;

/** A cross field as it is read back by somebody who has only the mesh and `CrossFieldCR`. */
class FieldReading : public MeshReading
{
public:
  using Complex = std::complex<double>;
  /** u at the midpoints of the sides of a triangle, or three times that of a line. */
  using Sides = std::array<Complex, 3>;

  explicit FieldReading(vtkUnstructuredGrid* mesh);

  Sides At(vtkIdType cell) const;
  Complex OnLine(std::size_t line) const;

  /** The linear function on a triangle with the given values at the midpoints, at its corners. */
  Sides AtCorners(std::size_t triangle) const;

  /** ½ ∫ |∇u|², triangle by triangle. */
  double Energy() const;

  /** ½ ∫ |∇φ|² over one triangle, φ the argument of u, of which no step exceeds half a turn. */
  double PhaseEnergy(std::size_t triangle) const;

  /** Number of triangles and inner vertices around whose midpoints u turns. */
  int Singular() const;

  /** Turns of u around a hole, counter-clockwise. */
  double Degree(int row) const;

private:
  /** ½ ∫ |∇w|² of the linear function that grows by the given values from the first corner. */
  double Dirichlet(std::size_t triangle, Complex toSecond, Complex toThird) const;

  vtkSmartPointer<vtkDataArray> Exact; // outlives the output of the filter
};

#endif
