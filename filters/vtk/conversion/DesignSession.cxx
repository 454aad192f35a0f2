#include "DesignSession.h"

#include "DesignInPlane.h"
#include "DesignOnSurface.h"
#include "Error.h"
#include "Plane.h"
#include "QuarterIndexRange.h"
#include "SurfaceConversion.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

namespace
{
/** Returns the distance of two rows. The fourth numbers are their z, or radii. */
double Distance(const DesignModel::Row& one, const DesignModel::Row& other, bool hasHeight)
{
  return std::hypot(one[0] - other[0], one[1] - other[1], hasHeight ? one[3] - other[3] : 0.0);
}
}

//------------------------------------------------------------------------------
const DesignModel& DesignSession::Read(vtkDataSet* data, double featureAngle)
{
  if (!this->Model || this->Data != data || this->Time != data->GetMTime() ||
    this->FeatureAngle != featureAngle)
  {
    const bool isSurface = SurfaceConversion::IsSurface(data);
    this->Model.reset();
    this->Design.reset();
    this->UndoStack.clear();
    this->Events.clear();
    this->Explained.clear();
    this->Origins.clear();
    this->Snapped.clear();
    this->RequiredSum.reset();
    if (isSurface)
    {
      this->Model = std::make_unique<DesignOnSurface>(data, featureAngle);
    }
    else
    {
      this->Model = std::make_unique<DesignInPlane>(data);
    }
    this->Data = data;
    this->Time = data->GetMTime();
    this->FeatureAngle = featureAngle;
  }
  return *this->Model;
}

//------------------------------------------------------------------------------
DesignUpdate DesignSession::Update(
  DesignRequest request, std::vector<Row>& rows, const crossfield::Progress& progress)
{
  DesignUpdate update;
  const double energyBefore =
    this->Design ? this->Design->energy.energy : std::numeric_limits<double>::quiet_NaN();
  try
  {
    const bool isTyped = !rows.empty();
    update.rows = this->Start(request, rows, progress.Part(0.0, 0.2));
    this->Apply(request, update.rows, rows, progress.Part(0.2, 0.4));
    this->ExplainRows(request, isTyped, update.rows);
    update.isSnapped = update.rows == this->Snapped;
    update.reasons = this->Origins;
    if (!request.isDragging) // costs a tenth of a layout, and is not shown meanwhile
    {
      this->RequiredSum = this->Model->RequiredSum(request, update.rows);
    }
    update.requiredSum = this->RequiredSum;
    if (this->Design)
    {
      request.options.earlier = this->Design->colours;
    }
    this->Design = this->Model->Design(request, update.rows, progress.Part(0.4, 0.95));
    update.reasons = this->ExplainNodes(request, update.rows);
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
/** Returns the singularities before the command. */
DesignModel::Rows DesignSession::Start(
  const DesignRequest& request, const std::vector<Row>& rows, const crossfield::Progress& progress)
{
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    crossfield::RequireQuarterIndex(
      rows[i][2], "The quarter index of singularity " + std::to_string(i + 1));
  }
  if (request.command == DesignCommand::Propose)
  {
    this->Model->Choose(request, progress);
  }
  return !rows.empty() ? rows
    : request.start    ? *request.start
                       : this->Model->Choose(request, progress);
}

//------------------------------------------------------------------------------
void DesignSession::Apply(const DesignRequest& request, DesignModel::Rows& singularities,
  std::vector<Row>& rows, const crossfield::Progress& progress)
{
  this->Events.clear();
  const DesignModel::Rows start = singularities;
  switch (request.command)
  {
  case DesignCommand::None:
    return;
  case DesignCommand::Undo:
    if (!this->UndoStack.empty())
    {
      rows = this->UndoStack.back();
      this->UndoStack.pop_back();
      singularities = rows;
    }
    return;
  case DesignCommand::Propose:
    singularities = this->Model->Choose(request, progress);
    break;
  case DesignCommand::Remove:
    if (request.rowToRemove >= 0 && request.rowToRemove < static_cast<int>(singularities.size()))
    {
      singularities.erase(singularities.begin() + request.rowToRemove);
    }
    break;
  default:
    singularities = this->Model->Change(request, singularities, this->Events, progress);
    break;
  }
  if (singularities != start) // otherwise chosen singularities stay chosen
  {
    this->UndoStack.push_back(start);
    rows = singularities;
  }
}

//------------------------------------------------------------------------------
/** Returns how a row got its place, if this update has put it there. */
std::string DesignSession::OriginOf(const DesignRequest& request, bool isTyped) const
{
  switch (request.command)
  {
  case DesignCommand::AddPair:
    return "Added by Add Pair, where there is most space.";
  case DesignCommand::Undo:
    return "Restored by Undo.";
  case DesignCommand::Optimise:
    return this->Model->HasHeight() ? "Moved by Optimise, to make sizes more even."
                                    : "Moved by Optimise, to lower the energy.";
  case DesignCommand::Snap:
    return "Moved by Snap, to join separatrices.";
  case DesignCommand::Propose:
    return "Chosen for this domain.";
  default:
    return isTyped    ? "Placed by you."
      : request.start ? "Given by Start From."
                      : "Chosen for this domain.";
  }
}

//------------------------------------------------------------------------------
/** Notes how each row got its place, in this update or an earlier one. */
void DesignSession::ExplainRows(
  const DesignRequest& request, bool isTyped, const DesignModel::Rows& rows)
{
  if (request.command == DesignCommand::Snap)
  {
    this->Snapped = rows;
  }
  std::vector<std::string> origins;
  for (const Row& row : rows)
  {
    const auto same = std::find(this->Explained.begin(), this->Explained.end(), row);
    origins.push_back(same == this->Explained.end()
        ? this->OriginOf(request, isTyped)
        : this->Origins[static_cast<std::size_t>(same - this->Explained.begin())]);
  }
  this->Explained = rows;
  this->Origins = std::move(origins);
}

//------------------------------------------------------------------------------
/** Returns the sentences about rows, and how far their nodes are from them. */
std::vector<std::string> DesignSession::ExplainNodes(
  const DesignRequest& request, const DesignModel::Rows& rows) const
{
  std::vector<std::string> reasons = this->Origins;
  const DesignModel::Rows nodes = this->Model->NodesOf(*this->Design);
  const double noticeable = 0.1 * request.QuadSizeOn(this->Model->Area());
  for (std::size_t i = 0; i < std::min(rows.size(), nodes.size()); ++i)
  {
    const double distance = Distance(rows[i], nodes[i], this->Model->HasHeight());
    if (this->Design->quads && distance > noticeable)
    {
      reasons[i] += " Its node is " + crossfield::FormatNumber(distance, 2) + " away, " +
        (request.options.clean ? "where separatrices meet (Merge)."
                               : "because quads would be poor here.");
    }
  }
  return reasons;
}
