#include "ExportConversion.h"

#include "CellLattice.h"
#include "ColumnWriting.h"
#include "Error.h"
#include "GatherBlocks.h"
#include "HigherOrderConversion.h"
#include "Index.h"
#include "InputCheck.h"
#include "PeriodicConversion.h"
#include "SideFaces.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataSet.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <map>

namespace names = vtkCrossFieldArrayNames;

namespace
{
using crossfield::Error;
using crossfield::ExportMesh;
using crossfield::Index;

/** What a type of cell is. */
struct CellKind
{
  int dimension = 0; ///< 0 for cells that no mesh has.
  int order = 0;
};

CellKind KindOf(int type, vtkIdType points)
{
  switch (type)
  {
  case VTK_LINE:
    return { 1, 1 };
  case VTK_QUADRATIC_EDGE:
    return { 1, 2 };
  case VTK_LAGRANGE_CURVE:
    return { points == 4 ? 1 : 0, 3 };
  case VTK_TRIANGLE: // of the boundary of prisms
  case VTK_QUAD:
    return { 2, 1 };
  case VTK_BIQUADRATIC_QUAD:
    return { 2, 2 };
  case VTK_LAGRANGE_QUADRILATERAL:
    return { points == 16 ? 2 : 0, 3 };
  case VTK_WEDGE:
  case VTK_HEXAHEDRON:
    return { 3, 1 };
  case VTK_TRIQUADRATIC_HEXAHEDRON:
    return { 3, 2 };
  default:
    return {};
  }
}

/** Corners of a hexahedron that is a prism, as numbers of the points of a VTK_WEDGE. */
constexpr std::array<vtkIdType, 8> PrismCorners = { 0, 3, 5, 2, 0, 3, 4, 1 };

/** Positions in the lattice (ExportMesh.h) of the nodes of a cell in VTK's order. */
std::vector<int> LatticeOrder(int dimension, int order)
{
  if (dimension == 2)
  {
    std::vector<int> positions;
    for (const std::size_t position : HigherOrderConversion::LatticeOrder(order))
    {
      positions.push_back(static_cast<int>(position));
    }
    return positions;
  }
  std::vector<int> positions = crossfield::CellLattice(3, order).AbaqusOrder(); // corners, edges
  if (order == 2)
  {
    // Middles of the faces with least and largest first, second and third index, then the middle.
    positions.insert(positions.end(), { 12, 14, 10, 16, 4, 22, 13 });
  }
  return positions;
}

/** Adds the nodes of a cell of a data set as a lattice. */
void AddCell(vtkIdList* ids, int type, const std::vector<int>& order, std::vector<int>& cells)
{
  const std::size_t first = cells.size();
  cells.resize(first + order.size());
  for (std::size_t node = 0; node < order.size(); ++node)
  {
    const vtkIdType number = type == VTK_WEDGE ? PrismCorners[node] : static_cast<vtkIdType>(node);
    cells[first + static_cast<std::size_t>(order[node])] = static_cast<int>(ids->GetId(number));
  }
}

/** Adds the corners of a face of a data set. */
void AddFace(vtkIdList* ids, int corners, std::vector<int>& faces)
{
  for (int corner = 0; corner < corners; ++corner)
  {
    // A triangle repeats its last corner.
    const vtkIdType last = ids->GetNumberOfIds() - 1;
    faces.push_back(static_cast<int>(ids->GetId(std::min<vtkIdType>(corner, last))));
  }
}

int SideOf(const std::string& name, std::map<std::string, int>& numbers, ExportMesh& mesh)
{
  const auto [side, isNew] = numbers.emplace(name, static_cast<int>(mesh.sideNames.size()));
  if (isNew)
  {
    mesh.sideNames.push_back(name);
  }
  return side->second;
}

int DimensionOf(vtkUnstructuredGrid* mesh)
{
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const int type = mesh->GetCellType(cell);
    if (type == VTK_HEXAHEDRON || type == VTK_WEDGE || type == VTK_TRIQUADRATIC_HEXAHEDRON)
    {
      return 3;
    }
  }
  return 2;
}

std::vector<crossfield::ExportBlock> ReadBlocks(
  const ExportConversion::Cells& cells, vtkCellData* data)
{
  std::vector<vtkDataArray*> arrays;
  for (const char* name : { names::BlockId, names::I, names::J, names::K })
  {
    arrays.push_back(data->GetArray(name));
    if (arrays.back() == nullptr && (name != names::K || cells.mesh.dimension == 3))
    {
      return {};
    }
  }
  std::vector<crossfield::BlockPlace> places;
  for (const vtkIdType cell : cells.cells)
  {
    const auto value = [&](std::size_t array)
    { return arrays[array] ? static_cast<int>(arrays[array]->GetTuple1(cell)) : 0; };
    places.push_back({ value(0), { value(1), value(2), value(3) } });
  }
  return crossfield::GatherBlocks(cells.mesh, places);
}

/** Reads which sides are the ends of a sweep. */
crossfield::SweepEnds ReadSweep(vtkFieldData* data, const std::map<std::string, int>& sides)
{
  crossfield::SweepEnds sweep;
  vtkDataArray* layers = data->GetArray(names::SweepLayers);
  vtkDataArray* angle = data->GetArray(names::SweepAngle);
  auto* ends = vtkStringArray::SafeDownCast(data->GetAbstractArray(names::SweepEnds));
  if (layers == nullptr || layers->GetNumberOfValues() != 1)
  {
    return sweep;
  }
  sweep.layers = static_cast<int>(layers->GetTuple1(0));
  sweep.isRotation = angle != nullptr;
  if (ends != nullptr && ends->GetNumberOfValues() == 2)
  {
    const auto find = [&](vtkIdType i)
    {
      const auto side = sides.find(ends->GetValue(i));
      return side == sides.end() ? -1 : side->second;
    };
    sweep.back = find(0);
    sweep.front = find(1);
  }
  return sweep;
}

/** Inserts a cell: a hexahedron or a prism. */
vtkIdType InsertCell(
  const ExportMesh& mesh, int cell, const std::vector<int>& order, vtkUnstructuredGrid* output)
{
  std::vector<vtkIdType> ids;
  const int collapsed = mesh.CollapsedEdge(cell);
  if (collapsed >= 0)
  {
    const std::array<int, 6> prism = mesh.Prism(cell, collapsed);
    for (const std::size_t i :
      { 0U, 2U, 1U, 3U, 5U, 4U }) // the normals of VTK's triangle point outwards
    {
      ids.push_back(prism[i]);
    }
    return output->InsertNextCell(VTK_WEDGE, 6, ids.data());
  }
  for (const int position : order)
  {
    ids.push_back(mesh.Cell(cell)[position]);
  }
  return output->InsertNextCell(mesh.order == 1 ? VTK_HEXAHEDRON : VTK_TRIQUADRATIC_HEXAHEDRON,
    static_cast<vtkIdType>(ids.size()), ids.data());
}

/** Inserts a face in VTK's order, a triangle if a node occurs twice. */
vtkIdType InsertFace(std::vector<int> nodes, vtkUnstructuredGrid* output)
{
  const int type = nodes.size() > 4 ? VTK_BIQUADRATIC_QUAD : VTK_QUAD;
  crossfield::RemoveRepeated(nodes);
  const std::vector<vtkIdType> ids(nodes.begin(), nodes.end());
  return output->InsertNextCell(
    ids.size() == 3 ? VTK_TRIANGLE : type, static_cast<vtkIdType>(ids.size()), ids.data());
}

/** Sets the arrays that are not those of the quads: layers, and the sides and places of faces. */
void WriteSweptArrays(const crossfield::SweptMesh& swept, vtkUnstructuredGrid* output)
{
  const ExportMesh& mesh = swept.mesh;
  vtkCellData* data = output->GetCellData();
  const vtkIdType cells = mesh.CellCount();
  auto layers =
    ColumnWriting::NewArray<vtkIntArray>(data, names::K, 1, output->GetNumberOfCells(), -1);
  const auto quads = static_cast<int>(cells / mesh.sweep.layers);
  vtkNew<vtkStringArray> sides;
  sides->SetName(names::Side);
  sides->SetNumberOfValues(output->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    layers->SetValue(cell, static_cast<int>(cell) / quads);
  }
  for (int face = 0; face < mesh.FaceCount(); ++face)
  {
    sides->SetValue(cells + face, mesh.sideNames[Index(mesh.side[Index(face)])]);
    for (const char* name : { names::I, names::J })
    {
      if (vtkDataArray* array = data->GetArray(name))
      {
        array->SetTuple1(cells + face, -1.0);
      }
    }
  }
  data->AddArray(sides);
}
}

namespace ExportConversion
{
//------------------------------------------------------------------------------
Cells ReadMesh(vtkUnstructuredGrid* mesh)
{
  Cells cells;
  ExportMesh& result = cells.mesh;
  result.order = 0;
  result.dimension = DimensionOf(mesh);
  result.regionNames = { "domain" };
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    InputCheck::RequireFinite(mesh->GetPoint(i), i);
    result.points.emplace_back(mesh->GetPoint(i));
  }
  auto* sides = vtkStringArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray(names::Side));
  std::map<std::string, int> numbers;
  std::vector<int> order; // per node in VTK's order, its position in the lattice
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const int type = mesh->GetCellType(cell);
    mesh->GetCellPoints(cell, ids);
    const CellKind kind = KindOf(type, ids->GetNumberOfIds());
    const bool isCell = kind.dimension == result.dimension && type != VTK_TRIANGLE;
    const bool isFace = kind.dimension == result.dimension - 1;
    if ((!isCell && !isFace) || (result.order != 0 && kind.order != result.order))
    {
      throw Error(
        "The mesh has other cells than quads and lines of one order; give the quads of a Quad "
        "Mesher, of Quads To Higher Order or the hexahedra of Extrude Quads.");
    }
    if (result.order == 0)
    {
      result.order = kind.order;
      order = LatticeOrder(result.dimension, result.order);
    }
    if (isCell)
    {
      AddCell(ids, type, order, result.cells);
      result.region.push_back(0);
      cells.cells.push_back(cell);
      continue;
    }
    if (sides == nullptr)
    {
      throw Error(
        "The boundary edges have no cell array Side of strings; give the quads of a Quad Mesher.");
    }
    AddFace(ids, result.CornersOfFace(), result.faces);
    result.side.push_back(SideOf(sides->GetValue(cell), numbers, result));
    cells.faces.push_back(cell);
  }
  if (result.region.empty())
  {
    throw Error("The mesh has no quads; give the quads of a Quad Mesher.");
  }
  if (result.side.empty())
  {
    throw Error(
      "The quads have no boundary edges; put Quads To Higher Order with Order 1 directly behind Quad "
      "Mesher, before filters that change points or cells.");
  }
  result.blocks = ReadBlocks(cells, mesh->GetCellData());
  result.sweep = ReadSweep(mesh->GetFieldData(), numbers);
  result.periodic = PeriodicConversion::Read(mesh->GetFieldData(), result.sideNames);
  return cells;
}

//------------------------------------------------------------------------------
void WriteSwept(const crossfield::SweptMesh& swept, const Cells& quads, vtkUnstructuredGrid* from,
  vtkUnstructuredGrid* output)
{
  const ExportMesh& mesh = swept.mesh;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  output->SetPoints(points);
  output->Allocate(mesh.CellCount() + mesh.FaceCount());
  vtkPointData* pointData = output->GetPointData();
  pointData->CopyAllocate(from->GetPointData(), static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    pointData->CopyData(
      from->GetPointData(), swept.pointOf[i], points->InsertNextPoint(mesh.points[i].data()));
  }
  output->Allocate(mesh.CellCount() + mesh.FaceCount());
  vtkCellData* cellData = output->GetCellData();
  cellData->CopyAllocate(from->GetCellData(), mesh.CellCount() + mesh.FaceCount());
  const std::vector<int> order = LatticeOrder(3, mesh.order);
  for (int cell = 0; cell < mesh.CellCount(); ++cell)
  {
    const vtkIdType number = InsertCell(mesh, cell, order, output);
    cellData->CopyData(from->GetCellData(), quads.cells[Index(swept.cellOf[Index(cell)])], number);
  }
  const crossfield::SideFaces faces = crossfield::FindSideFaces(mesh);
  const crossfield::CellLattice lattice(3, mesh.order);
  std::vector<std::size_t> next(mesh.sideNames.size(), 0);
  for (int face = 0; face < mesh.FaceCount(); ++face)
  {
    const std::size_t side = Index(mesh.side[Index(face)]);
    const crossfield::SideFace& part = faces.ofSide[side][next[side]++];
    const std::vector<int> positions = lattice.Face(part.face);
    std::vector<int> nodes;
    for (const std::size_t position : HigherOrderConversion::LatticeOrder(mesh.order))
    {
      nodes.push_back(mesh.Cell(part.cell)[positions[position]]);
    }
    const vtkIdType number = InsertFace(nodes, output);
    // Data of the quad that the cell comes from, so that colours of faces and cells agree.
    cellData->CopyData(
      from->GetCellData(), quads.cells[Index(swept.cellOf[Index(part.cell)])], number);
    const int edge = swept.faceOf[Index(face)];
    for (const char* name : { names::BoundaryKind, names::BoundaryId, names::Curve })
    {
      vtkDataArray* array = cellData->GetArray(name);
      if (edge >= 0 && array != nullptr)
      {
        array->SetTuple(number, quads.faces[Index(edge)], from->GetCellData()->GetArray(name));
      }
    }
  }
  WriteSweptArrays(swept, output);
  vtkFieldData* report = output->GetFieldData();
  report->ShallowCopy(from->GetFieldData());
  ColumnWriting::AddIntegers(report, names::SweepLayers, { mesh.sweep.layers });
  ColumnWriting::AddIntegers(report, names::Hexahedra, { mesh.CellCount() });
  const auto nameOf = [&](int side) { return side < 0 ? "" : mesh.sideNames[Index(side)]; };
  ColumnWriting::AddColumn<vtkStringArray>(
    report, names::SweepEnds, std::vector<int>{ mesh.sweep.back, mesh.sweep.front }, nameOf);
}

//------------------------------------------------------------------------------
void WriteBlocks(const ExportMesh& mesh, vtkMultiBlockDataSet* output)
{
  output->SetNumberOfBlocks(static_cast<unsigned int>(mesh.blocks.size()));
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
  {
    const crossfield::ExportBlock& block = mesh.blocks[b];
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const int node : block.nodes)
    {
      points->InsertNextPoint(mesh.points[Index(node)].data());
    }
    vtkNew<vtkStructuredGrid> grid;
    grid->SetDimensions(block.cells[0] + 1, block.cells[1] + 1, block.cells[2] + 1);
    grid->SetPoints(points);
    ColumnWriting::NewArray<vtkIntArray>(
      grid->GetCellData(), names::BlockId, 1, grid->GetNumberOfCells(), static_cast<int>(b));
    const auto number = static_cast<unsigned int>(b);
    output->SetBlock(number, grid);
    output->GetMetaData(number)->Set(
      vtkCompositeDataSet::NAME(), ("block" + std::to_string(b)).c_str());
  }
}
}
