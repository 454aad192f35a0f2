#include "SideConversion.h"

#include "ColumnWriting.h"
#include "Error.h"
#include "QuadMesher.h"
#include "QuadSides.h"
#include "SegmentCells.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
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

/** Reads the texts of a row. */
class RowReader
{
public:
  RowReader(const std::array<std::string, 4>& row, crossfield::SidePrescription& prescribed)
    : Row(row)
    , Prescribed(prescribed)
  {
  }

  void Read() const
  {
    if (!this->Row[1].empty())
    {
      this->RequireOnce(this->Prescribed.count == 0, "number of edges");
      const double count = this->Number(this->Row[1], "number of edges", "a whole number");
      if (count < 1.0 || count > VTK_INT_MAX || count != std::floor(count))
      {
        this->Refuse(this->Row[1], "number of edges", "a positive whole number");
      }
      this->Prescribed.count = static_cast<int>(count);
    }
    if (!this->Row[2].empty())
    {
      this->RequireOnce(!this->Prescribed.isGraded, "progression");
      this->ReadProgression();
    }
    if (!this->Row[3].empty())
    {
      this->RequireOnce(this->Prescribed.size == 0.0, "size");
      this->Prescribed.size = this->Positive(this->Row[3], "size", "a positive number");
    }
  }

private:
  [[noreturn]] void Refuse(const std::string& text, const char* what, const char* form) const
  {
    throw Error("The " + std::string(what) + " '" + text + "' of side '" + this->Row[0] +
      "' is not valid; give " + form + ".");
  }

  void RequireOnce(bool isFirst, const char* what) const
  {
    if (!isFirst)
    {
      throw Error("The " + std::string(what) + " of side '" + this->Row[0] +
        "' is prescribed twice; leave one out.");
    }
  }

  double Number(const std::string& text, const char* what, const char* form) const
  {
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    double value = 0.0;
    if (!(stream >> value) || !(stream >> std::ws).eof() || !std::isfinite(value))
    {
      this->Refuse(text, what, form);
    }
    return value;
  }

  double Positive(const std::string& text, const char* what, const char* form) const
  {
    const double value = this->Number(text, what, form);
    if (!(value > 0.0))
    {
      this->Refuse(text, what, form);
    }
    return value;
  }

  void ReadProgression() const
  {
    constexpr const char* What = "progression";
    constexpr const char* Form =
      "RATIO, or FIRST,LAST for lengths, positive, after both: for both ends";
    crossfield::Progression& progression = this->Prescribed.progression;
    std::string text = this->Row[2];
    const std::string both = "both:";
    progression.both = text.compare(0, both.size(), both) == 0;
    text = progression.both ? text.substr(both.size()) : text;
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos)
    {
      progression.ratio = this->Positive(text, What, Form);
    }
    else
    {
      progression.first = this->Positive(text.substr(0, comma), What, Form);
      progression.last = this->Positive(text.substr(comma + 1), What, Form);
    }
    this->Prescribed.isGraded = true;
  }

  const std::array<std::string, 4>& Row;
  crossfield::SidePrescription& Prescribed;
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
  crossfield::SegmentNames segments;
  bool isNamed = false;
  for (const std::vector<vtkIdType>& cells :
    SegmentCells::Find(input, domain, [&](vtkIdType cell) { return !cellNames.Of(cell).empty(); }))
  {
    segments.emplace_back();
    for (const vtkIdType cell : cells)
    {
      segments.back().push_back(cell < 0 ? std::string() : cellNames.Of(cell));
      isNamed = isNamed || cell >= 0;
    }
  }
  if (!isNamed && !requested.empty())
  {
    throw Error("The cell array '" + requested +
      "' names no part of the boundary; give lines along the boundary with their names.");
  }
  return crossfield::NameSides(domain.domain, segments);
}

//------------------------------------------------------------------------------
crossfield::SidePrescriptions ReadPrescriptions(
  const std::vector<std::array<std::string, 4>>& rows, const crossfield::BoundarySides& sides)
{
  crossfield::SidePrescriptions prescribed;
  for (const std::array<std::string, 4>& row : rows)
  {
    crossfield::RequireSide(sides.names, row[0]);
    const int side = sides.Find(row[0]);
    const auto found = std::find_if(prescribed.begin(), prescribed.end(),
      [side](const crossfield::SidePrescription& one) { return one.side == side; });
    if (found != prescribed.end())
    {
      RowReader(row, *found).Read();
      continue;
    }
    prescribed.emplace_back();
    prescribed.back().side = side;
    RowReader(row, prescribed.back()).Read();
  }
  return prescribed;
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
}
