#include "SideConversion.h"

#include "ColumnWriting.h"
#include "Error.h"
#include "Index.h"
#include "QuadMesher.h"
#include "QuadSides.h"
#include "RegionSides.h"
#include "SegmentCells.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

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

/** Returns the names of the segments of a domain, empty without a line that has a name. */
crossfield::SegmentNames NamesOfSegments(
  vtkDataSet* input, const std::string& array, const DomainConversion::Domain& domain)
{
  const CellNames names(input, array);
  crossfield::SegmentNames segments;
  for (const std::vector<vtkIdType>& cells : SegmentCells::FindAround(
         input, domain, [&](vtkIdType cell) { return !names.Of(cell).empty(); }))
  {
    segments.emplace_back();
    for (const vtkIdType cell : cells)
    {
      segments.back().push_back(cell < 0 ? std::string() : names.Of(cell));
    }
  }
  return segments;
}

bool IsNamed(const crossfield::SegmentNames& segments)
{
  return std::any_of(segments.begin(), segments.end(),
    [](const std::vector<std::string>& ofLoop)
    {
      return std::any_of(
        ofLoop.begin(), ofLoop.end(), [](const std::string& name) { return !name.empty(); });
    });
}

/** Returns the text of a cell of a table; empty for an empty string, 0 and NaN. */
std::string TextAt(vtkAbstractArray* column, vtkIdType row)
{
  if (auto* texts = vtkStringArray::SafeDownCast(column))
  {
    const std::string text = texts->GetValue(row);
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string::npos
      ? ""
      : text.substr(first, text.find_last_not_of(" \t") - first + 1);
  }
  const double number = column->GetVariantValue(row).ToDouble();
  if (number == 0.0 || std::isnan(number))
  {
    return {};
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << number;
  return text.str();
}
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
std::vector<std::string> NamesOfCells(vtkDataSet* input, const std::string& requested)
{
  const std::string array = FindArray(input, requested);
  std::vector<std::string> result;
  if (!array.empty())
  {
    const CellNames names(input, array);
    for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
    {
      result.push_back(names.Of(cell));
    }
  }
  return result;
}

//------------------------------------------------------------------------------
std::vector<crossfield::BoundarySides> ReadSides(vtkDataSet* input, const std::string& requested,
  const std::vector<DomainConversion::Domain>& parts, crossfield::RegionSet* regions)
{
  const std::string array = FindArray(input, requested);
  std::vector<crossfield::BoundarySides> result;
  std::vector<std::string> generated; // for earlier parts
  std::vector<crossfield::SegmentNames> segments(parts.size());
  bool isNamed = false;
  for (std::size_t p = 0; p < parts.size() && !array.empty(); ++p)
  {
    segments[p] = NamesOfSegments(input, array, parts[p]);
    isNamed = isNamed || IsNamed(segments[p]);
  }
  if (regions != nullptr)
  {
    crossfield::UseGivenNames(segments, *regions);
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    result.push_back(regions == nullptr
        ? crossfield::NameSides(parts[p].domain, segments[p], generated)
        : crossfield::SidesOfRegion(*regions, p, segments[p], generated));
    const std::vector<std::string>& names = result.back().names;
    generated.insert(generated.end(), names.begin() + result.back().given, names.end());
  }
  if (!isNamed && !requested.empty() && regions == nullptr) // only lines inside may have names
  {
    throw Error("The cell array '" + requested +
      "' names no part of the boundary; give lines along the boundary with their names.");
  }
  return result;
}

//------------------------------------------------------------------------------
std::vector<SideText::Row> ReadTable(vtkTable* table)
{
  std::vector<SideText::Row> rows(static_cast<std::size_t>(table->GetNumberOfRows()));
  for (vtkIdType c = 0; c < table->GetNumberOfColumns(); ++c)
  {
    vtkAbstractArray* column = table->GetColumn(c);
    const std::string name = column->GetName() != nullptr ? column->GetName() : "";
    const auto known = std::find_if(SideText::Columns.begin(), SideText::Columns.end(),
      [&](const SideText::Column& one) { return name == one.name; });
    if (known == SideText::Columns.end())
    {
      std::string all;
      for (const SideText::Column& one : SideText::Columns)
      {
        all += (all.empty() ? "" : ", ") + std::string(one.name);
      }
      throw Error("The table of sides has the column '" + name + "', which is none of " + all +
        "; rename or remove it.");
    }
    for (std::size_t row = 0; row < rows.size(); ++row)
    {
      rows[row].*known->text = TextAt(column, static_cast<vtkIdType>(row));
    }
  }
  if (table->GetColumnByName(SideText::Columns[0].name) == nullptr &&
    table->GetNumberOfColumns() > 0)
  {
    throw Error("The table of sides has no column Side; add it with the names of the sides.");
  }
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    if (rows[row].side.empty())
    {
      throw Error("Row " + std::to_string(row) +
        " of the table of sides has no name in the column Side; give one, or remove the row.");
    }
  }
  return rows;
}

//------------------------------------------------------------------------------
void WriteSides(const crossfield::QuadMesh& mesh, vtkCellData* data)
{
  ColumnWriting::AddColumn<vtkStringArray>(data, names::Side, mesh.boundary,
    [&mesh](const crossfield::QuadBoundaryEdge& edge)
    { return edge.side < 0 ? std::string() : mesh.sideNames[edge.side]; });
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
          text += (text.empty() ? "" : ",") + result.mesh.sideNames[side];
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

//------------------------------------------------------------------------------
void WritePlaces(const crossfield::QuadMesh& mesh, const crossfield::DomainPlane& plane,
  vtkStringArray* names, vtkDoubleArray* places)
{
  std::vector<std::vector<const crossfield::QuadBoundaryEdge*>> edges(mesh.sideNames.size());
  for (const crossfield::QuadBoundaryEdge& edge : mesh.boundary)
  {
    if (edge.side >= 0)
    {
      edges[crossfield::Index(edge.side)].push_back(&edge);
    }
  }
  names->SetNumberOfValues(0);
  places->SetNumberOfTuples(0);
  for (std::size_t side = 0; side < edges.size(); ++side)
  {
    if (edges[side].empty())
    {
      continue; // the name of a line inside
    }
    const auto& [first, second] = edges[side][edges[side].size() / 2]->points;
    const Eigen::Vector3d middle = 0.5 *
      (plane.PlaceToSpace(mesh.points[crossfield::Index(first)].place) +
        plane.PlaceToSpace(mesh.points[crossfield::Index(second)].place));
    names->InsertNextValue(mesh.sideNames[side]);
    places->InsertNextTuple(middle.data());
  }
}
}
