#include "MeshReading.h"

#include "FilterChecks.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
MeshReading::MeshReading(vtkUnstructuredGrid* mesh)
{
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    this->points.emplace_back(mesh->GetPoint(i)[0], mesh->GetPoint(i)[1]);
  }
  const auto value = [mesh](const char* name, vtkIdType cell)
  {
    vtkDataArray* array = FilterChecks::RequireArray(mesh->GetCellData(), name);
    return static_cast<int>(array->GetTuple1(cell));
  };
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    if (mesh->GetCellType(cell) == VTK_LINE)
    {
      this->lines.push_back({ cell, { ids->GetId(0), ids->GetId(1) }, value("BoundaryKind", cell),
        value("BoundaryId", cell), value("QuarterIndex", cell) });
      continue;
    }
    EXPECT_EQ(mesh->GetCellType(cell), VTK_TRIANGLE);
    Triangle triangle{ cell, { ids->GetId(0), ids->GetId(1), ids->GetId(2) }, 0.0 };
    const Place& origin = this->points[triangle.points[0]];
    triangle.area = 0.5 *
      std::imag(std::conj(this->points[triangle.points[1]] - origin) *
        (this->points[triangle.points[2]] - origin));
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::array<vtkIdType, 2> side = { triangle.points[i], triangle.points[(i + 1) % 3] };
      const bool added = this->sides.insert({ side, { this->triangles.size(), i } }).second;
      EXPECT_TRUE(added) << "two triangles on the same side of an edge";
    }
    this->triangles.push_back(triangle);
  }
}

//------------------------------------------------------------------------------
double MeshReading::Area() const
{
  double area = 0.0;
  for (const Triangle& triangle : this->triangles)
  {
    area += triangle.area;
  }
  return area;
}

//------------------------------------------------------------------------------
double MeshReading::MinimumAngle() const
{
  double smallest = 180.0;
  for (const Triangle& triangle : this->triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Place& here = this->points[triangle.points[i]];
      const Place next = this->points[triangle.points[(i + 1) % 3]] - here;
      const Place last = this->points[triangle.points[(i + 2) % 3]] - here;
      smallest = std::min(smallest, std::abs(std::arg(last / next)) * 180.0 / std::acos(-1.0));
    }
  }
  return smallest;
}

//------------------------------------------------------------------------------
std::vector<std::size_t> MeshReading::OrderedLoop(int kind, int id) const
{
  std::map<vtkIdType, std::size_t> outgoing;
  for (std::size_t i = 0; i < this->lines.size(); ++i)
  {
    if (this->lines[i].kind == kind && this->lines[i].id == id)
    {
      outgoing[this->lines[i].points[0]] = i;
    }
  }
  EXPECT_FALSE(outgoing.empty()) << "no line of kind " << kind << " and id " << id;
  std::vector<std::size_t> walk;
  auto here = outgoing.begin();
  while (here != outgoing.end() && walk.size() < outgoing.size())
  {
    walk.push_back(here->second);
    here = outgoing.find(this->lines[here->second].points[1]);
  }
  EXPECT_TRUE(walk.size() == outgoing.size() && here == outgoing.begin())
    << "the lines of kind " << kind << " and id " << id << " are not one closed loop";
  return walk;
}
