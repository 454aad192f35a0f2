#ifndef BoundaryInput_h
#define BoundaryInput_h

#include "DomainReader.h"

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

#include <string>
#include <utility>
#include <vector>

namespace CLI
{
class App;
}

/** Options that simplify the boundary of a command's domain. */
struct BoundaryOptions
{
  std::string part;       ///< Part of vtkBoundarySimplifier.
  double thinning = -1.0; ///< ThinningLength of vtkBoundarySimplifier.
  double smoothing = 0.0; ///< SmoothingLength of vtkBoundarySimplifier.
  DomainReader::DrawingOptions drawing;
  std::string names;                                 ///< SideNameArray of vtkBoundarySimplifier.
  std::string materials = "none";                    ///< MaterialArray of vtkBoundarySimplifier.
  std::vector<std::pair<std::string, double>> sizes; ///< AddSideSize of vtkBoundarySimplifier.
  std::vector<std::string> kept;                     ///< AddKeptSide of vtkBoundarySimplifier.
  std::string curves;                                ///< Curves of vtkBoundarySimplifier.
  std::vector<std::string> lines;                    ///< Lines of vtkQuadMesher.
  std::vector<std::string> openLines;                ///< OpenLines of vtkQuadMesher.

  /** Adds the options --part, --drawing-layer, --thin-boundary, --smooth-boundary and --join-tolerance. */
  void AddTo(CLI::App& command);
  /** Adds --materials, and uses the materials of the domain by default. */
  void AddMaterialsTo(CLI::App& command);
  /** Adds --line. */
  void AddLinesTo(CLI::App& command);
  /** Adds --open. */
  void AddOpenLinesTo(CLI::App& command);
};

namespace BoundaryInput
{
/** Opens a domain as DomainReader::Open does and simplifies its boundary; `size` is the mesh size.
 */
vtkSmartPointer<vtkAlgorithm> Open(
  const std::string& name, double size, const BoundaryOptions& options);

/** Keeps the boundary of such a domain in place at these points. */
void Keep(vtkAlgorithm* domain, vtkAlgorithm* points, int port = 0);
/** Keeps the boundary in place at the points of a file, if one is named. */
void Keep(vtkAlgorithm* domain, const std::string& file);

/** Prints the unit of a drawing, how the boundary was simplified and which corners merged, if any. */
void Print(vtkAlgorithm* domain);
}

#endif
