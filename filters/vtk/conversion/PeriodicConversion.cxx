#include "PeriodicConversion.h"

#include "Error.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <algorithm>

namespace names = vtkCrossFieldArrayNames;

namespace PeriodicConversion
{
//------------------------------------------------------------------------------
std::vector<crossfield::PeriodicPair> Read(
  vtkFieldData* data, const std::vector<std::string>& sideNames)
{
  std::vector<crossfield::PeriodicPair> pairs;
  auto* sides = vtkStringArray::SafeDownCast(data->GetAbstractArray(names::PeriodicSides));
  vtkDataArray* motions = data->GetArray(names::PeriodicMotion);
  if (sides == nullptr && motions == nullptr)
  {
    return pairs;
  }
  if (sides == nullptr || motions == nullptr || motions->GetNumberOfComponents() != 16 ||
    sides->GetNumberOfValues() != 2 * motions->GetNumberOfTuples())
  {
    throw crossfield::Error(
      "The field data PeriodicSides and PeriodicMotion do not have two names and 16 numbers for "
      "each pair; remove both, or make the mesh again.");
  }
  const auto sideAt = [&](vtkIdType i)
  {
    const std::string name = sides->GetValue(i);
    const auto found = std::find(sideNames.begin(), sideNames.end(), name);
    if (found == sideNames.end())
    {
      throw crossfield::Error("The mesh has no side '" + name +
        "', which the field data PeriodicSides names; remove PeriodicSides and PeriodicMotion.");
    }
    return static_cast<int>(found - sideNames.begin());
  };
  for (vtkIdType pair = 0; pair < motions->GetNumberOfTuples(); ++pair)
  {
    crossfield::PeriodicPair one;
    one.first = sideAt(2 * pair);
    one.second = sideAt(2 * pair + 1);
    for (int i = 0; i < 16; ++i)
    {
      one.motion(i / 4, i % 4) = motions->GetComponent(pair, i);
    }
    pairs.push_back(one);
  }
  return pairs;
}
}
