#ifndef MethodRun_h
#define MethodRun_h

#include "CompareTable.h"

#include "vtkNew.h"

class SingularityInput;
class vtkAlgorithm;
class vtkCrossFieldSingularities;
class vtkDrillHoles;
class vtkGinzburgLandauCrossField;
class vtkPerforatedCrossField;
class vtkSingularitySource;

/**
 * Pipeline of one method of `crossfield compare`: domain and singularities -> mesh -> field ->
 * singularities in the field.
 */
class MethodRun
{
public:
  /** Returns the names of the methods. */
  static const std::vector<std::string>& AllMethods();

  /** Returns whether a method places the singularities itself. */
  static bool IsReference(const std::string& method);

  MethodRun();
  ~MethodRun();

  /**
   * Solves; `size` is the edge length, `epsilon` the length in the penalty. Throws
   * PipelineRun::Error.
   */
  CompareRow Solve(const std::string& method, double size, double epsilon, vtkAlgorithm* domain,
    const SingularityInput& singularities);

  /** Returns the field, null before Solve. */
  vtkUnstructuredGrid* GetField() const { return this->Field; }

private:
  vtkNew<vtkSingularitySource> None;
  vtkNew<vtkDrillHoles> Drill;
  vtkNew<vtkPerforatedCrossField> Constrained;
  vtkNew<vtkGinzburgLandauCrossField> Reference;
  vtkNew<vtkCrossFieldSingularities> Found;
  vtkUnstructuredGrid* Field = nullptr;
};

#endif
