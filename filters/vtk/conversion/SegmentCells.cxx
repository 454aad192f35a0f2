#include "SegmentCells.h"

#include "BoundaryCorners.h"
#include "CellOutline.h"
#include "Segment.h"
#include "SegmentSearch.h"

#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

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

/** Finds the line cells that segments are parts of. */
class PartSearch
{
public:
  PartSearch(vtkDataSet* input, const DomainConversion::Domain& domain,
    const std::function<bool(vtkIdType)>& isWanted)
    : Reach(crossfield::BoundaryReach * domain.domain.Diagonal())
  {
    std::vector<crossfield::SegmentSearch::Segment> segments;
    const auto at = [&](vtkIdType point)
    { return domain.plane.ToPlane(Eigen::Vector3d(input->GetPoint(point))); };
    CellOutline::ForEachCell(input,
      [&](vtkIdType cell, int type, const auto& points)
      {
        const bool isLine = type == VTK_LINE || type == VTK_POLY_LINE;
        for (vtkIdType i = 1; isLine && i < points.Size() && isWanted(cell); ++i)
        {
          segments.push_back({ at(points[i - 1]), at(points[i]) });
          this->Cells.push_back(cell);
        }
      });
    if (!segments.empty())
    {
      this->Search.emplace(std::move(segments));
    }
  }

  /** Returns the line that a segment is a part of, −1 if there is none. */
  vtkIdType Find(const crossfield::Point& from, const crossfield::Point& to) const
  {
    if (!this->Search)
    {
      return -1;
    }
    const std::size_t nearest = this->Search->Find(0.5 * (from + to)).segment;
    const auto isOn = [&](const crossfield::Point& place)
    {
      const auto& [a, b] = this->Search->At(nearest);
      return crossfield::OffsetFromSegment(place, a, b).norm() <= this->Reach;
    };
    return isOn(from) && isOn(to) ? this->Cells[nearest] : -1;
  }

private:
  const double Reach;
  std::optional<crossfield::SegmentSearch> Search;
  std::vector<vtkIdType> Cells; // of the segments
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

//------------------------------------------------------------------------------
std::vector<std::vector<vtkIdType>> FindAround(vtkDataSet* input,
  const DomainConversion::Domain& domain, const std::function<bool(vtkIdType)>& isWanted)
{
  std::vector<std::vector<vtkIdType>> cells = Find(input, domain, isWanted);
  const PartSearch parts(input, domain, isWanted);
  for (std::size_t l = 0; l < cells.size(); ++l)
  {
    const crossfield::Loop& loop = domain.domain.loops[l];
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      vtkIdType& cell = cells[l][i];
      cell = cell < 0 ? parts.Find(loop[i], loop[(i + 1) % loop.size()]) : cell;
    }
  }
  return cells;
}
}
