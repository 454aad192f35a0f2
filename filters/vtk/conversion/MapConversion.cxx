#include "MapConversion.h"

#include "ColumnWriting.h"
#include "Error.h"
#include "HolonomyConversion.h"
#include "Index.h"
#include "InputCheck.h"
#include "PlanarTopology.h"
#include "SurfaceTopology.h"
#include "UsedPoints.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <string>

namespace names = vtkCrossFieldArrayNames;

namespace
{
using ColumnWriting::NewArray;
using crossfield::Index;
using crossfield::Point;

vtkDataArray* RequireArray(vtkFieldData* data, const char* name, int components)
{
  vtkDataArray* array = data->GetArray(name);
  if (array == nullptr || array->GetNumberOfComponents() != components)
  {
    throw crossfield::Error(std::string("The input has no array '") + name +
      "' of a seamless map; give the output of the cross field map filter.");
  }
  return array;
}

/** Returns an integer of an array. Throws crossfield::Error if it is out of range. */
int RequireInteger(vtkDataArray* array, vtkIdType tuple, int component, int minimum, int maximum)
{
  const double value = array->GetComponent(tuple, component);
  if (!(value >= minimum && value <= maximum))
  {
    throw crossfield::Error(std::string("The array '") + array->GetName() +
      "' of the seamless map has a value out of range; give the output of the cross field map filter "
      "as it is.");
  }
  return static_cast<int>(value);
}

/** Returns the directions of boundary edges, given for the edges in another order. */
std::vector<int> InOrderOf(const std::vector<crossfield::BoundaryEdge>& edges,
  const std::vector<crossfield::BoundaryEdge>& given, const std::vector<int>& directions)
{
  std::map<std::array<int, 2>, int> directionOf;
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    directionOf[given[i].vertices] = directions[i];
  }
  std::vector<int> ordered;
  for (const crossfield::BoundaryEdge& edge : edges)
  {
    const auto found = directionOf.find(edge.vertices);
    if (found == directionOf.end())
    {
      throw crossfield::Error(
        "A boundary edge of the seamless map has no line; give the output of the cross field map "
        "filter as it is.");
    }
    ordered.push_back(found->second);
  }
  return ordered;
}
}

namespace MapConversion
{
//------------------------------------------------------------------------------
void WriteMap(const Map& written, vtkUnstructuredGrid* output)
{
  const crossfield::SeamlessMap& map = written.map;
  const crossfield::TriangleMesh& mesh = map.topology->mesh;
  const auto pointCount = static_cast<vtkIdType>(map.original.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(pointCount);
  output->SetPoints(points);
  vtkPointData* pointData = output->GetPointData();
  const auto uv = NewArray<vtkDoubleArray>(pointData, names::UV, 2, pointCount);
  const auto vertices = NewArray<vtkIntArray>(pointData, names::VertexId, 1, pointCount);
  const auto quarters = NewArray<vtkIntArray>(pointData, names::QuarterIndex, 1, pointCount);
  const auto cones = NewArray<vtkIntArray>(pointData, names::Cone, 1, pointCount, -1);
  std::vector<int> coneAt(mesh.points.size(), -1);
  for (std::size_t c = 0; c < map.cones.size(); ++c)
  {
    coneAt[map.cones[c].vertex] = static_cast<int>(c);
  }
  for (vtkIdType p = 0; p < pointCount; ++p)
  {
    const int vertex = map.original[p];
    points->SetPoint(p, written.plane.PlaceToSpace(map.topology->PositionOf(vertex)).data());
    const Point& w = map.points[p];
    uv->SetTuple2(p, w.x(), w.y());
    vertices->SetValue(p, vertex);
    const int cone = coneAt[vertex];
    cones->SetValue(p, cone);
    quarters->SetValue(p, cone < 0 ? 0 : map.cones[cone].quarterIndex);
  }

  const auto triangles = static_cast<vtkIdType>(mesh.triangles.size());
  const auto cells = triangles + static_cast<vtkIdType>(mesh.boundary.size());
  output->Allocate(cells);
  vtkCellData* cellData = output->GetCellData();
  const auto kind = NewArray<vtkIntArray>(cellData, names::BoundaryKind, 1, cells);
  const auto id = NewArray<vtkIntArray>(cellData, names::BoundaryId, 1, cells, -1);
  const auto seams = NewArray<vtkIntArray>(cellData, names::Seam, 3, cells);
  const auto directions = NewArray<vtkIntArray>(cellData, names::Direction, 1, cells, -1);
  for (vtkIdType t = 0; t < triangles; ++t)
  {
    const auto& corners = map.corners[t];
    const vtkIdType ids[] = { corners[0], corners[1], corners[2] };
    output->InsertNextCell(VTK_TRIANGLE, 3, ids);
    const auto& seam = map.seams[t];
    seams->SetTuple3(t, seam[0], seam[1], seam[2]);
  }
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    const int t = map.topology->SideOfBoundary(static_cast<int>(i)).first;
    const auto& v = mesh.triangles[t];
    const auto copy = [&](int vertex)
    { return vtkIdType{ map.corners[t][std::find(v.begin(), v.end(), vertex) - v.begin()] }; };
    const vtkIdType ids[] = { copy(mesh.boundary[i].vertices[0]),
      copy(mesh.boundary[i].vertices[1]) };
    const vtkIdType cell = output->InsertNextCell(VTK_LINE, 2, ids);
    kind->SetValue(cell, static_cast<int>(mesh.boundary[i].kind));
    id->SetValue(cell, mesh.boundary[i].id);
    directions->SetValue(cell, map.directions[i]);
  }

  vtkFieldData* field = output->GetFieldData();
  const auto count = static_cast<vtkIdType>(map.transitions.size());
  const auto rotations = NewArray<vtkIntArray>(field, names::SeamRotation, 1, count);
  const auto translations = NewArray<vtkDoubleArray>(field, names::SeamTranslation, 2, count);
  for (vtkIdType k = 0; k < count; ++k)
  {
    const crossfield::SeamTransition& seam = map.transitions[k];
    rotations->SetValue(k, seam.rotation);
    translations->SetTuple2(k, seam.translation.x(), seam.translation.y());
  }
  std::vector<int> rows;
  for (const crossfield::Cone& cone : map.cones)
  {
    rows.push_back(cone.row);
  }
  ColumnWriting::AddIntegers(field, names::ConeRow, rows);
  ColumnWriting::AddIntegers(field, names::Flips, { 0 });
  ColumnWriting::AddNumbers(field, names::MapResidual, { map.residual });
  ColumnWriting::AddNumbers(field, names::HolonomyDefect, map.holonomyDefect);
  HolonomyConversion::WriteStretch(map.flattening, field);
}

//------------------------------------------------------------------------------
Map ReadMap(vtkUnstructuredGrid* input)
{
  InputCheck::Require(input);
  Map result;
  crossfield::SeamlessMap& map = result.map;
  vtkDataArray* uv = RequireArray(input->GetPointData(), names::UV, 2);
  vtkDataArray* vertices = RequireArray(input->GetPointData(), names::VertexId, 1);
  vtkDataArray* quarters = RequireArray(input->GetPointData(), names::QuarterIndex, 1);
  vtkDataArray* cones = RequireArray(input->GetPointData(), names::Cone, 1);
  vtkDataArray* kind = RequireArray(input->GetCellData(), names::BoundaryKind, 1);
  vtkDataArray* id = RequireArray(input->GetCellData(), names::BoundaryId, 1);
  vtkDataArray* seams = RequireArray(input->GetCellData(), names::Seam, 3);
  vtkDataArray* directions = RequireArray(input->GetCellData(), names::Direction, 1);
  vtkDataArray* rotations = RequireArray(input->GetFieldData(), names::SeamRotation, 1);
  vtkDataArray* translations = RequireArray(input->GetFieldData(), names::SeamTranslation, 2);
  vtkDataArray* rows = RequireArray(input->GetFieldData(), names::ConeRow, 1);

  const UsedPoints used(input);
  result.plane = used.NearestPlane(input);
  const bool isSurface = !result.plane.IsNear();
  crossfield::TriangleMesh mesh;
  std::vector<crossfield::SpacePoint> places; // of a surface in space
  const auto pointCount = static_cast<int>(input->GetNumberOfPoints());
  const auto coneCount = static_cast<int>(rows->GetNumberOfTuples());
  map.cones.resize(Index(coneCount));
  for (const vtkIdType p : used.GetIds())
  {
    const int vertex = RequireInteger(vertices, p, 0, 0, pointCount - 1);
    mesh.points.resize(std::max(mesh.points.size(), Index(vertex) + 1));
    Eigen::Vector3d place;
    input->GetPoint(p, place.data());
    mesh.points[vertex] = result.plane.ToPlane(place);
    places.resize(mesh.points.size());
    places[vertex] = place;
    map.original.push_back(vertex);
    map.points.emplace_back(uv->GetComponent(p, 0), uv->GetComponent(p, 1));
    const int cone = RequireInteger(cones, p, 0, -1, coneCount - 1);
    if (cone >= 0)
    {
      map.cones[cone].vertex = vertex;
      map.cones[cone].quarterIndex = RequireInteger(quarters, p, 0, -1000, 2);
      map.cones[cone].row = static_cast<int>(rows->GetTuple1(cone));
    }
  }
  const auto transitions = static_cast<int>(rotations->GetNumberOfTuples());
  for (vtkIdType k = 0; k < transitions && k < translations->GetNumberOfTuples(); ++k)
  {
    map.transitions.push_back({ RequireInteger(rotations, k, 0, 0, 3),
      { translations->GetComponent(k, 0), translations->GetComponent(k, 1) } });
  }
  const auto seamCount = static_cast<int>(map.transitions.size());
  std::vector<bool> onBoundary(mesh.points.size(), false);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    input->GetCellPoints(cell, ids);
    const auto corner = [&](vtkIdType i) { return used.IndexOf(ids->GetId(i)); };
    const auto vertex = [&](vtkIdType i) { return map.original[corner(i)]; };
    if (input->GetCellType(cell) == VTK_TRIANGLE)
    {
      map.corners.push_back({ corner(0), corner(1), corner(2) });
      mesh.triangles.push_back({ vertex(0), vertex(1), vertex(2) });
      std::array<int, 3> seam{};
      for (int i = 0; i < 3; ++i)
      {
        seam[i] = RequireInteger(seams, cell, i, -seamCount, seamCount);
      }
      map.seams.push_back(seam);
    }
    else if (input->GetCellType(cell) == VTK_LINE)
    {
      crossfield::BoundaryEdge edge;
      edge.vertices = { vertex(0), vertex(1) };
      edge.kind = static_cast<crossfield::BoundaryKind>(RequireInteger(kind, cell, 0, 1, 2));
      edge.id = static_cast<int>(id->GetTuple1(cell));
      mesh.boundary.push_back(edge);
      map.directions.push_back(RequireInteger(directions, cell, 0, 0, 3));
      onBoundary[vertex(0)] = true;
    }
  }
  for (crossfield::Cone& cone : map.cones)
  {
    cone.onBoundary = onBoundary[cone.vertex];
  }
  if (isSurface)
  {
    result.plane = crossfield::DomainPlane();
    map.topology = std::make_shared<const crossfield::SurfaceTopology>(
      crossfield::SurfaceMesh{ std::move(places), std::move(mesh.triangles) });
    map.directions = InOrderOf(map.topology->mesh.boundary, mesh.boundary, map.directions);
    return result;
  }
  map.topology = crossfield::ShareTopology(std::move(mesh));
  return result;
}
}
