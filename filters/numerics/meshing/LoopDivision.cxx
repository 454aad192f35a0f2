#include "LoopDivision.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Point on a loop, with its arc length from a fixed point.
struct Station
{
  double at = 0.0;
  Point place = Point::Zero();
  double turn = 0.0; ///< Absolute turning angle; 0 at points between vertices.
  bool stays = false;
  bool isAbsorbed = false; ///< Merged into a corner nearby; not a vertex of the new loop.
};

/// Returns whether one of the sorted runs contains an arc length.
bool IsInside(const std::vector<std::pair<double, double>>& runs, double at)
{
  const auto after = std::upper_bound(
    runs.begin(), runs.end(), at, [](double place, const auto& run) { return place < run.first; });
  return after != runs.begin() && at <= (after - 1)->second;
}

/// Returns the vertices and fixed points of a loop in order, starting and ending at the first fixed
/// point.
std::vector<Station> Unroll(const LoopArc& arc, const std::vector<double>& turns,
  const KeptPlaces& kept, const Thinning& thinning)
{
  const double first = *std::min_element(kept.places.begin(), kept.places.end());
  const double round = arc.Length();
  const auto unrolled = [&](double at)
  {
    at -= first;
    at -= std::floor((at + thinning.rounding) / round) * round;
    return std::max(at, 0.0);
  };
  std::vector<Station> stations;
  for (const double at : kept.places)
  {
    stations.push_back({ unrolled(at), arc.At(at), 0.0, true, false });
  }
  for (std::size_t i = 0; i < turns.size(); ++i)
  {
    const double at = arc.Start(i);
    const bool isAbsorbed = IsInside(kept.merged, at) || IsInside(kept.merged, at + round) ||
      IsInside(kept.merged, at - round);
    stations.push_back({ unrolled(at), arc.Vertices()[i], std::abs(turns[i]), false, isAbsorbed });
  }
  std::sort(stations.begin(), stations.end(),
    [](const Station& a, const Station& b) { return a.at < b.at; });
  // A fixed vertex occurs twice, once as a fixed point.
  std::vector<Station> once;
  for (const Station& station : stations)
  {
    if (!once.empty() && station.at - once.back().at <= thinning.rounding &&
      (station.stays || once.back().stays))
    {
      Station& last = once.back();
      last.place = station.stays ? last.place : station.place;
      last.turn = std::max(last.turn, station.turn);
      last.stays = true;
      last.isAbsorbed = false;
      continue;
    }
    once.push_back(station);
  }
  once.push_back(once.front());
  once.back().at = round;
  return once;
}

/// Divides a loop between two fixed stations symmetrically, so that neither direction along it is
/// preferred.
class Division
{
public:
  Division(const std::vector<Station>& stations, const Thinning& thinning)
    : Stations(stations)
    , Limits(thinning)
    , Turns{ 0.0 }
  {
    for (const Station& station : stations)
    {
      this->Turns.push_back(this->Turns.back() + (station.isAbsorbed ? 0.0 : station.turn));
    }
  }

  /// Appends the vertices of the new loop between the stations `begin` and `end`.
  void Divide(std::size_t begin, std::size_t end, std::vector<ArcVertex>& vertices) const
  {
    this->Divide(begin, this->Stations[begin].at, end, this->Stations[end].at, vertices);
  }

private:
  const std::vector<Station>& Stations;
  Thinning Limits;
  std::vector<double> Turns; ///< Sums of turning angles before each station.

  /// Divides the part from `from` to `to`, with the stations begin + 1 to end − 1 strictly between.
  void Divide(std::size_t begin, double from, std::size_t end, double to,
    std::vector<ArcVertex>& vertices) const
  {
    // The candidates closest to the middle, before and after it.
    const double middle = 0.5 * (from + to);
    const auto first = this->Stations.begin() + static_cast<std::ptrdiff_t>(begin) + 1;
    const auto last = this->Stations.begin() + static_cast<std::ptrdiff_t>(end);
    auto after = std::lower_bound(
      first, last, middle, [](const Station& station, double at) { return station.at < at; });
    auto before = after;
    while (after != last && after->isAbsorbed)
    {
      ++after;
    }
    while (before != first && (before - 1)->isAbsorbed)
    {
      --before;
    }
    const bool hasBefore = before != first;
    const bool hasAfter = after != last;
    if ((!hasBefore && !hasAfter) ||
      (to - from <= this->Limits.length &&
        this->Turns[end] - this->Turns[begin + 1] <= this->Limits.turn))
    {
      return;
    }
    const auto indexOf = [&](auto iterator)
    { return static_cast<std::size_t>(iterator - this->Stations.begin()); };
    const std::size_t left = hasBefore ? indexOf(before - 1) : begin;
    const std::size_t right = hasAfter ? indexOf(after) : end;
    const double toLeft = hasBefore ? middle - this->Stations[left].at : to - from;
    const double toRight = hasAfter ? this->Stations[right].at - middle : to - from;
    if (std::abs(toLeft - toRight) > this->Limits.rounding)
    {
      const std::size_t at = toLeft < toRight ? left : right;
      this->Divide(begin, from, at, this->Stations[at].at, vertices);
      vertices.push_back({ this->Stations[at].at, this->Stations[at].place });
      this->Divide(at, this->Stations[at].at, end, to, vertices);
      return;
    }
    if (toRight <= this->Limits.rounding) // a single station in the middle
    {
      this->Divide(begin, from, right, middle, vertices);
      vertices.push_back({ middle, this->Stations[right].place });
      this->Divide(right, middle, end, to, vertices);
      return;
    }
    if (toLeft + toRight <= 0.5 * this->Limits.length &&
      this->Stations[left].turn + this->Stations[right].turn <= this->Limits.turn)
    { // Two stations at the same distance that may both be removed: their midpoint replaces them.
      this->Divide(begin, from, right, middle, vertices);
      vertices.push_back(
        { middle, 0.5 * (this->Stations[left].place + this->Stations[right].place) });
      this->Divide(left, middle, end, to, vertices);
      return;
    }
    this->Divide(begin, from, left, this->Stations[left].at, vertices);
    vertices.push_back({ this->Stations[left].at, this->Stations[left].place });
    vertices.push_back({ this->Stations[right].at, this->Stations[right].place });
    this->Divide(right, this->Stations[right].at, end, to, vertices);
  }
};

}

//------------------------------------------------------------------------------
std::vector<ArcVertex> DivideLoop(const LoopArc& arc, const std::vector<double>& turns,
  const KeptPlaces& kept, const Thinning& thinning)
{
  const std::vector<Station> stations = Unroll(arc, turns, kept, thinning);
  const Division division(stations, thinning);
  std::vector<ArcVertex> vertices;
  for (std::size_t begin = 0; begin + 1 < stations.size();)
  {
    std::size_t end = begin + 1;
    while (end + 1 < stations.size() && !stations[end].stays)
    {
      ++end;
    }
    vertices.push_back({ stations[begin].at, stations[begin].place });
    division.Divide(begin, end, vertices);
    begin = end;
  }
  // Convert to arc lengths from the first vertex of the loop.
  const double first = *std::min_element(kept.places.begin(), kept.places.end());
  for (ArcVertex& vertex : vertices)
  {
    vertex.at = std::fmod(vertex.at + first, arc.Length());
  }
  std::sort(vertices.begin(), vertices.end(),
    [](const ArcVertex& a, const ArcVertex& b) { return a.at < b.at; });
  return vertices;
}
}
