#ifndef SweepOptions_h
#define SweepOptions_h

#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

namespace CLI
{
class App;
}
class vtkExtrudeQuads;

/** Options that make hexahedra from quads: --extrude and --revolve. */
struct SweepOptions
{
  std::string extrude; ///< HEIGHT[,LAYERS[,RATIO]]
  std::string revolve; ///< ANGLE[,LAYERS[,AXIS]]

  void AddTo(CLI::App& command);
  /** Reads the texts. Throws CLI::ValidationError if one is not valid. */
  void Read();
  bool IsSet() const { return this->Size > 0.0; }
  /** Returns the filter that was asked for, or none. */
  vtkSmartPointer<vtkExtrudeQuads> Make() const;

private:
  /** Reads the last part of a text. Returns false if it is not valid. */
  bool ReadRatio(const std::string& text);
  bool ReadAxis(const std::vector<std::string>& parts);

  double Size = 0.0; ///< Height or angle; 0 without a sweep.
  int Layers = 1;
  double Ratio = 1.0;
  int Axis = 0;
  std::array<double, 4> Line = { 0.0, 0.0, 1.0,
    0.0 }; ///< Two points of another axis than those of the plane.
};

#endif
