#include "TestInputs.h"
#include "ResultFiles.h"

#include "vtkDrillHoles.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace TestInputs
{
namespace
{
vtkSmartPointer<vtkPoints> NewPoints()
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  return points;
}

vtkSmartPointer<vtkPolyData> NewLines(vtkPoints* points, vtkCellArray* lines)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetLines(lines);
  return result;
}
}

//------------------------------------------------------------------------------
Curve Circle(int count, double radius, Place centre)
{
  Curve curve;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / count;
    curve.push_back({ centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle) });
  }
  return curve;
}

//------------------------------------------------------------------------------
Curve Rectangle(Place lower, Place upper)
{
  return { lower, { upper[0], lower[1] }, upper, { lower[0], upper[1] } };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Loops(const std::vector<Curve>& curves, double z)
{
  auto points = NewPoints();
  vtkNew<vtkCellArray> lines;
  for (const Curve& curve : curves)
  {
    lines->InsertNextCell(static_cast<int>(curve.size()) + 1);
    const vtkIdType first = points->GetNumberOfPoints();
    for (const Place& place : curve)
    {
      lines->InsertCellPoint(points->InsertNextPoint(place[0], place[1], z));
    }
    lines->InsertCellPoint(first);
  }
  return NewLines(points, lines);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> OpenCurve(const Curve& curve)
{
  auto points = NewPoints();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(curve.size()));
  for (const Place& place : curve)
  {
    lines->InsertCellPoint(points->InsertNextPoint(place[0], place[1], 0.0));
  }
  return NewLines(points, lines);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> UntidyLoops(const std::vector<Curve>& curves, double z)
{
  std::vector<std::array<Place, 2>> segments;
  for (const Curve& curve : curves)
  {
    for (std::size_t i = curve.size(); i > 0; --i)
    {
      segments.push_back({ curve[i % curve.size()], curve[i - 1] });
    }
  }
  std::mt19937 random(7);
  for (std::size_t i = segments.size(); i > 1; --i)
  {
    std::swap(segments[i - 1], segments[random() % i]);
  }
  auto points = NewPoints();
  vtkNew<vtkCellArray> lines;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const auto& [from, to] = segments[i];
    const vtkIdType a = points->InsertNextPoint(from[0], from[1], z);
    const vtkIdType b = points->InsertNextPoint(to[0], to[1], z);
    lines->InsertNextCell({ i % 2 == 0 ? a : b, i % 2 == 0 ? b : a });
  }
  return NewLines(points, lines);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Singularities(const std::vector<Row>& rows)
{
  auto points = NewPoints();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkIntArray> quarters;
  quarters->SetName("QuarterIndex");
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radius");
  for (const auto& [x, y, quarterIndex, radius] : rows)
  {
    vertices->InsertNextCell({ points->InsertNextPoint(x, y, 0.0) });
    quarters->InsertNextValue(static_cast<int>(quarterIndex));
    radii->InsertNextValue(radius);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetVerts(vertices);
  result->GetPointData()->AddArray(quarters);
  result->GetPointData()->AddArray(radii);
  return result;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> FrameMesh()
{
  auto points = NewPoints();
  vtkNew<vtkCellArray> triangles;
  for (int j = 0; j <= 6; ++j)
  {
    for (int i = 0; i <= 6; ++i)
    {
      points->InsertNextPoint(i, j, 0.0);
    }
  }
  for (vtkIdType j = 0; j < 6; ++j)
  {
    for (vtkIdType i = 0; i < 6; ++i)
    {
      const bool inHole = i >= 2 && i < 4 && j >= 2 && j < 4;
      const vtkIdType corner = 7 * j + i;
      if (!inHole)
      {
        // One triangle of each square is clockwise, since the orientation of cells is arbitrary.
        triangles->InsertNextCell({ corner, corner + 1, corner + 8 });
        triangles->InsertNextCell({ corner, corner + 7, corner + 8 });
      }
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(triangles);
  return result;
}

//------------------------------------------------------------------------------
std::vector<Curve> FrameCurves()
{
  std::vector<Curve> curves;
  for (const auto& [lower, upper] : { std::array{ 0, 6 }, std::array{ 2, 4 } })
  {
    Curve curve;
    for (int i = lower; i < upper; ++i)
    {
      curve.push_back({ double(i), double(lower) });
    }
    for (int i = lower; i < upper; ++i)
    {
      curve.push_back({ double(upper), double(i) });
    }
    for (int i = upper; i > lower; --i)
    {
      curve.push_back({ double(i), double(upper) });
    }
    for (int i = upper; i > lower; --i)
    {
      curve.push_back({ double(lower), double(i) });
    }
    curves.push_back(curve);
  }
  return curves;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> AsUnstructuredGrid(vtkPolyData* input)
{
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->SetPoints(input->GetPoints());
  result->Allocate(input->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    input->GetCellPoints(cell, ids);
    result->InsertNextCell(input->GetCellType(cell), ids);
  }
  return result;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> Drill(
  vtkPolyData* domain, const std::vector<Row>& rows, double meshSize, int mode)
{
  vtkNew<vtkDrillHoles> drill;
  drill->SetMode(mode);
  drill->SetInputData(domain);
  drill->SetSingularitiesData(Singularities(rows));
  drill->SetMeshSize(meshSize);
  drill->Update();
  ResultFiles::Save(drill);
  return drill->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> DrilledDisk(double meshSize)
{
  return Drill(Loops({ Circle(64, 1.0) }), FourOnDisk(), meshSize);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> DrilledIsland()
{
  return Drill(Loops({ Rectangle({ 0.0, 0.0 }, { 6.0, 4.0 }), Circle(40, 0.7, { 4.5, 2.0 }) }),
    { { 1.5, 1.0, -1.0, 0.2 }, { 1.5, 3.0, -1.0, 0.1 }, { 3.0, 2.0, -2.0, 0.15 } }, 0.3);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> BlownUpCube(int n)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int end : { 0, 1 })
    {
      for (int i = 0; i < n * n; ++i)
      {
        const auto corner = [&](int di, int dj)
        {
          double place[3];
          const auto angle = [n](int k)
          { return std::tan(0.25 * 3.14159265358979 * (2.0 * k / n - 1.0)); };
          place[axis] = 2.0 * end - 1.0;
          place[(axis + 1) % 3] = angle(i % n + (end == 1 ? di : dj));
          place[(axis + 2) % 3] = angle(i / n + (end == 1 ? dj : di));
          const double norm = std::hypot(place[0], place[1], place[2]);
          return points->InsertNextPoint(place[0] / norm, place[1] / norm, place[2] / norm);
        };
        cells->InsertNextCell({ corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1) });
      }
    }
  }
  auto sphere = vtkSmartPointer<vtkPolyData>::New();
  sphere->SetPoints(points);
  sphere->SetPolys(cells);
  return sphere;
}

//------------------------------------------------------------------------------
std::vector<Row> FourOnDisk()
{
  const double d = 0.6 * std::sqrt(0.5);
  return { { d, d, 1.0, 0.1 }, { -d, d, 1.0, 0.1 }, { -d, -d, 1.0, 0.1 }, { d, -d, 1.0, 0.1 } };
}
}
