#include "vtkLayoutDesigner.h"

#include "DesignSession.h"
#include "EnergyConversion.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "LayoutConversion.h"
#include "MapConversion.h"
#include "PatchConversion.h"
#include "PlaneFrame.h"
#include "QuadConversion.h"
#include "QuadReport.h"
#include "TMeshConversion.h"
#include "ViewText.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <utility>

vtkStandardNewMacro(vtkLayoutDesigner);

namespace
{
/** Output data objects of the filter. */
class Outputs
{
public:
  explicit Outputs(vtkInformationVector* outputVector)
    : Separatrices(vtkPolyData::GetData(outputVector, 0))
    , Patches(vtkPolyData::GetData(outputVector, 1))
    , Singularities(vtkPolyData::GetData(outputVector, 2))
    , Quads(vtkUnstructuredGrid::GetData(outputVector, 3))
    , Summary(vtkTable::GetData(outputVector, 4))
    , Boundary(vtkPolyData::GetData(outputVector, 5))
  {
  }

  /**
   * Writes the last design of a session and the singularities of its last update, whose refusal is
   * added to the report.
   */
  void Write(const DesignSession& session, const DesignUpdate& update, const DesignModel& model,
    LayoutConversion::Report report) const
  {
    report.refusal = update.refusal;
    const crossfield::LayoutDesign* design = session.GetDesign();
    const bool current = design != nullptr && update.refusal.empty();
    model.WriteSingularities(current ? model.NodesOf(*design) : update.rows, this->Singularities);
    if (design != nullptr)
    {
      this->WriteDesign(*design, model.Plane(), !current);
    }
    this->WriteReport(design, report);
    for (vtkPolyData* output : { this->Separatrices, this->Singularities })
    {
      // Added last, since ParaView shows no array if the first one is empty.
      EnergyConversion::WriteEvents(session.GetEvents(), output);
    }
  }

  /** Writes the message of a failure. */
  void WriteFailure(const char* message) const
  {
    LayoutConversion::Report report;
    report.refusal = message;
    this->WriteReport(nullptr, report);
  }

private:
  void WriteDesign(
    const crossfield::LayoutDesign& design, const crossfield::DomainPlane& plane, bool stale) const
  {
    const crossfield::Layout& layout = design.layouts.Single();
    const MapConversion::Map map{ layout.map, plane };
    const bool isOnSurface = layout.map.topology->charts.has_value();
    if (isOnSurface)
    {
      TMeshConversion::WriteArcs(map, layout.tMesh, this->Separatrices);
    }
    else
    {
      TMeshConversion::WriteTraces(map, layout.separatrices, {}, 0.0, this->Separatrices);
    }
    LayoutConversion::AddShade(stale, this->Separatrices);
    if (isOnSurface && design.quads)
    {
      PatchConversion::WriteQuadsOfPatches(design.quads->mesh, this->Patches);
    }
    else
    {
      PatchConversion::WritePatches(map, layout.tMesh, this->Patches);
    }
    LayoutConversion::AddColours(design.colours, stale, this->Patches);
    TMeshConversion::AddCounts(layout.tMesh, this->Patches->GetFieldData());
    if (design.quads)
    {
      QuadConversion::WriteQuads(*design.quads, plane, this->Quads);
      QuadConversion::WriteBoundary(design.quads->mesh, {}, plane, this->Boundary);
      QuadReport::Write(*design.quads, plane, this->Summary->GetFieldData());
    }
  }

  void WriteReport(
    const crossfield::LayoutDesign* design, const LayoutConversion::Report& report) const
  {
    for (vtkPolyData* output : { this->Separatrices, this->Singularities })
    {
      LayoutConversion::AddReport(design, report, output->GetFieldData());
    }
    ViewText::Write(vtkCrossFieldArrayNames::Summary,
      ViewText::WrapLines(LayoutConversion::Summary(design, report)),
      LayoutConversion::ReportsProblem(design, report), this->Summary);
  }

  vtkPolyData* Separatrices;
  vtkPolyData* Patches;
  vtkPolyData* Singularities;
  vtkUnstructuredGrid* Quads;
  vtkTable* Summary;
  vtkPolyData* Boundary;
};
}

//------------------------------------------------------------------------------
vtkLayoutDesigner::vtkLayoutDesigner()
  : Command(DesignCommand::None)
  , Session(std::make_unique<DesignSession>())
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(6);
  this->OutputRows->SetNumberOfComponents(4);
  this->Triangles->SetNumberOfComponents(9);
  PlaneFrame().Write(this->Plane);
}

//------------------------------------------------------------------------------
vtkLayoutDesigner::~vtkLayoutDesigner() = default;

//------------------------------------------------------------------------------
int vtkLayoutDesigner::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::AcceptDomain(info) : FilterPorts::AcceptOptionalPoints(info);
}

//------------------------------------------------------------------------------
int vtkLayoutDesigner::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* const types[6] = { "vtkPolyData", "vtkPolyData", "vtkPolyData", "vtkUnstructuredGrid",
    "vtkTable", "vtkPolyData" };
  return FilterPorts::Produce(info, types[port]);
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::SetSingularity(
  int row, double x, double y, double quarterIndex, double fourth)
{
  if (row < 0)
  {
    return;
  }
  const auto index = static_cast<std::size_t>(row);
  const DesignSession::Row newRow = { x, y, quarterIndex, fourth };
  if (index < this->Rows.size() && this->Rows[index] == newRow)
  {
    return;
  }
  if (index >= this->Rows.size())
  {
    this->Rows.resize(index + 1, { 0.0, 0.0, 1.0, 0.0 });
  }
  this->Rows[index] = newRow;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::AddSingularity(double x, double y, double quarterIndex, double fourth)
{
  this->Rows.push_back({ x, y, quarterIndex, fourth });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::RemoveAllSingularities()
{
  if (!this->Rows.empty())
  {
    this->Rows.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkLayoutDesigner::GetNumberOfSingularities() const
{
  return static_cast<int>(this->Rows.size());
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkLayoutDesigner::GetRows()
{
  return this->OutputRows;
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkLayoutDesigner::GetPlane()
{
  return this->Plane;
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkLayoutDesigner::GetTriangles()
{
  return this->Triangles;
}

//------------------------------------------------------------------------------
vtkIntArray* vtkLayoutDesigner::GetRequiredSum()
{
  return this->RequiredSum;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkLayoutDesigner::GetReasons()
{
  return this->Reasons;
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::SetCommand(DesignCommand command)
{
  this->Command = command;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::Propose()
{
  this->SetCommand(DesignCommand::Propose);
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::Optimise()
{
  this->SetCommand(DesignCommand::Optimise);
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::Snap()
{
  this->SetCommand(DesignCommand::Snap);
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::AddPair()
{
  this->SetCommand(DesignCommand::AddPair);
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::RemoveSingularity(int row)
{
  if (row >= 0)
  {
    this->RowToRemove = row;
    this->SetCommand(DesignCommand::Remove);
  }
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::Undo()
{
  this->SetCommand(DesignCommand::Undo);
}

//------------------------------------------------------------------------------
DesignRequest vtkLayoutDesigner::MakeRequest(
  const DesignModel& model, vtkDataSet* start, vtkDataSet* corners)
{
  DesignRequest request;
  request.options.map.corners = model.ReadCorners(corners);
  request.options.map.capCorners = this->CapCorners;
  if (start != nullptr)
  {
    request.start = model.Read(start);
  }
  request.meshSize = this->MeshSize;
  request.isDragging = this->Dragging;
  request.quadSize = this->QuadSize;
  request.quadCount = this->QuadCount;
  if (this->Quads != QuadsNone)
  {
    request.options.quads.emplace();
    request.options.quads->quadSize = this->QuadSize;
    request.options.quads->quadCount = this->QuadCount;
    const bool smooth = this->Quads == QuadsSmooth && !this->Dragging;
    request.options.quads->smooth = smooth;
    request.options.quads->coarse = this->Merge == vtkQuadMesher::MergeCoarse && smooth;
    request.options.clean = this->Merge == vtkQuadMesher::MergeClean && smooth;
  }
  request.snapTolerance = this->SnapTolerance;
  request.command = std::exchange(this->Command, DesignCommand::None);
  request.rowToRemove = this->RowToRemove;
  return request;
}

//------------------------------------------------------------------------------
int vtkLayoutDesigner::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* domain = vtkDataSet::GetData(inputVector[0]);
  const Outputs outputs(outputVector);
  return FilterRun::Run(
    this, this->ErrorCode, domain,
    [&](const crossfield::Progress& progress)
    {
      const DesignModel& model = this->Session->Read(domain, this->FeatureAngle);
      PlaneFrame(model.Plane()).Write(this->Plane);
      this->Triangles->SetNumberOfTuples(0);
      model.WriteTriangles(this->Triangles);
      const DesignRequest request = this->MakeRequest(
        model, vtkDataSet::GetData(inputVector[1]), vtkDataSet::GetData(inputVector[2]));
      const DesignUpdate update = this->Session->Update(request, this->Rows, progress);
      if (update.refusal.empty())
      {
        this->StageSeconds = this->Session->GetDesign()->seconds;
      }
      this->OutputRows->SetNumberOfTuples(0);
      for (const DesignSession::Row& row : update.rows)
      {
        this->OutputRows->InsertNextTuple(row.data());
      }
      this->RequiredSum->SetNumberOfValues(0);
      if (update.requiredSum)
      {
        this->RequiredSum->InsertNextValue(*update.requiredSum);
      }
      this->Reasons->SetNumberOfValues(0);
      for (const std::string& reason : update.reasons)
      {
        this->Reasons->InsertNextValue(reason);
      }
      outputs.Write(*this->Session, update, model,
        { {}, request.QuadSizeOn(model.Area()),
          this->Merge == vtkQuadMesher::MergeNone && !model.HasHeight(), update.isSnapped,
          this->Quads != QuadsSmooth || this->Dragging });
    },
    [&](const char* message)
    {
      this->OutputRows->SetNumberOfTuples(0); // no domain, no rows
      this->RequiredSum->SetNumberOfValues(0);
      this->Reasons->SetNumberOfValues(0);
      this->Triangles->SetNumberOfTuples(0);
      outputs.WriteFailure(message);
    });
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Singularities: " << this->Rows.size() << "\n";
  os << indent << "MeshSize: " << this->MeshSize << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "CapCorners: " << this->CapCorners << "\n";
  os << indent << "Quads: " << this->Quads << "\n";
  os << indent << "Merge: " << this->Merge << "\n";
  os << indent << "Dragging: " << this->Dragging << "\n";
  os << indent << "QuadSize: " << this->QuadSize << "\n";
  os << indent << "QuadCount: " << this->QuadCount << "\n";
  os << indent << "SnapTolerance: " << this->SnapTolerance << "\n";
  os << indent << "StageSeconds: " << this->StageSeconds << "\n";
}
