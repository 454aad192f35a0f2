#include "CheckOutput.h"

#include "CommandLine.h"
#include "PipelineRun.h"
#include "vtkBoundaryCornerClassifier.h"
#include "vtkConfigurationProposal.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldReport.h"
#include "vtkPoincareHopfCheck.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <iostream>

namespace names = vtkCrossFieldArrayNames;

namespace CheckOutput
{
void Print(vtkPoincareHopfCheck* check)
{
  vtkDataSet* domain = check->GetOutput();
  const char* const part =
    domain->GetFieldData()->HasArray(names::Valence) != 0 ? names::Valence : names::TotalCurvature;
  std::cout << "Euler characteristic " << FieldValue(domain, names::EulerCharacteristic)
            << (part == names::Valence ? ", valence " : ", total curvature ")
            << FieldValue(domain, part) << ", tangent turning "
            << FieldValue(domain, names::TangentTurning) << "\ninterior quarter indices: required "
            << FieldValue(domain, names::RequiredInteriorQuarters) << ", given "
            << FieldValue(domain, names::GivenInteriorQuarters) << "\n";
  auto* materials =
    vtkStringArray::SafeDownCast(domain->GetFieldData()->GetAbstractArray(names::RegionMaterial));
  for (vtkIdType r = 0; materials != nullptr && r < materials->GetNumberOfValues(); ++r)
  {
    const auto count = [&](const char* name)
    { return domain->GetFieldData()->GetArray(name)->GetTuple1(r); };
    std::cout << "  " << materials->GetValue(r) << ": required "
              << count(names::RegionRequiredInteriorQuarters) << ", given "
              << count(names::RegionGivenInteriorQuarters) << "\n";
  }
  auto* corners = vtkDataSet::SafeDownCast(check->GetOutputDataObject(2));
  for (vtkIdType i = 0; i < corners->GetNumberOfPoints(); ++i)
  {
    if (corners->GetPointData()->GetArray(names::Cancellable)->GetTuple1(i) != 0.0)
    {
      std::cout << "the corner at (" << corners->GetPoint(i)[0] << ", " << corners->GetPoint(i)[1];
      if (vtkCrossFieldReport::HasHeight(domain))
      {
        std::cout << ", " << corners->GetPoint(i)[2];
      }
      std::cout << ") can be cancelled by singularities in the domain\n";
    }
  }
  PrintAmbiguous(domain->GetFieldData());
  if (vtkDataArray* defects = domain->GetFieldData()->GetArray(names::HolonomyDefect))
  {
    for (vtkIdType i = 0; i < defects->GetNumberOfTuples(); ++i)
    {
      std::cout << "holonomy defect at "
                << (part == names::Valence ? "inner loop " : "loop or handle ") << i + 1 << ": "
                << defects->GetTuple1(i) << "\n";
    }
  }
}

vtkSmartPointer<vtkPolyData> AlternativePoints(vtkConfigurationProposal* proposal, int number)
{
  auto* all = vtkPolyData::SafeDownCast(proposal->GetOutputDataObject(3));
  vtkDataArray* numbers = all->GetPointData()->GetArray(names::Alternative);
  vtkDataArray* allQuarters = all->GetPointData()->GetArray(names::QuarterIndex);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIntArray> quarters;
  quarters->SetName(names::QuarterIndex);
  for (vtkIdType i = 0; i < all->GetNumberOfPoints(); ++i)
  {
    if (static_cast<int>(numbers->GetTuple1(i)) == number)
    {
      points->InsertNextPoint(all->GetPoint(i));
      quarters->InsertNextValue(static_cast<int>(allQuarters->GetTuple1(i)));
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->GetPointData()->AddArray(quarters);
  return result;
}

void PrintAlternatives(vtkTable* table)
{
  std::cout << "alternative singularities logarithm_coefficient renormalized_energy "
               "energy_at_core_radius holonomy_defect size_spread origin\n";
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    for (const char* name : { names::Alternative, names::Singularities, names::LogarithmCoefficient,
           names::RenormalizedEnergy, names::EnergyAtCoreRadius, names::HolonomyDefect,
           names::SizeSpread })
    {
      std::cout << table->GetValueByName(row, name).ToDouble() << " ";
    }
    std::cout << table->GetValueByName(row, names::Origin).ToString() << "\n";
  }
}

void PrintCornerHint(vtkAlgorithm* domain, double required)
{
  vtkNew<vtkBoundaryCornerClassifier> classifier;
  classifier->SetInputConnection(domain->GetOutputPort());
  PipelineRun::Update(classifier, "corners");
  const double cheapest = FieldValue(classifier->GetOutput(), names::InteriorQuarters);
  if (cheapest != required)
  {
    std::cout << "the cheapest quarter indices of the corners require " << cheapest
              << " in the interior instead; to use them, pass the file that `crossfield corners` "
                 "writes to --corners\n";
  }
}
}
