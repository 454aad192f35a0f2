#ifndef ColumnWriting_h
#define ColumnWriting_h

#include "DomainPlane.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <string>
#include <vector>

/** Functions that create arrays. */
namespace ColumnWriting
{
/** Adds an array with a number of tuples and all components equal to `value`. */
template <class Array>
vtkSmartPointer<Array> NewArray(vtkFieldData* data, const char* name, int components,
  vtkIdType tuples, typename Array::ValueType value = 0)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  std::fill_n(array->GetPointer(0), tuples * components, value);
  data->AddArray(array);
  return array;
}

/** Adds an array with value(item) for each item. */
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

/** Adds an array with the given numbers. */
inline void AddNumbers(vtkFieldData* data, const char* name, const std::vector<double>& values)
{
  AddColumn<vtkDoubleArray>(data, name, values, [](double value) { return value; });
}

/** Adds an array with the given integers. */
inline void AddIntegers(vtkFieldData* data, const char* name, const std::vector<int>& values)
{
  AddColumn<vtkIntArray>(data, name, values, [](int value) { return value; });
}

/** Adds an array with one text. */
inline void AddText(vtkFieldData* data, const char* name, const std::string& text)
{
  AddColumn<vtkStringArray>(
    data, name, std::vector<std::string>{ text }, [](const std::string& value) { return value; });
}

/** Writes the positions of items in a plane as points in space, with a vertex cell each. */
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
