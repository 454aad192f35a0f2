#include "PatchConversion.h"

#include "ColumnWriting.h"
#include "Index.h"
#include "PolygonTriangulation.h"
#include "TMesh.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

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
}

namespace PatchConversion
{
//------------------------------------------------------------------------------
void WritePatches(
  const MapConversion::Map& traced, const crossfield::TMesh& mesh, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  std::vector<OutlinePoint> all;
  std::vector<int> patchOfPoint;
  std::vector<int> patchOfCell;
  const ArcOutlines outlines(traced.map, mesh);
  for (int f = 0; f < static_cast<int>(mesh.patches.size()); ++f)
  {
    const std::vector<OutlinePoint> outline = outlines.Outline(mesh.patches[f]);
    const vtkIdType first = points->GetNumberOfPoints();
    crossfield::Loop polygon;
    for (const OutlinePoint& point : outline)
    {
      points->InsertNextPoint(traced.plane.ToSpace(point.place).data());
      polygon.push_back(point.place);
      patchOfPoint.push_back(f);
    }
    all.insert(all.end(), outline.begin(), outline.end());
    for (const auto& [i, j, k] : crossfield::TriangulatePolygon(polygon))
    {
      const vtkIdType ids[] = { first + i, first + j, first + k };
      triangles->InsertNextCell(3, ids);
      patchOfCell.push_back(f);
    }
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  vtkPointData* pointData = output->GetPointData();
  ColumnWriting::AddColumn<vtkIntArray>(
    pointData, names::NodeKind, all, [](const OutlinePoint& point) { return point.kind; });
  ColumnWriting::AddIntegers(pointData, names::FaceId, patchOfPoint);
  vtkNew<vtkDoubleArray> uv;
  uv->SetName(names::UV);
  uv->SetNumberOfComponents(2);
  for (const OutlinePoint& point : all)
  {
    uv->InsertNextTuple2(point.uv.x(), point.uv.y());
  }
  pointData->AddArray(uv);
  vtkCellData* cellData = output->GetCellData();
  ColumnWriting::AddIntegers(cellData, names::FaceId, patchOfCell);
  const auto addSize = [&](const char* name, std::size_t side)
  {
    ColumnWriting::AddColumn<vtkDoubleArray>(cellData, name, patchOfCell,
      [&mesh, side](int f) { return mesh.SideLength(mesh.patches[f], side); });
  };
  addSize(names::USize, 0);
  addSize(names::VSize, 1);
}
}
