#ifndef SideOptions_h
#define SideOptions_h

#include <string>
#include <utility>
#include <vector>

namespace CLI
{
class App;
}
class vtkQuadMesher;

/** Options that prescribe something for named sides of the boundary. */
struct SideOptions
{
  std::vector<std::string> counts;
  std::vector<std::string> progressions;
  std::vector<std::string> sizes;
  std::vector<std::string> periodic;
  std::vector<std::string> curves;      ///< Of --curve.
  std::string otherCurves;              ///< Of --curves.
  std::vector<std::string> sizesNear;   ///< Of --size-near.
  std::vector<std::string> sizesInside; ///< Of --size-in.
  std::vector<std::string> nodes;       ///< Of --node.
  double minimumSize = 0.0;
  double maximumSize = 0.0;
  double growth = 0.0; ///< 0: not given.

  /**
   * Adds the options --count, --progression, --size-at, --size-near, --size-in, --growth, --min-size, --max-size,
   * --periodic, --curve, --curves and --node.
   */
  void AddTo(CLI::App& command);
  /** Returns whether sizes of parts of the domain are prescribed, or bounds. */
  bool HasSizes() const;
  /**
   * Returns the sizes of --size-at and --size-in that are positive numbers; others are refused by the filter.
   */
  std::vector<std::pair<std::string, double>> ReadSizes() const;
  /** Returns the sides of --periodic. Throws PipelineRun::Error if a pair has no two names. */
  std::vector<std::string> PeriodicNames() const;
  /** Returns the curves in the form of vtkQuadMesher. */
  std::string CurvesText() const;
  /** Sets the prescriptions of a filter. Throws PipelineRun::Error if one has no name. */
  void SetOn(vtkQuadMesher* mesher) const;
};

#endif
