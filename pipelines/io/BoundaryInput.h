#ifndef BoundaryInput_h
#define BoundaryInput_h

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

#include <string>

namespace CLI
{
class App;
}

/** What is taken out of the boundary of a command's domain. */
struct BoundaryOptions
{
  double thinning = -1.0; ///< As ThinningLength of vtkBoundarySimplifier.
  double smoothing = 0.0;

  /** Adds the options --thin-boundary and --smooth-boundary. */
  void AddTo(CLI::App& command);
};

namespace BoundaryInput
{
/** The domain of DomainReader::Open, without what the options take out; `size` is that of the mesh. */
vtkSmartPointer<vtkAlgorithm> Open(
  const std::string& name, double size, const BoundaryOptions& options);

/** Points of the boundary of such a domain that stay where they are. */
void Keep(vtkAlgorithm* domain, vtkAlgorithm* points, int port = 0);
/** The same, of a file, if one is named. */
void Keep(vtkAlgorithm* domain, const std::string& file);

/** One line, where something was taken out. */
void Print(vtkAlgorithm* domain);

/** A JSON report, and where something was taken out with `boundary`: its `points_before`, `points` and `moved`. */
std::string AddTo(const std::string& report, vtkAlgorithm* domain);
}

#endif
