#include "QuadBoundary.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace
{
vtkInformationIntegerKey* PortKey()
{
  static vtkInformationIntegerKey* const key =
    vtkInformationIntegerKey::MakeKey("BOUNDARY_PORT", "QuadBoundary");
  return key;
}

/** Returns whether two grids share their points and cells, as after a shallow copy. */
bool ShareCells(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* other)
{
  return grid != nullptr && other != nullptr && grid->GetPoints() == other->GetPoints() &&
    grid->GetCells() == other->GetCells();
}
}

namespace QuadBoundary
{
//------------------------------------------------------------------------------
void Declare(vtkInformation* quads, int boundaryPort)
{
  quads->Set(PortKey(), boundaryPort);
}

//------------------------------------------------------------------------------
vtkPolyData* Find(vtkAlgorithm* self)
{
  if (self->GetNumberOfInputConnections(1) > 0)
  {
    return vtkPolyData::SafeDownCast(self->GetInputDataObject(1, 0));
  }
  auto* quads = vtkUnstructuredGrid::SafeDownCast(self->GetInputDataObject(0, 0));
  for (vtkAlgorithm* consumer = self;
       consumer->GetNumberOfInputPorts() > 0 && consumer->GetNumberOfInputConnections(0) > 0;)
  {
    int port = 0;
    vtkAlgorithm* producer = consumer->GetInputAlgorithm(0, 0, port);
    vtkInformation* info = producer->GetOutputPortInformation(port);
    if (info->Has(PortKey()) &&
      ShareCells(quads, vtkUnstructuredGrid::SafeDownCast(producer->GetOutputDataObject(port))))
    {
      return vtkPolyData::SafeDownCast(producer->GetOutputDataObject(info->Get(PortKey())));
    }
    consumer = producer;
  }
  return nullptr;
}
}
