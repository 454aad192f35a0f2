#include "vtkBoundaryCornerClassifier.h"

#include "ConfigurationConversion.h"
#include "CornerConversion.h"
#include "DomainConversion.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "QuarterIndexRange.h"

#include "vtkDataSet.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <cmath>
#include <string>

vtkStandardNewMacro(vtkBoundaryCornerClassifier);

namespace
{
int RequireInteger(double quarterIndex)
{
  return crossfield::RequireQuarterIndex(
    quarterIndex, "The quarter index that was given for a corner", "1 or 0");
}

/** Sets a row of a list, which grows as needed. */
template <class Row>
void SetRow(std::vector<Row>& rows, int row, const Row& value)
{
  if (static_cast<std::size_t>(row) >= rows.size())
  {
    rows.resize(static_cast<std::size_t>(row) + 1, value);
  }
  rows[row] = value;
}
}

//------------------------------------------------------------------------------
vtkBoundaryCornerClassifier::vtkBoundaryCornerClassifier()
{
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
void vtkBoundaryCornerClassifier::SetOverride(int row, double x, double y, double quarterIndex)
{
  if (row < 0)
  {
    vtkErrorMacro("The row of an override must not be negative.");
    return;
  }
  SetRow(this->Overrides, row, { x, y, quarterIndex });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkBoundaryCornerClassifier::AddOverride(double x, double y, double quarterIndex)
{
  this->SetOverride(static_cast<int>(this->Overrides.size()), x, y, quarterIndex);
}

//------------------------------------------------------------------------------
void vtkBoundaryCornerClassifier::RemoveAllOverrides()
{
  this->Overrides.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkBoundaryCornerClassifier::SetPointOverride(int row, vtkIdType pointId, double quarterIndex)
{
  if (row < 0)
  {
    vtkErrorMacro("The row of an override must not be negative.");
    return;
  }
  SetRow(this->PointOverrides, row, { static_cast<double>(pointId), quarterIndex });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkBoundaryCornerClassifier::AddPointOverride(vtkIdType pointId, double quarterIndex)
{
  this->SetPointOverride(static_cast<int>(this->PointOverrides.size()), pointId, quarterIndex);
}

//------------------------------------------------------------------------------
void vtkBoundaryCornerClassifier::RemoveAllPointOverrides()
{
  this->PointOverrides.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkBoundaryCornerClassifier::FillInputPortInformation(int, vtkInformation* info)
{
  return FilterPorts::AcceptDomain(info);
}

//------------------------------------------------------------------------------
int vtkBoundaryCornerClassifier::FillOutputPortInformation(int port, vtkInformation* info)
{
  return FilterPorts::Produce(info, port == 1 ? "vtkTable" : "vtkPolyData");
}

//------------------------------------------------------------------------------
int vtkBoundaryCornerClassifier::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* domain = vtkDataSet::GetData(inputVector[0]);
  return FilterRun::Run(this, this->ErrorCode, domain,
    [&](const crossfield::Progress& progress)
    {
      const DomainConversion::Domain input = DomainConversion::ReadDomain(domain, this);
      progress.Report(0.5);
      crossfield::ClassificationOptions options;
      options.cornerAngle = vtkMath::RadiansFromDegrees(this->CornerAngle);
      options.splitHalves = this->SplitHalves;
      if (this->PrintedCoefficient)
      {
        options.coefficient = crossfield::InteriorCoefficient::Printed;
      }
      for (const auto& [x, y, quarterIndex] : this->Overrides)
      {
        options.overrides.push_back({ crossfield::Point(x, y), RequireInteger(quarterIndex) });
      }
      for (const auto& [pointId, quarterIndex] : this->PointOverrides)
      {
        const auto id = static_cast<vtkIdType>(pointId);
        if (id < 0 || id >= domain->GetNumberOfPoints())
        {
          throw crossfield::Error("A quarter index was given for point " + std::to_string(id) +
            " but the domain has no such point; give a point id below " +
            std::to_string(domain->GetNumberOfPoints()) + ".");
        }
        options.overrides.push_back({ input.plane.ToPlane(Eigen::Vector3d(domain->GetPoint(id))),
          RequireInteger(quarterIndex) });
      }
      const crossfield::CornerClassification classification =
        crossfield::ClassifyCorners(input.domain, options);
      CornerConversion::WriteCorners(
        classification, input.plane, vtkPolyData::GetData(outputVector, 0));
      CornerConversion::WriteScenarios(classification, vtkTable::GetData(outputVector, 1));
      ConfigurationConversion::WriteConfiguration(
        classification.split, input.plane, vtkPolyData::GetData(outputVector, 2));
    });
}

//------------------------------------------------------------------------------
void vtkBoundaryCornerClassifier::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "PrintedCoefficient: " << (this->PrintedCoefficient ? "on" : "off") << "\n";
  os << indent << "SplitHalves: " << (this->SplitHalves ? "on" : "off") << "\n";
  os << indent << "Overrides: " << this->Overrides.size() << "\n";
  for (const auto& [x, y, quarterIndex] : this->Overrides)
  {
    os << indent.GetNextIndent() << x << " " << y << " " << quarterIndex << "\n";
  }
  os << indent << "PointOverrides: " << this->PointOverrides.size() << "\n";
  for (const auto& [pointId, quarterIndex] : this->PointOverrides)
  {
    os << indent.GetNextIndent() << pointId << " " << quarterIndex << "\n";
  }
}
