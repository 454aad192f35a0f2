#include "DesignSession.h"

#include "LayoutSnap.h"
#include "PairPlacement.h"
#include "QuarterIndexRange.h"

#include <sstream>

using crossfield::Configuration;

//------------------------------------------------------------------------------
Configuration DesignSession::FromRows(const std::vector<Row>& rows)
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

//------------------------------------------------------------------------------
std::vector<DesignSession::Row> DesignSession::ToRows(const Configuration& configuration)
{
  std::vector<Row> rows;
  rows.reserve(configuration.size());
  for (const crossfield::Singularity& singularity : configuration)
  {
    rows.push_back({ singularity.position.x(), singularity.position.y(),
      static_cast<double>(singularity.quarterIndex), singularity.radius });
  }
  return rows;
}

//------------------------------------------------------------------------------
const DomainConversion::Domain& DesignSession::Read(vtkDataSet* data)
{
  const DomainConversion::Domain& domain = this->Domain.Read(data);
  if (this->Version != this->Domain.GetVersion())
  {
    this->Chosen.reset();
    this->design.reset();
    this->Before.clear();
    this->events.clear();
    this->Version = this->Domain.GetVersion();
  }
  return domain;
}

//------------------------------------------------------------------------------
const Configuration& DesignSession::Choose(
  const DesignRequest& question, const crossfield::Progress& progress)
{
  if (!this->Chosen)
  {
    crossfield::AutomaticOptions automatic;
    automatic.proposal.corners = question.options.map.corners;
    if (question.options.map.capCorners)
    {
      crossfield::CapCorners(this->Domain.Get(), automatic);
    }
    automatic.optimizer.meshSize = question.meshSize;
    automatic.quadSize = question.quadSize;
    this->Chosen = crossfield::ChooseConfiguration(this->Domain.Get(), automatic, progress);
  }
  return this->Chosen->singularities;
}

//------------------------------------------------------------------------------
Configuration DesignSession::Start(
  DesignRequest& question, const std::vector<Row>& given, const crossfield::Progress& progress)
{
  Configuration now = !given.empty() ? FromRows(given)
    : question.start                 ? *question.start
                                     : this->Choose(question, progress);
  if (question.command == DesignCommand::Propose)
  {
    this->Choose(question, progress);
  }
  if (this->Chosen)
  {
    question.options.map.corners = this->Chosen->corners;
  }
  return now;
}

//------------------------------------------------------------------------------
void DesignSession::Apply(const DesignRequest& question, Configuration& now,
  std::vector<Row>& given, const crossfield::Progress& progress)
{
  this->events.clear();
  if (question.command == DesignCommand::None)
  {
    return;
  }
  if (question.command != DesignCommand::Undo)
  {
    const std::vector<Row> start = ToRows(now);
    this->Apply(question, now, progress);
    this->Before.push_back(start);
    given = ToRows(now);
  }
  else if (!this->Before.empty())
  {
    given = this->Before.back();
    this->Before.pop_back();
    now = FromRows(given);
  }
}

//------------------------------------------------------------------------------
void DesignSession::Apply(
  const DesignRequest& question, Configuration& now, const crossfield::Progress& progress)
{
  if (question.command == DesignCommand::Propose)
  {
    now = this->Chosen->singularities;
  }
  else if (question.command == DesignCommand::Optimise)
  {
    crossfield::OptimizerOptions optimizer;
    optimizer.meshSize = question.meshSize;
    optimizer.corners = question.options.map.corners;
    optimizer.clearance = crossfield::ClearanceForQuads(question.quadSize);
    optimizer.keepAll = true; // a row that vanished could not be dragged on
    const crossfield::OptimizerResult result =
      crossfield::OptimizeSingularities(this->Domain.Get(), now, optimizer, progress);
    now = result.configuration;
    this->events = result.events;
    this->events.push_back(result.reason);
  }
  else if (question.command == DesignCommand::Snap)
  {
    const crossfield::LayoutSnap snap =
      crossfield::SnapLayout(this->Domain.Factor(now, question.meshSize), now, question.options.map,
        question.snapTolerance, progress);
    now = snap.singularities;
    std::ostringstream text;
    text << snap.joined << " near misses of lines were joined and " << snap.leftOut
         << " left; no singularity moved by more than " << snap.largestMove << ".";
    this->events.push_back(text.str());
  }
  else if (question.command == DesignCommand::AddPair)
  {
    const auto places = crossfield::PlacesForPair(this->Domain.Factor(now, question.meshSize), now);
    now.push_back({ places[0], 1 });
    now.push_back({ places[1], -1 });
  }
  else if (question.rowToRemove >= 0 && question.rowToRemove < static_cast<int>(now.size()))
  {
    now.erase(now.begin() + question.rowToRemove);
  }
}
