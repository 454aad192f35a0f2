#include "LineNetwork.h"

#include "EndGrid.h"
#include "PieceChains.h"
#include "PieceSampling.h"
#include "UnionFind.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace crossfield
{
namespace
{
struct Place
{
  std::size_t segment = 0;
  double part = 0.0;
  double distance = std::numeric_limits<double>::infinity();
};

/// Returns the place of a polyline nearest to a point.
Place NearestOn(const Loop& points, const Point& place)
{
  Place nearest;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const Point along = points[i + 1] - points[i];
    const double squared = along.squaredNorm();
    const double part =
      squared > 0.0 ? std::clamp((place - points[i]).dot(along) / squared, 0.0, 1.0) : 0.0;
    const double distance = (points[i] + part * along - place).norm();
    if (distance < nearest.distance)
    {
      nearest = { i, part, distance };
    }
  }
  return nearest;
}

/// Divides lines where they meet.
class NetworkMaker
{
public:
  NetworkMaker(const Drawing& drawing, double tolerance, double turn)
    : Tolerance(tolerance)
  {
    const double extent = ExtentOf(drawing.pieces);
    constexpr double Distance = 1e-4; // as in TraceOutline
    constexpr double Shortest = 1e-6;
    const SamplingRule rule = { turn, Distance * extent, Shortest * extent };
    for (const DrawingPiece& piece : drawing.pieces)
    {
      DrawnLine line;
      line.name = piece.name;
      const std::vector<double> parameters = SampleParameters(piece, rule);
      for (std::size_t i = 0; i < parameters.size(); ++i)
      {
        line.points.push_back(i == 0     ? piece.first
            : i + 1 == parameters.size() ? piece.last
                                         : PointAt(piece, parameters[i]));
      }
      if (ApproximateLength(piece) > tolerance)
      {
        this->Lines.push_back(std::move(line));
      }
    }
    this->JoinEnds();
    this->DivideAtEnds();
    this->DivideAtCrossings();
    this->RemoveCopies();
  }

  std::vector<DrawnLine> Lines;

private:
  /// Moves ends that are near each other to the place of the first one.
  void JoinEnds()
  {
    std::vector<Point*> ends;
    for (DrawnLine& line : this->Lines)
    {
      ends.push_back(&line.points.front());
      ends.push_back(&line.points.back());
    }
    EndGrid grid(this->Tolerance);
    UnionFind sets(ends.size());
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      for (const std::size_t other : grid.Near(*ends[i]))
      {
        if ((*ends[i] - *ends[other]).norm() <= this->Tolerance)
        {
          sets.Join(static_cast<int>(i), static_cast<int>(other));
        }
      }
      grid.Add(*ends[i], i);
    }
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      *ends[i] = *ends[static_cast<std::size_t>(sets.Find(static_cast<int>(i)))];
    }
  }

  /// Divides a line at a place, which becomes one of its points.
  void Divide(std::size_t number, const Place& at, const Point& place)
  {
    DrawnLine& line = this->Lines[number];
    DrawnLine rest{ { place }, line.name };
    const auto after = line.points.begin() + static_cast<std::ptrdiff_t>(at.segment) + 1;
    // A point of the sampling that is nearly there would leave a tiny segment.
    const bool skips = (*after - place).norm() <= this->Tolerance && after + 1 != line.points.end();
    rest.points.insert(rest.points.end(), skips ? after + 1 : after, line.points.end());
    line.points.erase(after, line.points.end());
    if (line.points.size() > 1 && (line.points.back() - place).norm() <= this->Tolerance)
    {
      line.points.pop_back();
    }
    line.points.push_back(place);
    this->Lines.push_back(std::move(rest));
  }

  void DivideAtEnds()
  {
    std::vector<Point> ends;
    for (const DrawnLine& line : this->Lines)
    {
      ends.push_back(line.points.front());
      ends.push_back(line.points.back());
    }
    for (const Point& end : ends)
    {
      for (std::size_t i = 0; i < this->Lines.size(); ++i)
      {
        const Loop& points = this->Lines[i].points;
        if (points.front() == end || points.back() == end)
        {
          continue;
        }
        const Place at = NearestOn(points, end);
        if (at.distance <= this->Tolerance)
        {
          this->Divide(i, at, end);
        }
      }
    }
  }

  /// Returns a point where two lines cross inside of both.
  std::optional<std::pair<Place, Place>> FindCrossing(
    const DrawnLine& one, const DrawnLine& two) const
  {
    for (std::size_t i = 0; i + 1 < one.points.size(); ++i)
    {
      const Point& a = one.points[i];
      const Point u = one.points[i + 1] - a;
      for (std::size_t j = 0; j + 1 < two.points.size(); ++j)
      {
        const Point& b = two.points[j];
        const Point v = two.points[j + 1] - b;
        const double cross = Cross(u, v);
        if (cross == 0.0)
        {
          continue;
        }
        const double s = Cross(b - a, v) / cross;
        const double t = Cross(b - a, u) / cross;
        const Point place = a + s * u;
        const auto isEnd = [&](const Loop& points)
        {
          return (points.front() - place).norm() <= this->Tolerance ||
            (points.back() - place).norm() <= this->Tolerance;
        };
        if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0 && !isEnd(one.points) &&
          !isEnd(two.points))
        {
          return std::make_pair(Place{ i, s, 0.0 }, Place{ j, t, 0.0 });
        }
      }
    }
    return std::nullopt;
  }

  void DivideAtCrossings()
  {
    for (std::size_t i = 0; i < this->Lines.size(); ++i)
    {
      for (std::size_t j = i + 1; j < this->Lines.size(); ++j)
      {
        const auto crossing = this->FindCrossing(this->Lines[i], this->Lines[j]);
        if (crossing)
        {
          const Loop& points = this->Lines[i].points;
          const Place& at = crossing->first;
          const Point place =
            points[at.segment] + at.part * (points[at.segment + 1] - points[at.segment]);
          this->Divide(i, crossing->first, place);
          this->Divide(j, crossing->second, place);
          --j; // the two may cross again
        }
      }
    }
  }

  /// Removes lines that are drawn twice.
  void RemoveCopies()
  {
    std::vector<DrawnLine> kept;
    for (DrawnLine& line : this->Lines)
    {
      const Point middle = line.points.size() > 2 ? line.points[line.points.size() / 2]
                                                  : Point(0.5 * (line.points[0] + line.points[1]));
      const bool isCopy = std::any_of(kept.begin(), kept.end(),
        [&](const DrawnLine& other)
        {
          const Point& a = other.points.front();
          const Point& b = other.points.back();
          const bool sameEnds = (a == line.points.front() && b == line.points.back()) ||
            (b == line.points.front() && a == line.points.back());
          // Ends have moved by up to the tolerance, and the other line is within it.
          return sameEnds && NearestOn(other.points, middle).distance <= 2.0 * this->Tolerance;
        });
      if (!isCopy)
      {
        kept.push_back(std::move(line));
      }
    }
    this->Lines = std::move(kept);
  }

  const double Tolerance;
};
}

std::vector<DrawnLine> MakeLineNetwork(const Drawing& drawing, double tolerance, double turn)
{
  return std::move(NetworkMaker(drawing, tolerance, turn).Lines);
}

std::vector<DrawnLine> TakeLines(
  const std::vector<std::string>& names, double tolerance, double turn, Drawing& drawing)
{
  Drawing taken;
  const auto first = std::stable_partition(drawing.pieces.begin(), drawing.pieces.end(),
    [&names](const DrawingPiece& piece)
    { return std::find(names.begin(), names.end(), piece.name) == names.end(); });
  taken.pieces.assign(first, drawing.pieces.end());
  drawing.pieces.erase(first, drawing.pieces.end());
  return taken.pieces.empty()
    ? std::vector<DrawnLine>()
    : MakeLineNetwork(
        taken, tolerance > 0.0 ? tolerance : DefaultJoinTolerance(taken.pieces), turn);
}
}
