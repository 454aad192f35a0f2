#include "DrawingConversion.h"

#include "ColumnWriting.h"
#include "CurveConversion.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <array>
#include <map>

namespace names = vtkCrossFieldArrayNames;

namespace
{
void WriteUnit(const crossfield::Drawing& drawing, vtkPolyData* output)
{
  if (!drawing.unit.empty())
  {
    ColumnWriting::AddText(output->GetFieldData(), names::DrawingUnit, drawing.unit);
  }
}
}

namespace DrawingConversion
{
//------------------------------------------------------------------------------
void WriteOutline(const crossfield::Drawing& drawing, const crossfield::DrawingOutline& outline,
  const std::vector<crossfield::DrawnLine>& inner, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  std::vector<std::string> sides;
  CurveConversion::CellCurves curves;
  curves.curves = outline.curves;
  bool hasNames = false;
  for (const crossfield::OutlineLoop& loop : outline.loops)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    const auto count = static_cast<vtkIdType>(loop.points.size());
    for (vtkIdType i = 0; i < count; ++i)
    {
      const auto index = static_cast<std::size_t>(i);
      points->InsertNextPoint(drawing.plane.ToSpace(loop.points[index]).data());
      lines->InsertNextCell({ first + i, first + (i + 1) % count });
      const crossfield::OutlineSegment& segment = loop.segments[index];
      sides.push_back(segment.name);
      curves.ofCell.push_back(segment.curve);
      hasNames = hasNames || !segment.name.empty();
    }
  }
  for (const crossfield::DrawnLine& line : inner)
  {
    for (std::size_t i = 0; i < line.points.size(); ++i)
    {
      const vtkIdType last = points->InsertNextPoint(drawing.plane.ToSpace(line.points[i]).data());
      if (i > 0)
      {
        lines->InsertNextCell({ last - 1, last });
        sides.push_back(line.name);
        curves.ofCell.push_back(-1);
        hasNames = true;
      }
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  if (hasNames)
  {
    ColumnWriting::AddColumn<vtkStringArray>(
      output->GetCellData(), names::Side, sides, [](const std::string& name) { return name; });
  }
  if (!curves.curves.empty())
  {
    CurveConversion::AddCurves(curves, output);
  }
  WriteUnit(drawing, output);
  ColumnWriting::AddNumbers(output->GetFieldData(), names::LargestGap, { outline.largestGap });
}

//------------------------------------------------------------------------------
void WriteFaces(const crossfield::Drawing& drawing, const std::vector<crossfield::DrawnLine>& inner,
  vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::map<std::array<double, 2>, vtkIdType> numbers; // nodes that faces share have equal places
  const auto numberOf = [&](const crossfield::Point& place)
  {
    const auto [found, isNew] =
      numbers.emplace(std::array{ place.x(), place.y() }, points->GetNumberOfPoints());
    if (isNew)
    {
      points->InsertNextPoint(drawing.plane.ToSpace(place).data());
    }
    return found->second;
  };
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkCellArray> lines;
  std::vector<std::string> sides; // of lines, then of polygons
  std::vector<std::string> materials;
  for (const crossfield::DrawingPiece& piece : drawing.pieces)
  {
    lines->InsertNextCell({ numberOf(piece.first), numberOf(piece.last) });
    sides.push_back(piece.name);
    materials.emplace_back();
  }
  for (const crossfield::DrawnLine& line : inner)
  {
    for (std::size_t i = 1; i < line.points.size(); ++i)
    {
      lines->InsertNextCell({ numberOf(line.points[i - 1]), numberOf(line.points[i]) });
      sides.push_back(line.name);
      materials.emplace_back();
    }
  }
  for (const crossfield::DrawingFace& face : drawing.faces)
  {
    polygons->InsertNextCell(static_cast<int>(face.points.size()));
    for (const crossfield::Point& point : face.points)
    {
      polygons->InsertCellPoint(numberOf(point));
    }
    sides.emplace_back();
    materials.push_back(face.material);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->SetPolys(polygons);
  const auto text = [](const std::string& value) { return value; };
  ColumnWriting::AddColumn<vtkStringArray>(output->GetCellData(), names::Side, sides, text);
  ColumnWriting::AddColumn<vtkStringArray>(output->GetCellData(), names::Material, materials, text);
}

//------------------------------------------------------------------------------
void WriteSurface(const crossfield::Drawing& drawing, vtkPolyData* output)
{
  const crossfield::DrawingSurface& surface = drawing.surface;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const crossfield::SpacePoint& point : surface.points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polygons;
  const auto insert = [](vtkCellArray* cells, const std::vector<int>& ids)
  {
    cells->InsertNextCell(static_cast<int>(ids.size()));
    for (const int point : ids)
    {
      cells->InsertCellPoint(point);
    }
  };
  std::vector<std::string> sides; // of lines, then of polygons
  for (const crossfield::SurfaceLine& line : surface.lines)
  {
    insert(lines, line.points);
    sides.push_back(line.name);
  }
  for (const std::vector<int>& polygon : surface.polygons)
  {
    insert(polygons, polygon);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->SetPolys(polygons);
  const auto text = [](const std::string& value) { return value; };
  if (!surface.regions.empty())
  {
    std::vector<std::string> materials(surface.lines.size());
    materials.insert(materials.end(), surface.regions.begin(), surface.regions.end());
    ColumnWriting::AddColumn<vtkStringArray>(
      output->GetCellData(), names::Material, materials, text);
  }
  if (!surface.lines.empty())
  {
    sides.resize(surface.lines.size() + surface.polygons.size());
    ColumnWriting::AddColumn<vtkStringArray>(output->GetCellData(), names::Side, sides, text);
  }
  WriteUnit(drawing, output);
}
}
