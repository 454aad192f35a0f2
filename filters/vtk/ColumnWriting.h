#ifndef ColumnWriting_h
#define ColumnWriting_h

#include "DomainPlane.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

/** Writes one value per item into arrays. */
namespace ColumnWriting
{
/** An array with one value per item. */
template <class Array, class Items, class Value>
void AddColumn(vtkFieldData* data, const char* name, const Items& items, Value value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->Allocate(static_cast<vtkIdType>(items.size()));
  for (const auto& item : items)
  {
    array->InsertNextValue(value(item));
  }
  data->AddArray(array);
}

/** Points of a plane, with a vertex cell each. */
template <class Items>
void WritePlaces(const Items& items, const crossfield::DomainPlane& plane, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (const auto& item : items)
  {
    vertices->InsertNextCell({ points->InsertNextPoint(plane.ToSpace(item.position).data()) });
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
}
}

#endif
