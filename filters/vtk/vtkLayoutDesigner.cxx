#include "vtkLayoutDesigner.h"

#include "ConfigurationConversion.h"
#include "CornerConversion.h"
#include "DesignSession.h"
#include "EnergyConversion.h"
#include "FaceConversion.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "LayoutConversion.h"
#include "MapConversion.h"
#include "PlaneFrame.h"
#include "QuadConversion.h"
#include "TMeshConversion.h"
#include "ViewText.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

vtkStandardNewMacro(vtkLayoutDesigner);

//------------------------------------------------------------------------------
vtkLayoutDesigner::vtkLayoutDesigner()
  : Waiting(DesignCommand::None)
  , Session(std::make_unique<DesignSession>())
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(5);
  this->OutputRows->SetNumberOfComponents(4);
  PlaneFrame().Write(this->Plane);
}

//------------------------------------------------------------------------------
vtkLayoutDesigner::~vtkLayoutDesigner() = default;

//------------------------------------------------------------------------------
int vtkLayoutDesigner::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::TakeDomain(info) : FilterPorts::TakeOptionalPoints(info);
}

//------------------------------------------------------------------------------
int vtkLayoutDesigner::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* const types[5] = { "vtkPolyData", "vtkPolyData", "vtkPolyData", "vtkUnstructuredGrid",
    "vtkTable" };
  return FilterPorts::Give(info, types[port]);
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::SetSingularity(
  int row, double x, double y, double quarterIndex, double radius)
{
  if (row < 0)
  {
    return;
  }
  const auto index = static_cast<std::size_t>(row);
  const DesignSession::Row wanted = { x, y, quarterIndex, radius };
  if (index < this->Rows.size() && this->Rows[index] == wanted)
  {
    return;
  }
  if (index >= this->Rows.size())
  {
    this->Rows.resize(index + 1, { 0.0, 0.0, 1.0, 0.0 });
  }
  this->Rows[index] = wanted;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::AddSingularity(double x, double y, double quarterIndex, double radius)
{
  this->Rows.push_back({ x, y, quarterIndex, radius });
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
void vtkLayoutDesigner::Ask(DesignCommand command)
{
  this->Waiting = command;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::Propose()
{
  this->Ask(DesignCommand::Propose);
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::Optimise()
{
  this->Ask(DesignCommand::Optimise);
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::Snap()
{
  this->Ask(DesignCommand::Snap);
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::AddPair()
{
  this->Ask(DesignCommand::AddPair);
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::RemoveSingularity(int row)
{
  if (row >= 0)
  {
    this->RowToRemove = row;
    this->Ask(DesignCommand::Remove);
  }
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::Undo()
{
  this->Ask(DesignCommand::Undo);
}

//------------------------------------------------------------------------------
int vtkLayoutDesigner::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* domain = vtkDataSet::GetData(inputVector[0]);
  vtkDataSet* start = vtkDataSet::GetData(inputVector[1]);
  vtkDataSet* corners = vtkDataSet::GetData(inputVector[2]);
  vtkPolyData* lines = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* faces = vtkPolyData::GetData(outputVector, 1);
  vtkPolyData* points = vtkPolyData::GetData(outputVector, 2);
  vtkUnstructuredGrid* quads = vtkUnstructuredGrid::GetData(outputVector, 3);
  vtkTable* summary = vtkTable::GetData(outputVector, 4);
  return FilterRun::Run(
    this, this->ErrorCode, domain,
    [&](const crossfield::Progress& progress)
    {
      DesignSession& session = *this->Session;
      const DomainConversion::Domain& input = session.Read(domain);
      PlaneFrame(input.plane).Write(this->Plane);
      DesignRequest question;
      question.options.map.corners = CornerConversion::ReadCorners(corners, input.plane);
      question.options.map.capCorners = this->CapCorners;
      if (start != nullptr)
      {
        question.start = ConfigurationConversion::ReadConfiguration(start, input.plane);
      }
      question.meshSize =
        this->Dragging ? crossfield::LiveMeshSize(input.domain, this->MeshSize) : this->MeshSize;
      question.quadSize = this->QuadSize > 0.0
        ? this->QuadSize
        : std::sqrt(input.domain.Area() / static_cast<double>(this->QuadCount));
      if (this->Quads != QuadsNone)
      {
        question.options.quads.emplace();
        question.options.quads->size = this->QuadSize;
        question.options.quads->count = this->QuadCount;
        question.options.quads->smooth = this->Quads == QuadsSmooth && !this->Dragging;
      }
      question.snapTolerance =
        this->SnapTolerance > 0.0 ? this->SnapTolerance : 0.5 * question.quadSize;
      question.command = std::exchange(this->Waiting, DesignCommand::None);
      question.rowToRemove = this->RowToRemove;

      LayoutConversion::Report report;
      report.quadSize = question.quadSize;
      crossfield::Configuration now;
      const double energyBefore =
        session.design ? session.design->energy.energy : std::numeric_limits<double>::quiet_NaN();
      // A configuration that cannot be is a step of designing one: what was there before stays, and the sentence is the reason.
      try
      {
        now = session.Start(question, this->Rows, progress.Part(0.0, 0.2));
        session.Apply(question, now, this->Rows, progress.Part(0.2, 0.4));
        session.design = crossfield::DesignLayout(
          session.GetDomain().Factor(now, question.meshSize, progress.Part(0.4, 0.6)), now,
          question.options, progress.Part(0.6, 0.95));
        this->StageSeconds = session.design->seconds;
        if (question.command != DesignCommand::None && std::isfinite(energyBefore))
        {
          std::ostringstream text;
          text << "The renormalised energy went from " << energyBefore << " to "
               << session.design->energy.energy << ".";
          session.events.push_back(text.str());
        }
      }
      catch (const crossfield::Error& error)
      {
        report.refusal = error.what();
      }

      this->OutputRows->SetNumberOfTuples(0);
      for (const DesignSession::Row& row : DesignSession::ToRows(now))
      {
        this->OutputRows->InsertNextTuple(row.data());
      }
      ConfigurationConversion::WriteConfiguration(now, input.plane, points);
      const crossfield::LayoutDesign* design = session.design ? &*session.design : nullptr;
      if (design != nullptr)
      {
        const MapConversion::Map map{ design->map, input.plane };
        TMeshConversion::WriteTraces(map, design->lines, {}, 0.0, lines);
        LayoutConversion::AddShade(!report.refusal.empty(), lines);
        FaceConversion::WriteFaces(map, design->mesh, faces);
        TMeshConversion::AddCounts(design->mesh, faces->GetFieldData());
        if (design->quads)
        {
          QuadConversion::WriteQuads(*design->quads, input.plane, quads);
        }
      }
      for (vtkPolyData* output : { lines, points })
      {
        LayoutConversion::AddReport(design, report, output->GetFieldData());
        // Last: where the first array is empty, ParaView shows none.
        EnergyConversion::WriteEvents(session.events, output);
      }
      ViewText::Write(vtkCrossFieldArrayNames::Summary,
        ViewText::InLines(LayoutConversion::Summary(design, report)), !report.refusal.empty(),
        summary);
    },
    [&](const char* sentence)
    {
      // Without a domain there are no rows either.
      this->OutputRows->SetNumberOfTuples(0);
      LayoutConversion::Report report;
      report.refusal = sentence;
      for (vtkPolyData* output : { lines, points })
      {
        LayoutConversion::AddReport(nullptr, report, output->GetFieldData());
      }
      ViewText::Write(vtkCrossFieldArrayNames::Summary, ViewText::InLines(sentence), true, summary);
    });
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Singularities: " << this->Rows.size() << "\n";
  os << indent << "MeshSize: " << this->MeshSize << "\n";
  os << indent << "CapCorners: " << this->CapCorners << "\n";
  os << indent << "Quads: " << this->Quads << "\n";
  os << indent << "Dragging: " << this->Dragging << "\n";
  os << indent << "QuadSize: " << this->QuadSize << "\n";
  os << indent << "QuadCount: " << this->QuadCount << "\n";
  os << indent << "SnapTolerance: " << this->SnapTolerance << "\n";
  os << indent << "StageSeconds: " << this->StageSeconds << "\n";
}
