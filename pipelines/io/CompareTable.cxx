#include "CompareTable.h"

#include "CommandLine.h"
#include "Json.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldReport.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <map>
#include <sstream>

namespace
{
namespace names = vtkCrossFieldArrayNames;

int Integer(vtkUnstructuredGrid* field, const char* name)
{
  return static_cast<int>(FieldValue(field, name));
}

void ReadNormRange(vtkUnstructuredGrid* field, CompareRow& row)
{
  vtkDataArray* values = field->GetCellData()->GetArray(names::CrossFieldCR);
  row.normMinimum = VTK_DOUBLE_MAX;
  for (vtkIdType cell = 0; cell < values->GetNumberOfTuples(); ++cell)
  {
    for (int i = 0; i < 6; i += 2)
    {
      const double norm =
        std::hypot(values->GetComponent(cell, i), values->GetComponent(cell, i + 1));
      row.normMinimum = std::min(row.normMinimum, norm);
      row.normMaximum = std::max(row.normMaximum, norm);
    }
  }
}

/** Reads Σ |k| of the requested indices on holes and circles, and the part that the field has. */
void ReadDegrees(vtkUnstructuredGrid* field, CompareRow& row)
{
  vtkDataArray* kinds = field->GetCellData()->GetArray(names::BoundaryKind);
  vtkDataArray* ids = field->GetCellData()->GetArray(names::BoundaryId);
  vtkDataArray* quarters = field->GetCellData()->GetArray(names::QuarterIndex);
  std::map<int, int> requested;
  for (vtkIdType cell = 0; cell < field->GetNumberOfCells(); ++cell)
  {
    if (kinds->GetComponent(cell, 0) >= 3)
    {
      requested[static_cast<int>(ids->GetComponent(cell, 0))] =
        static_cast<int>(quarters->GetComponent(cell, 0));
    }
  }
  vtkDataArray* degrees = field->GetFieldData()->GetArray(names::HoleDegree);
  vtkIdType hole = 0;
  for (const auto& [id, quarter] : requested)
  {
    row.wanted += std::abs(quarter);
    row.reached +=
      static_cast<int>(degrees->GetComponent(hole, 0)) == quarter ? std::abs(quarter) : 0;
    ++hole;
  }
}

/** Returns JSON as text; bytes of notes that are not UTF-8 become the replacement character. */
std::string JsonText(const nlohmann::ordered_json& json, int indent)
{
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

using Fields = std::vector<std::pair<std::string, nlohmann::ordered_json>>;

Fields FieldsOf(const CompareRow& row)
{
  return { { "method", row.method }, { "energy", row.energy },
    { "gradient_energy", row.gradientEnergy }, { "norm_minimum", row.normMinimum },
    { "norm_maximum", row.normMaximum }, { "wanted", row.wanted }, { "reached", row.reached },
    { "unwanted", row.unwanted }, { "iterations", row.iterations }, { "seconds", row.seconds },
    { "converged", row.converged }, { "note", row.note } };
}
}

namespace CompareTable
{
CompareRow Read(const std::string& method, vtkUnstructuredGrid* field, vtkPolyData* found)
{
  CompareRow row;
  row.method = method;
  row.energy = FieldValue(field, names::Energy);
  row.gradientEnergy = field->GetFieldData()->GetArray(names::GradientEnergy) != nullptr
    ? FieldValue(field, names::GradientEnergy)
    : row.energy;
  ReadNormRange(field, row);
  row.unwanted = Integer(field, names::UnwantedSingularities);
  row.iterations = Integer(field, names::Iterations);
  row.converged = Integer(field, names::Converged) != 0;
  ReadDegrees(field, row);
  if (row.wanted == 0)
  {
    row.wanted = std::abs(Integer(field, names::RequiredInteriorQuarters));
    vtkDataArray* quarters = found->GetPointData()->GetArray(names::QuarterIndex);
    int size = 0;
    for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
    {
      size += std::abs(static_cast<int>(quarters->GetComponent(i, 0)));
    }
    row.reached = std::min(row.wanted, size);
  }
  return row;
}

std::string Text(const std::vector<CompareRow>& rows)
{
  std::ostringstream text;
  text << std::left << std::setw(26) << "method" << std::right << std::setw(11) << "energy"
       << std::setw(16) << "norm" << std::setw(8) << "wanted" << std::setw(9) << "unwanted"
       << std::setw(11) << "iterations" << std::setw(9) << "seconds"
       << "\n";
  for (const CompareRow& row : rows)
  {
    text << std::left << std::setw(26) << row.method << std::right;
    if (!row.note.empty())
    {
      text << "  refused: " << row.note << "\n";
      continue;
    }
    std::ostringstream norm;
    norm << std::fixed << std::setprecision(3) << row.normMinimum << " .. " << row.normMaximum;
    text << std::fixed << std::setprecision(4) << std::setw(11) << row.energy << std::setw(16)
         << norm.str() << std::setw(8)
         << std::to_string(row.reached) + "/" + std::to_string(row.wanted) << std::setw(9)
         << row.unwanted << std::setw(11) << row.iterations << std::setprecision(2) << std::setw(9)
         << row.seconds << (row.converged ? "" : "  NOT converged") << "\n";
  }
  return text.str();
}

std::string Csv(const std::vector<CompareRow>& rows)
{
  std::ostringstream text;
  const Fields header = FieldsOf(CompareRow());
  for (std::size_t i = 0; i < header.size(); ++i)
  {
    text << (i == 0 ? "" : ",") << header[i].first;
  }
  text << "\n";
  for (const CompareRow& row : rows)
  {
    const Fields fields = FieldsOf(row);
    for (std::size_t i = 0; i < fields.size(); ++i)
    {
      text << (i == 0 ? "" : ",") << JsonText(fields[i].second, -1);
    }
    text << "\n";
  }
  return text.str();
}

std::string Json(const std::vector<CompareRow>& rows, vtkDataObject* domain)
{
  nlohmann::ordered_json methods = nlohmann::ordered_json::array();
  for (const CompareRow& row : rows)
  {
    nlohmann::ordered_json object;
    for (const auto& [name, value] : FieldsOf(row))
    {
      object[name] = value;
    }
    methods.push_back(object);
  }
  nlohmann::ordered_json report = { { "methods", methods } };
  vtkNew<vtkCrossFieldReport> common;
  common->SetSource("domain", domain);
  report.update(nlohmann::ordered_json::parse(common->Write("")));
  return JsonText(report, 2) + "\n";
}
}
