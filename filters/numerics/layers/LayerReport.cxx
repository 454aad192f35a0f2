#include "LayerReport.h"

#include "Index.h"
#include "QuadWalk.h"

#include <algorithm>
#include <limits>
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

  /// Returns the mean length of the sides of a quad next to a side.
  double Height(int side) const
  {
    return 0.5 * (this->Length(QuadWalk::Next(side)) + this->Length(QuadWalk::Previous(side)));
  }

private:
  Point PlaceOf(int point) const { return this->Layered.mesh.points[point].place; }

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
    report.first = prescription.first;
    report.minimumHeight = std::numeric_limits<double>::infinity();
    reports.push_back(report);
  }
  std::vector<double> lengths(reports.size(), 0.0);
  std::vector<std::vector<double>> ratios(reports.size());
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
    if (std::abs(first - report.first) <= HeightTolerance * report.first)
    {
      report.partInBounds += length;
    }
    double last = 0.0;
    int side = walls[e];
    for (int row = 0; row <= rows[e] && side >= 0; ++row, side = walk.Above(side))
    {
      const double height = measurer.Height(side);
      if (row > 0)
      {
        const double ratio = std::max(height / last, last / height);
        report.largestRatio = std::max(report.largestRatio, ratio);
        ratios[layer].push_back(ratio);
      }
      if (row > 0 && row < rows[e])
      {
        report.largestGrowth = std::max(report.largestGrowth, height / last);
      }
      report.meanThickness += row < rows[e] ? length * height : 0.0;
      last = height;
    }
  }
  for (std::size_t layer = 0; layer < reports.size(); ++layer)
  {
    reports[layer].partInBounds /= lengths[layer];
    reports[layer].meanThickness /= lengths[layer];
    reports[layer].ratio99 = Quantile99(std::move(ratios[layer]));
  }
  return reports;
}
}
