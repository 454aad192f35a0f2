#include "MaterialCheck.h"

#include "Error.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkStringArray.h"

#include <set>
#include <vector>

namespace
{
namespace names = vtkCrossFieldArrayNames;

bool CanBeMaterial(vtkAbstractArray* array)
{
  // Gmsh numbers the surfaces of a geometry; its materials are physical groups.
  static const std::set<std::string> others = { names::BoundaryKind, names::BoundaryId,
    names::QuarterIndex, names::BlockId, names::Part, names::I, names::J, names::K, names::FaceId,
    names::Irregular, names::Valence, "vtkGhostType", "vtkOriginalCellIds", "gmsh:geometrical" };
  auto* numbers = vtkDataArray::SafeDownCast(array);
  const bool isInteger = numbers != nullptr && numbers->GetDataType() != VTK_FLOAT &&
    numbers->GetDataType() != VTK_DOUBLE;
  return array != nullptr && array->GetName() != nullptr && array->GetNumberOfComponents() == 1 &&
    (isInteger || vtkStringArray::SafeDownCast(array) != nullptr) &&
    others.count(array->GetName()) == 0;
}

std::vector<vtkIdType> SurfaceCells(vtkDataSet* domain)
{
  const std::set<int> types = { VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON, VTK_PIXEL };
  std::vector<vtkIdType> cells;
  for (vtkIdType cell = 0; cell < domain->GetNumberOfCells(); ++cell)
  {
    if (types.count(domain->GetCellType(cell)) > 0)
    {
      cells.push_back(cell);
    }
  }
  return cells;
}

template <class Value>
std::size_t CountValues(const std::vector<vtkIdType>& cells, Value value)
{
  std::set<decltype(value(0))> values;
  for (const vtkIdType cell : cells)
  {
    values.insert(value(cell));
  }
  return values.size();
}

std::size_t CountValues(vtkAbstractArray* array, const std::vector<vtkIdType>& cells)
{
  if (auto* texts = vtkStringArray::SafeDownCast(array))
  {
    return CountValues(
      cells, [texts](vtkIdType cell) { return std::string(texts->GetValue(cell)); });
  }
  auto* numbers = vtkDataArray::SafeDownCast(array);
  return CountValues(cells, [numbers](vtkIdType cell) { return numbers->GetTuple1(cell); });
}
}

namespace MaterialCheck
{
//------------------------------------------------------------------------------
std::string FindArray(vtkDataSet* domain, const std::string& requested)
{
  vtkCellData* data = domain->GetCellData();
  if (requested == "none")
  {
    return {};
  }
  if (!requested.empty())
  {
    if (!CanBeMaterial(data->GetAbstractArray(requested.c_str())))
    {
      throw crossfield::Error("The domain has no cell array '" + requested +
        "' of strings or single integers with the materials of its cells; give the name of one, or none.");
    }
    return requested;
  }
  for (const char* name : { names::Material, names::Region })
  {
    vtkAbstractArray* array = data->GetAbstractArray(name);
    if (CanBeMaterial(array) && CountValues(array, SurfaceCells(domain)) > 1)
    {
      return name;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::string Warning(vtkDataSet* domain)
{
  vtkCellData* data = domain->GetCellData();
  std::vector<vtkIdType> surfaces;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (!CanBeMaterial(array))
    {
      continue;
    }
    surfaces = surfaces.empty() ? SurfaceCells(domain) : surfaces;
    const std::size_t count = CountValues(array, surfaces);
    if (count > 1 && count < surfaces.size())
    {
      return "The cells of the domain have " + std::to_string(count) + " values in the array '" +
        array->GetName() +
        "', but the domain is meshed as one, without lines between them; to mesh one of them, give its cells only.";
    }
  }
  return "";
}
}
