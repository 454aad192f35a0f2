#include "NamedSurface.h"

#include "CellOutline.h"
#include "Error.h"
#include "MaterialCheck.h"
#include "SideConversion.h"
#include "SurfaceConversion.h"

#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace
{
/** Finds the points of a surface at places of its data set. */
class PointSearch
{
public:
  explicit PointSearch(const crossfield::SurfaceMesh& surface)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const crossfield::SpacePoint& point : surface.points)
    {
      points->InsertNextPoint(point.data());
    }
    this->Points->SetPoints(points);
    this->Locator->SetDataSet(this->Points);
    this->Locator->BuildLocator();
    // Points that were merged are up to 1e-9 of the diagonal away.
    constexpr double Merged = 2e-9;
    this->Reach = Merged * this->Points->GetLength();
  }

  /** Returns the point at a place, −1 if there is none. */
  int At(const crossfield::SpacePoint& place) const
  {
    double squared = 0.0;
    return static_cast<int>(
      this->Locator->FindClosestPointWithinRadius(this->Reach, place.data(), squared));
  }

private:
  vtkNew<vtkPolyData> Points;
  vtkNew<vtkStaticPointLocator> Locator;
  double Reach = 0.0;
};

using EdgeSides = std::map<std::array<int, 2>, std::vector<std::array<int, 2>>>;

/** Returns the sides of triangles at each edge. */
EdgeSides SidesAtEdges(const crossfield::SurfaceMesh& surface)
{
  EdgeSides result;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t)
  {
    const std::array<int, 3>& v = surface.triangles[static_cast<std::size_t>(t)];
    for (int i = 0; i < 3; ++i)
    {
      const auto [least, largest] =
        std::minmax(v[static_cast<std::size_t>(i)], v[static_cast<std::size_t>((i + 1) % 3)]);
      result[{ least, largest }].push_back({ t, i });
    }
  }
  return result;
}

/** Reads the lines of line cells with a name. */
void ReadLines(vtkDataSet* input, const std::string& sides, NamedSurface& surface)
{
  const std::vector<std::string> names = SideConversion::NamesOfCells(input, sides);
  std::vector<std::pair<std::string, std::vector<crossfield::SpacePoint>>> lines;
  CellOutline::ForEachCell(input,
    [&](vtkIdType cell, int type, const CellLoop::Points& points)
    {
      const auto index = static_cast<std::size_t>(cell);
      const bool isLine = type == VTK_LINE || type == VTK_POLY_LINE;
      if (!isLine || index >= names.size() || names[index].empty())
      {
        return;
      }
      lines.emplace_back(names[index], std::vector<crossfield::SpacePoint>());
      for (const vtkIdType point : points)
      {
        lines.back().second.emplace_back(input->GetPoint(point));
      }
    });
  if (lines.empty())
  {
    return;
  }
  const PointSearch search(surface.mesh);
  const EdgeSides edges = SidesAtEdges(surface.mesh);
  std::map<std::string, int> numbers;
  surface.mesh.lines.assign(surface.mesh.triangles.size(), { -1, -1, -1 });
  for (const auto& [name, places] : lines)
  {
    const auto [number, isNew] =
      numbers.emplace(name, static_cast<int>(surface.names.lines.size()));
    if (isNew)
    {
      surface.names.lines.push_back(name);
    }
    for (std::size_t i = 1; i < places.size(); ++i)
    {
      const auto [from, to] = std::minmax({ search.At(places[i - 1]), search.At(places[i]) });
      const auto found = edges.find({ from, to });
      if (found == edges.end())
      {
        throw crossfield::Error("The line '" + name + "' from " +
          crossfield::DescribeInSpace(places[i - 1]) + " to " +
          crossfield::DescribeInSpace(places[i]) +
          " is along no edge of the surface; give lines along its edges, or remove their names.");
      }
      for (const auto& [triangle, side] : found->second)
      {
        surface.mesh.lines[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(side)] =
          number->second;
      }
    }
  }
}
}

//------------------------------------------------------------------------------
NamedSurface NamedSurface::Read(
  vtkDataSet* input, const std::string& materials, const std::string& sides)
{
  NamedSurface result;
  std::vector<vtkIdType> cells;
  result.mesh = SurfaceConversion::ReadTriangles(input, &cells);
  const std::string array = MaterialCheck::FindArray(input, materials);
  if (!array.empty())
  {
    result.regions = RegionValues::Read(input, array, cells);
    result.mesh.regions = result.regions.ofCell;
    result.names.regions = result.regions.names;
  }
  ReadLines(input, sides, result);
  return result;
}
