#include "DesignSession.h"

#include "DesignInPlane.h"
#include "DesignOnSurface.h"
#include "Error.h"
#include "QuarterIndexRange.h"
#include "SurfaceConversion.h"

#include "vtkDataSet.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

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
    update.rows = this->Start(request, rows, progress.Part(0.0, 0.2));
    this->Apply(request, update.rows, rows, progress.Part(0.2, 0.4));
    if (this->Design)
    {
      request.options.earlier = this->Design->colours;
    }
    this->Design = this->Model->Design(request, update.rows, progress.Part(0.4, 0.95));
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
