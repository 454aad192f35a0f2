#include "BoundarySides.h"

#include "BoundaryCorners.h"
#include "Error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
bool IsLeft(const Point& a, const Point& b)
{
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

/// Returns the vertex from which the sides of a loop are numbered: the lowest of the leftmost ones,
/// because users look for the first side there. The order of vertices in a domain is that of its
/// frame.
std::size_t FirstVertex(const Loop& loop)
{
  return static_cast<std::size_t>(
    std::min_element(loop.begin(), loop.end(), IsLeft) - loop.begin());
}

/// Returns the loops in the order in which their sides are numbered, the outer loop first.
std::vector<std::size_t> OrderOfLoops(const std::vector<Loop>& loops)
{
  std::vector<std::size_t> order(loops.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin() + 1, order.end(),
    [&](std::size_t a, std::size_t b)
    { return IsLeft(loops[a][FirstVertex(loops[a])], loops[b][FirstVertex(loops[b])]); });
  return order;
}

/// Returns names as "'a', 'b' or 'c'", at most ten of them.
std::string ListOf(const std::vector<std::string>& names)
{
  constexpr std::size_t Most = 10;
  const std::size_t count = std::min(names.size(), Most);
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
  {
    text += (i == 0                                       ? "'"
                : i + 1 == count && count == names.size() ? " or '"
                                                          : ", '") +
      names[i] + "'";
  }
  return text + (names.size() > Most ? " or another side" : "");
}

/// Collects pieces and their names.
class Namer
{
public:
  Namer(
    const PlanarDomain& domain, const SegmentNames& names, const std::vector<std::string>& taken)
    : Domain(domain)
    , Names(names)
    , Taken(taken.begin(), taken.end())
    , Order(OrderOfLoops(domain.loops))
  {
    for (const std::size_t l : this->Order)
    {
      const std::size_t count = domain.loops[l].size();
      const std::size_t first = FirstVertex(domain.loops[l]);
      for (std::size_t i = first; i < first + count; ++i)
      {
        const std::string& name = this->NameOf(l, i % count);
        if (!name.empty() && this->Sides.Find(name) < 0)
        {
          this->Sides.names.push_back(name);
        }
      }
    }
    this->Sides.given = static_cast<int>(this->Sides.names.size());
  }

  BoundarySides Run()
  {
    for (const std::size_t l : this->Order)
    {
      this->AddLoop(l);
    }
    return std::move(this->Sides);
  }

private:
  const std::string& NameOf(std::size_t loop, std::size_t segment) const
  {
    static const std::string None;
    return this->Names.empty() ? None : this->Names[loop][segment];
  }

  void AddLoop(std::size_t l)
  {
    const Loop& loop = this->Domain.loops[l];
    const std::vector<double> turns = LoopArc(loop).Turns();
    const std::size_t before = this->Sides.starts.size();
    const std::size_t first = FirstVertex(loop);
    for (std::size_t step = 0; step < loop.size(); ++step)
    {
      const std::size_t i = (first + step) % loop.size();
      const std::string& name = this->NameOf(l, i);
      const bool changes = name != this->NameOf(l, (i + loop.size() - 1) % loop.size());
      if (changes || (name.empty() && IsCorner(turns[i])))
      {
        this->Sides.starts.push_back({ loop[i], this->SideFor(l, name), changes });
      }
    }
    if (this->Sides.starts.size() == before)
    {
      this->Sides.starts.push_back(
        { loop[first], this->SideFor(l, this->NameOf(l, first)), false });
    }
  }

  /// Returns the side of a piece; a new one if the piece has no name.
  int SideFor(std::size_t loop, const std::string& name)
  {
    if (!name.empty())
    {
      return this->Sides.Find(name);
    }
    std::string generated;
    do
    {
      generated =
        loop == 0 ? "outer" + std::to_string(this->Outer++) : "hole" + std::to_string(this->Hole++);
    } while (this->Sides.Find(generated) >= 0 || this->Taken.count(generated) > 0);
    this->Sides.names.push_back(generated);
    return static_cast<int>(this->Sides.names.size()) - 1;
  }

  const PlanarDomain& Domain;
  const SegmentNames& Names;
  const std::set<std::string> Taken;
  const std::vector<std::size_t> Order; ///< Loops in the order of their names.
  BoundarySides Sides;
  int Outer = 0; ///< Number of the next generated name on the outer loop.
  int Hole = 0;  ///< Number of the next generated name on inner loops.
};
}

//------------------------------------------------------------------------------
void RequireSide(
  const std::vector<std::string>& names, const std::string& name, const std::string& purpose)
{
  if (std::find(names.begin(), names.end(), name) == names.end())
  {
    throw Error(
      "The boundary has no side '" + name + "'" + purpose + "; give " + ListOf(names) + ".");
  }
}

int BoundarySides::Find(const std::string& name) const
{
  const auto found = std::find(this->names.begin(), this->names.end(), name);
  return found == this->names.end() ? -1 : static_cast<int>(found - this->names.begin());
}

//------------------------------------------------------------------------------
std::vector<Point> BoundarySides::FixedPlaces() const
{
  std::vector<Point> places;
  for (const SideStart& start : this->starts)
  {
    if (start.isFixed)
    {
      places.push_back(start.place);
    }
  }
  return places;
}

//------------------------------------------------------------------------------
BoundarySides NameSides(
  const PlanarDomain& domain, const SegmentNames& names, const std::vector<std::string>& taken)
{
  return Namer(domain, names, taken).Run();
}

//------------------------------------------------------------------------------
SidesAlong::SidesAlong(const BoundarySides& sides, const std::vector<LoopArc>& loops)
  : Starts(loops.size())
{
  for (const LoopArc& loop : loops)
  {
    this->Lengths.push_back(loop.Length());
  }
  for (const SideStart& start : sides.starts)
  {
    std::size_t nearest = 0;
    double at = 0.0;
    double smallest = std::numeric_limits<double>::infinity();
    const std::size_t first = start.loop < 0 ? 0 : static_cast<std::size_t>(start.loop);
    const std::size_t end = start.loop < 0 ? loops.size() : first + 1;
    for (std::size_t l = first; l < end; ++l)
    {
      const double candidate = loops[l].Nearest(start.place);
      const double distance = (loops[l].At(candidate) - start.place).norm();
      if (distance < smallest)
      {
        nearest = l;
        at = candidate;
        smallest = distance;
      }
    }
    this->Starts[nearest].push_back({ at, start.side, start.isFixed });
  }
  for (std::vector<LoopSide>& starts : this->Starts)
  {
    std::stable_sort(starts.begin(), starts.end(),
      [](const LoopSide& a, const LoopSide& b) { return a.at < b.at; });
  }
}

//------------------------------------------------------------------------------
int SidesAlong::At(std::size_t loop, double at) const
{
  const std::vector<LoopSide>& starts = this->Starts[loop];
  if (starts.empty())
  {
    return -1;
  }
  const double length = this->Lengths[loop];
  at -= length * std::floor(at / length);
  const auto after = std::upper_bound(starts.begin(), starts.end(), at,
    [](double place, const LoopSide& start) { return place < start.at; });
  return after == starts.begin() ? starts.back().side : (after - 1)->side;
}
}
