/**
 * @class   vtkCrossFieldSolver
 * @brief   base class of the filters that compute a cross field by an iteration
 *
 * Abstract class with the parameters of the iteration, its times, and the method that writes a
 * field and its report to the output. See vtkPerforatedCrossField for the arrays.
 *
 * @sa vtkPerforatedCrossField, vtkGinzburgLandauCrossField
 */

#ifndef vtkCrossFieldSolver_h
#define vtkCrossFieldSolver_h

#include "vtkCrossFieldArraySets.h"     // for the values of Arrays
#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkUnstructuredGridAlgorithm.h"

namespace crossfield
{
struct SolvedField;
class Progress;
}
namespace DrilledMeshConversion
{
struct DrilledMesh;
}

class VTKCROSSFIELDFILTERS_EXPORT vtkCrossFieldSolver : public vtkUnstructuredGridAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkCrossFieldSolver, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sets the maximum number of iterations. Default: 100 for vtkPerforatedCrossField, 500 for
   * vtkGinzburgLandauCrossField. Range: 1 or more.
   */
  vtkSetClampMacro(MaximumIterations, int, 1, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

  ///@{
  /**
   * Sets the relative residual of the optimality conditions at which the iteration stops. Default:
   * 1e-10. Range: 1e-15 to 1e-2.
   */
  vtkSetClampMacro(Tolerance, double, 1e-15, 1e-2);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Selects the arrays of the output by a value of vtkCrossFieldArraySets: Exact (those that other
   * filters need), Display (also those for viewing) or All. Default: All.
   */
  vtkSetClampMacro(Arrays, int, vtkCrossFieldArraySets::Exact, vtkCrossFieldArraySets::All);
  vtkGetMacro(Arrays, int);
  void SetArraysToExact() { this->SetArrays(vtkCrossFieldArraySets::Exact); }
  void SetArraysToDisplay() { this->SetArrays(vtkCrossFieldArraySets::Display); }
  void SetArraysToAll() { this->SetArrays(vtkCrossFieldArraySets::All); }
  ///@}

  /**
   * Returns the seconds that the last run spent in assembling, in factoring (or computing the
   * initial field) and in solving. They are not part of the output, so that equal inputs give equal
   * outputs.
   */
  vtkGetVector3Macro(StageSeconds, double);

protected:
  explicit vtkCrossFieldSolver(int maximumIterations)
    : MaximumIterations(maximumIterations)
  {
  }
  ~vtkCrossFieldSolver() override = default;

  /** Reads the mesh and calls Compute unless the mesh is empty. */
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

#ifndef __VTK_WRAP__
  /** Computes the field and publishes it. Throws crossfield::Error. */
  virtual void Compute(const DrilledMeshConversion::DrilledMesh& cells,
    vtkInformationVector** inputVector, const crossfield::Progress& progress,
    vtkInformationVector* outputVector) = 0;

  /**
   * Writes the message of an error to the outputs. Called after a failure; the default does
   * nothing.
   */
  virtual void ReportFailure(const char* /*sentence*/, vtkInformationVector*) {}

  /**
   * Copies the mesh and adds the field and its report. Warns, with `advice`, if the iteration did
   * not converge.
   */
  void Publish(const DrilledMeshConversion::DrilledMesh& cells,
    const crossfield::SolvedField& field, const char* advice, vtkUnstructuredGrid* input,
    vtkUnstructuredGrid* output);
#endif

private:
  vtkCrossFieldSolver(const vtkCrossFieldSolver&) = delete;
  void operator=(const vtkCrossFieldSolver&) = delete;

  int MaximumIterations;
  double Tolerance = 1e-10;
  int Arrays = vtkCrossFieldArraySets::All;
  double StageSeconds[3] = { 0.0, 0.0, 0.0 };
};

#endif
