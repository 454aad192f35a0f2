#include "ReportJson.h"

#include "CommandLine.h"
#include "DomainReader.h"
#include "JsonText.h"
#include "ReportSchema.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <optional>

namespace
{
using Json = nlohmann::ordered_json;
using OptionalJson = std::optional<Json>; // without a value the key is left out

const Json& Schema()
{
  static const Json schema = Json::parse(ReportSchema);
  return schema;
}

/** Place where entries read their arrays: field data, or a row of a table or of points. */
struct Place
{
  vtkFieldData* arrays = nullptr;
  vtkDataSet* points = nullptr;
  vtkIdType row = 0;
};

/** Converts a value of an array; `kind` is number, integer, flag, text or the plural of these. */
Json Convert(vtkAbstractArray* array, vtkIdType index, const std::string& kind)
{
  if (auto* texts = vtkStringArray::SafeDownCast(array))
  {
    return texts->GetValue(index);
  }
  const int components = array->GetNumberOfComponents();
  const double value = vtkDataArray::SafeDownCast(array)->GetComponent(
    index / components, static_cast<int>(index % components));
  if (kind.front() == 'i')
  {
    return static_cast<long long>(value);
  }
  return kind.front() == 'f' ? Json(value != 0.0) : Json(value);
}

/** Evaluates the entries of the table for the sources of a run. */
class Reader
{
public:
  explicit Reader(const ReportJson::Sources& sources)
    : Sources(sources)
  {
    const auto hasHeight = [](vtkDataObject* data)
    {
      return data != nullptr && data->IsA("vtkDataSet") &&
        DomainReader::HasHeight(vtkDataSet::SafeDownCast(data));
    };
    this->HasHeight = hasHeight(sources.data) ||
      std::any_of(sources.others.begin(), sources.others.end(),
        [&](const auto& other) { return hasHeight(other.second); });
  }

  /** Adds the entries whose keys the object does not have yet. */
  void Fill(const Json& entries, const Place& place, Json& object) const
  {
    for (const auto& [key, entry] : entries.items())
    {
      if (object.contains(key))
      {
        continue;
      }
      if (entry.is_array() && entry[0] == "if")
      {
        const OptionalJson flag = this->Evaluate({ "flag", entry[1] }, place);
        this->Fill(flag == true ? entry[2] : Json::object(), place, object);
      }
      else if (const OptionalJson value = this->Evaluate(entry, place))
      {
        object[key] = *value;
      }
    }
  }

  Place FieldData() const { return { this->Sources.data->GetFieldData() }; }

  OptionalJson Evaluate(const Json& entry, const Place& place) const
  {
    if (entry.is_object())
    {
      Json object = Json::object();
      this->Fill(entry, place, object);
      return object.empty() ? OptionalJson() : object;
    }
    const std::string kind = entry[0];
    if (kind.find("rows") != std::string::npos)
    {
      return this->Rows(entry, place);
    }
    if (kind == "columns")
    {
      return this->Columns(entry[1], place);
    }
    if (kind == "coordinate")
    {
      const int axis = entry[1];
      return axis < 2 || this->HasHeight ? Json(place.points->GetPoint(place.row)[axis])
                                         : OptionalJson();
    }
    if (kind == "triangles")
    {
      return CountTriangles(vtkUnstructuredGrid::SafeDownCast(this->Sources.data));
    }
    if (kind == "stages" || kind == "seconds")
    {
      return this->Seconds(entry);
    }
    return this->FromArray(entry, place);
  }

private:
  vtkDataObject* Source(const std::string& name) const
  {
    const auto other = this->Sources.others.find(name);
    return name.empty()                     ? this->Sources.data
      : other == this->Sources.others.end() ? nullptr
                                            : other->second;
  }

  /** Returns the array of a name, or of source/name, or null. */
  vtkAbstractArray* Array(const std::string& name, const Place& place) const
  {
    const std::size_t slash = name.find('/');
    if (slash == std::string::npos)
    {
      return place.arrays->GetAbstractArray(name.c_str());
    }
    vtkDataObject* source = this->Source(name.substr(0, slash));
    return source == nullptr
      ? nullptr
      : source->GetFieldData()->GetAbstractArray(name.substr(slash + 1).c_str());
  }

  OptionalJson FromArray(const Json& entry, const Place& place) const
  {
    const std::string kind = entry[0];
    vtkAbstractArray* array = this->Array(entry[1], place);
    if (kind == "counts")
    {
      return this->Counts(array, this->Array(entry[2], place));
    }
    if (kind.back() == 's')
    {
      return array == nullptr && entry.size() < 3 ? OptionalJson() : List(array, kind);
    }
    if (array == nullptr)
    {
      return {};
    }
    const vtkIdType index = place.row * array->GetNumberOfComponents() +
      (entry.size() > 2 ? entry[2].get<vtkIdType>() : 0);
    if (kind == "file")
    {
      return this->Sources.files[Convert(array, index, "integer").get<std::size_t>()];
    }
    return Convert(array, index, kind);
  }

  static Json List(vtkAbstractArray* array, const std::string& kind)
  {
    Json list = Json::array();
    for (vtkIdType i = 0; array != nullptr && i < array->GetNumberOfTuples(); ++i)
    {
      const int components = array->GetNumberOfComponents();
      Json tuple = Json::array();
      for (int j = 0; j < components; ++j)
      {
        tuple.push_back(Convert(array, i * components + j, kind));
      }
      list.push_back(components == 1 ? tuple[0] : tuple);
    }
    return list;
  }

  static Json Counts(vtkAbstractArray* valences, vtkAbstractArray* counts)
  {
    Json object = Json::object();
    for (vtkIdType i = 0; i < valences->GetNumberOfTuples(); ++i)
    {
      const Json count = Convert(counts, i, "integer");
      if (count > 0)
      {
        object[Convert(valences, i, "integer").dump()] = count;
      }
    }
    return object;
  }

  OptionalJson Seconds(const Json& entry) const
  {
    if (entry[0] == "seconds")
    {
      return this->Sources.seconds.at(entry[1]);
    }
    Json object = Json::object();
    for (std::size_t i = 1; i < entry.size(); ++i)
    {
      object[entry[i].get<std::string>()] = this->Sources.seconds.at(i - 1);
    }
    return object;
  }

  OptionalJson Rows(const Json& entry, const Place& outer) const
  {
    const std::string kind = entry[0];
    vtkDataObject* source = this->Source(entry[1]);
    if (source == nullptr)
    {
      return {};
    }
    Place place;
    place.points = vtkDataSet::SafeDownCast(source);
    auto* table = vtkTable::SafeDownCast(source);
    place.arrays = table != nullptr ? static_cast<vtkFieldData*>(table->GetRowData())
                                    : place.points->GetPointData();
    const vtkIdType count =
      table != nullptr ? table->GetNumberOfRows() : place.points->GetNumberOfPoints();
    Json list = Json::array();
    Json object = Json::object();
    for (place.row = 0; place.row < count; ++place.row)
    {
      Json row = Json::object();
      this->Fill(entry[2], place, row);
      if (kind == "named rows")
      {
        object[Convert(this->Array(entry[3], place), place.row, "text").get<std::string>()] = row;
      }
      else if (kind == "rows" ||
        Convert(this->Array(entry[3], place), place.row, "integer") ==
          Convert(this->Array(entry[3], outer), outer.row, "integer"))
      {
        list.push_back(row);
      }
    }
    return kind == "named rows" ? object : list;
  }

  /** Returns the rows of the arrays in the field data. */
  OptionalJson Columns(const Json& entries, const Place& outer) const
  {
    vtkAbstractArray* first = this->Array((*entries.begin())[1], outer);
    if (first == nullptr)
    {
      return {};
    }
    Json list = Json::array();
    for (Place place = outer; place.row < first->GetNumberOfTuples(); ++place.row)
    {
      list.push_back(Json::object());
      this->Fill(entries, place, list.back());
    }
    return list;
  }

  const ReportJson::Sources& Sources;
  bool HasHeight;
};
}

namespace ReportJson
{
void AddCommon(const Sources& sources, Json& report)
{
  const Reader reader(sources);
  reader.Fill(Schema()["common"], reader.FieldData(), report);
}

std::string Write(const std::string& name, const Sources& sources)
{
  const Reader reader(sources);
  Json report = Json::object();
  reader.Fill(Schema()["reports"][name], reader.FieldData(), report);
  AddCommon(sources, report);
  return JsonText(report) + "\n";
}

std::string Write(const std::string& name, const std::string& key, const Sources& sources)
{
  const Reader reader(sources);
  const OptionalJson value = reader.Evaluate(Schema()["reports"][name][key], reader.FieldData());
  return value.has_value() ? JsonText(*value, -1) : "";
}
}
