#ifndef SweepOptions_h
#define SweepOptions_h

#include "vtkSmartPointer.h"

#include <string>

namespace CLI
{
class App;
}
class vtkExtrudeQuads;

/** Options that make hexahedra from quads: --extrude and --revolve. */
struct SweepOptions
{
  std::string extrude; ///< HEIGHT[,LAYERS]
  std::string revolve; ///< ANGLE,LAYERS[,x|y]

  void AddTo(CLI::App& command);
  /** Reads the texts. Throws CLI::ValidationError if one is not valid. */
  void Read();
  bool IsSet() const { return this->Size > 0.0; }
  /** Returns the filter that was asked for, or none. */
  vtkSmartPointer<vtkExtrudeQuads> Make() const;

private:
  double Size = 0.0; ///< Height or angle; 0 without a sweep.
  int Layers = 1;
  int Axis = 0;
};

#endif
