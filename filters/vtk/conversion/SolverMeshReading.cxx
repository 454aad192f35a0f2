#include "SolverMeshReading.h"

#include "BoundarySides.h"
#include "CellLoop.h"
#include "CurveConversion.h"
#include "Error.h"
#include "Index.h"
#include "InputCheck.h"
#include "MeshBlocks.h"
#include "PeriodicConversion.h"
#include "PrismLattice.h"
#include "QuadConversion.h"
#include "SegmentCurveConversion.h"
#include "SolverCells.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace names = vtkCrossFieldArrayNames;

namespace
{
using crossfield::Error;
using crossfield::Index;
using crossfield::SolverMesh;
using SolverCells::CellKind;
using SolverCells::Kinds;

/** Throws Error unless quads and boundary have the arrays of vtkQuadMesher's outputs. */
void RequireBoundaryOf(vtkUnstructuredGrid* quads, vtkPolyData* boundary)
{
  const auto hasCells = [](vtkDataSet* data, const char* name)
  { return data->GetCellData()->GetAbstractArray(name) != nullptr; };
  vtkDataArray* vertices = boundary->GetPointData()->GetArray(names::VertexId);
  const auto isVertex = [&](vtkIdType i)
  {
    const double id = vertices->GetTuple1(i);
    return id >= 0.0 && id < static_cast<double>(quads->GetNumberOfPoints());
  };
  bool isValid = vertices != nullptr && vertices->GetNumberOfComponents() == 1 &&
    boundary->GetNumberOfLines() == boundary->GetNumberOfCells();
  for (vtkIdType i = 0; isValid && i < boundary->GetNumberOfPoints(); ++i)
  {
    isValid = isVertex(i);
  }
  for (vtkIdType i = 0; isValid && i < boundary->GetNumberOfCells(); ++i)
  {
    isValid = boundary->GetCellType(i) == VTK_LINE;
  }
  for (const char* name : { names::BoundaryKind, names::BoundaryId, names::Side })
  {
    isValid = isValid && hasCells(boundary, name);
  }
  for (const char* name :
    { names::BlockId, names::I, names::J, names::ScaledJacobian, names::SizeRatio })
  {
    isValid = isValid && hasCells(quads, name);
  }
  if (!isValid)
  {
    throw Error(
      "The inputs are not the quads and the boundary of one mesh; connect the outputs Quads "
      "and Boundary of the same Quad Mesher.");
  }
}

/** Returns whether a cell is a triangle, the face of a prism. */
bool IsTriangle(int type)
{
  return type == VTK_TRIANGLE || type == VTK_QUADRATIC_TRIANGLE;
}

/**
 * Adds a cell of a grid as a lattice of `size` nodes, given the position of each of its nodes
 * there.
 */
void AddCell(const CellLoop::Points& ids, std::size_t size, const std::vector<int>& positions,
  std::vector<int>& cells)
{
  const std::size_t first = cells.size();
  cells.resize(first + size);
  for (std::size_t node = 0; node < positions.size(); ++node)
  {
    cells[first + Index(positions[node])] = static_cast<int>(ids[static_cast<vtkIdType>(node)]);
  }
}

/** Adds the corners of a face of a grid. */
void AddFace(const CellLoop::Points& ids, int type, int corners, std::vector<int>& faces)
{
  for (int corner = 0; corner < corners; ++corner)
  {
    // A triangle repeats its last corner.
    faces.push_back(static_cast<int>(ids[IsTriangle(type) && corner == 3 ? 2 : corner]));
  }
}

int SideOf(const std::string& name, std::map<std::string, int>& numbers, SolverMesh& mesh)
{
  const auto [side, isNew] = numbers.emplace(name, static_cast<int>(mesh.sideNames.size()));
  if (isNew)
  {
    mesh.sideNames.push_back(name);
  }
  return side->second;
}

std::vector<crossfield::MeshBlock> ReadBlocks(const SolverMesh& mesh, vtkCellData* data)
{
  std::vector<vtkDataArray*> arrays;
  for (const char* name : { names::BlockId, names::I, names::J, names::K })
  {
    arrays.push_back(data->GetArray(name));
    if (arrays.back() == nullptr && (name != names::K || mesh.dimension == 3))
    {
      return {};
    }
  }
  std::vector<crossfield::BlockPlace> places;
  for (const int cell : mesh.sources.cells)
  {
    const auto value = [&](std::size_t array)
    { return arrays[array] ? static_cast<int>(arrays[array]->GetTuple1(cell)) : 0; };
    places.push_back({ value(0), { value(1), value(2), value(3) } });
  }
  return crossfield::GatherBlocks(mesh, places);
}

/** Reads the materials of the cells, if they have several. */
void ReadRegions(vtkUnstructuredGrid* grid, SolverMesh& mesh)
{
  vtkDataArray* regions = grid->GetCellData()->GetArray(names::Region);
  if (regions == nullptr || regions->GetNumberOfComponents() != 1)
  {
    return;
  }
  std::map<int, int> numbers;
  for (const int cell : mesh.sources.cells)
  {
    numbers.emplace(static_cast<int>(regions->GetTuple1(cell)), 0);
  }
  auto* texts =
    vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray(names::RegionName));
  mesh.regionNames.clear();
  for (auto& [value, number] : numbers)
  {
    number = static_cast<int>(mesh.regionNames.size());
    const bool isNamed = texts != nullptr && value >= 0 && value < texts->GetNumberOfValues();
    mesh.regionNames.push_back(isNamed ? texts->GetValue(value) : std::to_string(value));
  }
  for (std::size_t cell = 0; cell < mesh.region.size(); ++cell)
  {
    mesh.region[cell] = numbers.at(static_cast<int>(regions->GetTuple1(mesh.sources.cells[cell])));
  }
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

/** Returns whether each edge of the quads of a mesh has two of them, as on a closed surface. */
bool IsClosed(vtkUnstructuredGrid* grid)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> quadsAt;
  CellLoop::ForEachCell(grid,
    [&quadsAt](vtkIdType, int, const CellLoop::Points& points)
    {
      constexpr vtkIdType Corners = 4; // first in all orders
      for (vtkIdType i = 0; points.Size() >= Corners && i < Corners; ++i)
      {
        ++quadsAt[std::minmax(points[i], points[(i + 1) % Corners])];
      }
    });
  return std::all_of(
    quadsAt.begin(), quadsAt.end(), [](const auto& edge) { return edge.second == 2; });
}
}

namespace SolverMeshReading
{
//------------------------------------------------------------------------------
void Join(vtkUnstructuredGrid* quads, vtkPolyData* boundary, vtkUnstructuredGrid* grid)
{
  InputCheck::Require(quads);
  if (boundary == nullptr || boundary->GetNumberOfCells() == 0)
  {
    grid->ShallowCopy(quads);
    return;
  }
  InputCheck::Require(boundary);
  RequireBoundaryOf(quads, boundary);
  QuadConversion::Combine(quads, boundary, grid);
  SegmentCurveConversion::CopyCurves(boundary, grid);
  PeriodicConversion::Copy(boundary->GetFieldData(), grid->GetFieldData());
}

//------------------------------------------------------------------------------
SolverMesh Read(vtkUnstructuredGrid* grid)
{
  SolverMesh mesh;
  mesh.order = 0;
  mesh.regionNames = { "domain" };
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    InputCheck::RequireFinite(grid->GetPoint(i), i);
    mesh.points.emplace_back(grid->GetPoint(i));
  }
  mesh.sources.points.resize(mesh.points.size());
  std::iota(mesh.sources.points.begin(), mesh.sources.points.end(), 0);
  const auto kindOf = [](int type)
  {
    return std::find_if(
      Kinds.begin(), Kinds.end(), [type](const CellKind& kind) { return kind.type == type; });
  };
  CellLoop::ForEachCell(grid,
    [&](vtkIdType, int type, const CellLoop::Points&)
    {
      const auto* kind = kindOf(type);
      mesh.dimension = kind != Kinds.end() && kind->dimension == 3 ? 3 : mesh.dimension;
    });
  auto* sides = vtkStringArray::SafeDownCast(grid->GetCellData()->GetAbstractArray(names::Side));
  std::map<std::string, int> numbers;
  // Per node in VTK's order, its position in the lattice.
  std::vector<int> order;
  std::vector<int> prism;
  CellLoop::ForEachCell(grid,
    [&](vtkIdType cell, int type, const CellLoop::Points& ids)
    {
      const auto* kind = kindOf(type);
      const bool isKnown = kind != Kinds.end() && kind->points == ids.Size();
      const bool isCell = isKnown && kind->dimension == mesh.dimension && !IsTriangle(type);
      const bool isFace = isKnown && kind->dimension == mesh.dimension - 1;
      if ((!isCell && !isFace) || (mesh.order != 0 && kind->order != mesh.order))
      {
        throw Error(
          "The mesh has other cells than quads and lines of one order; give the quads of a Quad "
          "Mesher, of Quads To Higher Order or the hexahedra of Extrude Quads.");
      }
      if (mesh.order == 0)
      {
        mesh.order = kind->order;
        order =
          crossfield::CellLattice(mesh.dimension, mesh.order).OrderFor(crossfield::NodeOrder::Vtk);
        prism = crossfield::PrismPositions(mesh.order, 0, crossfield::NodeOrder::Vtk);
      }
      if (isCell)
      {
        const bool isPrism = type == VTK_WEDGE || type == VTK_BIQUADRATIC_QUADRATIC_WEDGE;
        AddCell(ids, order.size(), isPrism ? prism : order, mesh.cells);
        if (isPrism)
        {
          crossfield::FillPrismLattice(mesh.order, &mesh.cells[mesh.cells.size() - order.size()]);
        }
        mesh.region.push_back(0);
        mesh.sources.cells.push_back(static_cast<int>(cell));
        return;
      }
      if (sides == nullptr)
      {
        throw Error("The boundary edges have no cell array Side of strings; give the quads of a "
                    "Quad Mesher.");
      }
      AddFace(ids, type, mesh.CornersOfFace(), mesh.faces);
      mesh.side.push_back(SideOf(sides->GetValue(cell), numbers, mesh));
      mesh.sources.faces.push_back(static_cast<int>(cell));
    });
  if (mesh.region.empty())
  {
    throw Error("The mesh has no quads; give the quads of a Quad Mesher.");
  }
  if (mesh.side.empty() && !IsClosed(grid))
  {
    throw Error(
      "The quads have no boundary edges; put Quads To Higher Order with Order 1 directly behind Quad "
      "Mesher, before filters that change points or cells.");
  }
  ReadRegions(grid, mesh);
  mesh.blocks = ReadBlocks(mesh, grid->GetCellData());
  mesh.sweep = ReadSweep(grid->GetFieldData(), numbers);
  mesh.pairs = PeriodicConversion::Read(grid->GetFieldData(), mesh.sideNames);
  if (auto* layers =
        vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray(names::LayerSide)))
  {
    for (vtkIdType i = 0; i < layers->GetNumberOfValues(); ++i)
    {
      mesh.patchTypes[layers->GetValue(i)] = "wall";
    }
  }
  return mesh;
}

//------------------------------------------------------------------------------
void SetPatchTypes(const std::map<std::string, std::string>& types, SolverMesh& mesh)
{
  // Types that need other entries, or faces that only the writer knows.
  const std::set<std::string> others = { "cyclic", "cyclicAMI", "cyclicACMI", "cyclicSlip", "empty",
    "processor", "processorCyclic", "wedge" };
  for (const auto& [name, type] : types)
  {
    crossfield::RequireSide(mesh.sideNames, name, " for the patch type '" + type + "'");
    const auto side = std::find(mesh.sideNames.begin(), mesh.sideNames.end(), name);
    const auto index = static_cast<int>(side - mesh.sideNames.begin());
    const bool isPeriodic = std::any_of(mesh.pairs.begin(), mesh.pairs.end(),
      [index](const crossfield::SidePair& pair)
      { return pair.first == index || pair.second == index; });
    const bool isEnd =
      mesh.sweep.layers == 1 && (index == mesh.sweep.back || index == mesh.sweep.front);
    if (isPeriodic || isEnd)
    {
      throw Error("The patch of the side '" + name + "' is " +
        (isPeriodic                 ? "cyclic"
            : mesh.sweep.isRotation ? "a wedge"
                                    : "empty") +
        "; leave out its type '" + type + "'.");
    }
    if (others.count(type) > 0 ||
      !std::all_of(type.begin(), type.end(), [](unsigned char c) { return std::isalpha(c) != 0; }))
    {
      throw Error("A patch of the side '" + name + "' cannot have the type '" + type +
        "'; give wall, patch, symmetry or another type without further entries.");
    }
    mesh.patchTypes[name] = type;
  }
}

//------------------------------------------------------------------------------
void ReadCurves(vtkUnstructuredGrid* grid, SolverMesh& mesh)
{
  CurveConversion::CellCurves curves = CurveConversion::ReadCurves(grid);
  mesh.curves = std::move(curves.curves);
  mesh.curve.clear();
  for (std::size_t face = 0; face < mesh.sources.faces.size() && !curves.ofCell.empty(); ++face)
  {
    mesh.curve.push_back(curves.ofCell[mesh.sources.faces[face]]);
  }
}

}
