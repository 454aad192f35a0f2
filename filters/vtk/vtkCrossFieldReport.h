/**
 * @class   vtkCrossFieldReport
 * @brief   write the numbers of a run as JSON
 *
 * A report has the numbers in the outputs of filters. Its keys are the names of their arrays in lower case with
 * underscores, `hole_degree` for `HoleDegree`; names with a common beginning and arrays with several components are
 * objects, `{"scaled_jacobian": {"min", "mean", "bound"}}` for `ScaledJacobianRange` and `ScaledJacobianBound`.
 * Arrays that do not exist are left out. Rows of tables and points are lists of objects.
 *
 * The source `data` has the field data, rows or points of the report. Others have the names of the sources below.
 * Every report reads `domain`, the domain after its boundary was simplified, and `singularities`, those that were used.
 *
 * | report | data: output 0 of | other sources | stages |
 * | --- | --- | --- | --- |
 * | `check` | vtkPoincareHopfCheck | `loops` and `corners`, its outputs 1 and 2 | |
 * | `corners` | vtkBoundaryCornerClassifier | `scenarios` and `split`, its outputs 1 and 2 | |
 * | `energy` | vtkSingularityEnergy | `gradients`, its output 1 | |
 * | `field` | vtkPerforatedCrossField, vtkGinzburgLandauCrossField, vtkHField | | assemble, factor, mesh, solve, write |
 * | `optimize` | vtkSingularityOptimizer | | |
 * | `quads` | vtkQuadMesher::CopyMesh, also raised or extruded | | those of vtkQuadMesher |
 * | `separatrices` | vtkSeparatrices | `map`, output 0 of vtkCrossFieldMap | mesh, map, trace |
 *
 * Any other name gives what every report has.
 */

#ifndef vtkCrossFieldReport_h
#define vtkCrossFieldReport_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkDataObject.h"              // for Sources
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for Sources

#include <map>    // for Sources
#include <string> // for names
#include <vector> // for Seconds

class VTKCROSSFIELDFILTERS_EXPORT vtkCrossFieldReport : public vtkObject
{
public:
  static vtkCrossFieldReport* New();
  vtkTypeMacro(vtkCrossFieldReport, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Sets the source of this name; null is none. */
  void SetSource(const std::string& name, vtkDataObject* data) { this->Sources[name] = data; }

  /** Sets the times of the stages. Default: none, and the report has no `seconds`. */
  void SetSeconds(const std::vector<double>& seconds) { this->Seconds = seconds; }

  /**
   * Sets the names of the files of the configurations. With them the report `energy` has `file` instead of
   * `configuration`, and no energies of inconsistent configurations. Default: none.
   */
  void SetFiles(const std::vector<std::string>& names) { this->Files = names; }

  /** Returns whether a domain or mesh is in no plane z = const, so that reports need z coordinates. */
  static bool HasHeight(vtkDataObject* object);

  /**
   * Returns the report of this name with a line break at the end. Numbers that are not finite are null, and bytes of
   * texts that are not UTF-8 become the replacement character.
   */
  std::string Write(const std::string& name);

protected:
  vtkCrossFieldReport() = default;
  ~vtkCrossFieldReport() override = default;

private:
  vtkCrossFieldReport(const vtkCrossFieldReport&) = delete;
  void operator=(const vtkCrossFieldReport&) = delete;

  std::map<std::string, vtkSmartPointer<vtkDataObject>> Sources;
  std::vector<double> Seconds;
  std::vector<std::string> Files;
};

#endif
