#include "QuadConversion.h"

#include "ColumnWriting.h"
#include "CurveConversion.h"
#include "SegmentCurveConversion.h"
#include "SideConversion.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace names = vtkCrossFieldArrayNames;

namespace
{
using crossfield::QuadMesh;
using crossfield::QuadPoint;
using crossfield::QuadResult;

void WriteCellData(const QuadResult& result, vtkCellData* data)
{
  ColumnWriting::AddIntegers(data, names::BlockId, result.blocks.block);
  ColumnWriting::AddIntegers(data, names::I, result.blocks.i);
  ColumnWriting::AddIntegers(data, names::J, result.blocks.j);
  ColumnWriting::AddNumbers(data, names::ScaledJacobian, result.quality.scaledJacobian);
  ColumnWriting::AddNumbers(data, names::SizeRatio, result.quality.sizeRatio);
}

void WritePointData(const QuadMesh& mesh, vtkPointData* data)
{
  ColumnWriting::AddColumn<vtkIntArray>(
    data, names::Valence, mesh.points, [](const QuadPoint& point) { return point.valence; });
  ColumnWriting::AddColumn<vtkIntArray>(
    data, names::Irregular, mesh.points, [](const QuadPoint& point) { return point.quarterIndex; });
  ColumnWriting::AddColumn<vtkIntArray>(data, names::BoundarySide, mesh.points,
    [](const QuadPoint& point) { return point.curve.loop; });
}

void InsertPoint(const QuadPoint& point, const crossfield::DomainPlane& plane, vtkPoints* points)
{
  points->InsertNextPoint(plane.PlaceToSpace(point.place).data());
}

/** Adds the array of a mesh from those of its quads and of its lines; `value` is that of cells without it. */
template <class Array>
void Join(vtkCellData* quads, vtkCellData* lines, const char* name, typename Array::ValueType value,
  vtkCellData* to)
{
  vtkAbstractArray* ofQuads = quads->GetAbstractArray(name);
  vtkAbstractArray* ofLines = lines->GetAbstractArray(name);
  const vtkIdType quadCount = quads->GetNumberOfTuples();
  const vtkIdType lineCount = lines->GetNumberOfTuples();
  const auto array = ColumnWriting::NewArray<Array>(to, name, 1, quadCount + lineCount, value);
  if (ofQuads != nullptr)
  {
    array->InsertTuples(0, quadCount, 0, ofQuads);
  }
  if (ofLines != nullptr)
  {
    array->InsertTuples(quadCount, lineCount, 0, ofLines);
  }
}
}

namespace QuadConversion
{
//------------------------------------------------------------------------------
void WriteQuads(
  const QuadResult& result, const crossfield::DomainPlane& plane, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const QuadPoint& point : result.mesh.points)
  {
    points->InsertNextPoint(plane.PlaceToSpace(point.place).data());
  }
  output->SetPoints(points);
  output->Allocate(static_cast<vtkIdType>(result.mesh.quads.size()));
  for (const std::array<int, 4>& quad : result.mesh.quads)
  {
    const std::array<vtkIdType, 4> ids = { quad[0], quad[1], quad[2], quad[3] };
    output->InsertNextCell(VTK_QUAD, 4, ids.data());
  }
  WriteCellData(result, output->GetCellData());
  WritePointData(result.mesh, output->GetPointData());
}

//------------------------------------------------------------------------------
void WriteBoundary(const QuadMesh& mesh, const crossfield::CurvedBoundary& curves,
  const crossfield::DomainPlane& plane, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  std::map<int, vtkIdType> numbers;
  std::vector<int> vertices;
  std::vector<int> kinds;
  std::vector<int> ids;
  for (const crossfield::QuadBoundaryEdge& edge : mesh.boundary)
  {
    lines->InsertNextCell(2);
    for (const int point : edge.points)
    {
      const auto [place, isNew] = numbers.emplace(point, points->GetNumberOfPoints());
      if (isNew)
      {
        InsertPoint(mesh.points[point], plane, points);
        vertices.push_back(point);
      }
      lines->InsertCellPoint(place->second);
    }
    kinds.push_back(static_cast<int>(edge.kind));
    ids.push_back(edge.id);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  ColumnWriting::AddIntegers(output->GetCellData(), names::BoundaryKind, kinds);
  ColumnWriting::AddIntegers(output->GetCellData(), names::BoundaryId, ids);
  SideConversion::WriteSides(mesh, output->GetCellData());
  ColumnWriting::AddIntegers(output->GetPointData(), names::VertexId, vertices);
  SegmentCurveConversion::RemoveCurves(output); // those of the domain, which the executive passes
  if (!curves.IsEmpty())
  {
    CurveConversion::CellCurves ofLines{ curves.curves, {} };
    for (const crossfield::QuadBoundaryEdge& edge : mesh.boundary)
    {
      ofLines.ofCell.push_back(edge.curve);
    }
    CurveConversion::AddCurves(ofLines, output);
  }
}

//------------------------------------------------------------------------------
void Combine(vtkUnstructuredGrid* quads, vtkPolyData* boundary, vtkUnstructuredGrid* output)
{
  const vtkIdType quadCount = quads->GetNumberOfCells();
  const vtkIdType lineCount = boundary->GetNumberOfCells();
  output->Initialize();
  if (quadCount == 0)
  {
    return;
  }
  output->DeepCopy(quads);
  vtkDataArray* vertices = boundary->GetPointData()->GetArray(names::VertexId);
  for (vtkIdType line = 0; line < lineCount; ++line)
  {
    vtkIdType size = 0;
    const vtkIdType* ends = nullptr;
    boundary->GetLines()->GetCellAtId(line, size, ends);
    std::array<vtkIdType, 2> ids{};
    std::transform(ends, ends + 2, ids.begin(),
      [&](vtkIdType end) { return static_cast<vtkIdType>(vertices->GetTuple1(end)); });
    output->InsertNextCell(VTK_LINE, 2, ids.data());
  }
  vtkCellData* from = quads->GetCellData();
  vtkCellData* lines = boundary->GetCellData();
  vtkCellData* to = output->GetCellData();
  to->Initialize();
  for (const char* name : { names::BlockId, names::I, names::J, names::Part })
  {
    Join<vtkIntArray>(from, lines, name, -1, to);
  }
  for (const char* name : { names::ScaledJacobian, names::SizeRatio })
  {
    Join<vtkDoubleArray>(from, lines, name, 1.0, to);
  }
  Join<vtkIntArray>(from, lines, names::BoundaryKind, 0, to);
  Join<vtkIntArray>(from, lines, names::BoundaryId, -1, to);
  for (const char* name : { names::Curve, names::Region, names::RegionLeft, names::RegionRight })
  {
    if (from->HasArray(name) || lines->HasArray(name))
    {
      Join<vtkIntArray>(from, lines, name, -1, to);
    }
  }
  vtkNew<vtkStringArray> sides;
  sides->SetName(names::Side);
  sides->SetNumberOfValues(quadCount);
  sides->InsertTuples(quadCount, lineCount, 0, lines->GetAbstractArray(names::Side));
  to->AddArray(sides);
}

//------------------------------------------------------------------------------
void WriteBlocks(
  const QuadResult& result, const crossfield::DomainPlane& plane, vtkMultiBlockDataSet* output)
{
  output->SetNumberOfBlocks(static_cast<unsigned int>(result.blocks.blocks.size()));
  for (std::size_t b = 0; b < result.blocks.blocks.size(); ++b)
  {
    const crossfield::QuadBlock& block = result.blocks.blocks[b];
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const int point : block.points)
    {
      InsertPoint(result.mesh.points[point], plane, points);
    }
    vtkNew<vtkStructuredGrid> grid;
    grid->SetDimensions(block.width + 1, block.height + 1, 1);
    grid->SetPoints(points);
    ColumnWriting::NewArray<vtkIntArray>(
      grid->GetCellData(), names::BlockId, 1, grid->GetNumberOfCells(), static_cast<int>(b));
    using crossfield::BlockNeighbour;
    const auto add = [&](const char* name, int BlockNeighbour::*member)
    {
      ColumnWriting::AddColumn<vtkIntArray>(grid->GetFieldData(), name, block.neighbours,
        [member](const BlockNeighbour& neighbour) { return neighbour.*member; });
    };
    add(names::NeighbourBlock, &BlockNeighbour::block);
    add(names::NeighbourSide, &BlockNeighbour::side);
    add(names::NeighbourOrientation, &BlockNeighbour::orientation);
    const auto number = static_cast<unsigned int>(b);
    output->SetBlock(number, grid);
    output->GetMetaData(number)->Set(
      vtkCompositeDataSet::NAME(), ("block" + std::to_string(b)).c_str());
  }
  SideConversion::WriteBlockSides(result, output);
}

//------------------------------------------------------------------------------
void WriteParts(const crossfield::QuadWorkflowResult& result, vtkUnstructuredGrid* quads,
  vtkMultiBlockDataSet* blocks)
{
  ColumnWriting::AddIntegers(quads->GetCellData(), names::Part, result.part);
  std::vector<int> ofBlock(result.quads.blocks.blocks.size());
  for (std::size_t q = 0; q < result.part.size(); ++q)
  {
    ofBlock[static_cast<std::size_t>(result.quads.blocks.block[q])] = result.part[q];
  }
  for (unsigned int b = 0; b < blocks->GetNumberOfBlocks(); ++b)
  {
    auto* grid = vtkStructuredGrid::SafeDownCast(blocks->GetBlock(b));
    ColumnWriting::NewArray<vtkIntArray>(
      grid->GetCellData(), names::Part, 1, grid->GetNumberOfCells(), ofBlock[b]);
  }
}

//------------------------------------------------------------------------------
void WriteLayout(
  const QuadResult& result, const crossfield::DomainPlane& plane, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  std::vector<int> edges;
  for (const std::vector<int>& side : crossfield::SidesOf(result.blocks.blocks))
  {
    lines->InsertNextCell(static_cast<int>(side.size()));
    for (const int point : side)
    {
      lines->InsertCellPoint(points->GetNumberOfPoints());
      InsertPoint(result.mesh.points[point], plane, points);
    }
    edges.push_back(static_cast<int>(side.size()) - 1);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  ColumnWriting::AddIntegers(output->GetCellData(), names::Edges, edges);
}

//------------------------------------------------------------------------------
void WriteSeparatrices(
  const QuadResult& result, const crossfield::DomainPlane& plane, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const crossfield::TArc& arc : result.tMesh.arcs)
  {
    lines->InsertNextCell(static_cast<int>(arc.polyline.size()));
    for (const crossfield::SpacePoint& point : arc.polyline)
    {
      lines->InsertCellPoint(points->InsertNextPoint(plane.PlaceToSpace(point).data()));
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  ColumnWriting::AddIntegers(output->GetCellData(), names::Edges, result.counts.counts);
}

//------------------------------------------------------------------------------
void WriteIrregularNodes(
  const QuadMesh& mesh, const crossfield::DomainPlane& plane, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  std::vector<int> valences;
  std::vector<int> quarters;
  for (const QuadPoint& point : mesh.points)
  {
    if (point.curve.loop < 0 && point.valence != 4)
    {
      vertices->InsertNextCell(1);
      vertices->InsertCellPoint(points->GetNumberOfPoints());
      InsertPoint(point, plane, points);
      valences.push_back(point.valence);
      quarters.push_back(4 - point.valence);
    }
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  ColumnWriting::AddIntegers(output->GetPointData(), names::QuarterIndex, quarters);
  ColumnWriting::AddIntegers(output->GetPointData(), names::Valence, valences);
}
}
