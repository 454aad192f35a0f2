#include "ProposalConversion.h"

#include "ColumnWriting.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkPointData.h"
#include "vtkTable.h"

namespace
{
namespace names = vtkCrossFieldArrayNames;
using ColumnWriting::AddColumn;
using crossfield::ProposedConfiguration;

/** A singularity or a chosen corner with the number of its proposal. */
struct PointRow
{
  crossfield::Point position;
  int alternative;
  int quarterIndex;
};
}

namespace ProposalConversion
{
//------------------------------------------------------------------------------
void WriteTable(
  const std::vector<ProposedConfiguration>& proposals, double coreRadius, vtkTable* output)
{
  vtkFieldData* data = output->GetRowData();
  int number = 0;
  AddColumn<vtkIntArray>(data, names::Alternative, proposals,
    [&number](const ProposedConfiguration&) { return number++; });
  AddColumn<vtkStringArray>(data, names::Origin, proposals,
    [](const ProposedConfiguration& proposal) { return proposal.origin; });
  AddColumn<vtkIntArray>(data, names::Singularities, proposals,
    [](const ProposedConfiguration& proposal)
    { return static_cast<int>(proposal.singularities.size()); });
  const auto add = [&](const char* name, auto value)
  { AddColumn<vtkDoubleArray>(data, name, proposals, value); };
  using Proposal = ProposedConfiguration;
  add(names::LogarithmCoefficient, [](const Proposal& p) { return p.logarithmCoefficient; });
  add(names::RenormalizedEnergy, [](const Proposal& p) { return p.renormalized; });
  add(names::CoreRadius, [coreRadius](const Proposal&) { return coreRadius; });
  add(names::EnergyAtCoreRadius, [](const Proposal& p) { return p.energy; });
  add(names::HolonomyDefect, [](const Proposal& p) { return p.holonomyDefect; });
  add(names::SizeSpread, [](const Proposal& p) { return p.sizeSpread; });
}

//------------------------------------------------------------------------------
void WritePoints(const std::vector<ProposedConfiguration>& proposals,
  const crossfield::DomainPlane& plane, vtkPolyData* output)
{
  std::vector<PointRow> rows;
  int number = 0;
  for (const ProposedConfiguration& proposal : proposals)
  {
    for (const crossfield::Singularity& singularity : proposal.singularities)
    {
      rows.push_back({ singularity.position, number, singularity.quarterIndex });
    }
    for (const crossfield::CornerChoice& corner : proposal.corners)
    {
      rows.push_back({ corner.position, number, corner.quarterIndex });
    }
    ++number;
  }
  ColumnWriting::WritePlaces(rows, plane, output);
  AddColumn<vtkIntArray>(output->GetPointData(), names::Alternative, rows,
    [](const PointRow& row) { return row.alternative; });
  AddColumn<vtkIntArray>(output->GetPointData(), names::QuarterIndex, rows,
    [](const PointRow& row) { return row.quarterIndex; });
}
}
