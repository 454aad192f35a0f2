#include "FlatteningReport.h"

#include "Error.h"
#include "Plane.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace crossfield
{
std::string DescribeStretch(const FlatteningReport& report, const std::string& remedy)
{
  if (!(report.predictedStrain > 0.0))
  {
    return {};
  }
  const auto largest = std::max_element(report.loopDefects.begin(), report.loopDefects.end(),
    [](double a, double b) { return std::abs(a) < std::abs(b); });
  std::ostringstream text;
  text << "Quads are stretched by about " << std::fixed << std::setprecision(1)
       << report.PredictedStretch() << " : 1, because the grid lines around inner loop "
       << largest - report.loopDefects.begin() + 1 << " do not close up by " << std::setprecision(0)
       << std::abs(*largest) * 180.0 / Pi << "°";
  return Sentence(text.str(), remedy);
}
}
