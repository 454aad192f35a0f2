#include "vtkSingularitySource.h"

#include "ConfigurationConversion.h"
#include "ConfigurationSpread.h"
#include "DomainConversion.h"
#include "Error.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "PlaneFrame.h"
#include "PointTable.h"
#include "QuarterIndexRange.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

vtkStandardNewMacro(vtkSingularitySource);

namespace
{
using crossfield::Error;

using Row = std::array<double, 4>;

/** Rows of x, y, quarter index and radius. */
struct RowTable
{
  std::vector<Row> rows;
  bool hasRadius = true;
  std::vector<Eigen::Vector3d> places; ///< Positions in space; empty if rows are in the plane.
};

RowTable ReadRows(const std::string& fileName)
{
  if (!vtksys::SystemTools::FileExists(fileName, true))
  {
    throw Error("There is no file '" + fileName + "' with singularities; check the name.");
  }
  const auto text = PointTable::Read(PointTable::ReadFile(fileName));
  constexpr int Count = 5;
  // ParaView exports coordinates under the second names.
  const char* names[Count] = { "x", "y", "quarter_index", "radius", "z" };
  vtkAbstractArray* columns[Count] = { PointTable::FindColumn(text, PointTable::NamesOfAxis(0)),
    PointTable::FindColumn(text, PointTable::NamesOfAxis(1)),
    PointTable::FindColumn(text, { "quarter_index", "quarterindex" }),
    PointTable::FindColumn(text, { "radius" }),
    PointTable::FindColumn(text, PointTable::NamesOfAxis(2)) };
  for (int i = 0; i < 3; ++i)
  {
    if (columns[i] == nullptr)
    {
      throw Error("The file '" + fileName + "' has no column '" + names[i] +
        "'; its first line must be x,y,quarter_index or x,y,quarter_index,radius, and may have z.");
    }
  }
  RowTable table;
  table.hasRadius = columns[3] != nullptr;
  for (vtkIdType row = 0; row < text->GetNumberOfRows(); ++row)
  {
    double numbers[Count];
    for (int i = 0; i < Count; ++i)
    {
      const auto number =
        columns[i] == nullptr ? std::optional(0.0) : PointTable::NumberAt(columns[i], row);
      numbers[i] = number.value_or(0.0);
      if (!number)
      {
        throw Error("Row " + std::to_string(row + 1) + " of '" + fileName +
          "' has no number in column '" + names[i] + "'; correct it.");
      }
    }
    table.rows.push_back({ numbers[0], numbers[1], numbers[2], numbers[3] });
    table.places.emplace_back(numbers[0], numbers[1], numbers[4]);
  }
  return table;
}

/** Reads the rows from the points of Start. */
RowTable ReadStart(vtkDataSet* start)
{
  vtkDataArray* quarters = ConfigurationConversion::RequireQuarterIndices(start);
  vtkDataArray* radii = start->GetPointData()->GetArray(vtkCrossFieldArrayNames::Radius);
  RowTable table;
  table.hasRadius = radii != nullptr;
  for (vtkIdType i = 0; i < start->GetNumberOfPoints(); ++i)
  {
    const double* place = start->GetPoint(i);
    table.rows.push_back({ place[0], place[1], quarters->GetComponent(i, 0),
      radii == nullptr ? 0.0 : radii->GetComponent(i, 0) });
    table.places.emplace_back(place);
  }
  return table;
}

/** Returns the rows of the first figure of the paper, for the unit disk. */
std::vector<Row> DefaultRows()
{
  const double diagonal = 0.6 * std::sqrt(0.5);
  std::vector<Row> rows;
  for (const auto& [x, y] : { std::array{ 1, 1 }, { -1, 1 }, { -1, -1 }, { 1, -1 } })
  {
    rows.push_back({ x * diagonal, y * diagonal, 1.0, 0.1 });
  }
  return rows;
}

/** Computes rows that fit a domain, in the coordinates of its plane. */
RowTable FitRows(vtkDataSet* domain, const crossfield::Progress& progress)
{
  RowTable table;
  for (const crossfield::Singularity& singularity : crossfield::SpreadConfiguration(
         DomainConversion::ReadDomain(domain, nullptr).domain, {}, progress))
  {
    table.rows.push_back({ singularity.position.x(), singularity.position.y(),
      static_cast<double>(singularity.quarterIndex), singularity.radius });
  }
  return table;
}

/** Moves the rows to the handles. */
void MoveToHandles(const std::vector<std::array<double, 3>>& handles, RowTable& table)
{
  Row next = { 0.0, 0.0, 1.0, 0.1 };
  if (!table.rows.empty())
  {
    next[3] = table.rows.back()[3];
  }
  table.rows.resize(handles.size(), next);
  table.places.clear();
  for (const auto& handle : handles)
  {
    table.places.emplace_back(handle.data());
  }
}

/** Returns whether points are in a plane, up to rounding in single precision. */
bool AreInPlane(const PlaneFrame& frame, vtkDataSet* points)
{
  constexpr double Rounding = 1e-5; // relative, after some operations
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const Eigen::Vector3d place(points->GetPoint(i));
    const crossfield::Point foot = frame.ToPlane(place);
    if ((frame.ToSpace(foot.x(), foot.y()) - place).norm() >
      Rounding * (place.norm() + frame.origin.norm()))
    {
      return false;
    }
  }
  return true;
}

/**
 * Returns the plane of the domain, else the plane recorded with the initial points if they are in
 * it, else a plane z = const.
 */
PlaneFrame FindFrame(vtkDataSet* domain, vtkDataSet* start)
{
  if (domain != nullptr)
  {
    return PlaneFrame(DomainConversion::FindPlane(domain));
  }
  if (start == nullptr)
  {
    return {};
  }
  const std::optional<PlaneFrame> recorded = PlaneFrame::Read(start->GetFieldData());
  if (recorded && AreInPlane(*recorded, start)) // another filter may have moved the points
  {
    return *recorded;
  }
  PlaneFrame horizontal;
  if (start->GetNumberOfPoints() > 0)
  {
    horizontal.origin.z() = start->GetPoint(0)[2];
  }
  return horizontal;
}

/**
 * Computes positions in space from coordinates in the plane, or the other way round if positions
 * are given.
 */
void CompletePositions(const PlaneFrame& frame, RowTable& table)
{
  const bool haveSpacePositions = !table.places.empty();
  table.places.resize(table.rows.size());
  for (std::size_t i = 0; i < table.rows.size(); ++i)
  {
    if (haveSpacePositions)
    {
      const crossfield::Point point = frame.ToPlane(table.places[i]);
      table.rows[i][0] = point.x();
      table.rows[i][1] = point.y();
    }
    else
    {
      table.places[i] = frame.ToSpace(table.rows[i][0], table.rows[i][1]);
    }
  }
}

/** Returns whether no row has a radius. */
bool LacksRadii(const RowTable& table)
{
  return !table.hasRadius ||
    (!table.rows.empty() &&
      std::all_of(
        table.rows.begin(), table.rows.end(), [](const auto& row) { return row[3] == 0.0; }));
}

void WritePoints(const RowTable& table, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkIntArray> quarters;
  quarters->SetName(vtkCrossFieldArrayNames::QuarterIndex);
  vtkNew<vtkDoubleArray> radii;
  radii->SetName(vtkCrossFieldArrayNames::Radius);
  for (std::size_t i = 0; i < table.rows.size(); ++i)
  {
    const auto& [x, y, quarterIndex, radius] = table.rows[i];
    const Eigen::Vector3d& place = table.places[i];
    if (!std::isfinite(x) || !std::isfinite(y) || !place.allFinite() || !std::isfinite(radius))
    {
      throw Error("Row " + std::to_string(i + 1) +
        " of the singularities has a coordinate or radius that is not a finite number; correct it.");
    }
    const int integerIndex = crossfield::RequireQuarterIndex(
      quarterIndex, "The quarter index of singularity " + std::to_string(i + 1));
    const vtkIdType id = points->InsertNextPoint(place.data());
    vertices->InsertNextCell({ id });
    quarters->InsertNextValue(integerIndex);
    radii->InsertNextValue(radius);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->GetPointData()->AddArray(quarters);
  if (!LacksRadii(table))
  {
    output->GetPointData()->AddArray(radii);
  }
}
}

//------------------------------------------------------------------------------
vtkSingularitySource::vtkSingularitySource()
{
  this->SetNumberOfInputPorts(2);
  this->OutputRows->SetNumberOfComponents(4);
  PlaneFrame().Write(this->Plane);
  this->Rows = DefaultRows();
  for (const Row& row : this->Rows)
  {
    this->Handles.push_back({ row[0], row[1], 0.0 });
  }
}

//------------------------------------------------------------------------------
void vtkSingularitySource::SetSingularity(
  int row, double x, double y, double quarterIndex, double radius)
{
  if (row < 0)
  {
    vtkErrorMacro("The row of a singularity must not be negative.");
    return;
  }
  const auto index = static_cast<std::size_t>(row);
  if (index >= this->Rows.size())
  {
    this->Rows.resize(index + 1, { 0.0, 0.0, 1.0, 0.1 });
  }
  this->Rows[index] = { x, y, quarterIndex, radius };
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSingularitySource::AddSingularity(double x, double y, double quarterIndex, double radius)
{
  this->SetSingularity(this->GetNumberOfSingularities(), x, y, quarterIndex, radius);
}

//------------------------------------------------------------------------------
void vtkSingularitySource::SetNumberOfSingularities(int count)
{
  this->Rows.resize(static_cast<std::size_t>(std::max(count, 0)), { 0.0, 0.0, 1.0, 0.1 });
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkSingularitySource::GetNumberOfSingularities() const
{
  return static_cast<int>(this->Rows.size());
}

//------------------------------------------------------------------------------
void vtkSingularitySource::RemoveAllSingularities()
{
  this->SetNumberOfSingularities(0);
}

//------------------------------------------------------------------------------
void vtkSingularitySource::SetHandle(int handle, double x, double y, double z)
{
  if (handle < 0)
  {
    vtkErrorMacro("The number of a handle must not be negative.");
    return;
  }
  const auto index = static_cast<std::size_t>(handle);
  this->Handles.resize(std::max(index + 1, this->Handles.size()), { 0.0, 0.0, 0.0 });
  this->Handles[index] = { x, y, z };
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSingularitySource::SetNumberOfHandles(int count)
{
  this->Handles.resize(static_cast<std::size_t>(std::max(count, 0)), { 0.0, 0.0, 0.0 });
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkSingularitySource::GetNumberOfHandles() const
{
  return static_cast<int>(this->Handles.size());
}

//------------------------------------------------------------------------------
vtkSingularitySource::~vtkSingularitySource() = default;

//------------------------------------------------------------------------------
vtkDoubleArray* vtkSingularitySource::GetOutputRows()
{
  return this->OutputRows;
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkSingularitySource::GetPlane()
{
  return this->Plane;
}

//------------------------------------------------------------------------------
int vtkSingularitySource::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::AcceptOptionalPoints(info)
                   : FilterPorts::AcceptOptionalDomain(info);
}

//------------------------------------------------------------------------------
int vtkSingularitySource::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->OutputRows->SetNumberOfTuples(0);
  return FilterRun::Run(this, this->ErrorCode,
    [&](const crossfield::Progress& progress)
    {
      vtkDataSet* start = vtkDataSet::GetData(inputVector[0]);
      vtkDataSet* domain = vtkDataSet::GetData(inputVector[1]);
      const bool rowsAreDefault = this->Rows == DefaultRows();
      RowTable table{ this->Rows, true, {} };
      if (!this->FileName.empty())
      {
        table = ReadRows(this->FileName);
      }
      else if (start != nullptr && (rowsAreDefault || this->Rows.empty()))
      {
        table = ReadStart(start);
      }
      else if (domain != nullptr && domain->GetNumberOfCells() > 0 && rowsAreDefault)
      {
        table = FitRows(domain, progress);
      }
      if (this->UseHandles)
      {
        MoveToHandles(this->Handles, table);
      }
      const PlaneFrame frame = FindFrame(domain, start);
      frame.Write(this->Plane);
      CompletePositions(frame, table);
      vtkPolyData* output = vtkPolyData::GetData(outputVector);
      WritePoints(table, output);
      frame.Record(output->GetFieldData());
      for (const auto& row : table.rows)
      {
        this->OutputRows->InsertNextTuple(row.data());
      }
    });
}

//------------------------------------------------------------------------------
void vtkSingularitySource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Singularities: " << this->Rows.size() << "\n";
  for (const auto& [x, y, quarterIndex, radius] : this->Rows)
  {
    os << indent.GetNextIndent() << x << " " << y << " " << quarterIndex << " " << radius << "\n";
  }
  os << indent << "UseHandles: " << (this->UseHandles ? "on" : "off") << "\n";
  os << indent << "Handles: " << this->Handles.size() << "\n";
  for (const auto& [x, y, z] : this->Handles)
  {
    os << indent.GetNextIndent() << x << " " << y << " " << z << "\n";
  }
}
