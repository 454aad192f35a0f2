/**
 * @class   vtkCrossFieldSolver
 * @brief   what the filters that compute a cross field by an iteration have in common
 *
 * Abstract: the parameters of the iteration, the time that it took, and the one way in which a field
 * and its report get into the output. See vtkPerforatedCrossField for the arrays.
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
   * Most iterations. Default: 100 for vtkPerforatedCrossField, 500 for vtkGinzburgLandauCrossField.
   * Range: at least 1.
   */
  vtkSetClampMacro(MaximumIterations, int, 1, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

  ///@{
  /**
   * The iteration stops when the relative residual of the optimality conditions is below this.
   * Default: 1e-10. Range: 1e-15 to 1e-2.
   */
  vtkSetClampMacro(Tolerance, double, 1e-15, 1e-2);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Which arrays are written, one of vtkCrossFieldArraySets: Exact, what the other filters need; Display,
   * also what one looks at; All. Default: All.
   */
  vtkSetClampMacro(Arrays, int, vtkCrossFieldArraySets::Exact, vtkCrossFieldArraySets::All);
  vtkGetMacro(Arrays, int);
  void SetArraysToExact() { this->SetArrays(vtkCrossFieldArraySets::Exact); }
  void SetArraysToDisplay() { this->SetArrays(vtkCrossFieldArraySets::Display); }
  void SetArraysToAll() { this->SetArrays(vtkCrossFieldArraySets::All); }
  ///@}

  /**
   * Seconds that the last run spent in assembling, factoring (or computing the start) and solving.
   * Not in the output, so that the same input gives the same output.
   */
  vtkGetVector3Macro(StageSeconds, double);

protected:
  explicit vtkCrossFieldSolver(int maximumIterations)
    : MaximumIterations(maximumIterations)
  {
  }
  ~vtkCrossFieldSolver() override = default;

  /** Reads the mesh and has the field computed, unless the mesh is empty. */
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

#ifndef __VTK_WRAP__
  /** Computes the field and publishes it. Errors may be thrown. */
  virtual void Compute(const DrilledMeshConversion::DrilledMesh& cells,
    vtkInformationVector** inputVector, const crossfield::Progress& progress,
    vtkInformationVector* outputVector) = 0;

  /** Is told after an error. */
  virtual void SayWhyThereIsNoField(const char* /*sentence*/, vtkInformationVector*) {}

  /**
   * Copies the mesh and adds the field and its report; warns with `advice` when the iteration did not
   * converge.
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
