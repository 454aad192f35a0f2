#ifndef CompareTable_h
#define CompareTable_h

#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;
class vtkUnstructuredGrid;

/** Row of the table of `crossfield compare`: the result of one method. */
struct CompareRow
{
  std::string method;
  double energy = 0.0; ///< Energy that the method minimises, with its penalty if it has one.
  double gradientEnergy = 0.0; ///< ½ ∫ |∇u|², without penalty.
  double normMinimum = 0.0;    ///< Minimum of |u| over the midpoints of edges.
  double normMaximum = 0.0;    ///< Maximum of |u| over the midpoints of edges.
  /** Σ |k| of the requested singularities; for the reference method, the sum that the domain
   * requires. */
  int wanted = 0;
  int reached = 0;  ///< Part of `wanted` that the field has at the requested positions.
  int unwanted = 0; ///< Number of unwanted singularities, as in the report of the field.
  int iterations = 0;
  double seconds = 0.0; ///< Time for the mesh and the solve.
  bool converged = false;
  std::string note; ///< Reason why there is no field, or empty.
};

namespace CompareTable
{
/** Reads a row from a field and the singularities that were found in it. */
CompareRow Read(const std::string& method, vtkUnstructuredGrid* field, vtkPolyData* found);

/** Returns the table as aligned text for a terminal. */
std::string Text(const std::vector<CompareRow>& rows);

/** Returns the table as CSV. */
std::string Csv(const std::vector<CompareRow>& rows);

/** Returns the table as JSON, with the names of the CSV columns and the changes to the domain's
 * boundary. */
std::string Json(const std::vector<CompareRow>& rows, vtkDataObject* domain);
}

#endif
