#include "SingularityInput.h"

#include "BoundaryInput.h"
#include "CommandLine.h"
#include "DomainReader.h"
#include "OutputFile.h"
#include "PipelineRun.h"
#include "vtkConfigurationProposal.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldReport.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkVariant.h"

#include <iostream>

namespace names = vtkCrossFieldArrayNames;

SingularityInput::SingularityInput(
  const std::string& file, vtkAlgorithm* domain, double size, const std::string& corners)
  : Domain(domain)
{
  if (!file.empty())
  {
    this->Source = OpenPointsOf(domain, file);
    if (!corners.empty())
    {
      this->Corners = OpenPointsOf(domain, corners);
    }
    return;
  }
  this->Proposal = vtkSmartPointer<vtkConfigurationProposal>::New();
  this->Proposal->SetInputConnection(domain->GetOutputPort());
  this->Proposal->AutomaticOn();
  this->Proposal->SetMeshSize(size);
  if (!corners.empty())
  {
    this->Proposal->SetCornersConnection(OpenPointsOf(domain, corners)->GetOutputPort());
  }
  this->Source = this->Proposal;
  this->Corners = this->Proposal;
  this->CornerPort = 1;
}

SingularityInput::SingularityInput(vtkAlgorithm* source)
  : Source(source)
{
}

void SingularityInput::SetCapCorners(bool cap)
{
  if (this->AreChosen())
  {
    this->Proposal->SetCapCorners(cap);
  }
}

void SingularityInput::Update()
{
  PipelineRun::Update(this->Source, this->AreChosen() ? "choosing" : "reading");
}

vtkDataSet* SingularityInput::GetOutput() const
{
  if (this->Repaired != nullptr)
  {
    return this->Repaired;
  }
  return vtkDataSet::SafeDownCast(this->Source->GetOutputDataObject(0));
}

void SingularityInput::ApplyRepair(vtkFieldData* field)
{
  vtkDataArray* positions = field->GetArray(names::RepairedPositions);
  auto* given = vtkPointSet::SafeDownCast(this->GetOutput());
  if (positions == nullptr || given == nullptr)
  {
    return;
  }
  const auto moved = vtk::TakeSmartPointer(given->NewInstance());
  moved->DeepCopy(given);
  for (vtkIdType i = 0; i < positions->GetNumberOfTuples(); ++i)
  {
    moved->GetPoints()->SetPoint(i, positions->GetTuple3(i));
  }
  this->Repaired = moved;
  this->RepairReport = field;
}

bool SingularityInput::HasHeight() const
{
  return vtkCrossFieldReport::HasHeight(this->Domain->GetOutputDataObject(0));
}

void SingularityInput::PrintChoice(bool verbose) const
{
  if (!verbose)
  {
    return;
  }
  if (this->RepairReport != nullptr)
  {
    PrintRepair(this->RepairReport);
  }
  if (this->AreChosen())
  {
    PrintChosen(this->GetOutput(), this->HasHeight());
  }
}

void SingularityInput::Save(const std::string& file, OutputTransaction& outputs) const
{
  if (!file.empty())
  {
    OutputFile::WriteConfiguration(this->GetOutput(), this->HasHeight(), file, outputs);
  }
}

vtkSmartPointer<vtkAlgorithm> OpenPointsOf(vtkAlgorithm* domain, const std::string& file)
{
  const auto points = DomainReader::OpenPoints(file);
  BoundaryInput::Keep(domain, points);
  return points;
}

void PrintRepair(vtkFieldData* field)
{
  vtkDataArray* defects = field->GetArray(names::DefectBefore);
  vtkDataArray* distance = field->GetArray(names::RepairDistance);
  if (distance != nullptr && defects != nullptr && defects->GetNumberOfTuples() > 0)
  {
    std::cout << "The singularities moved by up to " << distance->GetTuple1(0)
              << " to repair the holonomy.\n";
  }
}

void PrintStretch(vtkFieldData* field)
{
  if (vtkAbstractArray* reason = field->GetAbstractArray(names::StretchReason))
  {
    std::cout << reason->GetVariantValue(0).ToString() << "\n";
  }
}

void PrintChosen(vtkDataSet* singularities, bool hasHeight)
{
  PrintEvents(singularities);
  PrintSingularities(singularities, hasHeight);
}

void PrintSingularities(vtkDataSet* singularities, bool hasHeight)
{
  for (vtkIdType i = 0; i < singularities->GetNumberOfPoints(); ++i)
  {
    const double* place = singularities->GetPoint(i);
    std::cout << "quarter index "
              << singularities->GetPointData()->GetArray(names::QuarterIndex)->GetComponent(i, 0)
              << " at " << place[0] << " " << place[1];
    if (hasHeight)
    {
      std::cout << " " << place[2];
    }
    std::cout << "\n";
  }
}
