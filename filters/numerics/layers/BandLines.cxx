#include "BandLines.h"

#include "BoundaryOrder.h"
#include "LayerRows.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
/// Returns the factor of the first height beyond a side at a distance from its end, relative to the
/// extent of the side. It grows by five per extent far away, and has the derivative 0 at the end,
/// as rows would have a kink there.
double FactorBeyond(double distance)
{
  constexpr double Growth = 5.0;
  constexpr double Transition = 0.5; // distance at which it grows by three quarters of this
  return 1.0 + Growth * distance * distance / (distance + Transition);
}

std::vector<Point> PlacesOf(const QuadMesh& mesh, const std::vector<int>& points)
{
  std::vector<Point> places;
  for (const int point : points)
  {
    places.push_back(mesh.points[point].InPlane());
  }
  return places;
}

/// Returns the number of the part of `ends` that contains a value, and the position in it.
std::pair<std::size_t, double> PartAt(const std::vector<double>& ends, double value)
{
  const auto next = std::upper_bound(ends.begin() + 1, ends.end() - 1, value);
  const auto part = static_cast<std::size_t>(next - ends.begin()) - 1;
  return { part, std::clamp((value - ends[part]) / (ends[part + 1] - ends[part]), 0.0, 1.0) };
}
}

BandLines::BandLines(const LayeredMesh& layered, const QuadBand& band, const QuadWalk& walk,
  const BoundaryCurves& curves, int rows)
  : Layered(layered)
  , Band(band)
  , Walk(walk)
  , Curves(curves)
  , OldRows(rows)
  , Data(band.LineCount())
{
  for (std::size_t line = 0; line < band.LineCount(); ++line)
  {
    this->Points.push_back(PointsAcross(band, walk, line, rows));
    this->Walls.push_back(this->PlaceOf(this->Points[line].front()));
  }
  const std::vector<double> heights = this->HeightsAtWall();
  for (std::size_t line = 0; line < this->Data.size(); ++line)
  {
    BandLine& data = this->Data[line];
    Point direction = Point::Zero();
    if (this->IsEnd(line))
    {
      data.length = this->LengthsOnBoundary(line).back();
      const double inside = std::min(heights[line], data.length);
      direction = this->Curves.At(this->PlaceOnBoundary(line, inside)) - this->WallAt(line);
    }
    else
    {
      const MonotoneCurve curve = this->CurveOf(line);
      data.length = curve.Length();
      direction = curve.StartTangent();
    }
    data.hasFirst = data.isLayered && heights[line] > 0.0;
    data.first = heights[line] > 0.0
      ? heights[line] / std::max(0.5, this->SineAtWall(line, direction))
      : data.length / rows;
  }
}

std::vector<double> BandLines::HeightsAtWall()
{
  if (!this->Band.heights.empty())
  {
    return this->Band.heights;
  }
  const std::size_t count = this->Data.size();
  const std::size_t columns = this->Band.layers.size();
  std::vector<double> heights(count, 0.0);
  std::vector<Point> layered;
  for (std::size_t line = 0; line < count; ++line)
  {
    int sides = 0;
    const bool hasLeft = this->Band.closed || line > 0;
    const bool hasRight = this->Band.closed || line < columns;
    for (const auto& [exists, column] :
      { std::make_pair(hasLeft, line + columns - 1), std::make_pair(hasRight, line) })
    {
      const int layer = exists ? this->Band.layers[column % columns] : -1;
      if (layer >= 0)
      {
        heights[line] += this->Layered.prescriptions[layer].first.value_or(0.0);
        ++sides;
      }
    }
    if (sides > 0)
    {
      heights[line] /= sides;
      layered.push_back(this->WallAt(line));
      this->Data[line].isLayered = true;
    }
  }
  // Beyond a side the height grows with the distance from its end along the line of the wall.
  std::vector<double> beyond(count, std::numeric_limits<double>::infinity());
  for (const bool forward : { true, false })
  {
    double distance = -1.0; // negative before the first layered line
    double extent = 0.0;
    double first = 0.0;
    const std::size_t rounds = this->Band.closed ? 2 * count : count;
    for (std::size_t step = 0; step < rounds; ++step)
    {
      const std::size_t line = (forward ? step : rounds - 1 - step) % count;
      const std::size_t before = (forward ? line + count - 1 : line + 1) % count;
      if (this->Data[line].isLayered)
      {
        extent = 0.0;
        for (const Point& other : layered)
        {
          extent = std::max(extent, (other - this->WallAt(line)).norm());
        }
        distance = 0.0;
        first = heights[line];
        continue;
      }
      if (distance >= 0.0)
      {
        distance += (this->WallAt(line) - this->WallAt(before)).norm();
        beyond[line] = std::min(beyond[line], first * FactorBeyond(distance / extent));
      }
    }
  }
  for (std::size_t line = 0; line < count; ++line)
  {
    heights[line] = this->Data[line].isLayered ? heights[line] : beyond[line];
  }
  return heights;
}

double BandLines::SineAtWall(std::size_t line, const Point& direction) const
{
  const std::size_t count = this->Walls.size();
  const std::size_t columns = this->Band.layers.size();
  double sum = 0.0;
  double edges = 0.0;
  for (const bool forward : { true, false })
  {
    if (!this->Band.closed && line == (forward ? count - 1 : 0))
    {
      continue;
    }
    const Point along =
      this->WallAt((forward ? line + 1 : line + count - 1) % count) - this->WallAt(line);
    const std::size_t column = (forward ? line : line + columns - 1) % columns;
    // At the end of a layered side, only the side counts.
    const double weight = this->Data[line].isLayered && this->Band.layers[column] < 0 ? 0.0 : 1.0;
    sum += weight * std::abs(std::sin(AngleBetween(along, direction)));
    edges += weight;
  }
  return sum / edges;
}

MonotoneCurve BandLines::CurveOf(std::size_t line) const
{
  const std::vector<Point> places = PlacesOf(this->Layered.mesh, this->Points[line]);
  const QuadPoint& wall = this->Layered.mesh.points[this->Points[line].front()];
  const std::size_t columns = this->Band.layers.size();
  if (this->IsEnd(line) || !wall.fixed || wall.curve.loop < 0 || wall.valence != 2 ||
    this->Band.layers[line % columns] < 0 || this->Band.layers[(line + columns - 1) % columns] < 0)
  {
    return MonotoneCurve(places);
  }
  const std::size_t count = this->Walls.size();
  const Point next = this->WallAt((line + 1) % count) - places[0];
  const Point previous = this->WallAt((line + count - 1) % count) - places[0];
  const double angle = AngleBetween(next, previous);
  const double half = 0.5 * (angle < 0.0 ? angle + 2.0 * Pi : angle);
  const Point bisector = Eigen::Rotation2Dd(half) * next.normalized();
  return MonotoneCurve(places, bisector);
}

bool BandLines::IsEnd(std::size_t line) const
{
  return !this->Band.closed && (line == 0 || line + 1 == this->Walls.size());
}

std::vector<double> BandLines::LengthsOnBoundary(std::size_t line) const
{
  std::vector<double> lengths = { 0.0 };
  for (std::size_t level = 0; level + 1 < this->Points[line].size(); ++level)
  {
    // The boundary leads down the first line and up the last one.
    const CurvePlace& below = this->Layered.mesh.points[this->Points[line][level]].curve;
    const CurvePlace& above = this->Layered.mesh.points[this->Points[line][level + 1]].curve;
    const double loop = this->Curves.Length(below.loop);
    lengths.push_back(lengths.back() +
      (line == 0 ? LengthAlong(above, below, loop) : LengthAlong(below, above, loop)));
  }
  return lengths;
}

CurvePlace BandLines::PlaceOnBoundary(std::size_t line, double length) const
{
  CurvePlace place = this->Layered.mesh.points[this->Points[line].front()].curve;
  const double loop = this->Curves.Length(place.loop);
  place.at = std::fmod(place.at + (line == 0 ? -length : length) + loop, loop);
  return place;
}

int BandLines::RowsNeeded() const
{
  int rows = 1;
  for (const BandLine& line : this->Data)
  {
    rows =
      std::max(rows, RowsToFill(line.length, std::min(line.first, line.length), this->Band.growth));
  }
  return rows;
}

double BandLines::LargestGrowth(const std::vector<std::vector<QuadPoint>>& points) const
{
  double growth = 0.0;
  for (std::size_t line = 0; line < points.size(); ++line)
  {
    Point from = this->WallAt(line);
    double last = std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row <= points[line].size(); ++row)
    {
      const Point to = row < points[line].size() ? points[line][row].InPlane()
                                                 : this->PlaceOf(this->Points[line].back());
      growth = std::max(growth, (to - from).norm() / last);
      last = (to - from).norm();
      from = to;
    }
  }
  return growth;
}

double BandLines::FirstOf(const BandLine& line, int rows) const
{
  // Rows that must not grow become lower instead where fewer of them would do.
  return line.hasFirst && this->Band.growth == 1.0 ? line.first
                                                   : std::min(line.first, line.length / rows);
}

double BandLines::LargestStep(int rows) const
{
  std::vector<double> last;
  for (const BandLine& line : this->Data)
  {
    const double first = this->FirstOf(line, rows);
    const std::vector<double> ends = RowEnds(line.length, first, rows);
    last.push_back(rows > 1 ? line.length - ends[ends.size() - 2] : line.length);
  }
  double step = 1.0;
  for (std::size_t column = 0; column < this->Band.layers.size(); ++column)
  {
    const int above = this->Walk.Above(this->Band.rows[this->OldRows - 1][column]);
    if ((this->Band.heights.empty() && this->Band.layers[column] < 0) || above < 0)
    {
      continue;
    }
    const double height = this->Walk.Height(above);
    const double below = 0.5 * (last[column] + last[(column + 1) % last.size()]);
    step = std::max({ step, height / below, below / height });
  }
  return step;
}

std::vector<double> BandLines::PartsOfEnd(std::size_t end) const
{
  const std::size_t count = this->Data.size();
  std::vector<double> parts(count, 0.0);
  parts[end] = 1.0;
  const std::size_t columns = this->Band.layers.size();
  const auto regionOf = [&](std::size_t column)
  { return this->Layered.regions[this->Band.rows[0][column] / 4]; };
  const int region = regionOf(end == 0 ? 0 : columns - 1);
  if (region == 0)
  {
    return parts;
  }
  // The rows of another layer follow the end line: they take its deviation, less the farther away.
  std::vector<double> distances = { 0.0 };
  for (std::size_t i = 0; i < columns; ++i)
  {
    const std::size_t line = end == 0 ? i : end - i;
    const std::size_t next = end == 0 ? i + 1 : end - i - 1;
    if (regionOf(end == 0 ? i : columns - 1 - i) != region)
    {
      break;
    }
    distances.push_back(distances.back() + (this->WallAt(next) - this->WallAt(line)).norm());
  }
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    parts[end == 0 ? i : end - i] = 1.0 - distances[i] / distances.back();
  }
  return parts;
}

std::vector<std::vector<QuadPoint>> BandLines::Divide(int rows) const
{
  const QuadMesh& mesh = this->Layered.mesh;
  struct End
  {
    std::size_t line;
    std::vector<double> parts;
    MonotoneCurve curve;
    double length;
  };
  std::vector<End> ends;
  for (const std::size_t line : { std::size_t(0), this->Data.size() - 1 })
  {
    if (this->IsEnd(line))
    {
      ends.push_back(
        { line, this->PartsOfEnd(line), this->CurveOf(line), this->Data[line].length });
    }
  }
  std::vector<std::vector<QuadPoint>> result;
  for (std::size_t line = 0; line < this->Data.size(); ++line)
  {
    const BandLine& data = this->Data[line];
    const std::vector<int>& points = this->Points[line];
    const MonotoneCurve curve = this->CurveOf(line);
    std::vector<double> lengths = { 0.0 };
    for (std::size_t level = 0; level + 1 < points.size(); ++level)
    {
      lengths.push_back(
        lengths.back() + (this->PlaceOf(points[level + 1]) - this->PlaceOf(points[level])).norm());
    }
    const std::vector<double> rowEnds = RowEnds(data.length, this->FirstOf(data, rows), rows);
    result.emplace_back();
    for (std::size_t row = 0; row + 1 < rowEnds.size(); ++row)
    {
      QuadPoint point;
      const double fraction = rowEnds[row] / data.length;
      const auto [level, position] = PartAt(lengths, fraction * lengths.back());
      point.scale = (1.0 - position) * mesh.points[points[level]].scale +
        position * mesh.points[points[level + 1]].scale;
      if (this->IsEnd(line))
      {
        point.valence = 2;
        point.curve = this->PlaceOnBoundary(line, rowEnds[row]);
        point.MoveTo(this->Curves.At(point.curve));
      }
      else
      {
        point.valence = 4;
        point.MoveTo(curve.At(rowEnds[row]));
        for (const End& end : ends)
        {
          if (end.parts[line] > 0.0)
          {
            point.place.head<2>() += end.parts[line] *
              (this->Curves.At(this->PlaceOnBoundary(end.line, fraction * end.length)) -
                end.curve.At(fraction * end.curve.Length()));
          }
        }
      }
      result.back().push_back(point);
    }
  }
  return result;
}
}
