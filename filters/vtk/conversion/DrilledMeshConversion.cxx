#include "DrilledMeshConversion.h"

#include "CellLoop.h"
#include "Error.h"
#include "InputCheck.h"
#include "UsedPoints.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

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

/**
 * Writes cells to lists of their final length. Inserting one cell after the other takes several
 * times as long.
 */
void WriteCells(const std::vector<std::array<int, 3>>& triangles,
  const std::vector<crossfield::BoundaryEdge>& lines, vtkUnstructuredGrid* output)
{
  const std::size_t count = triangles.size() + lines.size();
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(static_cast<vtkIdType>(3 * triangles.size() + 2 * lines.size()));
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(count + 1));
  vtkIdType* id = ids->GetPointer(0);
  vtkIdType* offset = offsets->GetPointer(0);
  for (const auto& triangle : triangles)
  {
    *offset++ = id - ids->GetPointer(0);
    id = std::copy(triangle.begin(), triangle.end(), id);
  }
  for (const auto& edge : lines)
  {
    *offset++ = id - ids->GetPointer(0);
    id = std::copy(edge.vertices.begin(), edge.vertices.end(), id);
  }
  *offset = id - ids->GetPointer(0);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, ids);
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(static_cast<vtkIdType>(count));
  unsigned char* type = types->GetPointer(0);
  type = std::fill_n(type, triangles.size(), static_cast<unsigned char>(VTK_TRIANGLE));
  std::fill_n(type, lines.size(), static_cast<unsigned char>(VTK_LINE));
  output->SetCells(types, cells);
}
}

namespace DrilledMeshConversion
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
  mesh.points.reserve(result.pointIds.size());
  for (const vtkIdType point : result.pointIds)
  {
    Eigen::Vector3d place;
    input->GetPoint(point, place.data());
    InputCheck::RequireFinite(place.data(), point);
    mesh.points.push_back(result.plane.ToPlane(place));
  }
  const auto cellCount = static_cast<std::size_t>(input->GetNumberOfCells());
  result.triangleCells.reserve(cellCount);
  mesh.triangles.reserve(cellCount);
  CellLoop::ForEachCell(input,
    [&](vtkIdType cell, int type, const auto& points)
    {
      const auto vertex = [&](vtkIdType i) { return used.IndexOf(points[i]); };
      if (type == VTK_TRIANGLE)
      {
        result.triangleCells.push_back(cell);
        mesh.triangles.push_back({ vertex(0), vertex(1), vertex(2) });
        return;
      }
      const int kind = static_cast<int>(kinds->GetTuple1(cell));
      if (type != VTK_LINE || kind < 1 || kind > 4)
      {
        throw Error("Cell " + std::to_string(cell) +
          " is neither a triangle nor a line with a BoundaryKind of 1 to 4; give a mesh made by "
          "the drill filter.");
      }
      const crossfield::BoundaryEdge edge{ { vertex(0), vertex(1) },
        static_cast<crossfield::BoundaryKind>(kind), static_cast<int>(ids->GetTuple1(cell)),
        static_cast<int>(quarters->GetTuple1(cell)) };
      const bool imprinted = edge.kind == crossfield::BoundaryKind::ImprintedCircle;
      (imprinted ? result.imprintedCells : result.lineCells).push_back(cell);
      (imprinted ? mesh.imprinted : mesh.boundary).push_back(edge);
    });
  result.topology = crossfield::ShareTopology(std::move(mesh));
  return result;
}

//------------------------------------------------------------------------------
DrilledMesh NumberCells(
  const crossfield::SharedPlanarTopology& topology, const crossfield::DomainPlane& plane)
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
  output->SetPoints(points);
  WriteCells(mesh.triangles, lines, output);

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
  // ParaView colours a new mesh by this array.
  output->GetCellData()->SetActiveScalars(vtkCrossFieldArrayNames::BoundaryKind);
}
}
