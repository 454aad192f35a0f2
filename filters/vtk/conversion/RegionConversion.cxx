#include "RegionConversion.h"

#include "ColumnWriting.h"
#include "MakeRegionSet.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace names = vtkCrossFieldArrayNames;

namespace
{
/** Reads the materials of surface cells, and sets the plane and the values of regions. */
crossfield::MaterialCells ReadCells(
  vtkDataSet* input, const std::string& array, RegionConversion::Regions& regions)
{
  const vtkSmartPointer<vtkPolyData> surface = DomainConversion::ReadSurface(input);
  regions.plane = DomainConversion::FindPlane(surface);
  crossfield::MaterialCells cells;
  for (vtkIdType point = 0; point < surface->GetNumberOfPoints(); ++point)
  {
    cells.points.push_back(regions.plane.ToPlane(Eigen::Vector3d(surface->GetPoint(point))));
  }
  vtkDataArray* original = surface->GetCellData()->GetArray("vtkOriginalCellIds");
  std::vector<vtkIdType> ids;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, corners);
    cells.cells.emplace_back(corners->begin(), corners->end());
    ids.push_back(static_cast<vtkIdType>(original->GetTuple1(cell)));
  }
  regions.values = RegionValues::Read(input, array, ids);
  cells.materials = regions.values.ofCell;
  cells.names = regions.values.names;
  return cells;
}
}

namespace RegionConversion
{
//------------------------------------------------------------------------------
std::vector<DomainConversion::Domain> Regions::Domains() const
{
  std::vector<DomainConversion::Domain> domains;
  for (const crossfield::Region& region : this->set.regions)
  {
    domains.push_back({ region.domain, this->plane });
  }
  return domains;
}

//------------------------------------------------------------------------------
Regions Read(
  vtkDataSet* input, const std::string& array, const LineConversion::Lines& lines, vtkObject* self)
{
  Regions regions;
  crossfield::MaterialCells cells;
  std::vector<crossfield::MaterialEdge> edges;
  if (!array.empty())
  {
    cells = ReadCells(input, array, regions);
    edges = crossfield::EdgesOf(cells);
  }
  else
  {
    const auto rest = LineConversion::Without(input, lines);
    for (const DomainConversion::Domain& part : DomainConversion::ReadParts(rest, self))
    {
      regions.plane = part.plane;
      const std::vector<crossfield::MaterialEdge> more = crossfield::EdgesOf(part.domain);
      edges.insert(edges.end(), more.begin(), more.end());
    }
    cells.names = { "domain" };
    regions.values.values = { 0 };
    regions.values.areNamed = true;
  }
  if (!lines.names.empty())
  {
    cells = crossfield::CellsAlongLines(edges, std::move(cells.names),
      LineConversion::Read(input, lines, regions.plane), lines.names);
  }
  regions.set = crossfield::MakeRegionSet(cells);
  return regions;
}

//------------------------------------------------------------------------------
void WriteCounts(const std::vector<crossfield::RegionReport>& regions,
  const std::vector<std::string>& materials, vtkFieldData* report)
{
  using crossfield::RegionReport;
  ColumnWriting::AddColumn<vtkStringArray>(report, names::RegionMaterial, regions,
    [&](const RegionReport& region)
    { return materials[static_cast<std::size_t>(region.material)]; });
  ColumnWriting::AddColumn<vtkIntArray>(report, names::RegionRequiredInteriorQuarters, regions,
    [](const RegionReport& region) { return region.requiredQuarters; });
  ColumnWriting::AddColumn<vtkIntArray>(report, names::RegionGivenInteriorQuarters, regions,
    [](const RegionReport& region) { return region.givenQuarters; });
}

//------------------------------------------------------------------------------
void Write(const RegionValues& regions, const crossfield::QuadWorkflowResult& result,
  vtkUnstructuredGrid* quads, vtkMultiBlockDataSet* blocks, vtkPolyData* boundary,
  vtkFieldData* report)
{
  const auto valueOf = [&](int region)
  {
    const int material = result.regions[static_cast<std::size_t>(region)].material;
    return regions.values[static_cast<std::size_t>(material)];
  };
  ColumnWriting::AddColumn<vtkIntArray>(
    quads->GetCellData(), names::Region, result.region, valueOf);
  std::vector<int> ofBlock(result.quads.blocks.blocks.size());
  for (std::size_t q = 0; q < result.region.size(); ++q)
  {
    ofBlock[static_cast<std::size_t>(result.quads.blocks.block[q])] = valueOf(result.region[q]);
  }
  for (unsigned int b = 0; b < blocks->GetNumberOfBlocks(); ++b)
  {
    auto* grid = vtkStructuredGrid::SafeDownCast(blocks->GetBlock(b));
    ColumnWriting::NewArray<vtkIntArray>(
      grid->GetCellData(), names::Region, 1, grid->GetNumberOfCells(), ofBlock[b]);
  }
  std::map<std::array<int, 2>, int> regionAt; // on the left of each side of a quad
  const crossfield::QuadMesh& mesh = result.quads.mesh;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      regionAt[{ mesh.quads[q][c], mesh.quads[q][(c + 1) % 4] }] = valueOf(result.region[q]);
    }
  }
  const auto find = [&](int from, int to)
  {
    const auto found = regionAt.find({ from, to });
    return found == regionAt.end() ? -1 : found->second;
  };
  using crossfield::QuadBoundaryEdge;
  for (const char* name : { names::Region, names::RegionLeft })
  {
    ColumnWriting::AddColumn<vtkIntArray>(boundary->GetCellData(), name, mesh.boundary,
      [&](const QuadBoundaryEdge& edge) { return find(edge.points[0], edge.points[1]); });
  }
  ColumnWriting::AddColumn<vtkIntArray>(boundary->GetCellData(), names::RegionRight, mesh.boundary,
    [&](const QuadBoundaryEdge& edge) { return find(edge.points[1], edge.points[0]); });
  if (regions.areNamed)
  {
    ColumnWriting::AddColumn<vtkStringArray>(
      report, names::RegionName, result.materials, [](const std::string& name) { return name; });
  }
  WriteCounts(result.regions, result.materials, report);
  ColumnWriting::AddColumn<vtkIntArray>(report, names::RegionQuads, result.regions,
    [](const crossfield::RegionReport& region) { return static_cast<int>(region.quads); });
  using crossfield::InterfaceMeasure;
  ColumnWriting::AddColumn<vtkStringArray>(report, names::InterfaceName, result.interfaces,
    [](const InterfaceMeasure& interface) { return interface.side; });
  ColumnWriting::AddColumn<vtkIntArray>(report, names::InterfaceEdges, result.interfaces,
    [](const InterfaceMeasure& interface) { return interface.edges; });
  const auto ratios = ColumnWriting::NewArray<vtkDoubleArray>(
    report, names::InterfaceSizeRatio, 2, static_cast<vtkIdType>(result.interfaces.size()));
  for (std::size_t i = 0; i < result.interfaces.size(); ++i)
  {
    const InterfaceMeasure& one = result.interfaces[i];
    ratios->SetTuple2(static_cast<vtkIdType>(i), one.largestRatio, one.medianRatio);
  }
}
}
