#include "ReportJson.h"

#include "vtkCrossFieldArrayNames.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <nlohmann/json.hpp>

#include <cctype>
#include <set>

namespace
{
using Json = nlohmann::ordered_json;

std::string SnakeCase(const std::string& name)
{
  std::string result;
  for (char letter : name)
  {
    if (std::isupper(static_cast<unsigned char>(letter)) != 0 && !result.empty())
    {
      result += '_';
    }
    result += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return result;
}

Json Number(vtkDataArray* array, vtkIdType tuple, int component)
{
  const double value = array->GetComponent(tuple, component);
  if (array->GetDataType() == VTK_INT)
  {
    return static_cast<long long>(value);
  }
  return value;
}

Json Tuple(vtkDataArray* array, vtkIdType tuple)
{
  if (array->GetNumberOfComponents() == 1)
  {
    return Number(array, tuple, 0);
  }
  Json list = Json::array();
  for (int i = 0; i < array->GetNumberOfComponents(); ++i)
  {
    list.push_back(Number(array, tuple, i));
  }
  return list;
}

Json Value(vtkDataArray* array)
{
  namespace names = vtkCrossFieldArrayNames;
  static const std::set<std::string> flags = { names::Converged, names::Consistent,
    names::DegreesReached, names::StartedFromUnitNorm, names::UnitHoles };
  static const std::set<std::string> lists = { names::HoleDegree, names::HoleNormRange,
    names::HolonomyDefect };
  if (flags.count(array->GetName()) != 0)
  {
    return array->GetComponent(0, 0) != 0.0;
  }
  if (lists.count(array->GetName()) == 0)
  {
    return Tuple(array, 0);
  }
  Json list = Json::array();
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    list.push_back(Tuple(array, i));
  }
  return list;
}
}

namespace ReportJson
{
std::string Write(vtkFieldData* data, const std::map<std::string, long long>& counts,
  const std::map<std::string, double>& seconds)
{
  Json report = Json::object();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = data->GetArray(i))
    {
      report[SnakeCase(array->GetName())] = Value(array);
    }
  }
  for (const auto& [name, count] : counts)
  {
    report[name] = count;
  }
  if (!seconds.empty())
  {
    report["seconds"] = seconds;
  }
  return report.dump(2) + "\n";
}

std::string AddSingularities(const std::string& report, vtkPolyData* singularities, bool hasHeight)
{
  Json json = Json::parse(report);
  vtkDataArray* quarters =
    singularities->GetPointData()->GetArray(vtkCrossFieldArrayNames::QuarterIndex);
  json["singularities"] = Json::array();
  for (vtkIdType i = 0; i < singularities->GetNumberOfPoints(); ++i)
  {
    const double* place = singularities->GetPoint(i);
    json["singularities"].push_back(
      { { "x", place[0] }, { "y", place[1] }, { "quarter_index", Number(quarters, i, 0) } });
    if (hasHeight)
    {
      json["singularities"].back()["z"] = place[2];
    }
  }
  return json.dump(2) + "\n";
}
}
