#include "SegmentCells.h"

#include "BoundaryCorners.h"
#include "CellOutline.h"

#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <array>
#include <map>

namespace
{
/** The smaller and the larger end of a segment. */
using Segment = std::array<vtkIdType, 2>;

Segment Ends(vtkIdType a, vtkIdType b)
{
  return { std::min(a, b), std::max(a, b) };
}

/** Locates the vertices of a domain by their number. */
class VertexLocator
{
public:
  explicit VertexLocator(const DomainConversion::Domain& domain)
    : Plane(domain.plane)
    , Reach(crossfield::BoundaryReach * domain.domain.Diagonal())
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const crossfield::Loop& loop : domain.domain.loops)
    {
      for (const crossfield::Point& point : loop)
      {
        points->InsertNextPoint(point.x(), point.y(), 0.0);
      }
    }
    this->Vertices->SetPoints(points);
    this->Locator->SetDataSet(this->Vertices);
    this->Locator->BuildLocator();
  }

  /** Returns the vertex at a point of a data set, −1 if there is none. */
  vtkIdType Find(vtkDataSet* input, vtkIdType id) const
  {
    double place[3];
    input->GetPoint(id, place);
    const crossfield::Point point = this->Plane.ToPlane(Eigen::Vector3d(place));
    const double inPlane[3] = { point.x(), point.y(), 0.0 };
    double squaredDistance = 0.0;
    return this->Locator->FindClosestPointWithinRadius(this->Reach, inPlane, squaredDistance);
  }

private:
  const crossfield::DomainPlane& Plane;
  const double Reach;
  vtkNew<vtkPolyData> Vertices;
  vtkNew<vtkStaticPointLocator> Locator;
};
}

namespace SegmentCells
{
//------------------------------------------------------------------------------
std::vector<std::vector<vtkIdType>> Find(vtkDataSet* input, const DomainConversion::Domain& domain,
  const std::function<bool(vtkIdType)>& isWanted)
{
  const VertexLocator vertices(domain);
  std::map<Segment, vtkIdType> cellOf;
  CellOutline::ForEachCell(input,
    [&](vtkIdType cell, int type, const auto& points)
    {
      const bool isLine = type == VTK_LINE || type == VTK_POLY_LINE;
      for (vtkIdType i = 1; isLine && i < points.Size() && isWanted(cell); ++i)
      {
        cellOf.emplace(
          Ends(vertices.Find(input, points[i - 1]), vertices.Find(input, points[i])), cell);
      }
    });
  std::vector<std::vector<vtkIdType>> cells;
  vtkIdType first = 0;
  for (const crossfield::Loop& loop : domain.domain.loops)
  {
    const auto count = static_cast<vtkIdType>(loop.size());
    cells.emplace_back();
    for (vtkIdType i = 0; i < count; ++i)
    {
      const auto found = cellOf.find(Ends(first + i, first + (i + 1) % count));
      cells.back().push_back(found == cellOf.end() ? -1 : found->second);
    }
    first += count;
  }
  return cells;
}
}
