#include "SolverMeshWriting.h"

#include "ColumnWriting.h"
#include "ElementNodes.h"
#include "SolverCells.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace names = vtkCrossFieldArrayNames;

namespace
{
using crossfield::Index;
using crossfield::SolverMesh;
using SolverCells::CellKind;
using SolverCells::Kinds;

/** A point of higher order: the points of the grid that it is between, with weights. */
struct Mixture
{
  std::vector<int> points;
  std::vector<double> weights;
  int quads = 0; ///< Number of quads that it belongs to.
  bool onBoundary = false;
};

/** Returns the points of quads that RaiseOrder added. */
std::map<int, Mixture> MixturesOf(const SolverMesh& mesh, const crossfield::MeshFaces& faces)
{
  std::map<int, Mixture> mixtures;
  const auto isNew = [&](int point) { return mesh.sources.points[point] < 0; };
  const auto source = [&](const int* nodes, int position)
  { return mesh.sources.points[nodes[position]]; };
  const int p = mesh.order;
  const crossfield::CellLattice lattice(2, p);
  for (int cell = 0; cell < mesh.CellCount(); ++cell)
  {
    const int* nodes = mesh.Cell(cell);
    for (int position = 0; position < mesh.NodesOfCell(); ++position)
    {
      if (!isNew(nodes[position]))
      {
        continue;
      }
      Mixture& mixture = mixtures[nodes[position]];
      ++mixture.quads;
      const double x = static_cast<double>(position % (p + 1)) / p;
      const double y = static_cast<double>(position / (p + 1)) / p;
      mixture.points.clear();
      for (int corner = 0; corner < 4; ++corner)
      {
        mixture.points.push_back(source(nodes, lattice.Corner(corner)));
      }
      mixture.weights = { (1.0 - x) * (1.0 - y), x * (1.0 - y), x * y, (1.0 - x) * y };
    }
  }
  for (const crossfield::CellFace& face : faces.BoundaryFaces())
  {
    const int* nodes = mesh.Cell(face.cell);
    const std::vector<int> along = lattice.Face(face.face);
    for (int k = 1; k < p; ++k)
    {
      Mixture& mixture = mixtures[nodes[along[k]]];
      mixture.onBoundary = true;
      mixture.points = { source(nodes, along.front()), source(nodes, along.back()) };
      const double part = static_cast<double>(k) / p;
      mixture.weights = { 1.0 - part, part };
    }
  }
  return mixtures;
}

/** Sets the values of a new point of higher order in the arrays of numbers. */
void SetMixture(vtkIdType point, const Mixture& mixture, vtkPointData* from, vtkPointData* to)
{
  for (int a = 0; a < to->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = to->GetArray(a);
    const std::string name = to->GetArrayName(a) ? to->GetArrayName(a) : "";
    vtkDataArray* source = from->GetArray(name.c_str());
    if (array == nullptr || source == nullptr)
    {
      continue; // texts
    }
    const bool isReal = array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT;
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      double value = 0.0;
      for (std::size_t i = 0; isReal && i < mixture.points.size(); ++i)
      {
        value += mixture.weights[i] * source->GetComponent(mixture.points[i], c);
      }
      value = name == names::Valence ? mixture.quads : value;
      value = name == names::BoundarySide
        ? (mixture.onBoundary ? source->GetComponent(mixture.points[0], c) : -1.0)
        : value;
      array->SetComponent(point, c, value);
    }
  }
}

void WritePoints(const SolverMesh& mesh, const crossfield::MeshFaces& faces, vtkPointData* from,
  vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  output->SetPoints(points);
  vtkPointData* data = output->GetPointData();
  data->CopyAllocate(from, static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    const vtkIdType number = points->InsertNextPoint(mesh.points[i].data());
    data->CopyData(from, std::max(mesh.sources.points[i], 0), number);
  }
  if (mesh.dimension == 2)
  {
    for (const auto& [point, mixture] : MixturesOf(mesh, faces))
    {
      SetMixture(point, mixture, from, data);
    }
  }
}

/** Inserts cells or faces in the order of a list: the numbers of cells, and after them those of boundary faces. */
void InsertCells(const SolverMesh& mesh, const crossfield::MeshFaces& faces,
  const std::vector<int>& list, vtkUnstructuredGrid* output)
{
  const crossfield::ElementNodes elements(mesh, crossfield::NodeOrder::Vtk);
  output->Allocate(static_cast<vtkIdType>(list.size()));
  for (const int item : list)
  {
    const int face = item - mesh.CellCount();
    const std::vector<int> nodes =
      face < 0 ? elements.OfCell(item) : elements.OfFace(faces.BoundaryFaces()[face]);
    const std::vector<vtkIdType> ids(nodes.begin(), nodes.end());
    const auto count = static_cast<vtkIdType>(ids.size());
    const int dimension = face < 0 ? mesh.dimension : mesh.dimension - 1;
    const auto* kind = std::find_if(Kinds.begin(), Kinds.end(),
      [&](const CellKind& candidate)
      { return candidate.dimension == dimension && candidate.points == count; });
    output->InsertNextCell(kind->type, count, ids.data());
  }
}

/** Writes the arrays of the cells of hexahedra, then of their boundary, whose faces have the data of their cell. */
void WriteSweptArrays(const SolverMesh& mesh, const crossfield::MeshFaces& faces, vtkCellData* from,
  vtkUnstructuredGrid* output)
{
  const int cells = mesh.CellCount();
  const vtkIdType count = cells + mesh.FaceCount();
  vtkCellData* data = output->GetCellData();
  data->CopyAllocate(from, count);
  for (int cell = 0; cell < cells; ++cell)
  {
    data->CopyData(from, mesh.sources.cells[cell], cell);
  }
  for (int face = 0; face < mesh.FaceCount(); ++face)
  {
    const int cell = faces.BoundaryFaces()[face].cell;
    data->CopyData(from, mesh.sources.cells[cell], cells + face);
    const int edge = mesh.sources.faces[face];
    for (const char* name : { names::BoundaryKind, names::BoundaryId, names::Curve })
    {
      vtkDataArray* array = data->GetArray(name);
      if (edge >= 0 && array != nullptr)
      {
        array->SetTuple(cells + face, edge, from->GetArray(name));
      }
    }
    for (const char* name : { names::I, names::J })
    {
      if (vtkDataArray* array = data->GetArray(name))
      {
        array->SetTuple1(cells + face, -1.0);
      }
    }
  }
  auto layers = ColumnWriting::NewArray<vtkIntArray>(data, names::K, 1, count, -1);
  for (int cell = 0; cell < cells; ++cell)
  {
    layers->SetValue(cell, cell / (cells / mesh.sweep.layers));
  }
  vtkNew<vtkStringArray> sides;
  sides->SetName(names::Side);
  sides->SetNumberOfValues(count);
  for (int face = 0; face < mesh.FaceCount(); ++face)
  {
    sides->SetValue(cells + face, mesh.sideNames[mesh.side[face]]);
  }
  data->AddArray(sides);
  vtkFieldData* report = output->GetFieldData();
  ColumnWriting::AddIntegers(report, names::SweepLayers, { mesh.sweep.layers });
  ColumnWriting::AddIntegers(report, names::Hexahedra, { cells });
  const auto nameOf = [&](int side) { return side < 0 ? "" : mesh.sideNames[side]; };
  ColumnWriting::AddColumn<vtkStringArray>(
    report, names::SweepEnds, std::vector<int>{ mesh.sweep.back, mesh.sweep.front }, nameOf);
}
}

namespace SolverMeshWriting
{
//------------------------------------------------------------------------------
void WriteMesh(const SolverMesh& mesh, vtkUnstructuredGrid* from, vtkUnstructuredGrid* output)
{
  const crossfield::MeshFaces faces(mesh);
  WritePoints(mesh, faces, from->GetPointData(), output);
  std::vector<int> list(mesh.region.size() + mesh.side.size());
  std::iota(list.begin(), list.end(), 0);
  output->GetFieldData()->ShallowCopy(from->GetFieldData());
  if (mesh.dimension == 3)
  {
    InsertCells(mesh, faces, list, output);
    WriteSweptArrays(mesh, faces, from->GetCellData(), output);
    return;
  }
  std::vector<int> sources = mesh.sources.cells; // all cells of the grid
  sources.insert(sources.end(), mesh.sources.faces.begin(), mesh.sources.faces.end());
  for (std::size_t item = 0; item < sources.size(); ++item)
  {
    list[sources[item]] = static_cast<int>(item);
  }
  InsertCells(mesh, faces, list, output);
  output->GetCellData()->PassData(from->GetCellData());
}

//------------------------------------------------------------------------------
void WriteBlocks(const SolverMesh& mesh, vtkMultiBlockDataSet* output)
{
  output->SetNumberOfBlocks(static_cast<unsigned int>(mesh.blocks.size()));
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
  {
    const crossfield::MeshBlock& block = mesh.blocks[b];
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const int node : block.nodes)
    {
      points->InsertNextPoint(mesh.points[node].data());
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
