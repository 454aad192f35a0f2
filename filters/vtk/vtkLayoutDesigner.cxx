#include "vtkLayoutDesigner.h"

#include "AutomaticConfiguration.h"
#include "CornerConversion.h"
#include "EnergyConversion.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "KeptDomain.h"
#include "LayoutConversion.h"
#include "LayoutDesign.h"
#include "LayoutSnap.h"
#include "MapConversion.h"
#include "PairPlacement.h"
#include "QuadConversion.h"
#include "QuarterIndexRange.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

vtkStandardNewMacro(vtkLayoutDesigner);

namespace
{
using crossfield::Configuration;

/** The designer's rows as a configuration, and back. */
template <class Rows>
Configuration FromRows(const Rows& rows)
{
  Configuration configuration;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const auto& [x, y, quarterIndex, radius] = rows[i];
    configuration.push_back({ { x, y },
      crossfield::RequireQuarterIndex(
        quarterIndex, "The quarter index of singularity " + std::to_string(i + 1)),
      radius });
  }
  return configuration;
}

template <class Rows>
Rows ToRows(const Configuration& configuration)
{
  Rows rows;
  for (const crossfield::Singularity& singularity : configuration)
  {
    rows.push_back({ singularity.position.x(), singularity.position.y(),
      static_cast<double>(singularity.quarterIndex), singularity.radius });
  }
  return rows;
}
}

/** What is asked of one update. */
struct vtkLayoutDesigner::Question
{
  const DomainConversion::Domain& input;
  std::optional<Configuration> start{}; ///< Port 1.
  crossfield::LayoutOptions options{};
  double meshSize = 0.0;
  double quadSize = 0.0;
  double snapTolerance = 0.0;
  Command command = Command::None;
  int rowToRemove = -1;
};

struct vtkLayoutDesigner::Memory
{
  KeptDomain domain;
  int version = 0; ///< Of the domain that the rest is of.
  std::optional<crossfield::AutomaticConfiguration> chosen;
  std::optional<crossfield::LayoutDesign> design;
  std::vector<std::vector<Row>> before; ///< Of the commands, the last one last.
  std::vector<std::string> events;      ///< Of the last command.
  vtkNew<vtkDoubleArray> rows;

  /** Forgets what was of another domain than the one that is read last. */
  void KeepUp()
  {
    if (this->version != this->domain.GetVersion())
    {
      this->chosen.reset();
      this->design.reset();
      this->before.clear();
      this->events.clear();
      this->version = this->domain.GetVersion();
    }
  }

  /** The singularities that would be chosen for the domain. */
  const Configuration& Choose(const Question& question, const crossfield::Progress& progress)
  {
    if (!this->chosen)
    {
      crossfield::AutomaticOptions automatic;
      automatic.proposal.corners = question.options.map.corners;
      if (question.options.map.capCorners)
      {
        crossfield::CapCorners(question.input.domain, automatic);
      }
      automatic.optimizer.meshSize = question.meshSize;
      automatic.quadSize = question.quadSize;
      this->chosen = crossfield::ChooseConfiguration(question.input.domain, automatic, progress);
    }
    return this->chosen->singularities;
  }

  /** The singularities before the command. */
  Configuration Start(
    Question& question, const std::vector<Row>& given, const crossfield::Progress& progress)
  {
    Configuration now = !given.empty() ? FromRows(given)
      : question.start                 ? *question.start
                                       : this->Choose(question, progress);
    if (question.command == Command::Propose)
    {
      this->Choose(question, progress);
    }
    if (this->chosen)
    {
      question.options.map.corners = this->chosen->corners;
    }
    return now;
  }

  /** Obeys the command: changes the singularities, and the rows to these. */
  void Obey(const Question& question, Configuration& now, std::vector<Row>& given,
    const crossfield::Progress& progress)
  {
    if (question.command != Command::None)
    {
      this->events.clear();
    }
    if (question.command == Command::Undo)
    {
      if (!this->before.empty())
      {
        given = this->before.back();
        this->before.pop_back();
        now = FromRows(given);
      }
    }
    else if (question.command != Command::None)
    {
      const auto start = ToRows<std::vector<Row>>(now);
      this->Apply(question, now, progress);
      this->before.push_back(start);
      given = ToRows<std::vector<Row>>(now);
    }
  }

private:
  void Apply(const Question& question, Configuration& now, const crossfield::Progress& progress)
  {
    if (question.command == Command::Propose)
    {
      now = this->chosen->singularities;
    }
    else if (question.command == Command::Optimise)
    {
      crossfield::OptimizerOptions optimizer;
      optimizer.meshSize = question.meshSize;
      optimizer.corners = question.options.map.corners;
      optimizer.clearance = crossfield::ClearanceForQuads(question.quadSize);
      optimizer.keepAll = true; // a row that vanished could not be dragged on
      const crossfield::OptimizerResult result =
        crossfield::OptimizeSingularities(question.input.domain, now, optimizer, progress);
      now = result.configuration;
      this->events = result.events;
      this->events.push_back(result.reason);
    }
    else if (question.command == Command::Snap)
    {
      const crossfield::FactoredDomain& factored = this->domain.Factor(now, question.meshSize);
      const crossfield::LayoutSnap snap = crossfield::SnapLayout(
        factored, now, question.options.map, question.snapTolerance, progress);
      now = snap.singularities;
      std::ostringstream text;
      text << snap.joined << " near misses of lines were joined and " << snap.leftOut
           << " left; no singularity moved by more than " << snap.largestMove << ".";
      this->events.push_back(text.str());
    }
    else if (question.command == Command::AddPair)
    {
      const auto places =
        crossfield::PlacesForPair(this->domain.Factor(now, question.meshSize), now);
      now.push_back({ places[0], 1 });
      now.push_back({ places[1], -1 });
    }
    else if (question.rowToRemove >= 0 && question.rowToRemove < static_cast<int>(now.size()))
    {
      now.erase(now.begin() + question.rowToRemove);
    }
  }
};

//------------------------------------------------------------------------------
vtkLayoutDesigner::vtkLayoutDesigner()
  : Kept(std::make_unique<Memory>())
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(4);
  this->Kept->rows->SetNumberOfComponents(4);
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
  return FilterPorts::Give(info, port == 3 ? "vtkUnstructuredGrid" : "vtkPolyData");
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
  const Row wanted = { x, y, quarterIndex, radius };
  if (index < this->Rows.size() && this->Rows[index] == wanted)
  {
    return;
  }
  if (index >= this->Rows.size())
  {
    this->Rows.resize(index + 1, Row{ 0.0, 0.0, 1.0, 0.0 });
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
  return this->Kept->rows;
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::Ask(Command command)
{
  this->Waiting = command;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::Propose()
{
  this->Ask(Command::Propose);
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::Optimise()
{
  this->Ask(Command::Optimise);
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::Snap()
{
  this->Ask(Command::Snap);
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::AddPair()
{
  this->Ask(Command::AddPair);
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::RemoveSingularity(int row)
{
  if (row >= 0)
  {
    this->RowToRemove = row;
    this->Ask(Command::Remove);
  }
}

//------------------------------------------------------------------------------
void vtkLayoutDesigner::Undo()
{
  this->Ask(Command::Undo);
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
  return FilterRun::Run(this, this->ErrorCode, domain,
    [&](const crossfield::Progress& progress)
    {
      Memory& kept = *this->Kept;
      const DomainConversion::Domain& input = kept.domain.Read(domain);
      kept.KeepUp();
      Question question{ input };
      question.options.map.corners = CornerConversion::ReadCorners(corners, input.plane);
      question.options.map.capCorners = this->CapCorners;
      if (start != nullptr)
      {
        question.start = DomainConversion::ReadConfiguration(start, input.plane);
      }
      question.meshSize = this->MeshSize;
      question.quadSize = this->QuadSize > 0.0
        ? this->QuadSize
        : std::sqrt(input.domain.Area() / static_cast<double>(this->QuadCount));
      if (this->Quads != QuadsNone)
      {
        question.options.quads.emplace();
        question.options.quads->size = this->QuadSize;
        question.options.quads->count = this->QuadCount;
        question.options.quads->smooth = this->Quads == QuadsSmooth;
      }
      question.snapTolerance =
        this->SnapTolerance > 0.0 ? this->SnapTolerance : 0.5 * question.quadSize;
      question.command = std::exchange(this->Waiting, Command::None);
      question.rowToRemove = this->RowToRemove;

      LayoutConversion::Report report;
      report.quadSize = question.quadSize;
      Configuration now;
      const double energyBefore =
        kept.design ? kept.design->energy.energy : std::numeric_limits<double>::quiet_NaN();
      // A configuration that cannot be is a step of designing one: what was there before stays, and the sentence is the verdict.
      try
      {
        now = kept.Start(question, this->Rows, progress.Part(0.0, 0.2));
        kept.Obey(question, now, this->Rows, progress.Part(0.2, 0.4));
        kept.design =
          crossfield::DesignLayout(kept.domain.Factor(now, this->MeshSize, progress.Part(0.4, 0.6)),
            now, question.options, progress.Part(0.6, 0.95));
        this->StageSeconds = kept.design->seconds;
        if (question.command != Command::None && std::isfinite(energyBefore))
        {
          std::ostringstream text;
          text << "The renormalised energy went from " << energyBefore << " to "
               << kept.design->energy.energy << ".";
          kept.events.push_back(text.str());
        }
      }
      catch (const crossfield::Error& error)
      {
        report.refusal = error.what();
      }

      kept.rows->SetNumberOfTuples(0);
      for (const Row& row : ToRows<std::vector<Row>>(now))
      {
        kept.rows->InsertNextTuple(row.data());
      }
      DomainConversion::WriteConfiguration(now, input.plane, points);
      const crossfield::LayoutDesign* design = kept.design ? &*kept.design : nullptr;
      if (design != nullptr)
      {
        const MapConversion::Map map{ design->map, input.plane };
        MapConversion::WriteTraces(map, design->lines, {}, 0.0, lines);
        MapConversion::WriteFaces(map, design->mesh, faces);
        MapConversion::AddCounts(design->mesh, faces->GetFieldData());
        if (design->quads)
        {
          QuadConversion::WriteQuads(*design->quads, input.plane, quads);
        }
      }
      EnergyConversion::WriteEvents(kept.events, lines);
      EnergyConversion::WriteEvents(kept.events, points);
      LayoutConversion::AddReport(design, report, lines->GetFieldData());
      LayoutConversion::AddReport(design, report, points->GetFieldData());
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
  os << indent << "QuadSize: " << this->QuadSize << "\n";
  os << indent << "QuadCount: " << this->QuadCount << "\n";
  os << indent << "SnapTolerance: " << this->SnapTolerance << "\n";
  os << indent << "StageSeconds: " << this->StageSeconds << "\n";
}
