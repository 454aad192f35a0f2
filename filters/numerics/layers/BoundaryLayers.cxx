#include "BoundaryLayers.h"

#include "BandDivision.h"
#include "BandLines.h"
#include "Error.h"
#include "LayerRows.h"
#include "NodePairs.h"
#include "QuadSymmetry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace crossfield
{
namespace
{
/// Ratio of neighbouring heights behind a layer up to which fewer rows than RowsToReplace suffice.
constexpr double AcceptedStep = 2.25;
/// Part of the smallest step by which a step of fewer rows may be larger.
constexpr double SimilarStep = 1.05;

std::string CountRows(int rows)
{
  return std::to_string(rows) + (rows == 1 ? " row" : " rows");
}

/// The rows of a band that are replaced, and those that replace them.
struct BandPlan
{
  int rowsReplaced = 0;
  int rows = 0; ///< 0: as many as the growth needs.
  bool isDivided = true;
  std::string lack; ///< As in LayerReport.
};

class Layerer
{
public:
  Layerer(LayeredMesh& layered, const BoundaryCurves& curves, double quadSize, bool takesFewRows)
    : Layered(layered)
    , Curves(curves)
    , QuadSize(quadSize)
    , TakesFewRows(takesFewRows)
  {
  }

  /// Finds the bands and the rows of them that are replaced.
  void Plan()
  {
    const QuadWalk walk(this->Layered.mesh);
    const std::vector<QuadBand> bands = FindBands(this->Layered, walk, this->MaximumRows());
    const std::vector<int> walls = walk.OfBoundary();
    this->Layered.bands.assign(walls.size(), -1);
    for (std::size_t b = 0; b < bands.size(); ++b)
    {
      for (std::size_t e = 0; e < walls.size(); ++e)
      {
        const std::vector<int>& row = bands[b].rows[0];
        if (this->Layered.LayerAt(e) >= 0 &&
          std::find(row.begin(), row.end(), walls[e]) != row.end())
        {
          this->Layered.bands[e] = static_cast<int>(b);
        }
      }
      this->Plans.push_back(this->PlanBand(bands[b], walk));
    }
  }

  /// Divides one band after the other, then those behind the lines that their rows follow beyond
  /// sides.
  void Divide()
  {
    for (std::size_t b = 0; b < this->Plans.size(); ++b)
    {
      if (!this->Plans[b].isDivided)
      {
        continue;
      }
      const QuadWalk walk(this->Layered.mesh);
      const QuadBand band =
        FindBand(this->Layered, walk, this->EdgeOf(b), this->Plans[b].rowsReplaced);
      this->DivideOne(band, walk, this->Plans[b]);
    }
    // Each band has two ends.
    for (std::size_t i = 0; i < 2 * this->Plans.size(); ++i)
    {
      const QuadWalk walk(this->Layered.mesh);
      std::vector<DividedBand> divided;
      for (std::size_t b = 0; b < this->Plans.size(); ++b)
      {
        divided.push_back({ this->EdgeOf(b), this->Plans[b].rows });
      }
      const auto find = [&](int maximumRows)
      { return FindBandBehind(this->Layered, walk, divided, maximumRows, AcceptedStep); };
      const std::optional<QuadBand> band = find(this->MaximumRows());
      if (!band)
      {
        break;
      }
      BandPlan plan;
      plan.rowsReplaced = this->BestRows(this->StepsOf(*band, walk));
      this->DivideOne(*find(plan.rowsReplaced), walk, plan);
    }
  }

  std::vector<LayerReport> Measure() const
  {
    std::vector<int> rows;
    for (const int band : this->Layered.bands)
    {
      rows.push_back(band < 0 ? 0 : this->Plans[band].rows);
    }
    std::vector<LayerReport> reports = MeasureLayers(this->Layered, rows);
    for (std::size_t e = 0; e < rows.size(); ++e)
    {
      if (this->Layered.bands[e] >= 0)
      {
        LayerReport& report = reports[this->Layered.LayerAt(e)];
        const BandPlan& plan = this->Plans[this->Layered.bands[e]];
        report.rowsReplaced = std::max(report.rowsReplaced, plan.rowsReplaced);
        report.lack = plan.lack.empty() ? report.lack : plan.lack;
      }
    }
    return reports;
  }

private:
  /// Returns an edge of mesh.boundary at a band.
  std::size_t EdgeOf(std::size_t band) const
  {
    const std::vector<int>& bands = this->Layered.bands;
    return static_cast<std::size_t>(
      std::find(bands.begin(), bands.end(), static_cast<int>(band)) - bands.begin());
  }

  int MaximumRows() const
  {
    int rows = 1;
    for (const LayerPrescription& prescription : this->Layered.prescriptions)
    {
      rows = std::max({ rows, 2 * RowsToReplace(prescription.growth), RowsBeside(prescription) });
    }
    return rows;
  }

  /// Divides a band as planned.
  void DivideOne(const QuadBand& band, const QuadWalk& walk, BandPlan& plan)
  {
    const BandLines lines(this->Layered, band, walk, this->Curves, plan.rowsReplaced);
    const bool isPrescribed = plan.rows > 0;
    plan.rows = isPrescribed ? plan.rows : lines.RowsNeeded();
    std::vector<std::vector<QuadPoint>> points = lines.Divide(plan.rows);
    // Chords of a curved line may grow slightly faster than its lengths.
    constexpr int MoreRows = 5;
    constexpr double Rounding = 1e-9;
    for (int more = 0; !isPrescribed && more < MoreRows &&
         lines.LargestGrowth(points) > band.growth * (1.0 + Rounding);
         ++more)
    {
      points = lines.Divide(++plan.rows);
    }
    DivideBand(this->Layered, band, walk, points);
  }

  /// Returns the largest step of heights behind 1, 2, ... rows of a band that are replaced.
  std::vector<double> StepsOf(const QuadBand& band, const QuadWalk& walk) const
  {
    std::vector<double> steps;
    for (int rows = 1; rows <= static_cast<int>(band.rows.size()); ++rows)
    {
      const BandLines lines(this->Layered, band, walk, this->Curves, rows);
      steps.push_back(lines.LargestStep(lines.RowsNeeded()));
    }
    return steps;
  }

  /// Returns the smallest number of rows whose step is about the smallest.
  static int BestRows(const std::vector<double>& steps)
  {
    const double best = *std::min_element(steps.begin(), steps.end());
    const auto similar = std::find_if(
      steps.begin(), steps.end(), [&](double step) { return step <= SimilarStep * best; });
    return static_cast<int>(similar - steps.begin()) + 1;
  }

  /// Returns the prescription of the first layered side of a band.
  const LayerPrescription& PrescriptionOf(const QuadBand& band) const
  {
    const auto found =
      std::find_if(band.layers.begin(), band.layers.end(), [](int layer) { return layer >= 0; });
    return this->Layered.prescriptions[*found];
  }

  BandPlan PlanBand(const QuadBand& band, const QuadWalk& walk) const
  {
    int rows = 0;
    for (const int layer : band.layers)
    {
      const int prescribed = layer < 0 ? 0 : this->Layered.prescriptions[layer].rows;
      if (prescribed > 0 && rows > 0 && prescribed != rows)
      {
        throw Error("The sides '" + this->PrescriptionOf(band).name + "' and '" +
          this->Layered.prescriptions[layer].name +
          "' share the rows of their layers, but have different numbers of them; give equal "
          "numbers, or end the rows at the corner between them.");
      }
      rows = std::max(rows, prescribed);
    }
    const bool isDivided = std::any_of(band.layers.begin(), band.layers.end(),
      [this](int layer) { return layer >= 0 && this->Layered.prescriptions[layer].first; });
    if (!isDivided)
    {
      return this->PlanOfQuads(band, walk);
    }
    BandPlan plan =
      rows > 0 ? this->PlanForRows(band, walk, rows) : this->PlanForGrowth(band, walk);
    const BandLines lines(this->Layered, band, walk, this->Curves, plan.rowsReplaced);
    this->RequireThinRows(band, lines, plan.rowsReplaced);
    return plan;
  }

  /// Throws Error if the first height of a layer is not below that of the rows that it replaces.
  void RequireThinRows(const QuadBand& band, const BandLines& lines, int rowsReplaced) const
  {
    for (const BandLine& line : lines.Lines())
    {
      if (line.hasFirst && line.first * rowsReplaced >= line.length)
      {
        const LayerPrescription& prescription = this->PrescriptionOf(band);
        // Normal to the wall, as the first height is.
        const double first = prescription.first.value_or(0.0);
        const double height = line.length / rowsReplaced * first / line.first;
        throw Error("The first height " + FormatNumber(first, 2) + " of the layer of '" +
          prescription.name + "' is not below the height " + FormatNumber(height, 2) +
          " of the quads beside it; give a smaller height, or larger quads.");
      }
    }
  }

  /// Returns a plan whose rows are those of the quads.
  BandPlan PlanOfQuads(const QuadBand& band, const QuadWalk& walk) const
  {
    int needed = 1;
    for (const int layer : band.layers)
    {
      needed = std::max(needed, layer < 0 ? 1 : RowsBeside(this->Layered.prescriptions[layer]));
    }
    BandPlan plan;
    plan.isDivided = false;
    plan.rowsReplaced = std::min(needed, static_cast<int>(band.rows.size()));
    plan.rows = plan.rowsReplaced;
    if (plan.rows < needed)
    {
      plan.lack = this->AcceptLack(band, walk, needed);
    }
    return plan;
  }

  /// Throws the error for a band with too few rows, unless it may have them; then returns its
  /// cause.
  std::string AcceptLack(const QuadBand& band, const QuadWalk& walk, int needed) const
  {
    const Error error = this->LackOf(band, walk, needed);
    if (!this->TakesFewRows || error.GetKind() != Error::Kind::LackOfRows)
    {
      throw Error(error);
    }
    return error.GetCause();
  }

  /// Returns the smallest number of rows behind which the step of heights is about the smallest.
  BandPlan PlanForGrowth(const QuadBand& band, const QuadWalk& walk) const
  {
    BandPlan plan;
    const std::vector<double> steps = this->StepsOf(band, walk);
    plan.rowsReplaced = BestRows(steps);
    const double best = *std::min_element(steps.begin(), steps.end());
    const auto available = static_cast<int>(band.rows.size());
    const int needed = RowsToReplace(band.growth);
    if (best > AcceptedStep && available < needed)
    {
      plan.lack = this->AcceptLack(band, walk, needed);
    }
    return plan;
  }

  /// Returns the largest number of rows that a prescribed number of rows can replace.
  BandPlan PlanForRows(const QuadBand& band, const QuadWalk& walk, int rows) const
  {
    BandPlan plan;
    plan.rows = rows;
    int needed = 0;
    for (int replaced = 1; replaced <= static_cast<int>(band.rows.size()); ++replaced)
    {
      const BandLines lines(this->Layered, band, walk, this->Curves, replaced);
      needed = lines.RowsNeeded();
      if (needed > rows)
      {
        break;
      }
      plan.rowsReplaced = replaced;
    }
    const LayerPrescription& prescription = this->PrescriptionOf(band);
    if (plan.rowsReplaced == 0)
    {
      throw Error("The layer of '" + prescription.name + "' needs " + CountRows(needed) +
        " to grow from " + FormatNumber(prescription.first.value_or(0.0), 2) +
        " to the quads beside it, but " + std::to_string(rows) +
        " are prescribed; give more rows, a larger growth, or smaller quads.");
    }
    const BandLines lines(this->Layered, band, walk, this->Curves, plan.rowsReplaced);
    for (const BandLine& line : lines.Lines())
    {
      if (line.hasFirst && rows * line.first > line.length)
      {
        throw Error("The " + CountRows(rows) + " of the layer of '" + prescription.name +
          "' are at least " + FormatNumber(rows * line.first, 2) + " thick, but only " +
          FormatNumber(line.length, 2) + " beside it can be divided; give fewer rows.");
      }
    }
    return plan;
  }

  /// Returns the line at a layered side whose point at the wall is nearest to a place.
  static std::size_t NearestLine(const BandLines& lines, const Point& place)
  {
    std::size_t nearest = 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t line = 0; line < lines.Lines().size(); ++line)
    {
      const double distance = (place - lines.WallAt(line)).norm();
      if (lines.Lines()[line].isLayered && distance < smallest)
      {
        smallest = distance;
        nearest = line;
      }
    }
    return nearest;
  }

  static double DistanceFromWall(const BandLines& lines, const Point& place)
  {
    return (place - lines.WallAt(NearestLine(lines, place))).norm();
  }

  /// Returns the error for a band with too few rows.
  Error LackOf(const QuadBand& band, const QuadWalk& walk, int needed) const
  {
    const auto available = static_cast<int>(band.rows.size());
    const std::string& name = this->PrescriptionOf(band).name;
    const std::string start = "Only " + CountRows(available) + " beside '" + name + "' " +
      (available == 1 ? "is" : "are") + " free of ";
    const std::string place =
      " near " + Describe(band.place) + ", " + std::to_string(needed) + " are needed";
    switch (band.end)
    {
    case BandEnd::Irregular:
    {
      const BandLines lines(this->Layered, band, walk, this->Curves, available);
      const std::size_t nearest = NearestLine(lines, band.place);
      const double height = std::max(lines.Lines()[nearest].length / available, this->QuadSize);
      const double away = (needed - available) * height;
      double farthest = 0.0;
      for (const QuadPoint& point : this->Layered.mesh.points)
      {
        farthest = std::max(farthest, DistanceFromWall(lines, point.InPlane()));
      }
      const bool hasRoom = DistanceFromWall(lines, band.place) + away < farthest;
      return Error(start + "irregular nodes" + place,
        hasRoom ? "move the singularities " + FormatNumber(away, 2) + " away" : "",
        Error::Kind::LackOfRows);
    }
    case BandEnd::Boundary:
      return Error(
        start + "corners and ends of sides" + place, "use smaller quads", Error::Kind::BadInput);
    default:
      return Error(start + "rows of other layers" + place, "use smaller quads, or a larger growth",
        Error::Kind::BadInput);
    }
  }

  LayeredMesh& Layered;
  const BoundaryCurves& Curves;
  const double QuadSize; ///< As in QuadResult::size.
  const bool TakesFewRows;
  std::vector<BandPlan> Plans;
};
}

void RequireLayers(const std::vector<LayerPrescription>& layers,
  const std::vector<std::string>& sides, double extent)
{
  // Of heights: coordinates have 16 digits, and four are enough for the shape of a quad.
  constexpr double LeastPart = 1e-12;
  for (std::size_t i = 0; i < layers.size(); ++i)
  {
    const LayerPrescription& layer = layers[i];
    const std::string name = "The layer of '" + layer.name + "'";
    if (layer.first && (!(*layer.first > 0.0) || !std::isfinite(*layer.first)))
    {
      throw Error(name + " has a first height of " + FormatNumber(*layer.first, 2) +
        "; give a positive length.");
    }
    if (layer.first && *layer.first < LeastPart * extent)
    {
      throw Error(name + " has a first height of " + FormatNumber(*layer.first, 2) +
        ", below the digits of coordinates; give at least " + FormatNumber(LeastPart * extent, 2) +
        ".");
    }
    if (!(layer.growth >= 1.0 && layer.growth <= 3.0))
    {
      throw Error(name + " has a growth of " + FormatNumber(layer.growth, 2) +
        "; give a number from 1 to 3.");
    }
    if (layer.rows < 0)
    {
      throw Error(name + " has " + std::to_string(layer.rows) +
        " rows; give a positive number, or 0 for as many as the growth needs.");
    }
    RequireSide(sides, layer.name, " for a layer");
    for (std::size_t j = 0; j < i; ++j)
    {
      if (layers[j].name == layer.name)
      {
        throw Error("The side '" + layer.name + "' has two layers; give one of them.");
      }
    }
  }
}

int RowsBeside(const LayerPrescription& layer)
{
  return !layer.first && layer.rows > 0 ? layer.rows : RowsToReplace(layer.growth);
}

std::vector<LayerReport> AddLayers(const PlanarDomain& domain, const BoundaryCurves& curves,
  const std::vector<LayerPrescription>& prescriptions, bool takesFewRows, QuadResult& quads)
{
  RequireLayers(prescriptions, quads.mesh.sideNames, domain.Diagonal());
  LayeredMesh layered;
  layered.prescriptions = prescriptions;
  for (const std::string& name : quads.mesh.sideNames)
  {
    const auto found = std::find_if(prescriptions.begin(), prescriptions.end(),
      [&](const LayerPrescription& layer) { return layer.name == name; });
    layered.layerOfSide.push_back(
      found == prescriptions.end() ? -1 : static_cast<int>(found - prescriptions.begin()));
  }
  layered.regions.assign(quads.mesh.quads.size(), 0);
  layered.mesh = std::move(quads.mesh);
  Layerer layerer(layered, curves, quads.size, takesFewRows);
  layerer.Plan();
  layerer.Divide();
  FindPairs(curves, layered.mesh);
  MatchPairs(curves, layered.mesh);
  // Where bands cross, points depend slightly on which is divided first.
  MakeSymmetricAndPeriodic(layered.mesh, curves, domain, quads.smoothing);
  const std::vector<LayerReport> reports = layerer.Measure();
  quads.mesh = std::move(layered.mesh);
  quads.regions = std::move(layered.regions);
  quads.blocks = FindBlocks(quads.mesh, quads.regions);
  quads.quality = MeasureQuads(quads.mesh, quads.size);
  return reports;
}
}
