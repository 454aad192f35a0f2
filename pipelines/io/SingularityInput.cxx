#include "SingularityInput.h"

#include "BoundaryInput.h"
#include "DomainReader.h"
#include "OutputFile.h"
#include "PipelineRun.h"
#include "vtkConfigurationProposal.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkQuadMesher.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <iostream>

namespace names = vtkCrossFieldArrayNames;

SingularityInput::SingularityInput(
  const std::string& file, vtkAlgorithm* domain, double size, const std::string& corners)
  : Domain(domain)
{
  if (!file.empty())
  {
    this->Source = DomainReader::OpenPoints(file);
    BoundaryInput::Keep(domain, this->Source);
    if (!corners.empty())
    {
      this->Corners = DomainReader::OpenPoints(corners);
      BoundaryInput::Keep(domain, this->Corners);
    }
    return;
  }
  this->Proposal = vtkSmartPointer<vtkConfigurationProposal>::New();
  this->Proposal->SetInputConnection(domain->GetOutputPort());
  this->Proposal->AutomaticOn();
  this->Proposal->SetMeshSize(size);
  if (!corners.empty())
  {
    const auto given = DomainReader::OpenPoints(corners);
    this->Proposal->SetCornersConnection(given->GetOutputPort());
    BoundaryInput::Keep(domain, given);
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

void SingularityInput::SetQuads(double clearance, vtkQuadMesher* mesher)
{
  if (this->AreChosen())
  {
    this->Proposal->SetClearance(clearance);
    this->Proposal->SetQuadSize(mesher->GetQuadSize());
    this->Proposal->SetQuadCount(mesher->GetQuadCount());
    this->Proposal->SetSizing(mesher->GetSizing());
    this->Proposal->SetSizeArray(mesher->GetSizeArray());
    this->Proposal->SetPairs(mesher->GetPairs());
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

void SingularityInput::TakeRepaired(vtkFieldData* field)
{
  vtkDataArray* places = field->GetArray(names::RepairedPositions);
  auto* given = vtkPointSet::SafeDownCast(this->GetOutput());
  if (places == nullptr || given == nullptr)
  {
    return;
  }
  const auto moved = vtk::TakeSmartPointer(given->NewInstance());
  moved->DeepCopy(given);
  for (vtkIdType i = 0; i < places->GetNumberOfTuples(); ++i)
  {
    moved->GetPoints()->SetPoint(i, places->GetTuple3(i));
  }
  this->Repaired = moved;
  this->RepairDistance = field->GetArray(names::RepairDistance)->GetTuple1(0);
}

std::vector<std::string> SingularityInput::GetEvents() const
{
  std::vector<std::string> events;
  auto* array = vtkStringArray::SafeDownCast(
    this->GetOutput()->GetFieldData()->GetAbstractArray(names::Events));
  for (vtkIdType i = 0; array != nullptr && i < array->GetNumberOfValues(); ++i)
  {
    events.push_back(array->GetValue(i));
  }
  return events;
}

void SingularityInput::PrintChoice() const
{
  if (this->Repaired != nullptr)
  {
    std::cout << "The singularities moved by up to " << this->RepairDistance
              << " to repair the holonomy.\n";
  }
  if (!this->AreChosen())
  {
    return;
  }
  for (const std::string& event : this->GetEvents())
  {
    std::cout << event << "\n";
  }
  PrintSingularities(this->GetOutput(),
    DomainReader::HasHeight(vtkDataSet::SafeDownCast(this->Domain->GetOutputDataObject(0))));
}

void SingularityInput::Save(const std::string& file, OutputTransaction& outputs) const
{
  if (file.empty())
  {
    return;
  }
  OutputFile::WriteConfiguration(this->GetOutput(),
    DomainReader::HasHeight(vtkDataSet::SafeDownCast(this->Domain->GetOutputDataObject(0))), file,
    outputs);
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
