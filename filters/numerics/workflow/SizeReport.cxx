#include "SizeReport.h"

#include "Error.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
constexpr double Tolerance = 1.25;

bool IsMet(double ratio)
{
  return ratio < Tolerance && ratio > 1.0 / Tolerance;
}

/// Returns the area of a quad, at least 0: an inverted quad has no size.
double AreaOf(const QuadMesh& mesh, std::size_t quad)
{
  const auto at = [&](std::size_t corner) -> const SpacePoint&
  { return mesh.points[mesh.quads[quad][corner]].place; };
  const SpacePoint cross = (at(2) - at(0)).cross(at(3) - at(1));
  return std::max(0.0, 0.5 * (mesh.normals.empty() ? cross.z() : cross.dot(mesh.normals[quad])));
}

Point CentreOf(const QuadMesh& mesh, const std::array<int, 4>& quad)
{
  Point centre = Point::Zero();
  for (const int point : quad)
  {
    centre += 0.25 * mesh.points[point].InPlane();
  }
  return centre;
}

/// Returns whether points are on a side.
std::vector<bool> PointsOn(const QuadMesh& mesh, int side)
{
  std::vector<bool> isOn(mesh.points.size(), false);
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    if (edge.side == side)
    {
      isOn[static_cast<std::size_t>(edge.points[0])] = true;
      isOn[static_cast<std::size_t>(edge.points[1])] = true;
    }
  }
  return isOn;
}

double DistanceToNearest(const std::vector<Point>& points, const Point& place)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Point& point : points)
  {
    least = std::min(least, (point - place).norm());
  }
  return least;
}

/// Returns the largest ratio of the sizes of two quads with a common edge.
double LargestJump(const QuadMesh& mesh, const std::vector<int>& twins)
{
  double largest = 1.0;
  for (std::size_t side = 0; side < twins.size(); ++side)
  {
    if (twins[side] > static_cast<int>(side))
    {
      const double area = AreaOf(mesh, side / 4);
      const double other = AreaOf(mesh, static_cast<std::size_t>(twins[side]) / 4);
      if (area > 0.0 && other > 0.0)
      {
        largest = std::max(largest, std::sqrt(std::max(area / other, other / area)));
      }
    }
  }
  return largest;
}

double MedianOf(std::vector<double> values)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}
}

void SizeTargets::Multiply(double by)
{
  this->factor *= by;
  this->mean *= by;
  this->length = [given = this->length, by](const Point& place) { return by * given(place); };
}

double SizeReport::Sample::Ratio() const
{
  return std::sqrt(this->area) / this->target;
}

double SizeReport::Set::Median() const
{
  return MedianOf(this->ratios);
}

double SizeReport::AreaShare() const
{
  double met = 0.0;
  double all = 0.0;
  for (const Sample& sample : this->samples)
  {
    all += sample.area;
    met += IsMet(sample.Ratio()) ? sample.area : 0.0;
  }
  return all > 0.0 ? met / all : 0.0;
}

double SizeReport::QuadShare() const
{
  const auto met = std::count_if(this->samples.begin(), this->samples.end(),
    [](const Sample& sample) { return IsMet(sample.Ratio()); });
  return this->samples.empty()
    ? 0.0
    : static_cast<double>(met) / static_cast<double>(this->samples.size());
}

double SizeReport::Met() const
{
  constexpr double EnoughArea = 0.95;
  constexpr double EnoughQuads = 0.9;
  return std::min({ 1.0, this->AreaShare() / EnoughArea, this->QuadShare() / EnoughQuads });
}

double SizeReport::FineMedian() const
{
  std::vector<Sample> sorted = this->samples;
  const std::size_t count = (sorted.size() + 9) / 10;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(count),
    sorted.end(), [](const Sample& a, const Sample& b) { return a.target < b.target; });
  std::vector<double> ratios;
  for (std::size_t i = 0; i < count; ++i)
  {
    ratios.push_back(sorted[i].Ratio());
  }
  return MedianOf(std::move(ratios));
}

void SizeReport::Add(const SizeReport& other)
{
  this->samples.insert(this->samples.end(), other.samples.begin(), other.samples.end());
  for (const Set& set : other.sets)
  {
    const auto same = std::find_if(
      this->sets.begin(), this->sets.end(), [&](const Set& one) { return one.name == set.name; });
    if (same == this->sets.end())
    {
      this->sets.push_back(set);
    }
    else
    {
      same->ratios.insert(same->ratios.end(), set.ratios.begin(), set.ratios.end());
    }
  }
  const bool differsMore = std::abs(std::log(other.factor)) > std::abs(std::log(this->factor));
  this->factor = differsMore ? other.factor : this->factor;
  this->largestJump = std::max(this->largestJump, other.largestJump);
  this->nodesAdded += other.nodesAdded;
}

SizeReport MeasureSizes(const QuadResult& quads, const SizeTargets& targets)
{
  const QuadMesh& mesh = quads.mesh;
  const std::vector<int> twins = mesh.Twins();
  SizeReport report;
  report.factor = targets.factor;
  report.largestJump = LargestJump(mesh, twins);
  std::vector<std::size_t> measured;
  std::vector<Point> centres;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    if (quads.regions.empty() || quads.regions[q] == 0)
    {
      measured.push_back(q);
      centres.push_back(CentreOf(mesh, mesh.quads[q]));
      report.samples.push_back({ AreaOf(mesh, q), targets.length(centres.back()) });
    }
  }
  for (const SizeSet& set : targets.sets)
  {
    const std::vector<bool> isOn = PointsOn(mesh, set.side);
    const auto hasEdgeOnSide = [&](std::size_t quad)
    {
      for (std::size_t s = 0; s < 4; ++s)
      {
        if (twins[4 * quad + s] < 0 && isOn[static_cast<std::size_t>(mesh.quads[quad][s])] &&
          isOn[static_cast<std::size_t>(mesh.quads[quad][(s + 1) % 4])])
        {
          return true;
        }
      }
      return false;
    };
    SizeReport::Set ofSet{ set.name, {} };
    const double reach =
      set.place ? std::max(set.radius, DistanceToNearest(centres, *set.place)) : 0.0;
    for (std::size_t i = 0; i < measured.size(); ++i)
    {
      if (set.side >= 0 ? hasEdgeOnSide(measured[i])
                        : !set.place || (centres[i] - *set.place).norm() <= reach)
      {
        ofSet.ratios.push_back(report.samples[i].Ratio());
      }
    }
    if (!ofSet.ratios.empty())
    {
      report.sets.push_back(std::move(ofSet));
    }
  }
  return report;
}

SizeReport MeasureTargets(const QuadMesh& mesh, const std::vector<double>& targets)
{
  SizeReport report;
  report.largestJump = LargestJump(mesh, mesh.Twins());
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    report.samples.push_back({ AreaOf(mesh, q), targets[q] });
  }
  return report;
}

std::string DescribeMissedSizes(const SizeReport& report)
{
  constexpr double Enough = 0.9;
  constexpr double FarOff = 2.0; // a set may be so small that it hardly counts in the shares
  const double area = report.AreaShare();
  const double quads = report.QuadShare();
  const bool isMissed = std::min(area, quads) < Enough;
  double largest = std::log(isMissed ? Tolerance : FarOff);
  std::string where;
  for (const SizeReport::Set& set : report.sets)
  {
    const double median = set.Median();
    if (median > 0.0 && std::abs(std::log(median)) > largest)
    {
      largest = std::abs(std::log(median));
      where =
        "at '" + set.name + "' quads have " + FormatNumber(median, 3) + " times the target size.";
    }
  }
  if (!isMissed && where.empty())
  {
    return {};
  }
  if (where.empty())
  {
    where = "where the smallest are requested, quads have " + FormatNumber(report.FineMedian(), 3) +
      " times the target size.";
  }
  const auto percent = [](double share) { return std::to_string(std::lround(100.0 * share)); };
  return "Sizes are met within 25 % on " + percent(area) + " % of the area, by " + percent(quads) +
    " % of the quads; " + where;
}
}
