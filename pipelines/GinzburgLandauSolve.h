#ifndef GinzburgLandauSolve_h
#define GinzburgLandauSolve_h

#include "CommandLine.h"

#include <string>
#include <vector>

class vtkPolyData;
class vtkUnstructuredGrid;

/** Prints one line for each singularity that was found in a field. */
void PrintSingularities(vtkPolyData* singularities, vtkUnstructuredGrid* field);

/** What `crossfield solve --method ginzburg-landau` was asked to do. */
struct GinzburgLandauSolve : MeshOptions
{
  double epsilon = 0.0;
  std::string start = "harmonic";
  std::string json;
  bool strict = false;

  /** Names of the starts, in the order of the filter's codes. */
  static const std::vector<std::string> Starts;

  /** Solves, writes and reports, to outputs that can be written; returns the exit status. */
  int Run() const;
};

#endif
