#include "QuadConversion.h"

#include "ColumnWriting.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <map>
#include <optional>

namespace names = vtkCrossFieldArrayNames;

namespace
{
using crossfield::QuadMesh;
using crossfield::QuadPoint;
using crossfield::QuadResult;

/** Appends one value for every boundary line to the values of the quads. */
template <class T>
std::vector<T> AppendForLines(std::vector<T> values, std::size_t lines, T value)
{
  values.insert(values.end(), lines, value);
  return values;
}

void WriteCellData(const QuadResult& result, vtkCellData* data)
{
  const QuadMesh& mesh = result.mesh;
  const std::size_t lines = mesh.boundary.size();
  ColumnWriting::AddIntegers(data, names::BlockId, AppendForLines(result.blocks.block, lines, -1));
  ColumnWriting::AddIntegers(data, names::I, AppendForLines(result.blocks.i, lines, -1));
  ColumnWriting::AddIntegers(data, names::J, AppendForLines(result.blocks.j, lines, -1));
  ColumnWriting::AddNumbers(
    data, names::ScaledJacobian, AppendForLines(result.quality.scaledJacobian, lines, 1.0));
  ColumnWriting::AddNumbers(
    data, names::SizeRatio, AppendForLines(result.quality.sizeRatio, lines, 1.0));
  std::vector<int> kinds(mesh.quads.size(), 0);
  std::vector<int> ids(mesh.quads.size(), -1);
  for (const crossfield::QuadBoundaryEdge& edge : mesh.boundary)
  {
    kinds.push_back(static_cast<int>(edge.kind));
    ids.push_back(edge.id);
  }
  ColumnWriting::AddIntegers(data, names::BoundaryKind, kinds);
  ColumnWriting::AddIntegers(data, names::BoundaryId, ids);
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

/** Writes the numbers of irregular interior points by valence: obtained and requested. */
void WriteIrregular(const QuadMesh& mesh, vtkFieldData* data)
{
  std::map<int, std::array<int, 2>> counts;
  for (const QuadPoint& point : mesh.points)
  {
    if (point.curve.loop < 0 && point.valence != 4)
    {
      ++counts[point.valence][0];
    }
    if (point.curve.loop < 0 && point.quarterIndex != 0)
    {
      ++counts[4 - point.quarterIndex][1];
    }
  }
  std::array<std::vector<int>, 3> columns;
  for (const auto& [valence, count] : counts)
  {
    columns[0].push_back(valence);
    columns[1].push_back(count[0]);
    columns[2].push_back(count[1]);
  }
  ColumnWriting::AddIntegers(data, names::IrregularValence, columns[0]);
  ColumnWriting::AddIntegers(data, names::IrregularObtained, columns[1]);
  ColumnWriting::AddIntegers(data, names::IrregularRequested, columns[2]);
}

void WriteReport(const QuadResult& result, const crossfield::DomainPlane& plane, vtkFieldData* data)
{
  const auto addCount = [data](const char* name, std::size_t value)
  { ColumnWriting::AddIntegers(data, name, { static_cast<int>(value) }); };
  const auto addFlag = [data](const char* name, bool value)
  { ColumnWriting::AddIntegers(data, name, { value ? 1 : 0 }); };
  const crossfield::QuadQuality& quality = result.quality;
  addCount(names::Quads, result.mesh.quads.size());
  addCount(names::Blocks, result.blocks.blocks.size());
  WriteIrregular(result.mesh, data);
  ColumnWriting::AddNumbers(
    data, names::ScaledJacobianRange, { quality.jacobian.min, quality.jacobian.mean });
  ColumnWriting::AddNumbers(data, names::ScaledJacobianBound, { quality.bound });
  ColumnWriting::AddNumbers(data, names::EtaRange, { quality.eta.min, quality.eta.mean });
  ColumnWriting::AddNumbers(
    data, names::SizeRange, { quality.size.min, quality.size.mean, quality.size.max });
  ColumnWriting::AddNumbers(data, names::SizeVariation, { quality.variation });
  ColumnWriting::AddNumbers(data, names::Size, { result.size });
  ColumnWriting::AddIntegers(data, names::ZeroArcs, { result.counts.ZeroArcs() });
  addCount(names::IntegerVariables, result.counts.counts.size());
  ColumnWriting::AddNumbers(data, names::IntegerGap, { result.counts.Gap() });
  addFlag(names::IntegerOptimal, result.counts.optimal);
  ColumnWriting::AddIntegers(data, names::Inverted, { quality.inverted });
  const Eigen::Vector3d where = plane.ToSpace(quality.where);
  ColumnWriting::AddNumbers(data, names::InvertedPlace, { where.x(), where.y(), where.z() });
  addFlag(names::Released, result.smoothing.released);
  ColumnWriting::AddNumbers(data, names::Moved, { result.smoothing.moved });
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
    points->InsertNextPoint(plane.ToSpace(point.place).data());
  }
  output->SetPoints(points);
  output->Allocate(static_cast<vtkIdType>(result.mesh.quads.size() + result.mesh.boundary.size()));
  for (const std::array<int, 4>& quad : result.mesh.quads)
  {
    const std::array<vtkIdType, 4> ids = { quad[0], quad[1], quad[2], quad[3] };
    output->InsertNextCell(VTK_QUAD, 4, ids.data());
  }
  for (const crossfield::QuadBoundaryEdge& edge : result.mesh.boundary)
  {
    const std::array<vtkIdType, 2> ids = { edge.points[0], edge.points[1] };
    output->InsertNextCell(VTK_LINE, 2, ids.data());
  }
  WriteCellData(result, output->GetCellData());
  WritePointData(result.mesh, output->GetPointData());
  WriteReport(result, plane, output->GetFieldData());
}

//------------------------------------------------------------------------------
void WriteBlockCounts(const crossfield::BlockCounts& counts, vtkFieldData* data)
{
  const auto add = [data](const char* name, const std::optional<int>& count)
  {
    if (count)
    {
      ColumnWriting::AddIntegers(data, name, { *count });
    }
  };
  add(names::BlocksUnmerged, counts.none);
  add(names::BlocksClean, counts.clean);
  add(names::BlocksCoarse, counts.coarse);
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
      points->InsertNextPoint(
        plane.ToSpace(result.mesh.points[static_cast<std::size_t>(point)].place).data());
    }
    vtkNew<vtkStructuredGrid> grid;
    grid->SetDimensions(block.width + 1, block.height + 1, 1);
    grid->SetPoints(points);
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
}

//------------------------------------------------------------------------------
void WriteLayout(
  const QuadResult& result, const crossfield::DomainPlane& plane, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const crossfield::TArc& arc : result.tMesh.arcs)
  {
    lines->InsertNextCell(static_cast<int>(arc.polyline.size()));
    for (const crossfield::Point& point : arc.polyline)
    {
      lines->InsertCellPoint(points->InsertNextPoint(plane.ToSpace(point).data()));
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  ColumnWriting::AddIntegers(output->GetCellData(), names::Edges, result.counts.counts);
}
}
