#include "BoundaryNames.h"

#include "Index.h"
#include "UnionFind.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
/// Entries of the boundary in order around a loop of the whole surface.
struct Loop
{
  std::vector<int> entries;
  double length = 0.0;
};

class BoundaryNaming
{
public:
  BoundaryNaming(const SeamlessMap& map, const std::vector<std::array<int, 2>>& twins,
    const std::vector<bool>& isOnLine)
    : Topology(*map.topology)
    , IsOnLine(isOnLine)
    , Places(Index(map.topology->VertexCount()))
  {
    for (const auto& [one, other] : twins)
    {
      this->Places.Join(one, other);
    }
    // A face with the quarter index k at its corner has 2 − k quads there.
    for (const BoundaryEdge& edge : this->Topology.mesh.boundary)
    {
      this->QuadsAt[this->Places.Find(edge.vertices[0])] += 2;
    }
    for (const Cone& cone : map.cones)
    {
      if (cone.onBoundary)
      {
        this->QuadsAt[this->Places.Find(cone.vertex)] -= cone.quarterIndex;
      }
    }
  }

  /// Completes the names and returns them in order.
  std::vector<std::string> Complete(std::vector<std::string>& names)
  {
    std::vector<std::string> sides;
    const std::set<std::string> given(names.begin(), names.end());
    int outer = 0;
    int hole = 0;
    std::vector<Loop> loops = this->FindLoops();
    for (std::size_t l = 0; l < loops.size(); ++l)
    {
      std::vector<int>& entries = loops[l].entries;
      const auto first = std::find_if(entries.begin(), entries.end(),
        [&](int entry) { return this->IsCorner(entry) || !names[Index(entry)].empty(); });
      std::rotate(entries.begin(), first == entries.end() ? entries.begin() : first, entries.end());
      std::string present; // empty: the next entry starts a side
      for (const int entry : entries)
      {
        std::string& name = names[Index(entry)];
        const bool isGiven = !name.empty();
        present = isGiven || this->IsCorner(entry) ? std::string() : present;
        while (!isGiven && (present.empty() || given.count(present) > 0))
        {
          present = l == 0 ? "outer" + std::to_string(outer++) : "hole" + std::to_string(hole++);
        }
        name = isGiven ? name : present;
        if (std::find(sides.begin(), sides.end(), name) == sides.end())
        {
          sides.push_back(name);
        }
      }
    }
    return sides;
  }

private:
  int PlaceOf(int entry, std::size_t end)
  {
    return this->Places.Find(this->Topology.BoundaryAt(entry).vertices[end]);
  }

  /// Returns whether there is a corner at the start of an entry.
  bool IsCorner(int entry)
  {
    constexpr int Straight = 2; // quads
    return this->QuadsAt.at(this->PlaceOf(entry, 0)) != Straight;
  }

  /// Returns the loops, the longest first.
  std::vector<Loop> FindLoops()
  {
    std::map<int, int> startingAt;
    std::vector<int> order;
    for (const BoundaryLoop& loop : this->Topology.loops)
    {
      for (const int entry : loop.edges)
      {
        if (!this->IsOnLine[Index(entry)])
        {
          startingAt.emplace(this->PlaceOf(entry, 0), entry);
          order.push_back(entry);
        }
      }
    }
    std::vector<Loop> loops;
    for (const int start : order)
    {
      Loop loop;
      for (auto next = startingAt.find(this->PlaceOf(start, 0));
           next != startingAt.end() && (!loop.entries.empty() || next->second == start);
           next = startingAt.find(this->PlaceOf(loop.entries.back(), 1)))
      {
        loop.entries.push_back(next->second);
        loop.length += this->Topology.Length(this->Topology.EdgeOfBoundary(next->second));
        startingAt.erase(next);
      }
      if (!loop.entries.empty())
      {
        loops.push_back(std::move(loop));
      }
    }
    std::stable_sort(
      loops.begin(), loops.end(), [](const Loop& a, const Loop& b) { return a.length > b.length; });
    return loops;
  }

  const MeshTopology& Topology;
  const std::vector<bool>& IsOnLine;
  UnionFind Places;
  std::map<int, int> QuadsAt; ///< Number of quads at each place of the boundary.
};
}

std::vector<std::string> NameBoundary(const SeamlessMap& map,
  const std::vector<std::array<int, 2>>& twins, const std::vector<bool>& isOnLine,
  std::vector<std::string>& names)
{
  return BoundaryNaming(map, twins, isOnLine).Complete(names);
}
}
