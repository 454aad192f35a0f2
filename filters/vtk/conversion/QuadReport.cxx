#include "QuadReport.h"

#include "ColumnWriting.h"
#include "QuadAdvice.h"
#include "SideConversion.h"
#include "vtkCrossFieldArrayNames.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <map>
#include <optional>
#include <sstream>

namespace names = vtkCrossFieldArrayNames;

namespace
{
using crossfield::QuadMesh;
using crossfield::QuadPoint;
using crossfield::QuadResult;

double Degrees(double radians)
{
  return 180.0 / crossfield::Pi * radians;
}

/** Numbers of irregular interior points by valence: obtained and requested. */
using IrregularCounts = std::map<int, std::array<int, 2>>;

IrregularCounts CountIrregular(const QuadMesh& mesh)
{
  IrregularCounts counts;
  for (const QuadPoint& point : mesh.points)
  {
    if (point.curve.loop < 0 && point.valence != 4)
    {
      ++counts[point.valence][0];
    }
    if (point.curve.loop < 0 && point.quarterIndex != 0)
    {
      ++counts[4 - point.quarterIndex][1];
    }
  }
  return counts;
}

void WriteIrregular(const IrregularCounts& counts, vtkFieldData* data)
{
  std::array<std::vector<int>, 3> columns;
  for (const auto& [valence, count] : counts)
  {
    columns[0].push_back(valence);
    columns[1].push_back(count[0]);
    columns[2].push_back(count[1]);
  }
  ColumnWriting::AddIntegers(data, names::IrregularValence, columns[0]);
  ColumnWriting::AddIntegers(data, names::IrregularObtained, columns[1]);
  ColumnWriting::AddIntegers(data, names::IrregularRequested, columns[2]);
}

/** Returns for example "irregular nodes: 4 of valence 3, 1 of valence 5". */
std::string DescribeIrregular(const QuadMesh& mesh)
{
  std::string text;
  for (const auto& [valence, count] : CountIrregular(mesh))
  {
    if (count[0] > 0)
    {
      text += (text.empty() ? "irregular nodes: " : ", ") + std::to_string(count[0]) +
        " of valence " + std::to_string(valence);
    }
  }
  return text.empty() ? "no irregular nodes" : text;
}

/** Returns a name without the number at its end, and this number; −1 without one. */
std::pair<std::string, int> SplitNumber(const std::string& name)
{
  const std::size_t end = name.find_last_not_of("0123456789") + 1; // 0 after npos
  const bool hasNumber = end > 0 && end < name.size() && name.size() - end < 6;
  return hasNumber ? std::pair(name.substr(0, end), std::stoi(name.substr(end)))
                   : std::pair(name, -1);
}

/** Returns for example "Sides: inlet, outer0 to outer3."; empty without names. */
std::string DescribeSides(const std::vector<std::string>& sides)
{
  constexpr std::size_t Listed = 12;
  std::vector<std::string> groups;
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const auto [stem, number] = SplitNumber(sides[i]);
    std::size_t last = i;
    while (number >= 0 && last + 1 < sides.size() &&
      SplitNumber(sides[last + 1]) == std::pair(stem, number + static_cast<int>(last + 1 - i)))
    {
      ++last;
    }
    groups.push_back(last > i ? sides[i] + " to " + sides[last] : sides[i]);
    i = last;
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(groups.size(), Listed); ++i)
  {
    text += (text.empty() ? "Sides: " : ", ") + groups[i];
  }
  return text +
    (groups.empty()              ? ""
        : groups.size() > Listed ? " and " + std::to_string(groups.size() - Listed) + " more."
                                 : ".");
}
}

namespace QuadReport
{
//------------------------------------------------------------------------------
void Write(const QuadResult& result, const crossfield::DomainPlane& plane, vtkFieldData* data)
{
  const auto addCount = [data](const char* name, std::size_t value)
  { ColumnWriting::AddIntegers(data, name, { static_cast<int>(value) }); };
  const auto addFlag = [data](const char* name, bool value)
  { ColumnWriting::AddIntegers(data, name, { value ? 1 : 0 }); };
  const crossfield::QuadQuality& quality = result.quality;
  addCount(names::Quads, result.mesh.quads.size());
  addCount(names::Blocks, result.blocks.blocks.size());
  WriteIrregular(CountIrregular(result.mesh), data);
  ColumnWriting::AddNumbers(
    data, names::ScaledJacobianRange, { quality.jacobian.min, quality.jacobian.mean });
  ColumnWriting::AddNumbers(data, names::ScaledJacobianBound, { quality.bound });
  if (quality.surface)
  {
    ColumnWriting::AddNumbers(
      data, names::ScaledJacobianBySurface, { quality.surface->minimumJacobian });
    ColumnWriting::AddNumbers(data, names::SurfaceDistance,
      { quality.surface->meanDistance, quality.surface->maximumDistance });
  }
  ColumnWriting::AddNumbers(data, names::MinimumAngle, { Degrees(quality.minimumAngle) });
  ColumnWriting::AddNumbers(data, names::EtaRange, { quality.eta.min, quality.eta.mean });
  ColumnWriting::AddNumbers(
    data, names::SizeRange, { quality.size.min, quality.size.mean, quality.size.max });
  ColumnWriting::AddNumbers(data, names::SizeVariation, { quality.variation });
  ColumnWriting::AddNumbers(data, names::Size, { result.size });
  ColumnWriting::AddIntegers(data, names::Symmetries, { result.smoothing.symmetries });
  ColumnWriting::AddIntegers(data, names::ZeroArcs, { result.counts.ZeroArcs() });
  addCount(names::IntegerVariables, result.counts.counts.size());
  ColumnWriting::AddNumbers(data, names::IntegerGap, { result.counts.Gap() });
  addFlag(names::IntegerOptimal, result.counts.optimal);
  ColumnWriting::AddIntegers(data, names::Inverted, { quality.inverted });
  const Eigen::Vector3d where = plane.PlaceToSpace(quality.where);
  ColumnWriting::AddNumbers(data, names::InvertedPlace, { where.x(), where.y(), where.z() });
  addFlag(names::Released, result.smoothing.released);
  SideConversion::WriteReport(result.mesh, data);
}

//------------------------------------------------------------------------------
void WriteBlockCounts(const crossfield::BlockCounts& counts, vtkFieldData* data)
{
  const auto add = [data](const char* name, const std::optional<int>& count)
  {
    if (count)
    {
      ColumnWriting::AddIntegers(data, name, { *count });
    }
  };
  add(names::BlocksUnmerged, counts.none);
  add(names::BlocksClean, counts.clean);
  add(names::BlocksCoarse, counts.coarse);
}

//------------------------------------------------------------------------------
void WriteLayers(const std::vector<crossfield::LayerReport>& layers, vtkFieldData* data)
{
  if (layers.empty())
  {
    return;
  }
  using Report = crossfield::LayerReport;
  const auto addNumbers = [&](const char* name, double Report::*value)
  {
    ColumnWriting::AddColumn<vtkDoubleArray>(
      data, name, layers, [value](const Report& layer) { return layer.*value; });
  };
  const auto addIntegers = [&](const char* name, int Report::*value)
  {
    ColumnWriting::AddColumn<vtkIntArray>(
      data, name, layers, [value](const Report& layer) { return layer.*value; });
  };
  ColumnWriting::AddColumn<vtkStringArray>(
    data, names::LayerSide, layers, [](const Report& layer) { return layer.name; });
  addIntegers(names::LayerReplaced, &Report::rowsReplaced);
  addIntegers(names::LayerRows, &Report::rows);
  addNumbers(names::LayerFirst, &Report::first);
  addNumbers(names::LayerThickness, &Report::meanThickness);
  addNumbers(names::LayerInBounds, &Report::partInBounds);
  addNumbers(names::LayerGrowth, &Report::largestGrowth);
  addNumbers(names::LayerRatio, &Report::largestRatio);
  addNumbers(names::LayerRatio99, &Report::ratio99);
  auto range = ColumnWriting::NewArray<vtkDoubleArray>(
    data, names::LayerHeightRange, 2, static_cast<vtkIdType>(layers.size()));
  for (std::size_t i = 0; i < layers.size(); ++i)
  {
    const double heights[] = { layers[i].minimumHeight, layers[i].maximumHeight };
    range->SetTypedTuple(static_cast<vtkIdType>(i), heights);
  }
}

//------------------------------------------------------------------------------
void WriteCurves(const crossfield::QuadWorkflowResult& result, vtkFieldData* data)
{
  if (result.curves.empty())
  {
    return;
  }
  using Report = crossfield::CurveReport;
  ColumnWriting::AddColumn<vtkStringArray>(data, names::CurveSides, result.curves,
    [&result](const Report& curve)
    {
      std::string text;
      for (const int side : curve.sides)
      {
        text += (text.empty() ? "" : ",") + result.quads.mesh.sideNames[side];
      }
      return text;
    });
  ColumnWriting::AddColumn<vtkIntArray>(
    data, names::CurveEdges, result.curves, [](const Report& curve) { return curve.edges; });
  ColumnWriting::AddColumn<vtkDoubleArray>(
    data, names::CurveMoved, result.curves, [](const Report& curve) { return curve.moved; });
}

//------------------------------------------------------------------------------
void WriteAlternatives(const std::vector<crossfield::Alternative>& alternatives, vtkFieldData* data)
{
  if (alternatives.size() < 2)
  {
    return;
  }
  using Mesh = crossfield::Alternative;
  ColumnWriting::AddColumn<vtkIntArray>(
    data, names::AlternativeNodes, alternatives, [](const Mesh& mesh) { return mesh.nodes; });
  ColumnWriting::AddColumn<vtkIntArray>(
    data, names::AlternativeBlocks, alternatives, [](const Mesh& mesh) { return mesh.blocks; });
  ColumnWriting::AddColumn<vtkDoubleArray>(data, names::AlternativeScaledJacobian, alternatives,
    [](const Mesh& mesh) { return mesh.scaledJacobian; });
  ColumnWriting::AddColumn<vtkDoubleArray>(data, names::AlternativeSizeVariation, alternatives,
    [](const Mesh& mesh) { return mesh.sizeVariation; });
}

//------------------------------------------------------------------------------
void WriteSizes(const std::optional<crossfield::SizeReport>& sizes, vtkFieldData* data)
{
  if (!sizes)
  {
    return;
  }
  using Set = crossfield::SizeReport::Set;
  ColumnWriting::AddNumbers(data, names::SizeTargetAreaShare, { sizes->AreaShare() });
  ColumnWriting::AddNumbers(data, names::SizeTargetQuadShare, { sizes->QuadShare() });
  ColumnWriting::AddNumbers(data, names::SizeTargetFineMedian, { sizes->FineMedian() });
  ColumnWriting::AddNumbers(data, names::SizeTargetLargestJump, { sizes->largestJump });
  ColumnWriting::AddIntegers(data, names::SizeTargetNodesAdded, { sizes->nodesAdded });
  ColumnWriting::AddNumbers(data, names::SizeTargetFactor, { sizes->factor });
  ColumnWriting::AddColumn<vtkStringArray>(
    data, names::SizeTargetSideName, sizes->sets, [](const Set& set) { return set.name; });
  ColumnWriting::AddColumn<vtkDoubleArray>(
    data, names::SizeTargetSideMedian, sizes->sets, [](const Set& set) { return set.Median(); });
}

//------------------------------------------------------------------------------
void WriteAttempts(const std::vector<crossfield::AttemptReport>& attempts, vtkFieldData* data)
{
  vtkNew<vtkStringArray> texts;
  texts->SetName(names::Attempts);
  texts->SetNumberOfComponents(2);
  for (const crossfield::AttemptReport& attempt : attempts)
  {
    texts->InsertNextValue(attempt.what);
    texts->InsertNextValue(attempt.outcome);
  }
  data->AddArray(texts);
}

//------------------------------------------------------------------------------
void WriteMoves(const crossfield::QuadWorkflowResult& result, const crossfield::DomainPlane& plane,
  vtkFieldData* data)
{
  if (!result.moves)
  {
    return;
  }
  using Move = crossfield::SingularityMove;
  ColumnWriting::AddColumn<vtkIntArray>(data, names::MoveSingularity, *result.moves,
    [](const Move& move) { return static_cast<int>(move.row) + 1; });
  const auto addPlaces = [&](const char* name, crossfield::Point Move::*place)
  {
    auto places = ColumnWriting::NewArray<vtkDoubleArray>(
      data, name, 3, static_cast<vtkIdType>(result.moves->size()));
    for (std::size_t i = 0; i < result.moves->size(); ++i)
    {
      places->SetTypedTuple(
        static_cast<vtkIdType>(i), plane.ToSpace((*result.moves)[i].*place).data());
    }
  };
  addPlaces(names::MoveFrom, &Move::from);
  addPlaces(names::MoveTo, &Move::to);
  ColumnWriting::AddColumn<vtkDoubleArray>(
    data, names::MoveDistance, *result.moves, [](const Move& move) { return move.Distance(); });
}

//------------------------------------------------------------------------------
std::string DescribeQuads(const QuadResult& result)
{
  std::ostringstream text;
  text << result.mesh.quads.size() << " quads in " << result.blocks.blocks.size()
       << (result.blocks.blocks.size() == 1 ? " block" : " blocks") << "; minimum angle "
       << std::fixed << std::setprecision(0) << Degrees(result.quality.minimumAngle) << "°";
  return text.str();
}

//------------------------------------------------------------------------------
std::string Summary(const crossfield::QuadWorkflowResult& result)
{
  const QuadResult& quads = result.quads;
  std::ostringstream text;
  if (result.PartCount() > 1)
  {
    text << result.PartCount() << " parts: ";
  }
  if (result.materials.size() > 1)
  {
    text << result.regions.size() << " regions of " << result.materials.size() << " materials: ";
  }
  else if (result.regions.size() > 1) // lines divide one material
  {
    text << result.regions.size() << " regions: ";
  }
  text << DescribeQuads(quads) << ", minimum scaled Jacobian " << std::fixed << std::setprecision(2)
       << quads.quality.jacobian.min << "; " << DescribeIrregular(quads.mesh) << ".";
  const std::string inverted =
    quads.quality.inverted > 0 ? crossfield::CountInverted(quads.quality) + "." : std::string();
  const std::string stretch =
    result.flattening ? crossfield::DescribeStretch(*result.flattening) : std::string();
  for (const std::string& sentence : { inverted, stretch })
  {
    const auto isRepeated = [&](const std::string& warning)
    { return warning.rfind(sentence.substr(0, sentence.size() - 1), 0) == 0; };
    if (!sentence.empty() &&
      std::none_of(result.warnings.begin(), result.warnings.end(), isRepeated))
    {
      text << " " << sentence;
    }
  }
  const char* separator = " Alternatives: ";
  for (std::size_t i = 0; i < result.alternatives.size() && result.alternatives.size() > 1; ++i)
  {
    const crossfield::Alternative& one = result.alternatives[i];
    text << separator << i << " has " << one.nodes << " nodes, " << one.blocks << " blocks, "
         << one.scaledJacobian;
    separator = "; ";
  }
  text << (result.alternatives.size() > 1 ? "." : "");
  if (!result.warnings.empty())
  {
    text << " " << result.warnings.front();
  }
  if (result.warnings.size() > 1) // all of them would cover the quads
  {
    text << " Further warnings in the report: " << result.warnings.size() - 1 << ".";
  }
  const std::string sides = DescribeSides(quads.mesh.sideNames);
  text << (sides.empty() ? "" : " ") << sides;
  return text.str();
}
}
