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

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
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
crossfield::SurfaceMesh ReadTriangles(vtkDataSet* input)
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
  return surface;
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
  return crossfield::PlaceCones(ReadTriangles(input), ReadSingularities(singularities));
}

//------------------------------------------------------------------------------
const crossfield::ConedSurface& Single(const crossfield::ConedSurfaces& surfaces)
{
  if (surfaces.parts.size() != 1)
  {
    throw crossfield::Error("The surface has " + std::to_string(surfaces.parts.size()) +
      " parts that are not connected; give one of them, for example from the filter Connectivity.");
  }
  const crossfield::ConedSurface& part = surfaces.parts.front();
  if (part.GivenQuarters() != part.RequiredQuarters())
  {
    throw crossfield::Error(
      crossfield::DescribeQuarters(part), crossfield::Error::Kind::Inconsistent);
  }
  return part;
}

//------------------------------------------------------------------------------
void WriteField(const crossfield::MeshTopology& topology, const crossfield::SurfaceField& field,
  vtkUnstructuredGrid* output)
{
  namespace names = vtkCrossFieldArrayNames;
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
  ColumnWriting::AddIntegers(output->GetFieldData(), names::UnwantedSingularities, { 0 });
}

//------------------------------------------------------------------------------
Crosses ReadCrosses(vtkUnstructuredGrid* input)
{
  vtkDataArray* cross = input->GetCellData()->GetArray(vtkCrossFieldArrayNames::Cross);
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
  result.angle.resize(result.topology->TriangleCount());
  for (int t = 0; t < result.topology->TriangleCount(); ++t)
  {
    const auto& v = result.topology->mesh.triangles[t];
    const crossfield::SpacePoint side =
      result.topology->PositionOf(v[1]) - result.topology->PositionOf(v[0]);
    const crossfield::SpacePoint across = result.topology->NormalOf(t).cross(side);
    const double angle = std::atan2(directions[t].dot(across), directions[t].dot(side));
    if (!std::isfinite(angle) || directions[t].isZero())
    {
      throw crossfield::Error(
        "The array 'Cross' has no direction on triangle " + std::to_string(t) + "; correct it.");
    }
    result.angle[t] = angle + result.topology->DirectionOf(t, 0);
  }
  return result;
}
}
