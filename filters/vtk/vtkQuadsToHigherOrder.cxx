#include "vtkQuadsToHigherOrder.h"

#include "FilterPorts.h"
#include "FilterRun.h"
#include "HigherOrderConversion.h"
#include "QuadBoundary.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <string>

vtkStandardNewMacro(vtkQuadsToHigherOrder);

//------------------------------------------------------------------------------
vtkQuadsToHigherOrder::vtkQuadsToHigherOrder()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkQuadsToHigherOrder::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::AcceptMesh(info) : FilterPorts::AcceptOptionalBoundary(info);
}

//------------------------------------------------------------------------------
int vtkQuadsToHigherOrder::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  return FilterRun::Run(this, this->ErrorCode, input,
    [&](const crossfield::Progress& progress)
    {
      vtkNew<vtkUnstructuredGrid> mesh;
      HigherOrderConversion::Join(input, QuadBoundary::Find(this), mesh);
      progress.Report(0.1);
      const HigherOrderConversion::Quads quads = HigherOrderConversion::ReadQuads(mesh);
      if (this->Order == 1)
      {
        vtkUnstructuredGrid::GetData(outputVector)->ShallowCopy(mesh);
        return;
      }
      const crossfield::CurvedQuads curved =
        crossfield::RaiseOrder(quads.straight, this->Order, progress.Part(0.1, 0.9));
      if (curved.inverted > 0)
      {
        vtkWarningMacro(<< HigherOrderConversion::DescribeInverted(curved));
      }
      HigherOrderConversion::WriteQuads(
        quads, curved, mesh, vtkUnstructuredGrid::GetData(outputVector));
    });
}

//------------------------------------------------------------------------------
void vtkQuadsToHigherOrder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Order: " << this->Order << "\n";
}
