#include "PatchConversion.h"

#include "ColumnWriting.h"
#include "Index.h"
#include "PolygonTriangulation.h"
#include "QuadMesh.h"
#include "SampledPatch.h"
#include "TMesh.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace names = vtkCrossFieldArrayNames;

namespace
{
using crossfield::Index;
using crossfield::Point;

/** Point of the outline of a patch. */
struct OutlinePoint
{
  Point place = Point::Zero();
  Point uv = Point::Zero(); ///< Coordinates in the rectangle, with its first corner as the origin.
  int kind = 0;
};

/**
 * Interior points of arcs, in the plane and by the length in the map, along their first half-edges.
 */
class ArcOutlines
{
public:
  ArcOutlines(const crossfield::SeamlessMap& map, const crossfield::TMesh& mesh)
    : Mesh(mesh)
  {
    for (const crossfield::TArc& arc : mesh.arcs)
    {
      this->Interior.emplace_back();
      double length = 0.0;
      for (const crossfield::ChartPiece& piece : arc.pieces)
      {
        if (length > 0.0 && length < arc.length)
        {
          this->Interior.back().emplace_back(
            length, map.PlaceOf(piece.triangle, piece.from).head<2>());
        }
        length += (piece.to - piece.from).norm();
      }
    }
  }

  /** Returns the outline of a patch, counter-clockwise from its first corner. */
  std::vector<OutlinePoint> Outline(const crossfield::TPatch& patch) const
  {
    const double width = this->Mesh.SideLength(patch, 0);
    const double height = this->Mesh.SideLength(patch, 1);
    const Point corners[] = { { 0.0, 0.0 }, { width, 0.0 }, { width, height }, { 0.0, height } };
    std::vector<OutlinePoint> outline;
    for (std::size_t side = 0; side < 4; ++side)
    {
      const double sideLength = side % 2 == 0 ? width : height;
      const Point sideVector = corners[(side + 1) % 4] - corners[side];
      double start = 0.0;
      for (const int half : patch.sides[side])
      {
        const crossfield::TArc& arc = this->Mesh.arcs[half / 2];
        const auto add = [&](double along, const Point& place, int kind)
        {
          const double part = sideLength > 0.0 ? std::min(1.0, (start + along) / sideLength) : 0.0;
          outline.push_back({ place, corners[side] + part * sideVector, kind });
        };
        const crossfield::TNode& node = this->Mesh.nodes[this->Mesh.halfEdges[half].node];
        add(0.0, node.place.head<2>(), static_cast<int>(node.kind) + 1);
        const auto& interior = this->Interior[half / 2];
        for (std::size_t i = 0; i < interior.size(); ++i)
        {
          const auto& [at, place] = half % 2 == 0 ? interior[i] : interior[interior.size() - 1 - i];
          add(half % 2 == 0 ? at : arc.length - at, place, 0);
        }
        start += arc.length;
      }
    }
    return outline;
  }

private:
  const crossfield::TMesh& Mesh;
  std::vector<std::vector<std::pair<double, Point>>> Interior;
};

/** Triangles of patches with the arrays of vtkSeparatrices. */
class PatchWriter
{
public:
  PatchWriter() { this->Points->SetDataTypeToDouble(); }

  /** Adds a point of a patch and returns its number. */
  vtkIdType AddPoint(const crossfield::SpacePoint& place, const Point& uv, int kind, int patch)
  {
    this->Uv.push_back(uv);
    this->Kinds.push_back(kind);
    this->PatchOfPoint.push_back(patch);
    return this->Points->InsertNextPoint(place.data());
  }

  void AddTriangle(vtkIdType i, vtkIdType j, vtkIdType k, int patch)
  {
    const vtkIdType ids[] = { i, j, k };
    this->Triangles->InsertNextCell(3, ids);
    this->PatchOfCell.push_back(patch);
  }

  void Write(const crossfield::TMesh& mesh, vtkPolyData* output) const
  {
    output->SetPoints(this->Points);
    output->SetPolys(this->Triangles);
    vtkPointData* pointData = output->GetPointData();
    ColumnWriting::AddIntegers(pointData, names::NodeKind, this->Kinds);
    ColumnWriting::AddIntegers(pointData, names::FaceId, this->PatchOfPoint);
    vtkNew<vtkDoubleArray> uv;
    uv->SetName(names::UV);
    uv->SetNumberOfComponents(2);
    for (const Point& one : this->Uv)
    {
      uv->InsertNextTuple2(one.x(), one.y());
    }
    pointData->AddArray(uv);
    vtkCellData* cellData = output->GetCellData();
    ColumnWriting::AddIntegers(cellData, names::FaceId, this->PatchOfCell);
    const auto addSize = [&](const char* name, std::size_t side)
    {
      ColumnWriting::AddColumn<vtkDoubleArray>(cellData, name, this->PatchOfCell,
        [&mesh, side](int f) { return mesh.SideLength(mesh.patches[Index(f)], side); });
    };
    addSize(names::USize, 0);
    addSize(names::VSize, 1);
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Triangles;
  std::vector<Point> Uv;
  std::vector<int> Kinds;
  std::vector<int> PatchOfPoint;
  std::vector<int> PatchOfCell;
};

/** Adds a lattice of triangles on the surface. */
void AddOnSurface(const crossfield::SampledPatch& sample, int patch, PatchWriter& writer)
{
  vtkIdType first = -1;
  for (std::size_t i = 0; i < sample.places.size(); ++i)
  {
    const vtkIdType point = writer.AddPoint(sample.places[i], sample.positions[i], 0, patch);
    first = first < 0 ? point : first;
  }
  for (int row = 0; row < sample.rows; ++row)
  {
    for (int column = 0; column < sample.columns; ++column)
    {
      const vtkIdType low = first + row * (sample.columns + 1) + column;
      const vtkIdType high = low + sample.columns + 1;
      writer.AddTriangle(low, low + 1, high + 1, patch);
      writer.AddTriangle(low, high + 1, high, patch);
    }
  }
}

/** Adds the triangles of a patch in a plane, whose points are its outline. */
void AddInPlane(const std::vector<OutlinePoint>& outline, const crossfield::DomainPlane& plane,
  int patch, PatchWriter& writer)
{
  vtkIdType first = -1;
  crossfield::Loop polygon;
  for (const OutlinePoint& one : outline)
  {
    const vtkIdType point = writer.AddPoint(plane.ToSpace(one.place), one.uv, one.kind, patch);
    first = first < 0 ? point : first;
    polygon.push_back(one.place);
  }
  for (const auto& [i, j, k] : crossfield::TriangulatePolygon(polygon))
  {
    writer.AddTriangle(first + i, first + j, first + k, patch);
  }
}
}

namespace PatchConversion
{
//------------------------------------------------------------------------------
void WritePatches(
  const MapConversion::Map& traced, const crossfield::TMesh& mesh, vtkPolyData* output)
{
  // About the side of a triangle of a mesh of 5,000.
  constexpr double Cell = 0.02;
  const bool isOnSurface = traced.map.topology->charts.has_value();
  const double size = Cell * std::sqrt(traced.map.topology->Area());
  PatchWriter writer;
  std::optional<ArcOutlines> outlines;
  if (!isOnSurface)
  {
    outlines.emplace(traced.map, mesh);
  }
  for (int f = 0; f < static_cast<int>(mesh.patches.size()); ++f)
  {
    const crossfield::TPatch& patch = mesh.patches[Index(f)];
    if (isOnSurface)
    {
      AddOnSurface(crossfield::SamplePatch(traced.map, mesh, patch, size), f, writer);
    }
    else
    {
      AddInPlane(outlines->Outline(patch), traced.plane, f, writer);
    }
  }
  writer.Write(mesh, output);
}

//------------------------------------------------------------------------------
void WriteQuadsOfPatches(const crossfield::QuadMesh& quads, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const crossfield::QuadPoint& point : quads.points)
  {
    points->InsertNextPoint(point.place.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const std::array<int, 4>& quad : quads.quads)
  {
    cells->InsertNextCell({ quad[0], quad[1], quad[2], quad[3] });
  }
  output->SetPoints(points);
  output->SetPolys(cells);
  ColumnWriting::AddIntegers(output->GetCellData(), names::FaceId, quads.patch);
}
}
