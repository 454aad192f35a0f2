#ifndef CompareTable_h
#define CompareTable_h

#include <string>
#include <vector>

class vtkPolyData;
class vtkUnstructuredGrid;

/** What `crossfield compare` says about one method. */
struct CompareRow
{
  std::string method;
  double energy = 0.0;         ///< As the method defines it; with the penalty where there is one.
  double gradientEnergy = 0.0; ///< ½ ∫ |∇u|² without it.
  double normMinimum = 0.0;    ///< Of |u| over the midpoints of edges.
  double normMaximum = 0.0;
  int wanted =
    0; ///< Σ |k| of the singularities asked for; of the reference, what the domain requires.
  int reached = 0;  ///< The part of it that the field has where it was asked for.
  int unwanted = 0; ///< As the field's report counts them.
  int iterations = 0;
  double seconds = 0.0; ///< Of the mesh and the solve.
  bool converged = false;
  std::string note; ///< Why there is no field, or empty.
};

namespace CompareTable
{
/** Reads a row from a field and the singularities found in it. */
CompareRow Read(const std::string& method, vtkUnstructuredGrid* field, vtkPolyData* found);

/** The table to look at, as .csv, and as .json with the same names. */
std::string Text(const std::vector<CompareRow>& rows);
std::string Csv(const std::vector<CompareRow>& rows);
std::string Json(const std::vector<CompareRow>& rows);
}

#endif
