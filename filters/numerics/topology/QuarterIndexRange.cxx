#include "QuarterIndexRange.h"

#include "Error.h"

#include <cmath>
#include <sstream>

namespace crossfield
{
int RequireQuarterIndex(double value, const std::string& what, const std::string& examples)
{
  if (!std::isfinite(value) || std::floor(value) != value)
  {
    throw Error(what + " is not an integer; give 4 times its index, for example " + examples + ".");
  }
  if (std::abs(value) > MaximumQuarterIndex)
  {
    std::ostringstream text;
    text.precision(10); // the digits of any int
    text << what << " is " << value << ", and meshes resolve none beyond " << MaximumQuarterIndex
         << "; give a smaller one.";
    throw Error(text.str());
  }
  return static_cast<int>(value);
}
}
