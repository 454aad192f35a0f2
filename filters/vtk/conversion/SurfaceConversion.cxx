#include "SurfaceConversion.h"

#include "CellLoop.h"
#include "ColumnWriting.h"
#include "ConfigurationConversion.h"
#include "DomainConversion.h"
#include "Error.h"
#include "InputCheck.h"
#include "QuarterIndexRange.h"
#include "SurfaceTopology.h"
#include "UsedPoints.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"

#include <Eigen/Geometry>

#include <cmath>
#include <string>
#include <utility>

namespace names = vtkCrossFieldArrayNames;

namespace
{
/** Writes a vertex for each item at its place in space. */
template <class Item, class Place>
void WritePlaces(const std::vector<Item>& items, vtkPolyData* output, Place place)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (const Item& item : items)
  {
    vertices->InsertNextCell({ points->InsertNextPoint(place(item).data()) });
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
}
}

namespace SurfaceConversion
{
//------------------------------------------------------------------------------
bool IsSurface(vtkDataSet* input)
{
  InputCheck::Require(input);
  bool hasSurface = false;
  CellLoop::ForEachCell(input,
    [&hasSurface](vtkIdType, int type, const CellLoop::Points&)
    {
      hasSurface = hasSurface ||
        (type != VTK_EMPTY_CELL && type != VTK_VERTEX && type != VTK_POLY_VERTEX &&
          type != VTK_LINE && type != VTK_POLY_LINE);
    });
  return hasSurface && !UsedPoints(input).NearestPlane(input).IsNear();
}

//------------------------------------------------------------------------------
crossfield::SurfaceMesh ReadTriangles(vtkDataSet* input, std::vector<vtkIdType>* cells)
{
  vtkNew<vtkTriangleFilter> divide;
  divide->SetInputData(DomainConversion::ReadSurface(input));
  divide->PassLinesOff();
  divide->PassVertsOff();
  divide->Update();
  vtkPolyData* triangles = divide->GetOutput();
  crossfield::SurfaceMesh surface;
  const UsedPoints used(triangles);
  for (const vtkIdType point : used.GetIds())
  {
    surface.points.emplace_back(triangles->GetPoint(point));
  }
  CellLoop::ForEachInList(triangles->GetPolys(),
    [&](vtkIdType, const CellLoop::Points& points)
    {
      surface.triangles.push_back(
        { used.IndexOf(points[0]), used.IndexOf(points[1]), used.IndexOf(points[2]) });
    });
  if (cells != nullptr)
  {
    vtkDataArray* original = triangles->GetCellData()->GetArray("vtkOriginalCellIds");
    for (vtkIdType t = 0; t < triangles->GetNumberOfPolys(); ++t)
    {
      cells->push_back(static_cast<vtkIdType>(original->GetTuple1(t)));
    }
  }
  return surface;
}

//------------------------------------------------------------------------------
void WriteConfiguration(
  const std::vector<crossfield::SurfaceSingularity>& singularities, vtkPolyData* output)
{
  using Singularity = crossfield::SurfaceSingularity;
  WritePlaces(singularities, output, [](const Singularity& one) { return one.place; });
  ColumnWriting::AddColumn<vtkIntArray>(output->GetPointData(), names::QuarterIndex, singularities,
    [](const Singularity& one) { return one.quarterIndex; });
}

//------------------------------------------------------------------------------
std::vector<crossfield::SurfaceSingularity> ReadSingularities(vtkDataSet* input)
{
  std::vector<crossfield::SurfaceSingularity> singularities;
  if (input == nullptr)
  {
    return singularities;
  }
  vtkDataArray* quarters = ConfigurationConversion::RequireQuarterIndices(input);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    InputCheck::RequireFinite(input->GetPoint(i), i);
    singularities.push_back({ crossfield::SpacePoint(input->GetPoint(i)),
      crossfield::RequireQuarterIndex(
        quarters->GetTuple1(i), "The quarter index of singularity " + std::to_string(i + 1)) });
  }
  return singularities;
}

//------------------------------------------------------------------------------
crossfield::ConedSurfaces Read(vtkDataSet* input, vtkDataSet* singularities)
{
  return crossfield::PlaceCones(
    ReadTriangles(input), ReadSingularities(singularities), vtkMath::Pi());
}

//------------------------------------------------------------------------------
const crossfield::ConedSurface& Single(const crossfield::ConedSurfaces& surfaces)
{
  if (surfaces.bodies.size() != 1)
  {
    throw crossfield::Error("The surface has " + std::to_string(surfaces.bodies.size()) +
      " parts that are not connected; give one of them, for example from the filter Connectivity.");
  }
  const crossfield::ConedSurface& part = surfaces.bodies.front().faces.front();
  if (part.GivenQuarters() != part.RequiredQuarters())
  {
    throw crossfield::Error(
      crossfield::DescribeQuarters(part), crossfield::Error::Kind::Inconsistent);
  }
  return part;
}

//------------------------------------------------------------------------------
void WriteField(const crossfield::ConedSurface& surface, const crossfield::SurfaceField& field,
  vtkUnstructuredGrid* output)
{
  const crossfield::MeshTopology& topology = *surface.topology;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkIdType vertices = topology.VertexCount();
  auto h = ColumnWriting::NewArray<vtkDoubleArray>(output->GetPointData(), names::H, 1, vertices);
  auto sizes =
    ColumnWriting::NewArray<vtkFloatArray>(output->GetPointData(), names::SizeMap, 1, vertices);
  for (int vertex = 0; vertex < topology.VertexCount(); ++vertex)
  {
    points->InsertNextPoint(topology.PositionOf(vertex).data());
    h->SetValue(vertex, field.h[vertex]);
    sizes->SetValue(vertex, static_cast<float>(std::exp(field.h[vertex])));
  }
  output->SetPoints(points);
  output->GetPointData()->SetActiveScalars(names::SizeMap);
  const vtkIdType triangles = topology.TriangleCount();
  auto cross =
    ColumnWriting::NewArray<vtkFloatArray>(output->GetCellData(), names::Cross, 3, triangles);
  auto second =
    ColumnWriting::NewArray<vtkFloatArray>(output->GetCellData(), names::Cross2, 3, triangles);
  output->Allocate(triangles);
  for (int t = 0; t < topology.TriangleCount(); ++t)
  {
    const auto& v = topology.mesh.triangles[t];
    const vtkIdType ids[] = { v[0], v[1], v[2] };
    output->InsertNextCell(VTK_TRIANGLE, 3, ids);
    const crossfield::SpacePoint& direction = field.cross[t];
    cross->SetTuple(t, direction.data());
    second->SetTuple(t, crossfield::SpacePoint(topology.NormalOf(t).cross(direction)).data());
  }
  ColumnWriting::AddNumbers(output->GetFieldData(), names::HolonomyDefect, field.holonomyDefect);
  ColumnWriting::AddIntegers(output->GetFieldData(), names::Converged, { 1 });
  ColumnWriting::AddIntegers(output->GetFieldData(), names::UnwantedSingularities,
    { crossfield::CountUnwanted(
      topology, field.angle, crossfield::QuartersOfVertices(topology, surface.cones)) });
}

//------------------------------------------------------------------------------
Crosses ReadCrosses(vtkUnstructuredGrid* input)
{
  vtkDataArray* cross = input->GetCellData()->GetArray(names::Cross);
  if (cross == nullptr || cross->GetNumberOfComponents() != 3)
  {
    throw crossfield::Error(
      "The surface has no cell array 'Cross' with three components; give the output of H Field, or "
      "triangles with a direction of the cross on each.");
  }
  crossfield::SurfaceMesh surface;
  const UsedPoints used(input);
  for (const vtkIdType point : used.GetIds())
  {
    surface.points.emplace_back(input->GetPoint(point));
  }
  std::vector<crossfield::SpacePoint> directions;
  CellLoop::ForEachCell(input,
    [&](vtkIdType cell, int type, const CellLoop::Points& points)
    {
      if (type == VTK_TRIANGLE)
      {
        surface.triangles.push_back(
          { used.IndexOf(points[0]), used.IndexOf(points[1]), used.IndexOf(points[2]) });
        directions.emplace_back(cross->GetTuple(cell));
      }
    });
  Crosses result;
  result.topology = std::make_shared<const crossfield::SurfaceTopology>(std::move(surface));
  result.angle = crossfield::AnglesInCharts(*result.topology, directions);
  return result;
}

//------------------------------------------------------------------------------
void WriteSingularities(const crossfield::MeshTopology& topology,
  const std::vector<crossfield::VertexSingularity>& singularities, vtkPolyData* output)
{
  using Singularity = crossfield::VertexSingularity;
  WritePlaces(singularities, output,
    [&topology](const Singularity& one) { return topology.PositionOf(one.vertex); });
  vtkPointData* data = output->GetPointData();
  ColumnWriting::AddColumn<vtkIntArray>(data, names::QuarterIndex, singularities,
    [](const Singularity& one) { return one.quarterIndex; });
  ColumnWriting::AddColumn<vtkIntArray>(data, names::BoundaryKind, singularities,
    [&topology](const Singularity& one)
    { return one.loop < 0 ? 0 : static_cast<int>(topology.loops[one.loop].kind); });
  ColumnWriting::AddColumn<vtkIntArray>(
    data, names::BoundaryId, singularities, [](const Singularity& one) { return one.loop; });
}

//------------------------------------------------------------------------------
void WriteCorners(const std::vector<crossfield::SurfaceCorner>& corners, vtkPolyData* output)
{
  using Corner = crossfield::SurfaceCorner;
  WritePlaces(corners, output, [](const Corner& corner) { return corner.place; });
  vtkPointData* data = output->GetPointData();
  ColumnWriting::AddColumn<vtkDoubleArray>(
    data, names::Angle, corners, [](const Corner& corner) { return corner.angle; });
  ColumnWriting::AddColumn<vtkIntArray>(
    data, names::QuarterIndex, corners, [](const Corner& corner) { return corner.quarterIndex; });
  ColumnWriting::AddColumn<vtkIntArray>(
    data, names::Cancellable, corners, [](const Corner&) { return 0; });
}
}
