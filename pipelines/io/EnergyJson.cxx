#include "EnergyJson.h"

#include "DomainReader.h"
#include "JsonText.h"
#include "ReportJson.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkSingularityEnergy.h"
#include "vtkSingularityOptimizer.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

namespace
{
namespace names = vtkCrossFieldArrayNames;
using Json = nlohmann::ordered_json;
}

namespace EnergyJson
{
std::string Write(
  vtkSingularityEnergy* energy, const std::vector<std::string>& files, vtkDataSet* chosen)
{
  vtkTable* table = energy->GetOutput();
  auto* gradients = vtkPolyData::SafeDownCast(energy->GetOutputDataObject(1));
  vtkDataArray* owners = gradients->GetPointData()->GetArray(names::Configuration);
  Json list = Json::array();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const auto value = [&](const char* name)
    { return table->GetValueByName(row, name).ToDouble(); };
    const int number = table->GetValueByName(row, names::Configuration).ToInt();
    const bool consistent = value(names::Consistent) != 0.0;
    Json entry = Json::object();
    entry["file"] = files[static_cast<std::size_t>(number)];
    if (consistent)
    {
      entry["energy"] = value(names::Energy);
      entry["energy_degree_only"] = value(names::EnergyDegreeOnly);
      entry["energy_lower_bound"] = value(names::EnergyLowerBound);
      entry["energy_upper_bound"] = value(names::EnergyUpperBound);
      entry["energy_degree_only_lower_bound"] = value(names::EnergyDegreeOnlyLowerBound);
      entry["energy_degree_only_upper_bound"] = value(names::EnergyDegreeOnlyUpperBound);
      entry["logarithm_coefficient"] = value(names::LogarithmCoefficient);
      entry["renormalized_energy"] = value(names::RenormalizedEnergy);
      entry["core_radius"] = value(names::CoreRadius);
      entry["energy_at_core_radius"] = value(names::EnergyAtCoreRadius);
      entry["holonomy_defect"] = value(names::HolonomyDefect);
      entry["gradient"] = Json::array();
      for (vtkIdType i = 0; i < gradients->GetNumberOfPoints(); ++i)
      {
        if (static_cast<int>(owners->GetTuple1(i)) == number)
        {
          const double* gradient =
            gradients->GetPointData()->GetArray(names::Gradient)->GetTuple3(i);
          const double dx = gradient[0];
          const double dy = gradient[1];
          const double* place = gradients->GetPoint(i);
          entry["gradient"].push_back(
            { { "x", place[0] }, { "y", place[1] }, { "dx", dx }, { "dy", dy } });
        }
      }
    }
    entry["consistent"] = consistent;
    list.push_back(entry);
  }
  Json report = Json{ { "configurations", list } };
  if (chosen != nullptr)
  {
    ReportJson::AddSingularities(report, chosen,
      DomainReader::HasHeight(vtkDataSet::SafeDownCast(energy->GetInputDataObject(0, 0))));
  }
  return JsonText(report) + "\n";
}

std::string Write(vtkSingularityOptimizer* optimizer)
{
  vtkPolyData* output = optimizer->GetOutput();
  vtkFieldData* data = output->GetFieldData();
  const auto value = [data](const char* name) { return data->GetArray(name)->GetTuple1(0); };
  Json report = Json::object();
  report["renormalized_energy_before"] = value(names::RenormalizedEnergyBefore);
  report["renormalized_energy_after"] = value(names::RenormalizedEnergyAfter);
  if (data->HasArray(names::SizeSpreadBefore) != 0)
  {
    report["size_spread_before"] = value(names::SizeSpreadBefore);
    report["size_spread_after"] = value(names::SizeSpreadAfter);
    report["front"] = Json::array();
    vtkDataArray* counts = data->GetArray(names::FrontSingularities);
    for (vtkIdType i = 0; i < counts->GetNumberOfTuples(); ++i)
    {
      const auto number = [data, i](const char* name)
      { return data->GetArray(name)->GetTuple1(i); };
      report["front"].push_back({ { "singularities", static_cast<long long>(counts->GetTuple1(i)) },
        { "size_spread", number(names::FrontSizeSpread) },
        { "renormalized_energy", number(names::FrontRenormalizedEnergy) },
        { "holonomy_defect", number(names::FrontHolonomyDefect) } });
    }
  }
  report["iterations"] = static_cast<long long>(value(names::Iterations));
  report["converged"] = value(names::Converged) != 0.0;
  report["holonomy_defect"] = Json::array();
  vtkDataArray* defects = data->GetArray(names::HolonomyDefect);
  for (vtkIdType i = 0; i < defects->GetNumberOfTuples(); ++i)
  {
    report["holonomy_defect"].push_back(defects->GetTuple1(i));
  }
  report["annihilation"] = Json::array();
  vtkDataArray* pairs = data->GetArray(names::Annihilation);
  for (vtkIdType i = 0; i < pairs->GetNumberOfTuples(); ++i)
  {
    report["annihilation"].push_back({ static_cast<long long>(pairs->GetComponent(i, 0)),
      static_cast<long long>(pairs->GetComponent(i, 1)) });
  }
  report["reason"] =
    vtkStringArray::SafeDownCast(data->GetAbstractArray(names::Reason))->GetValue(0);
  report["events"] = Json::array();
  auto* events = vtkStringArray::SafeDownCast(data->GetAbstractArray(names::Events));
  for (vtkIdType i = 0; i < events->GetNumberOfValues(); ++i)
  {
    report["events"].push_back(events->GetValue(i));
  }
  report["singularities"] = Json::array();
  vtkDataArray* quarters = output->GetPointData()->GetArray(names::QuarterIndex);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double* place = output->GetPoint(i);
    report["singularities"].push_back({ { "x", place[0] }, { "y", place[1] },
      { "quarter_index", static_cast<long long>(quarters->GetTuple1(i)) } });
  }
  return JsonText(report) + "\n";
}
}
