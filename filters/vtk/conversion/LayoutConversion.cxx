#include "LayoutConversion.h"

#include "ColumnWriting.h"
#include "HolonomyConversion.h"
#include "PoincareHopf.h"
#include "QuadReport.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkPolyData.h"

#include <iomanip>
#include <sstream>

namespace names = vtkCrossFieldArrayNames;

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
  if (design->quads)
  {
    text << QuadReport::DescribeQuads(*design->quads);
  }
  else
  {
    text << design->mesh.patches.size() << " patches";
  }
  text << std::fixed << std::setprecision(2) << "; energy W " << design->energy.energy
       << " (lower is better).";
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
  if (design->quads)
  {
    ColumnWriting::AddNumbers(
      data, names::MinimumAngle, { 180.0 / crossfield::Pi * design->quads->quality.minimumAngle });
  }
}
}
