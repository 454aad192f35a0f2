#include "Separation.h"

#include "Index.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
std::vector<double> LengthsOf(const TMesh& mesh)
{
  std::vector<double> lengths;
  for (const TArc& arc : mesh.arcs)
  {
    lengths.push_back(arc.length);
  }
  return lengths;
}

class Separator
{
public:
  Separator(const TMesh& mesh, const std::vector<int>& counts)
    : Mesh(mesh)
    , Counts(counts)
    , Points(mesh, counts)
    , Links(this->Points.Links())
    , Classes(Index(this->Points.Count()))
    , Sides(Index(this->Points.Count()))
    , OnBoundary(Index(this->Points.Count()), false)
    , LinksAt(Index(this->Points.Count()))
  {
    for (std::size_t l = 0; l < this->Links.size(); ++l)
    {
      const PointLink& link = this->Links[l];
      this->Classes.Join(link.from, link.to);
      this->LinksAt[link.from].push_back(l);
      this->LinksAt[link.to].push_back(l);
    }
    for (std::size_t a = 0; a < counts.size(); ++a)
    {
      if (mesh.arcs[a].onBoundary)
      {
        const auto half = static_cast<int>(2 * a);
        for (int j = 0; j <= counts[a]; ++j)
        {
          this->OnBoundary[this->Points.At(half, j)] = true;
        }
        if (counts[a] == 0)
        {
          this->Sides.Join(mesh.halfEdges[2 * a].node, mesh.halfEdges[2 * a + 1].node);
        }
      }
    }
  }

  std::vector<Violation> Find()
  {
    std::map<int, std::vector<int>> terminals;
    for (int p = 0; p < this->Points.Count(); ++p)
    {
      if (this->IsDistinct(p) || this->OnBoundary[p])
      {
        terminals[this->Classes.Find(p)].push_back(p);
      }
    }
    std::vector<Violation> violations;
    for (auto& [representative, members] : terminals)
    {
      std::stable_partition(
        members.begin(), members.end(), [this](int p) { return this->IsDistinct(p); });
      const int first = members.front();
      if (std::any_of(members.begin(), members.end(),
            [this, first](int p) { return this->Conflict(first, p); }))
      {
        violations.push_back(this->ShortestPath(first));
      }
    }
    this->AddShortLoops(violations);
    if (this->HasHandles())
    {
      this->AddCycles(violations);
    }
    return violations;
  }

private:
  bool HasHandles() const
  {
    std::set<int> loops;
    for (const TArc& arc : this->Mesh.arcs)
    {
      if (arc.onBoundary)
      {
        loops.insert(arc.loop);
      }
    }
    return this->Mesh.nodes.size() + this->Mesh.patches.size() + loops.size() <
      2 + this->Mesh.arcs.size();
  }

  /// Adds one path around a handle per class of coincident points, if there is any.
  void AddCycles(std::vector<Violation>& violations) const
  {
    const std::vector<double> lengths = LengthsOf(this->Mesh);
    std::vector<int> via(Index(this->Points.Count()), -1); // link towards the root of a tree
    std::vector<bool> isVisited(Index(this->Points.Count()), false);
    for (int root = 0; root < this->Points.Count(); ++root)
    {
      if (isVisited[root] || this->LinksAt[root].empty())
      {
        continue;
      }
      isVisited[root] = true;
      std::vector<int> queue = { root };
      std::vector<std::size_t> closing;
      for (std::size_t next = 0; next < queue.size(); ++next)
      {
        const int p = queue[next];
        for (const std::size_t l : this->LinksAt[p])
        {
          const int other = this->OtherEnd(l, p);
          if (!isVisited[other])
          {
            isVisited[other] = true;
            via[other] = static_cast<int>(l);
            queue.push_back(other);
          }
          else if (static_cast<int>(l) != via[p] && this->Links[l].from == p)
          {
            closing.push_back(l);
          }
        }
      }
      for (const std::size_t l : closing)
      {
        Violation cycle = this->CycleOf(l, via);
        if (!OpenCycle(this->Mesh, this->Counts, lengths, cycle.path).terms.empty())
        {
          violations.push_back(std::move(cycle));
          break;
        }
      }
    }
  }

  int OtherEnd(std::size_t link, int p) const
  {
    return this->Links[link].from == p ? this->Links[link].to : this->Links[link].from;
  }

  /// Returns the closed path that a link closes in a tree.
  Violation CycleOf(std::size_t closing, const std::vector<int>& via) const
  {
    const auto toRoot = [&](int p)
    {
      std::vector<PointLink> path;
      while (via[p] >= 0)
      {
        PointLink link = this->Links[Index(via[p])];
        if (link.from != p)
        {
          std::swap(link.from, link.to);
        }
        path.push_back(link);
        p = link.to;
      }
      return path;
    };
    std::vector<PointLink> first = toRoot(this->Links[closing].from);
    std::vector<PointLink> second = toRoot(this->Links[closing].to);
    // Both end at the root; what they have in common is not part of the cycle.
    const auto isSame = [](const PointLink& a, const PointLink& b)
    { return a.arc == b.arc && a.patch == b.patch && a.from == b.from && a.to == b.to; };
    while (!first.empty() && !second.empty() && isSame(first.back(), second.back()))
    {
      first.pop_back();
      second.pop_back();
    }
    Violation cycle;
    cycle.path = { this->Links[closing] };
    cycle.path.insert(cycle.path.end(), second.begin(), second.end());
    for (auto link = first.rbegin(); link != first.rend(); ++link)
    {
      cycle.path.push_back(*link);
      std::swap(cycle.path.back().from, cycle.path.back().to);
    }
    for (const PointLink& link : cycle.path)
    {
      this->AddArcs(link, cycle.arcs);
    }
    std::sort(cycle.arcs.begin(), cycle.arcs.end());
    cycle.arcs.erase(std::unique(cycle.arcs.begin(), cycle.arcs.end()), cycle.arcs.end());
    return cycle;
  }

  bool IsDistinct(int p) const
  {
    return p < static_cast<int>(this->Mesh.nodes.size()) && this->Mesh.nodes[p].IsDistinct();
  }

  /// Returns whether two coincident points must be apart.
  bool Conflict(int a, int b)
  {
    const bool both = this->IsDistinct(a) && this->IsDistinct(b);
    const bool terminal = this->IsDistinct(b) || this->OnBoundary[b];
    return a != b && terminal && (both || this->Sides.Find(a) != this->Sides.Find(b));
  }

  /// Returns the path with the fewest links from a point to one that it conflicts with, and the
  /// arcs on it.
  Violation ShortestPath(int start)
  {
    std::map<int, std::size_t> via;
    std::vector<int> queue = { start };
    Violation violation;
    for (std::size_t next = 0; next < queue.size(); ++next)
    {
      const int p = queue[next];
      if (this->Conflict(start, p))
      {
        for (int q = p; q != start;)
        {
          PointLink link = this->Links[via.at(q)];
          this->AddArcs(link, violation.arcs);
          if (link.to != q)
          {
            std::swap(link.from, link.to);
          }
          violation.path.push_back(link);
          q = link.from;
        }
        std::reverse(violation.path.begin(), violation.path.end());
        break;
      }
      for (const std::size_t l : this->LinksAt[p])
      {
        const int other = this->OtherEnd(l, p);
        if (other != start && via.emplace(other, l).second)
        {
          queue.push_back(other);
        }
      }
    }
    std::sort(violation.arcs.begin(), violation.arcs.end());
    violation.arcs.erase(
      std::unique(violation.arcs.begin(), violation.arcs.end()), violation.arcs.end());
    return violation;
  }

  void AddArcs(const PointLink& link, std::vector<int>& arcs) const
  {
    if (link.arc >= 0)
    {
      arcs.push_back(link.arc);
      return;
    }
    const TPatch& patch = this->Mesh.patches[link.patch];
    for (const std::size_t side : { Index(link.side), Index(link.side) + 2 })
    {
      for (const int half : patch.sides[side])
      {
        arcs.push_back(half / 2);
      }
    }
  }

  void AddShortLoops(std::vector<Violation>& violations) const
  {
    std::map<int, std::pair<int, Violation>> loops;
    for (std::size_t a = 0; a < this->Counts.size(); ++a)
    {
      if (this->Mesh.arcs[a].onBoundary)
      {
        auto& [sum, violation] = loops[this->Mesh.arcs[a].loop];
        sum += this->Counts[a];
        violation.arcs.push_back(static_cast<int>(a));
      }
    }
    for (const auto& [loop, sumAndArcs] : loops)
    {
      if (sumAndArcs.first < MinimumLoop)
      {
        violations.push_back(sumAndArcs.second);
      }
    }
  }

  const TMesh& Mesh;
  const std::vector<int>& Counts;
  const ArcPoints Points;
  const std::vector<PointLink> Links;
  UnionFind Classes;
  UnionFind Sides; ///< Classes that boundary arcs alone join.
  std::vector<bool> OnBoundary;
  std::vector<std::vector<std::size_t>> LinksAt;
};

/// Returns the row that at least one of the arcs has an edge.
SeparationRow AnyArc(const Violation& violation)
{
  SeparationRow row;
  for (const int arc : violation.arcs)
  {
    row.terms.emplace_back(arc, 1);
  }
  return row;
}
}

SeparationRow MakeSeparationRow(const Violation& violation, const TMesh& mesh,
  const std::vector<int>& counts, const std::vector<double>& target)
{
  if (!violation.path.empty())
  {
    return violation.IsCycle() ? OpenCycle(mesh, counts, target, violation.path)
                               : SeparateEnds(mesh, counts, target, violation.path);
  }
  SeparationRow row = AnyArc(violation);
  row.minimum = MinimumLoop;
  return row;
}

SeparationRow MakeSeparationRowFor(const std::vector<int>& best, const Violation& violation,
  const TMesh& mesh, const std::vector<int>& counts, const std::vector<double>& target)
{
  SeparationRow row = MakeSeparationRow(violation, mesh, counts, target);
  const bool isUseful = !row.terms.empty() && row.Holds(best) && !row.Holds(counts);
  return isUseful ? row : AnyArc(violation);
}

std::vector<Violation> FindViolations(const TMesh& mesh, const std::vector<int>& counts)
{
  return Separator(mesh, counts).Find();
}
}
