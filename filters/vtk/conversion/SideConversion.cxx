#include "SideConversion.h"

#include "BoundaryCorners.h"
#include "CellLoop.h"
#include "ColumnWriting.h"
#include "Error.h"
#include "QuadMesher.h"
#include "QuadSides.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStaticPointLocator.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace names = vtkCrossFieldArrayNames;

namespace
{
using crossfield::Error;

/** Reads the names of cells. */
class CellNames
{
public:
  CellNames(vtkDataSet* input, const std::string& array)
    : Texts(vtkStringArray::SafeDownCast(input->GetCellData()->GetAbstractArray(array.c_str())))
    , Numbers(input->GetCellData()->GetArray(array.c_str()))
  {
  }

  bool IsValid() const
  {
    return this->Texts != nullptr ||
      (this->Numbers != nullptr && this->Numbers->GetNumberOfComponents() == 1 &&
        this->Numbers->GetDataType() != VTK_FLOAT && this->Numbers->GetDataType() != VTK_DOUBLE);
  }

  std::string Of(vtkIdType cell) const
  {
    return this->Texts != nullptr
      ? this->Texts->GetValue(cell)
      : std::to_string(static_cast<long long>(this->Numbers->GetTuple1(cell)));
  }

private:
  vtkStringArray* Texts;
  vtkDataArray* Numbers;
};

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

namespace SideConversion
{
//------------------------------------------------------------------------------
std::string FindArray(vtkDataSet* input, const std::string& requested)
{
  const std::string array = requested.empty() ? names::Side : requested;
  if (input->GetCellData()->GetAbstractArray(array.c_str()) == nullptr)
  {
    if (requested.empty())
    {
      return {};
    }
    throw Error("The domain has no cell array '" + requested +
      "' with the names of its sides; give the name of a string or integer array of its lines, or "
      "none.");
  }
  if (!CellNames(input, array).IsValid())
  {
    if (requested.empty())
    {
      return {};
    }
    throw Error("The cell array '" + requested +
      "' with the names of sides holds neither strings nor single integers; convert it.");
  }
  return array;
}

//------------------------------------------------------------------------------
crossfield::BoundarySides ReadSides(
  vtkDataSet* input, const std::string& requested, const DomainConversion::Domain& domain)
{
  const std::string array = FindArray(input, requested);
  if (array.empty())
  {
    return crossfield::NameSides(domain.domain);
  }
  const CellNames cellNames(input, array);
  const VertexLocator vertices(domain);
  std::map<Segment, std::string> nameOf;
  CellLoop::ForEachCell(input,
    [&](vtkIdType cell, int type, const auto& points)
    {
      const std::string name =
        type == VTK_LINE || type == VTK_POLY_LINE ? cellNames.Of(cell) : std::string();
      for (vtkIdType i = 1; !name.empty() && i < points.Size(); ++i)
      {
        nameOf.emplace(
          Ends(vertices.Find(input, points[i - 1]), vertices.Find(input, points[i])), name);
      }
    });
  crossfield::SegmentNames segments;
  vtkIdType first = 0;
  bool isNamed = false;
  for (const crossfield::Loop& loop : domain.domain.loops)
  {
    const auto count = static_cast<vtkIdType>(loop.size());
    segments.emplace_back();
    for (vtkIdType i = 0; i < count; ++i)
    {
      const auto found = nameOf.find(Ends(first + i, first + (i + 1) % count));
      segments.back().push_back(found == nameOf.end() ? std::string() : found->second);
      isNamed = isNamed || found != nameOf.end();
    }
    first += count;
  }
  if (!isNamed && !requested.empty())
  {
    throw Error("The cell array '" + requested +
      "' names no part of the boundary; give lines along the boundary with their names.");
  }
  return crossfield::NameSides(domain.domain, segments);
}

//------------------------------------------------------------------------------
void WriteSides(const crossfield::QuadMesh& mesh, vtkCellData* data)
{
  ColumnWriting::AddColumn<vtkStringArray>(data, names::Side, mesh.boundary,
    [&mesh](const crossfield::QuadBoundaryEdge& edge) {
      return edge.side < 0 ? std::string() : mesh.sideNames[static_cast<std::size_t>(edge.side)];
    });
}

//------------------------------------------------------------------------------
void WriteBlockSides(const crossfield::QuadResult& result, vtkMultiBlockDataSet* blocks)
{
  const auto sides = crossfield::SidesOfBlocks(result.mesh, result.blocks.blocks);
  for (std::size_t b = 0; b < sides.size(); ++b)
  {
    ColumnWriting::AddColumn<vtkStringArray>(
      blocks->GetBlock(static_cast<unsigned int>(b))->GetFieldData(), names::SideName, sides[b],
      [&result](const std::vector<int>& ofSide)
      {
        std::string text;
        for (const int side : ofSide)
        {
          text += (text.empty() ? "" : ",") + result.mesh.sideNames[static_cast<std::size_t>(side)];
        }
        return text;
      });
  }
}

//------------------------------------------------------------------------------
void WriteReport(const crossfield::QuadMesh& mesh, vtkFieldData* data)
{
  const std::vector<crossfield::SideMeasure> measures = crossfield::MeasureSides(mesh);
  ColumnWriting::AddColumn<vtkStringArray>(
    data, names::SideNames, mesh.sideNames, [](const std::string& name) { return name; });
  ColumnWriting::AddColumn<vtkIntArray>(data, names::SideEdges, measures,
    [](const crossfield::SideMeasure& measure) { return measure.edges; });
  ColumnWriting::AddColumn<vtkDoubleArray>(data, names::SideLengths, measures,
    [](const crossfield::SideMeasure& measure) { return measure.length; });
}
}
