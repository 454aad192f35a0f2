#include "ReportJson.h"

#include "CommandLine.h"
#include "DomainReader.h"
#include "JsonText.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

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
  static const std::set<std::string> lists = { names::HoleDegree, names::HoleDegreeReliable,
    names::HoleNormRange, names::HolonomyDefect, names::PointSingularities };
  if (flags.count(array->GetName()) != 0)
  {
    return array->GetComponent(0, 0) != 0.0;
  }
  if (lists.count(array->GetName()) == 0)
  {
    return Tuple(array, 0);
  }
  Json list = Json::array();
  const bool flag = array->GetName() == std::string(names::HoleDegreeReliable);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    list.push_back(flag ? Json(array->GetComponent(i, 0) != 0.0) : Tuple(array, i));
  }
  return list;
}

Json Singularities(vtkDataSet* points, bool hasHeight)
{
  vtkDataArray* quarters = points->GetPointData()->GetArray(vtkCrossFieldArrayNames::QuarterIndex);
  Json list = Json::array();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double* place = points->GetPoint(i);
    list.push_back({ { "x", place[0] }, { "y", place[1] },
      { "quarter_index", static_cast<long long>(quarters->GetComponent(i, 0)) } });
    if (hasHeight)
    {
      list.back()["z"] = place[2];
    }
  }
  return list;
}
}

namespace ReportJson
{
void AddSingularities(Json& report, vtkDataSet* singularities, bool hasHeight)
{
  report["singularities"] = Singularities(singularities, hasHeight);
  if (auto* events = vtkStringArray::SafeDownCast(
        singularities->GetFieldData()->GetAbstractArray(vtkCrossFieldArrayNames::Events)))
  {
    report["events"] = Json::array();
    for (vtkIdType i = 0; i < events->GetNumberOfValues(); ++i)
    {
      report["events"].push_back(events->GetValue(i));
    }
  }
}

void AddRepair(Json& report, vtkFieldData* field)
{
  vtkDataArray* distance = field->GetArray(vtkCrossFieldArrayNames::RepairDistance);
  vtkDataArray* defects = field->GetArray(vtkCrossFieldArrayNames::DefectBefore);
  if (distance == nullptr || defects == nullptr)
  {
    return;
  }
  Json before = Json::array();
  for (vtkIdType i = 0; i < defects->GetNumberOfTuples(); ++i)
  {
    before.push_back(defects->GetTuple1(i));
  }
  report["repair"] = { { "distance", distance->GetTuple1(0) }, { "defect_before", before } };
}

std::string Write(vtkUnstructuredGrid* field, const std::map<std::string, double>& seconds,
  vtkDataSet* singularities)
{
  Json report = Json::object();
  vtkFieldData* data = field->GetFieldData();
  // Field data passes through filters; what is said of the domain is BoundaryInput's.
  namespace names = vtkCrossFieldArrayNames;
  const std::set<std::string> ofDomain = { names::BoundaryMoved, names::BoundaryPoints };
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (array != nullptr && ofDomain.count(array->GetName()) == 0)
    {
      report[SnakeCase(array->GetName())] = Value(array);
    }
  }
  report["triangles"] = CountTriangles(field);
  report["seconds"] = seconds;
  if (singularities != nullptr)
  {
    AddSingularities(report, singularities, DomainReader::HasHeight(field));
  }
  return JsonText(report) + "\n";
}
}
