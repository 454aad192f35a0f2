#include "LayoutConversion.h"

#include "ColumnWriting.h"
#include "HolonomyConversion.h"
#include "PoincareHopf.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkPolyData.h"

#include <iomanip>
#include <optional>
#include <sstream>

namespace names = vtkCrossFieldArrayNames;

namespace
{
/** Returns the minimum angle of the quads in degrees; nothing without quads. */
std::optional<double> MinimumAngle(const crossfield::LayoutDesign& design)
{
  return design.quads ? std::optional<double>(90.0 * design.quads->quality.eta.min) : std::nullopt;
}
}

namespace LayoutConversion
{
//------------------------------------------------------------------------------
void AddShade(bool stale, vtkPolyData* lines)
{
  vtkDataArray* quarters = lines->GetCellData()->GetArray(names::QuarterIndex);
  std::vector<int> shades;
  for (vtkIdType i = 0; quarters != nullptr && i < quarters->GetNumberOfTuples(); ++i)
  {
    const double quarterIndex = stale ? 0.0 : quarters->GetComponent(i, 0);
    shades.push_back((quarterIndex > 0.0 ? 1 : 0) - (quarterIndex < 0.0 ? 1 : 0));
  }
  ColumnWriting::AddIntegers(lines->GetCellData(), names::Shade, shades);
}

//------------------------------------------------------------------------------
std::string Summary(const crossfield::LayoutDesign* design, const Report& report)
{
  if (design == nullptr || !report.refusal.empty())
  {
    return report.refusal;
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(0);
  if (design->quads)
  {
    text << design->quads->mesh.quads.size() << " quads in " << design->quads->blocks.blocks.size()
         << " blocks; minimum angle " << *MinimumAngle(*design) << "°";
  }
  else
  {
    text << design->mesh.patches.size() << " patches";
  }
  text << std::setprecision(2) << "; energy W " << design->energy.energy << " (lower is better).";
  if (design->shortestArc < 0.5 * report.quadSize)
  {
    text << " Two separatrices nearly coincide: try Snap.";
  }
  if (design->map.flattening)
  {
    const std::string stretch = crossfield::DescribeStretch(*design->map.flattening);
    text << (stretch.empty() ? "" : " ") << stretch;
  }
  return text.str();
}

//------------------------------------------------------------------------------
void AddReport(const crossfield::LayoutDesign* design, const Report& report, vtkFieldData* data)
{
  const bool shown = report.refusal.empty();
  ColumnWriting::AddIntegers(data, names::Stale, { shown ? 0 : 1 });
  ColumnWriting::AddText(data, names::Reason,
    shown ? crossfield::ConsistencyReason(design->count, design->energy.holonomyDefect)
          : report.refusal);
  ColumnWriting::AddText(data, names::Summary, Summary(design, report));
  if (design == nullptr)
  {
    return;
  }
  ColumnWriting::AddNumbers(data, names::RenormalizedEnergy, { design->energy.energy });
  ColumnWriting::AddIntegers(data, names::Faces, { static_cast<int>(design->mesh.patches.size()) });
  ColumnWriting::AddNumbers(data, names::ShortestArc, { design->shortestArc / report.quadSize });
  HolonomyConversion::WriteStretch(design->map.flattening, data);
  if (const std::optional<double> angle = MinimumAngle(*design))
  {
    ColumnWriting::AddNumbers(data, names::MinimumAngle, { *angle });
  }
}
}
