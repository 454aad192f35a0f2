#include "CompositeInput.h"

#include "vtkAppendFilter.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

namespace CompositeInput
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> Append(vtkInformationVector* port)
{
  vtkCompositeDataSet* blocks = vtkCompositeDataSet::GetData(port);
  if (blocks == nullptr)
  {
    return vtkDataSet::GetData(port);
  }
  vtkNew<vtkAppendFilter> append;
  const auto block = vtk::TakeSmartPointer(blocks->NewIterator());
  for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
  {
    if (auto* data = vtkDataSet::SafeDownCast(block->GetCurrentDataObject()))
    {
      append->AddInputData(data);
    }
  }
  if (append->GetNumberOfInputConnections(0) == 0)
  {
    return vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  append->Update();
  return append->GetOutput();
}
}
