#include "DesignSession.h"

#include "Error.h"
#include "LayoutSnap.h"
#include "PairPlacement.h"
#include "QuadClearance.h"
#include "QuarterIndexRange.h"
#include "RequestedSingularities.h"
#include "ResolvedRequest.h"

#include <cmath>
#include <limits>
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
    this->Design.reset();
    this->UndoStack.clear();
    this->Events.clear();
    this->Version = this->Domain.GetVersion();
  }
  return domain;
}

//------------------------------------------------------------------------------
DesignUpdate DesignSession::Update(
  DesignRequest request, std::vector<Row>& rows, const crossfield::Progress& progress)
{
  DesignUpdate update;
  Configuration& singularities = update.singularities;
  const double energyBefore =
    this->Design ? this->Design->energy.energy : std::numeric_limits<double>::quiet_NaN();
  try
  {
    singularities = this->Prepare(request, rows, progress.Part(0.0, 0.2));
    this->Apply(request, singularities, rows, progress.Part(0.2, 0.4));
    if (this->Design)
    {
      request.options.earlier = this->Design->colours;
    }
    this->Design = crossfield::DesignLayout(
      this->Domain.Factor(singularities, request.meshSize, progress.Part(0.4, 0.6)), singularities,
      request.options, progress.Part(0.6, 0.95));
    if (request.command != DesignCommand::None && std::isfinite(energyBefore))
    {
      std::ostringstream text;
      text << "The renormalised energy changed from " << energyBefore << " to "
           << this->Design->energy.energy << ".";
      this->Events.push_back(text.str());
    }
  }
  catch (const crossfield::Error& error)
  {
    update.refusal = error.what();
  }
  return update;
}

//------------------------------------------------------------------------------
const Configuration& DesignSession::Choose(
  const DesignRequest& request, const crossfield::Progress& progress)
{
  if (!this->Chosen)
  {
    crossfield::QuadRequest quads;
    quads.corners = request.options.map.corners;
    quads.capCorners = request.options.map.capCorners;
    quads.meshSize = request.meshSize;
    quads.quadSize = request.quadSize;
    quads.sizing = crossfield::Sizing::Conformal; // as the quads of the design
    this->Chosen = crossfield::ChooseSingularities(
      this->Domain.Get(), crossfield::Resolve(this->Domain.Get(), quads), progress);
  }
  return this->Chosen->singularities;
}

//------------------------------------------------------------------------------
/**
 * Returns the singularities before the command, and sets the corners of the request to those that
 * were chosen with them.
 */
Configuration DesignSession::Prepare(
  DesignRequest& request, const std::vector<Row>& rows, const crossfield::Progress& progress)
{
  Configuration singularities = !rows.empty() ? FromRows(rows)
    : request.start                           ? *request.start
                                              : this->Choose(request, progress);
  if (request.command == DesignCommand::Propose)
  {
    this->Choose(request, progress);
  }
  if (this->Chosen)
  {
    request.options.map.corners = this->Chosen->corners;
  }
  return singularities;
}

//------------------------------------------------------------------------------
void DesignSession::Apply(const DesignRequest& request, Configuration& singularities,
  std::vector<Row>& rows, const crossfield::Progress& progress)
{
  this->Events.clear();
  if (request.command == DesignCommand::None)
  {
    return;
  }
  if (request.command != DesignCommand::Undo)
  {
    const std::vector<Row> start = ToRows(singularities);
    this->ApplyCommand(request, singularities, progress);
    if (ToRows(singularities) != start) // otherwise chosen singularities stay chosen
    {
      this->UndoStack.push_back(start);
      rows = ToRows(singularities);
    }
  }
  else if (!this->UndoStack.empty())
  {
    rows = this->UndoStack.back();
    this->UndoStack.pop_back();
    singularities = FromRows(rows);
  }
}

//------------------------------------------------------------------------------
void DesignSession::ApplyCommand(
  const DesignRequest& request, Configuration& singularities, const crossfield::Progress& progress)
{
  if (request.command == DesignCommand::Propose)
  {
    singularities = this->Chosen->singularities;
  }
  else if (request.command == DesignCommand::Optimise)
  {
    crossfield::OptimizerOptions optimizer;
    optimizer.meshSize = request.meshSize;
    optimizer.corners = request.options.map.corners;
    optimizer.clearance = crossfield::ClearanceForQuads(request.quadSize);
    optimizer.keepAll = true; // every row keeps its handle
    const crossfield::OptimizerResult result =
      crossfield::OptimizeSingularities(this->Domain.Get(), singularities, optimizer, progress);
    singularities = result.configuration;
    this->Events = result.events;
    this->Events.push_back(result.reason);
  }
  else if (request.command == DesignCommand::Snap)
  {
    const crossfield::LayoutSnap snap =
      crossfield::SnapLayout(this->Domain.Factor(singularities, request.meshSize), singularities,
        request.options.map, request.snapTolerance, progress);
    singularities = snap.singularities;
    this->Events.push_back(snap.event);
  }
  else if (request.command == DesignCommand::AddPair)
  {
    const auto places = crossfield::PositionsForPair(
      this->Domain.Factor(singularities, request.meshSize), singularities);
    singularities.push_back({ places[0], 1 });
    singularities.push_back({ places[1], -1 });
  }
  else if (request.rowToRemove >= 0 && request.rowToRemove < static_cast<int>(singularities.size()))
  {
    singularities.erase(singularities.begin() + request.rowToRemove);
  }
}
