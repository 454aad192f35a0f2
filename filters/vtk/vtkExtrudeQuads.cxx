#include "vtkExtrudeQuads.h"

#include "ColumnWriting.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "QuadBoundary.h"
#include "SolverMeshReading.h"
#include "SolverMeshWriting.h"
#include "SweepQuads.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkExtrudeQuads);

namespace names = vtkCrossFieldArrayNames;

//------------------------------------------------------------------------------
vtkExtrudeQuads::vtkExtrudeQuads()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkExtrudeQuads::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::AcceptMesh(info) : FilterPorts::AcceptOptionalBoundary(info);
}

//------------------------------------------------------------------------------
int vtkExtrudeQuads::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkMultiBlockDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkExtrudeQuads::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  return FilterRun::Run(this, this->ErrorCode, input,
    [&](const crossfield::Progress& progress)
    {
      vtkNew<vtkUnstructuredGrid> grid;
      SolverMeshReading::Join(input, QuadBoundary::Find(this), grid);
      crossfield::Sweep sweep;
      sweep.kind =
        this->Motion == Translation ? crossfield::Sweep::Translation : crossfield::Sweep::Rotation;
      sweep.layers = this->Layers;
      sweep.height = this->Height;
      sweep.angle = this->Angle;
      sweep.ratio = this->Ratio;
      if (this->Axis == AxisY)
      {
        sweep.axisDirection = { 0.0, 1.0 };
      }
      else if (this->Axis == AxisLine)
      {
        sweep.axisPoint = { this->AxisPoint1[0], this->AxisPoint1[1] };
        sweep.axisDirection =
          crossfield::Point(this->AxisPoint2[0], this->AxisPoint2[1]) - sweep.axisPoint;
      }
      progress.Report(0.2);
      const crossfield::SolverMesh swept =
        crossfield::SweepQuads(SolverMeshReading::Read(grid), sweep);
      progress.Report(0.6);
      vtkNew<vtkMultiBlockDataSet> blocks;
      SolverMeshWriting::WriteBlocks(swept, blocks);
      vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
      SolverMeshWriting::WriteMesh(swept, grid, output);
      if (this->Motion == Translation)
      {
        ColumnWriting::AddNumbers(output->GetFieldData(), names::SweepHeight, { this->Height });
      }
      else
      {
        ColumnWriting::AddNumbers(output->GetFieldData(), names::SweepAngle, { this->Angle });
      }
      vtkMultiBlockDataSet::GetData(outputVector, 1)->ShallowCopy(blocks);
    });
}

//------------------------------------------------------------------------------
void vtkExtrudeQuads::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Motion: " << this->Motion << "\n";
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "Ratio: " << this->Ratio << "\n";
  os << indent << "Angle: " << this->Angle << "\n";
  os << indent << "Axis: " << this->Axis << "\n";
  os << indent << "AxisPoint1: " << this->AxisPoint1[0] << " " << this->AxisPoint1[1] << "\n";
  os << indent << "AxisPoint2: " << this->AxisPoint2[0] << " " << this->AxisPoint2[1] << "\n";
}
