#include "DomainConversion.h"

#include "Error.h"
#include "InputCheck.h"
#include "UsedPoints.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <numeric>
#include <string>
#include <utility>

namespace
{
using crossfield::Error;

vtkDataArray* RequireCellArray(vtkUnstructuredGrid* grid, const char* name)
{
  vtkDataArray* array = grid->GetCellData()->GetArray(name);
  if (array == nullptr || array->GetNumberOfComponents() != 1)
  {
    throw Error(std::string("The mesh has no cell array '") + name +
      "' with one component; give a mesh made by the drill filter.");
  }
  return array;
}

vtkSmartPointer<vtkIntArray> NewCellArray(vtkUnstructuredGrid* grid, const char* name)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(name);
  array->SetNumberOfValues(grid->GetNumberOfCells());
  grid->GetCellData()->AddArray(array);
  return array;
}
}

namespace DomainConversion
{
//------------------------------------------------------------------------------
vtkUnstructuredGrid* AsDrilledMesh(vtkDataSet* input)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(input);
  return grid != nullptr &&
      grid->GetCellData()->GetArray(vtkCrossFieldArrayNames::BoundaryKind) != nullptr
    ? grid
    : nullptr;
}

//------------------------------------------------------------------------------
DrilledMesh ReadDrilledMesh(vtkUnstructuredGrid* input)
{
  InputCheck::Require(input);
  vtkDataArray* kinds = RequireCellArray(input, vtkCrossFieldArrayNames::BoundaryKind);
  vtkDataArray* ids = RequireCellArray(input, vtkCrossFieldArrayNames::BoundaryId);
  vtkDataArray* quarters = RequireCellArray(input, vtkCrossFieldArrayNames::QuarterIndex);
  DrilledMesh result;
  crossfield::TriangleMesh mesh;
  const UsedPoints used(input);
  result.plane = used.FindPlane(input);
  result.pointIds = used.GetIds();
  for (const vtkIdType point : result.pointIds)
  {
    mesh.points.push_back(result.plane.ToPlane(Eigen::Vector3d(input->GetPoint(point))));
  }
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    input->GetCellPoints(cell, points);
    const auto vertex = [&](vtkIdType i) { return used.NumberOf(points->GetId(i)); };
    const int kind = static_cast<int>(kinds->GetTuple1(cell));
    if (input->GetCellType(cell) == VTK_TRIANGLE)
    {
      result.triangleCells.push_back(cell);
      mesh.triangles.push_back({ vertex(0), vertex(1), vertex(2) });
    }
    else if (input->GetCellType(cell) == VTK_LINE && kind >= 1 && kind <= 4)
    {
      const crossfield::BoundaryEdge edge{ { vertex(0), vertex(1) },
        static_cast<crossfield::BoundaryKind>(kind), static_cast<int>(ids->GetTuple1(cell)),
        static_cast<int>(quarters->GetTuple1(cell)) };
      const bool imprinted = edge.kind == crossfield::BoundaryKind::ImprintedCircle;
      (imprinted ? result.imprintedCells : result.lineCells).push_back(cell);
      (imprinted ? mesh.imprinted : mesh.boundary).push_back(edge);
    }
    else
    {
      throw Error("Cell " + std::to_string(cell) +
        " is neither a triangle nor a line with a BoundaryKind of 1 to 4; give a mesh made by the "
        "drill filter.");
    }
  }
  result.topology = crossfield::ShareTopology(std::move(mesh));
  return result;
}

//------------------------------------------------------------------------------
DrilledMesh NumberCells(
  const crossfield::SharedTopology& topology, const crossfield::DomainPlane& plane)
{
  const crossfield::TriangleMesh& mesh = topology->mesh;
  const auto count = [](std::size_t size, vtkIdType first)
  {
    std::vector<vtkIdType> ids(size);
    std::iota(ids.begin(), ids.end(), first);
    return ids;
  };
  const auto lines = static_cast<vtkIdType>(mesh.triangles.size());
  const auto imprinted = lines + static_cast<vtkIdType>(mesh.boundary.size());
  DrilledMesh result;
  result.plane = plane;
  result.pointIds = count(mesh.points.size(), 0);
  result.triangleCells = count(mesh.triangles.size(), 0);
  result.lineCells = count(mesh.boundary.size(), lines);
  result.imprintedCells = count(mesh.imprinted.size(), imprinted);
  result.topology = topology;
  return result;
}

//------------------------------------------------------------------------------
void WriteDrilledMesh(const crossfield::TriangleMesh& mesh, const crossfield::DomainPlane& plane,
  vtkUnstructuredGrid* output)
{
  std::vector<crossfield::BoundaryEdge> lines = mesh.boundary;
  lines.insert(lines.end(), mesh.imprinted.begin(), mesh.imprinted.end());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), plane.ToSpace(mesh.points[i]).data());
  }
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> types;
  cells->AllocateExact(static_cast<vtkIdType>(mesh.triangles.size() + lines.size()),
    static_cast<vtkIdType>(3 * mesh.triangles.size() + 2 * lines.size()));
  for (const auto& triangle : mesh.triangles)
  {
    cells->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
    types->InsertNextValue(VTK_TRIANGLE);
  }
  for (const auto& edge : lines)
  {
    cells->InsertNextCell({ edge.vertices[0], edge.vertices[1] });
    types->InsertNextValue(VTK_LINE);
  }
  output->SetPoints(points);
  output->SetCells(types, cells);

  auto kinds = NewCellArray(output, vtkCrossFieldArrayNames::BoundaryKind);
  auto ids = NewCellArray(output, vtkCrossFieldArrayNames::BoundaryId);
  auto quarters = NewCellArray(output, vtkCrossFieldArrayNames::QuarterIndex);
  kinds->FillValue(0);
  ids->FillValue(-1);
  quarters->FillValue(0);
  auto cell = static_cast<vtkIdType>(mesh.triangles.size());
  for (const auto& edge : lines)
  {
    kinds->SetValue(cell, static_cast<int>(edge.kind));
    ids->SetValue(cell, edge.id);
    quarters->SetValue(cell, edge.quarterIndex);
    ++cell;
  }
  // What ParaView colours a new mesh by.
  output->GetCellData()->SetActiveScalars(vtkCrossFieldArrayNames::BoundaryKind);
}
}
