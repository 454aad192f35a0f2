#include "TopologyJson.h"

#include "DomainReader.h"
#include "JsonText.h"
#include "vtkBoundaryCornerClassifier.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkPoincareHopfCheck.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <cmath>
#include <utility>
#include <vector>

namespace
{
namespace names = vtkCrossFieldArrayNames;
using Json = nlohmann::ordered_json;

/** What an entry of the report is: how it is written, and the array it comes from. */
enum class Kind
{
  Integer,
  Number,
  Flag
};
struct Entry
{
  const char* key;
  const char* array;
  Kind kind;
};
using Entries = std::vector<Entry>;

Json Value(vtkDataArray* array, vtkIdType tuple, Kind kind)
{
  const double value = array->GetTuple1(tuple);
  switch (kind)
  {
  case Kind::Integer:
    return static_cast<long long>(value);
  case Kind::Flag:
    return value != 0.0;
  default:
    return value;
  }
}

std::string Text(vtkFieldData* data, const char* name, vtkIdType tuple = 0)
{
  return vtkStringArray::SafeDownCast(data->GetAbstractArray(name))->GetValue(tuple);
}

/**
 * One object per tuple, with its place if there is one; entries whose array is missing or not a
 * number are left out.
 */
Json Rows(vtkFieldData* data, const Entries& entries, vtkIdType count, vtkDataSet* places = nullptr,
  bool hasHeight = false)
{
  Json rows = Json::array();
  for (vtkIdType i = 0; i < count; ++i)
  {
    Json row = Json::object();
    if (places != nullptr)
    {
      row["x"] = places->GetPoint(i)[0];
      row["y"] = places->GetPoint(i)[1];
    }
    if (hasHeight)
    {
      row["z"] = places->GetPoint(i)[2];
    }
    for (const auto& [key, name, kind] : entries)
    {
      vtkDataArray* array = data->GetArray(name);
      if (array != nullptr && std::isfinite(array->GetTuple1(i)))
      {
        row[key] = Value(array, i, kind);
      }
    }
    rows.push_back(row);
  }
  return rows;
}

/** Points of a domain. */
Json Points(vtkDataSet* points, const Entries& entries, vtkDataSet* domain)
{
  return Rows(points->GetPointData(), entries, points->GetNumberOfPoints(), points,
    DomainReader::HasHeight(domain));
}

Json List(vtkFieldData* data, const char* name, Kind kind)
{
  Json list = Json::array();
  if (vtkDataArray* array = data->GetArray(name))
  {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      list.push_back(Value(array, i, kind));
    }
  }
  return list;
}
}

namespace TopologyJson
{
std::string Write(vtkPoincareHopfCheck* check)
{
  vtkFieldData* data = check->GetOutput()->GetFieldData();
  Json report = Rows(data,
    { { "euler_characteristic", names::EulerCharacteristic, Kind::Integer },
      { "valence", names::Valence, Kind::Number },
      { "tangent_turning", names::TangentTurning, Kind::Number },
      { "required_interior_quarters", names::RequiredInteriorQuarters, Kind::Integer },
      { "given_interior_quarters", names::GivenInteriorQuarters, Kind::Integer },
      { "consistent", names::Consistent, Kind::Flag },
      { "unwanted_singularities", names::UnwantedSingularities, Kind::Integer } },
    1)[0];
  if (data->GetArray(names::HoleDegree) != nullptr)
  {
    report["hole_degree"] = List(data, names::HoleDegree, Kind::Integer);
    report["hole_degree_reliable"] = List(data, names::HoleDegreeReliable, Kind::Flag);
  }
  report["holonomy_defect"] = List(data, names::HolonomyDefect, Kind::Number);
  report["corners"] = Points(vtkDataSet::SafeDownCast(check->GetOutputDataObject(2)),
    { { "angle", names::Angle, Kind::Number },
      { "quarter_index", names::QuarterIndex, Kind::Integer },
      { "cancellable", names::Cancellable, Kind::Flag } },
    check->GetOutput());
  auto* loops = vtkTable::SafeDownCast(check->GetOutputDataObject(1));
  report["loops"] = Rows(loops->GetRowData(),
    { { "valence", names::Valence, Kind::Number },
      { "tangent_turning", names::TangentTurning, Kind::Number },
      { "corner_quarters", names::CornerQuarters, Kind::Integer },
      { "required_part", names::RequiredPart, Kind::Integer } },
    loops->GetNumberOfRows());
  report["reason"] = Text(data, names::Reason);
  return JsonText(report) + "\n";
}

std::string Write(vtkBoundaryCornerClassifier* classifier)
{
  vtkFieldData* data = classifier->GetOutput()->GetFieldData();
  auto* domain = vtkDataSet::SafeDownCast(classifier->GetInput());
  Json report = Json::object();
  report["scenario"] = Text(data, names::Scenario);
  report["energy"] = data->GetArray(names::Energy)->GetTuple1(0);
  report["interior_quarters"] = List(data, names::InteriorQuarters, Kind::Integer)[0];
  auto* table = vtkTable::SafeDownCast(classifier->GetOutputDataObject(1));
  const Json rows = Rows(table->GetRowData(),
    { { "sum", names::Sum, Kind::Integer }, { "energy", names::Energy, Kind::Number },
      { "feasible", names::Feasible, Kind::Flag } },
    table->GetNumberOfRows());
  report["scenarios"] = Json::object();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    report["scenarios"][Text(table->GetRowData(), names::Scenario, row)] =
      rows[static_cast<std::size_t>(row)];
  }
  report["corners"] = Points(classifier->GetOutput(),
    { { "angle", names::Angle, Kind::Number },
      { "quarter_index", names::QuarterIndex, Kind::Integer },
      { "quarter_index_scarce", names::QuarterIndexScarce, Kind::Integer },
      { "quarter_index_balanced", names::QuarterIndexBalanced, Kind::Integer },
      { "quarter_index_excess", names::QuarterIndexExcess, Kind::Integer },
      { "quarter_index_conventional", names::QuarterIndexConventional, Kind::Integer },
      { "corner_energy", names::CornerEnergy, Kind::Number },
      { "cancellable", names::Cancellable, Kind::Flag }, { "tied", names::Tied, Kind::Flag },
      { "overridden", names::Overridden, Kind::Flag } },
    domain);
  report["split"] = Points(vtkDataSet::SafeDownCast(classifier->GetOutputDataObject(2)),
    { { "quarter_index", names::QuarterIndex, Kind::Integer } }, domain);
  return JsonText(report) + "\n";
}
}
