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

namespace names = vtkCrossFieldArrayNames;

namespace
{
/** Returns the index of the material of each cell, and sets names and values of the materials. */
template <class Key, class KeyOf, class NameOf>
std::vector<int> IndexMaterials(const std::vector<vtkIdType>& cells, const KeyOf& keyOf,
  const NameOf& nameOf, std::vector<Key>& keys)
{
  std::map<Key, int> index;
  for (const vtkIdType cell : cells)
  {
    index.emplace(keyOf(cell), 0);
  }
  for (auto& [key, number] : index)
  {
    number = static_cast<int>(keys.size());
    keys.push_back(key);
    nameOf(key);
  }
  std::vector<int> materials;
  std::transform(cells.begin(), cells.end(), std::back_inserter(materials),
    [&](vtkIdType cell) { return index.at(keyOf(cell)); });
  return materials;
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
Regions Read(vtkDataSet* input, const std::string& array)
{
  const vtkSmartPointer<vtkPolyData> surface = DomainConversion::ReadSurface(input);
  Regions regions;
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
  vtkAbstractArray* materials = input->GetCellData()->GetAbstractArray(array.c_str());
  if (auto* texts = vtkStringArray::SafeDownCast(materials))
  {
    std::vector<std::string> keys;
    cells.materials = IndexMaterials(
      ids, [texts](vtkIdType cell) { return std::string(texts->GetValue(cell)); },
      [&](const std::string& name)
      {
        cells.names.push_back(name);
        regions.values.push_back(static_cast<int>(regions.values.size()));
      },
      keys);
  }
  else
  {
    auto* numbers = vtkDataArray::SafeDownCast(materials);
    std::vector<int> keys;
    cells.materials = IndexMaterials(
      ids, [numbers](vtkIdType cell) { return static_cast<int>(numbers->GetTuple1(cell)); },
      [&](int value)
      {
        cells.names.push_back(std::to_string(value));
        regions.values.push_back(value);
      },
      keys);
  }
  regions.set = crossfield::MakeRegionSet(cells);
  return regions;
}

//------------------------------------------------------------------------------
void Write(const Regions& regions, const crossfield::QuadWorkflowResult& result,
  vtkUnstructuredGrid* quads, vtkMultiBlockDataSet* blocks, vtkPolyData* boundary,
  vtkFieldData* report)
{
  const auto valueOf = [&](int region)
  {
    const auto material = regions.set.regions[static_cast<std::size_t>(region)].material;
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
  ColumnWriting::AddColumn<vtkIntArray>(boundary->GetCellData(), names::RegionLeft, mesh.boundary,
    [&](const QuadBoundaryEdge& edge) { return find(edge.points[0], edge.points[1]); });
  ColumnWriting::AddColumn<vtkIntArray>(boundary->GetCellData(), names::RegionRight, mesh.boundary,
    [&](const QuadBoundaryEdge& edge) { return find(edge.points[1], edge.points[0]); });
  const auto text = [](const std::string& name) { return name; };
  ColumnWriting::AddColumn<vtkStringArray>(
    report, names::MaterialName, regions.set.materials, text);
  ColumnWriting::AddIntegers(report, names::MaterialValue, regions.values);
  using crossfield::RegionReport;
  ColumnWriting::AddColumn<vtkStringArray>(report, names::RegionName, result.regions,
    [&](const RegionReport& region)
    { return result.materials[static_cast<std::size_t>(region.material)]; });
  ColumnWriting::AddColumn<vtkIntArray>(report, names::RegionQuads, result.regions,
    [](const RegionReport& region) { return static_cast<int>(region.quads); });
  ColumnWriting::AddColumn<vtkIntArray>(report, names::RegionRequiredInteriorQuarters,
    result.regions, [](const RegionReport& region) { return region.requiredQuarters; });
  ColumnWriting::AddColumn<vtkIntArray>(report, names::RegionGivenInteriorQuarters, result.regions,
    [](const RegionReport& region) { return region.givenQuarters; });
}
}
