#include "DesignInPlane.h"

#include "ConfigurationCheck.h"
#include "ConfigurationConversion.h"
#include "CornerConversion.h"
#include "LayoutSnap.h"
#include "PairPlacement.h"
#include "QuadClearance.h"
#include "RequestedSingularities.h"
#include "ResolvedRequest.h"

using crossfield::Configuration;

namespace
{
Configuration ConfigurationOf(const DesignModel::Rows& rows)
{
  Configuration configuration;
  for (const auto& [x, y, quarterIndex, radius] : rows)
  {
    configuration.push_back({ { x, y }, static_cast<int>(quarterIndex), radius });
  }
  return configuration;
}

DesignModel::Rows RowsOf(const Configuration& configuration)
{
  DesignModel::Rows rows;
  rows.reserve(configuration.size());
  for (const crossfield::Singularity& singularity : configuration)
  {
    rows.push_back({ singularity.position.x(), singularity.position.y(),
      static_cast<double>(singularity.quarterIndex), singularity.radius });
  }
  return rows;
}
}

//------------------------------------------------------------------------------
DesignInPlane::DesignInPlane(vtkDataSet* data)
  : DomainsPlane(this->Domain.Read(data).plane)
{
}

//------------------------------------------------------------------------------
DesignModel::Rows DesignInPlane::Read(vtkDataSet* singularities) const
{
  return RowsOf(ConfigurationConversion::ReadConfiguration(singularities, this->DomainsPlane));
}

//------------------------------------------------------------------------------
std::vector<crossfield::CornerChoice> DesignInPlane::ReadCorners(vtkDataSet* corners) const
{
  return CornerConversion::ReadCorners(corners, this->DomainsPlane);
}

//------------------------------------------------------------------------------
crossfield::SeamlessMapOptions DesignInPlane::MapOptions(const DesignRequest& request) const
{
  crossfield::SeamlessMapOptions options = request.options.map;
  if (this->Chosen)
  {
    options.corners = this->Chosen->corners;
  }
  return options;
}

//------------------------------------------------------------------------------
const crossfield::FactoredDomain& DesignInPlane::Factor(const DesignRequest& request,
  const Configuration& singularities, const crossfield::Progress& progress)
{
  const double meshSize = request.isDragging
    ? crossfield::LiveMeshSize(this->Domain.Get(), request.meshSize)
    : request.meshSize;
  return this->Domain.Factor(singularities, meshSize, progress);
}

//------------------------------------------------------------------------------
const DesignModel::Rows& DesignInPlane::Choose(
  const DesignRequest& request, const crossfield::Progress& progress)
{
  if (!this->Chosen)
  {
    crossfield::QuadRequest quads;
    quads.corners = request.options.map.corners;
    quads.capCorners = request.options.map.capCorners;
    quads.meshSize = request.meshSize;
    quads.quadSize = request.QuadSizeOn(this->Area());
    quads.sizing = crossfield::Sizing::Conformal; // as the quads of the design
    this->Chosen = crossfield::ChooseSingularities(
      this->Domain.Get(), crossfield::Resolve(this->Domain.Get(), quads), progress);
    this->ChosenRows = RowsOf(this->Chosen->singularities);
  }
  return this->ChosenRows;
}

//------------------------------------------------------------------------------
DesignModel::Rows DesignInPlane::Change(const DesignRequest& request, const Rows& rows,
  std::vector<std::string>& events, const crossfield::Progress& progress)
{
  Configuration singularities = ConfigurationOf(rows);
  const double quadSize = request.QuadSizeOn(this->Area());
  if (request.command == DesignCommand::Optimise)
  {
    crossfield::OptimizerOptions optimizer;
    optimizer.meshSize = request.meshSize;
    optimizer.corners = this->MapOptions(request).corners;
    optimizer.clearance = crossfield::ClearanceForQuads(quadSize);
    optimizer.keepAll = true; // every row keeps its handle
    const crossfield::OptimizerResult result =
      crossfield::OptimizeSingularities(this->Domain.Get(), singularities, optimizer, progress);
    singularities = result.configuration;
    events = result.events;
    events.push_back(result.reason);
  }
  else if (request.command == DesignCommand::Snap)
  {
    const double tolerance = request.snapTolerance > 0.0 ? request.snapTolerance : 0.5 * quadSize;
    const crossfield::LayoutSnap snap = crossfield::SnapLayout(this->Factor(request, singularities),
      singularities, this->MapOptions(request), tolerance, progress);
    singularities = snap.singularities;
    events.push_back(snap.event);
  }
  else
  {
    const auto places =
      crossfield::PositionsForPair(this->Factor(request, singularities), singularities);
    singularities.push_back({ places[0], 1 });
    singularities.push_back({ places[1], -1 });
  }
  return RowsOf(singularities);
}

//------------------------------------------------------------------------------
crossfield::LayoutDesign DesignInPlane::Design(
  const DesignRequest& request, const Rows& rows, const crossfield::Progress& progress)
{
  const Configuration singularities = ConfigurationOf(rows);
  crossfield::LayoutOptions options = request.options;
  options.map = this->MapOptions(request);
  return crossfield::DesignLayout(this->Factor(request, singularities, progress.Part(0.0, 0.35)),
    singularities, options, progress.Part(0.35, 1.0));
}

//------------------------------------------------------------------------------
int DesignInPlane::RequiredSum(const DesignRequest& request, const Rows& rows)
{
  const crossfield::SeamlessMapOptions options = this->MapOptions(request);
  crossfield::CheckOptions check;
  check.cap = options.capCorners;
  return crossfield::RequiredSum(this->Domain.Get(), ConfigurationOf(rows), options.corners, check);
}

//------------------------------------------------------------------------------
DesignModel::Rows DesignInPlane::NodesOf(const crossfield::LayoutDesign& design) const
{
  return RowsOf(design.nodes.singularities);
}

//------------------------------------------------------------------------------
void DesignInPlane::WriteSingularities(const Rows& rows, vtkPolyData* output) const
{
  ConfigurationConversion::WriteConfiguration(ConfigurationOf(rows), this->DomainsPlane, output);
}
