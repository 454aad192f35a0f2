#include "LayoutConversion.h"

#include "ColumnWriting.h"
#include "HolonomyConversion.h"
#include "Index.h"
#include "QuadAdvice.h"
#include "QuadQuality.h"
#include "QuadReport.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace names = vtkCrossFieldArrayNames;

namespace
{
/** Returns for example "2 nodes moved by up to 0.21 from their handles."; empty if none moved. */
std::string DescribeMoves(const crossfield::NodePositions& nodes)
{
  const std::size_t count = nodes.events.size();
  if (count == 0)
  {
    return {};
  }
  std::ostringstream text;
  text << std::setprecision(2) << (count == 1 ? "One node" : std::to_string(count) + " nodes")
       << " moved by " << (count == 1 ? "" : "up to ") << nodes.moved << " from "
       << (count == 1 ? "its handle." : "their handles.");
  return text.str();
}

/** Returns a warning of inverted or nearly degenerate quads; empty if there are none. */
std::string DescribeBadQuads(const crossfield::LayoutDesign& design)
{
  if (!design.quads)
  {
    return {};
  }
  const crossfield::QuadQuality& quality = design.quads->quality;
  return quality.inverted > 0
    ? crossfield::CountInverted(quality) + "; move singularities nearby, or use smaller quads."
    : crossfield::DescribeWorstQuad(design.quads->mesh, quality);
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
void AddColours(
  const std::vector<crossfield::PatchColour>& colours, bool stale, vtkPolyData* patches)
{
  const auto* ids = vtkIntArray::SafeDownCast(patches->GetCellData()->GetArray(names::FaceId));
  std::vector<int> cells;
  for (vtkIdType i = 0; ids != nullptr && i < ids->GetNumberOfTuples(); ++i)
  {
    cells.push_back(stale ? -1 : colours[crossfield::Index(ids->GetValue(i))].colour);
  }
  ColumnWriting::AddIntegers(patches->GetCellData(), names::Colour, cells);
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
    text << design->layouts.Single().tMesh.patches.size() << " patches";
  }
  const bool isThin = design->shortestArc < 0.5 * report.quadSize;
  if (std::isfinite(design->energy.energy))
  {
    text << std::fixed << std::setprecision(2) << "; energy W " << design->energy.energy
         << (isThin ? "" : " (lower is better)"); // lower may make thin blocks
  }
  text << ".";
  if (report.canSnap && isThin)
  {
    text << " Two separatrices nearly coincide"
         << (report.isSnapped ? ", which Snap cannot join within its tolerance: try Merge."
                              : ": try Snap.");
  }
  const std::string moves = DescribeMoves(design->nodes);
  text << (moves.empty() ? "" : " ") << moves;
  if (const auto& flattening = design->layouts.Single().map.flattening)
  {
    const std::string stretch = crossfield::DescribeStretch(*flattening);
    text << (stretch.empty() ? "" : " ") << stretch;
  }
  const std::string warning = DescribeBadQuads(*design);
  text << (warning.empty() || report.isDraft ? "" : " " + warning);
  return text.str();
}

//------------------------------------------------------------------------------
bool ReportsProblem(const crossfield::LayoutDesign* design, const Report& report)
{
  return !report.refusal.empty() ||
    (design != nullptr && !report.isDraft && !DescribeBadQuads(*design).empty());
}

//------------------------------------------------------------------------------
void AddReport(const crossfield::LayoutDesign* design, const Report& report, vtkFieldData* data)
{
  const bool shown = report.refusal.empty();
  ColumnWriting::AddIntegers(data, names::Stale, { shown ? 0 : 1 });
  ColumnWriting::AddText(data, names::Reason, shown ? design->reason : report.refusal);
  ColumnWriting::AddText(data, names::Summary, Summary(design, report));
  if (design == nullptr)
  {
    return;
  }
  const crossfield::Layout& layout = design->layouts.Single();
  if (std::isfinite(design->energy.energy))
  {
    ColumnWriting::AddNumbers(data, names::RenormalizedEnergy, { design->energy.energy });
  }
  ColumnWriting::AddIntegers(data, names::Faces, { static_cast<int>(layout.tMesh.patches.size()) });
  ColumnWriting::AddNumbers(data, names::ShortestArc, { design->shortestArc / report.quadSize });
  HolonomyConversion::WriteStretch(layout.map.flattening, data);
  ColumnWriting::AddIntegers(
    data, names::MovedNodes, { static_cast<int>(design->nodes.events.size()) });
  ColumnWriting::AddNumbers(data, names::Moved, { design->nodes.moved });
  if (design->quads)
  {
    ColumnWriting::AddNumbers(
      data, names::MinimumAngle, { 180.0 / crossfield::Pi * design->quads->quality.minimumAngle });
  }
}
}
