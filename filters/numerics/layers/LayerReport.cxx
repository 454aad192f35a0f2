#include "LayerReport.h"

#include "Index.h"
#include "QuadWalk.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
/// Deviation from the prescribed height that counts as in bounds.
constexpr double HeightTolerance = 0.05;

class Measurer
{
public:
  Measurer(const LayeredMesh& layered, const QuadWalk& walk)
    : Layered(layered)
    , Walk(walk)
  {
  }

  Point Start(int side) const { return this->PlaceOf(this->Walk.StartOf(side)); }
  Point End(int side) const { return this->PlaceOf(this->Walk.EndOf(side)); }
  double Length(int side) const { return (this->End(side) - this->Start(side)).norm(); }

  /// Returns the mean distance of the opposite side of a quad from the line through a side.
  double HeightAcross(int side) const
  {
    const Point along = (this->End(side) - this->Start(side)).normalized();
    const int opposite = QuadWalk::Opposite(side);
    return 0.5 *
      (Cross(along, this->Start(opposite) - this->Start(side)) +
        Cross(along, this->End(opposite) - this->Start(side)));
  }

  /// Adds the ratios of the quads in the rows of a column to all of their neighbours: those of
  /// their heights above the common side.
  void AddRatios(int column, int rows, std::vector<double>& ratios) const
  {
    int side = column;
    for (int row = 0; row < rows && side >= 0; ++row, side = this->Walk.Above(side))
    {
      for (int corner = 0; corner < 4; ++corner)
      {
        const int own = side / 4 * 4 + corner;
        const int other = this->Walk.Twin(own);
        if (other >= 0)
        {
          const double ratio = this->Walk.Height(own) / this->Walk.Height(other);
          ratios.push_back(std::max(ratio, 1.0 / ratio));
        }
      }
    }
  }

private:
  Point PlaceOf(int point) const { return this->Layered.mesh.points[point].InPlane(); }

  const LayeredMesh& Layered;
  const QuadWalk& Walk;
};

/// Returns the smallest value that at most one of a hundred exceeds.
double Quantile99(std::vector<double> values)
{
  if (values.empty())
  {
    return 1.0;
  }
  const auto place = values.end() - 1 - static_cast<std::ptrdiff_t>(values.size() / 100);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}
}

std::vector<LayerReport> MeasureLayers(const LayeredMesh& layered, const std::vector<int>& rows)
{
  const QuadWalk walk(layered.mesh);
  const Measurer measurer(layered, walk);
  std::vector<LayerReport> reports;
  for (const LayerPrescription& prescription : layered.prescriptions)
  {
    LayerReport report;
    report.name = prescription.name;
    report.first = prescription.first.value_or(0.0);
    report.minimumHeight = std::numeric_limits<double>::infinity();
    reports.push_back(report);
  }
  std::vector<double> lengths(reports.size(), 0.0);
  std::vector<std::vector<double>> ratios(reports.size());
  std::vector<std::set<int>> columns(reports.size()); // whose ratios have been added
  const std::vector<int> walls = walk.OfBoundary();
  for (std::size_t e = 0; e < walls.size(); ++e)
  {
    if (layered.LayerAt(e) < 0)
    {
      continue;
    }
    const std::size_t layer = Index(layered.LayerAt(e));
    LayerReport& report = reports[layer];
    const double length = measurer.Length(walls[e]);
    const double first = measurer.HeightAcross(walls[e]);
    report.rows = std::max(report.rows, rows[e]);
    report.minimumHeight = std::min(report.minimumHeight, first);
    report.maximumHeight = std::max(report.maximumHeight, first);
    lengths[layer] += length;
    if (report.first == 0.0 || std::abs(first - report.first) <= HeightTolerance * report.first)
    {
      report.partInBounds += length;
    }
    double last = 0.0;
    int side = walls[e];
    for (int row = 0; row < rows[e] && side >= 0; ++row, side = walk.Above(side))
    {
      const double height = walk.Height(side);
      if (row > 0)
      {
        report.largestGrowth = std::max(report.largestGrowth, height / last);
      }
      report.meanThickness += length * height;
      last = height;
    }
    if (columns[layer].insert(walls[e]).second)
    {
      for (const int column : walk.RowThrough(walls[e]))
      {
        columns[layer].insert(column);
        measurer.AddRatios(column, rows[e], ratios[layer]);
      }
    }
  }
  for (std::size_t layer = 0; layer < reports.size(); ++layer)
  {
    reports[layer].partInBounds /= lengths[layer];
    reports[layer].meanThickness /= lengths[layer];
    for (const double ratio : ratios[layer])
    {
      reports[layer].largestRatio = std::max(reports[layer].largestRatio, ratio);
    }
    reports[layer].ratio99 = Quantile99(std::move(ratios[layer]));
  }
  return reports;
}
}
