#include "RegionValues.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <set>

//------------------------------------------------------------------------------
RegionValues RegionValues::Read(
  vtkDataSet* input, const std::string& array, const std::vector<vtkIdType>& cells)
{
  RegionValues result;
  vtkAbstractArray* materials = input->GetCellData()->GetAbstractArray(array.c_str());
  if (auto* texts = vtkStringArray::SafeDownCast(materials))
  {
    result.areNamed = true;
    std::map<std::string, int> numbers;
    for (const vtkIdType cell : cells)
    {
      const auto [found, isNew] =
        numbers.emplace(texts->GetValue(cell), static_cast<int>(numbers.size()));
      if (isNew)
      {
        result.names.push_back(found->first);
      }
      result.ofCell.push_back(found->second);
    }
    result.values.resize(result.names.size());
    std::iota(result.values.begin(), result.values.end(), 0);
    return result;
  }
  auto* integers = vtkDataArray::SafeDownCast(materials);
  for (const vtkIdType cell : cells)
  {
    result.ofCell.push_back(static_cast<int>(integers->GetTuple1(cell)));
  }
  const std::set<int> different(result.ofCell.begin(), result.ofCell.end());
  result.values.assign(different.begin(), different.end());
  std::map<int, int> numbers;
  for (const int value : result.values)
  {
    numbers.emplace(value, static_cast<int>(numbers.size()));
  }
  std::transform(result.ofCell.begin(), result.ofCell.end(), result.ofCell.begin(),
    [&numbers](int value) { return numbers.at(value); });
  std::transform(result.values.begin(), result.values.end(), std::back_inserter(result.names),
    [](int value) { return std::to_string(value); });
  return result;
}
