#include "FeatureEdges.h"

#include "Index.h"
#include "SurfaceParts.h"
#include "UnionFind.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace crossfield
{
namespace
{
/// An edge with two triangles.
struct InnerEdge
{
  std::array<int, 2> ends{};
  int triangle = 0;
  int side = 0;
  std::array<int, 2> other{}; ///< The other triangle and its side.
  double angle = 0.0;         ///< Between the normals.
};

class FeatureSearch
{
public:
  FeatureSearch(const SurfaceMesh& surface, double angle)
    : Surface(surface)
    , Angle(angle)
    , Neighbours(FindNeighbours(surface))
  {
    this->FindEdges();
  }

  /// Finds all features.
  FeatureEdges Run()
  {
    FeatureEdges result;
    if (std::find(this->IsSharp.begin(), this->IsSharp.end(), true) == this->IsSharp.end())
    {
      result.isFeature.assign(this->Surface.triangles.size(), { false, false, false });
      return result;
    }
    this->FindEdgesOfVertices();
    constexpr double Enough = 0.5; // a part has nearly all, a scan a tenth
    const double found = this->SharpLength();
    std::size_t closed = this->CloseGaps();
    std::size_t loose = this->RemoveLooseLines();
    if (this->SharpLength() < Enough * found)
    {
      this->IsSharp = this->IsGiven;
      closed = loose = 0;
      this->LooseNamed = 0;
      this->RemoveLooseLines();
      result.events.emplace_back(
        "Most sharp edges of the surface are on lines that end, as in a scan, so none is followed.");
    }
    std::size_t joined = 0;
    for (std::size_t more = this->JoinSmallFaces(); more > 0; more = this->JoinSmallFaces())
    {
      joined += more;
      loose += this->RemoveLooseLines();
    }
    if (closed > 0)
    {
      result.events.push_back(std::to_string(closed) +
        (closed == 1 ? " gap in a sharp edge was closed." : " gaps in sharp edges were closed."));
    }
    if (loose > 0)
    {
      result.events.push_back(std::to_string(loose) +
        (loose == 1 ? " sharp edge that ends inside of a face is not followed."
                    : " sharp edges of lines that end inside of a face are not followed."));
    }
    if (this->LooseNamed > 0)
    {
      result.events.push_back(std::to_string(this->LooseNamed) +
        (this->LooseNamed == 1
            ? " edge of a named line that ends inside of a face is not followed."
            : " edges of named lines that end inside of a face are not followed."));
    }
    if (joined > 0)
    {
      result.events.push_back(std::to_string(joined) +
        (joined == 1 ? " face, smaller than 1e-4 of the surface, was joined to another one."
                     : " faces, smaller than 1e-4 of the surface, were joined to others."));
    }
    this->Store(result);
    return result;
  }

  /// Joins faces of given features.
  void Join(const std::vector<int>& faceOf, const std::vector<bool>& joins, FeatureEdges& features)
  {
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      const InnerEdge& edge = this->Edges[e];
      this->IsSharp[e] = features.isFeature[Index(edge.triangle)][Index(edge.side)];
    }
    this->FindEdgesOfVertices();
    this->JoinFaces(faceOf, joins);
    this->RemoveLooseLines();
    this->Store(features);
  }

private:
  SpacePoint NormalOf(int triangle) const
  {
    const auto& v = this->Surface.triangles[Index(triangle)];
    const SpacePoint& a = this->Surface.points[Index(v[0])];
    return (this->Surface.points[Index(v[1])] - a).cross(this->Surface.points[Index(v[2])] - a);
  }

  double LengthOf(std::size_t edge) const
  {
    const auto& [from, to] = this->Edges[edge].ends;
    return (this->Surface.points[Index(to)] - this->Surface.points[Index(from)]).norm();
  }

  /// Returns the length of all sharp edges that are not given.
  double SharpLength() const
  {
    double length = 0.0;
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      length += this->IsSharp[e] && !this->IsGiven[e] ? this->LengthOf(e) : 0.0;
    }
    return length;
  }

  void FindEdges()
  {
    this->IsOnBoundary.assign(this->Surface.points.size(), false);
    for (int t = 0; t < static_cast<int>(this->Neighbours.size()); ++t)
    {
      const auto& v = this->Surface.triangles[Index(t)];
      for (int i = 0; i < 3; ++i)
      {
        const int other = this->Neighbours[Index(t)][Index(i)];
        const std::array<int, 2> ends = { v[Index(i)], v[Index((i + 1) % 3)] };
        if (other < 0)
        {
          this->IsOnBoundary[Index(ends[0])] = this->IsOnBoundary[Index(ends[1])] = true;
        }
        else if (t < other)
        {
          const auto& w = this->Surface.triangles[Index(other)];
          const auto back = static_cast<int>(std::find(w.begin(), w.end(), ends[1]) - w.begin());
          const SpacePoint a = this->NormalOf(t);
          const SpacePoint b = this->NormalOf(other);
          const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
          this->Edges.push_back({ ends, t, i, { other, back }, angle });
          this->IsGiven.push_back(
            this->Surface.RegionOf(Index(t)) != this->Surface.RegionOf(Index(other)) ||
            this->Surface.LinesOf(Index(t))[Index(i)] >= 0 ||
            this->Surface.LinesOf(Index(other))[Index(back)] >= 0);
          this->IsSharp.push_back(angle > this->Angle || this->IsGiven.back());
        }
      }
    }
  }

  void FindEdgesOfVertices()
  {
    this->EdgesAt.resize(this->Surface.points.size());
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      for (const int end : this->Edges[e].ends)
      {
        this->EdgesAt[Index(end)].push_back(e);
      }
    }
  }

  std::size_t SharpAt(int vertex) const
  {
    const std::vector<std::size_t>& edges = this->EdgesAt[Index(vertex)];
    return static_cast<std::size_t>(std::count_if(
      edges.begin(), edges.end(), [this](std::size_t e) { return this->IsSharp[e]; }));
  }

  bool IsLooseEnd(int vertex) const
  {
    return !this->IsOnBoundary[Index(vertex)] && this->SharpAt(vertex) == 1;
  }

  int OtherEnd(std::size_t edge, int vertex) const
  {
    const auto& [from, to] = this->Edges[edge].ends;
    return from == vertex ? to : from;
  }

  SpacePoint Along(std::size_t edge, int from) const
  {
    return (
      this->Surface.points[Index(this->OtherEnd(edge, from))] - this->Surface.points[Index(from)])
      .normalized();
  }

  /// Continues lines that end to other lines or the boundary. Returns the number of gaps closed.
  std::size_t CloseGaps()
  {
    std::size_t closed = 0;
    for (int vertex = 0; vertex < static_cast<int>(this->EdgesAt.size()); ++vertex)
    {
      if (!this->IsLooseEnd(vertex))
      {
        continue;
      }
      const std::vector<std::size_t> gap = this->FindGap(vertex);
      if (!gap.empty() && this->LineLength(vertex) > gap.size())
      {
        for (const std::size_t edge : gap)
        {
          this->IsSharp[edge] = true;
        }
        ++closed;
      }
    }
    return closed;
  }

  /// Returns the number of edges from the end of a line to where it ends or branches.
  std::size_t LineLength(int start) const
  {
    std::size_t edges = 0;
    std::size_t before = this->Edges.size();
    for (int at = start; edges == 0 || (at != start && this->SharpAt(at) == 2); ++edges)
    {
      const std::vector<std::size_t>& around = this->EdgesAt[Index(at)];
      before = *std::find_if(around.begin(), around.end(),
        [&](std::size_t e) { return this->IsSharp[e] && e != before; });
      at = this->OtherEnd(before, at);
    }
    return edges;
  }

  /// Returns the edges from the end of a line to another line or the boundary; none if there is no such gap.
  std::vector<std::size_t> FindGap(int start) const
  {
    constexpr std::size_t Longest = 4; // a blunt place of a scan or of a coarse conversion
    constexpr double Straight = 0.5;   // cosine of the largest turn, 60°
    const std::vector<std::size_t>& first = this->EdgesAt[Index(start)];
    const std::size_t sharp =
      *std::find_if(first.begin(), first.end(), [this](std::size_t e) { return this->IsSharp[e]; });
    SpacePoint direction = -this->Along(sharp, start);
    std::vector<std::size_t> gap;
    int at = start;
    while (gap.size() < Longest)
    {
      const std::size_t none = this->Edges.size();
      std::size_t best = none;
      for (const std::size_t e : this->EdgesAt[Index(at)])
      {
        const bool isCandidate = !this->IsSharp[e] && this->Edges[e].angle > 0.5 * this->Angle &&
          this->Along(e, at).dot(direction) > Straight;
        if (isCandidate && (best == none || this->Edges[e].angle > this->Edges[best].angle))
        {
          best = e;
        }
      }
      if (best == none)
      {
        return {};
      }
      direction = this->Along(best, at);
      at = this->OtherEnd(best, at);
      gap.push_back(best);
      if (this->IsOnBoundary[Index(at)] || this->SharpAt(at) > 0)
      {
        return gap;
      }
    }
    return {};
  }

  /// Leaves out lines that end inside. Returns the number of their edges but for given ones, which are counted.
  std::size_t RemoveLooseLines()
  {
    std::size_t removed = 0;
    for (int vertex = 0; vertex < static_cast<int>(this->EdgesAt.size()); ++vertex)
    {
      for (int at = vertex; this->IsLooseEnd(at);)
      {
        const std::vector<std::size_t>& edges = this->EdgesAt[Index(at)];
        const std::size_t edge = *std::find_if(
          edges.begin(), edges.end(), [this](std::size_t e) { return this->IsSharp[e]; });
        this->IsSharp[edge] = false;
        ++(this->IsGiven[edge] ? this->LooseNamed : removed);
        at = this->OtherEnd(edge, at);
      }
    }
    return removed;
  }

  /// Joins each small face to the neighbour with which it shares the longest line. Returns their number.
  std::size_t JoinSmallFaces()
  {
    constexpr double Small = 1e-4; // a mesh of a thousand quads has ten times larger ones
    UnionFind sets(this->Surface.triangles.size());
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      if (!this->IsSharp[e])
      {
        sets.Join(this->Edges[e].triangle, this->Edges[e].other[0]);
      }
    }
    std::map<int, int> number;
    std::vector<int> faceOf;
    std::vector<double> areas;
    double total = 0.0;
    for (int t = 0; t < static_cast<int>(this->Surface.triangles.size()); ++t)
    {
      const auto [found, isNew] = number.emplace(sets.Find(t), static_cast<int>(number.size()));
      faceOf.push_back(found->second);
      areas.resize(number.size(), 0.0);
      const double area = this->NormalOf(t).norm();
      areas[Index(found->second)] += area;
      total += area;
    }
    std::vector<bool> joins;
    for (const double area : areas)
    {
      joins.push_back(area < Small * total);
    }
    return this->JoinFaces(faceOf, joins);
  }

  /// Joins faces to the neighbours with which they share the longest lines. Returns the number of those that have one.
  std::size_t JoinFaces(const std::vector<int>& faceOf, const std::vector<bool>& joins)
  {
    const auto facesAt = [&](std::size_t e)
    {
      const InnerEdge& edge = this->Edges[e];
      return std::array<int, 2>{ faceOf[Index(edge.triangle)], faceOf[Index(edge.other[0])] };
    };
    std::map<int, std::map<int, double>> shared;
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      const auto [a, b] = facesAt(e);
      for (const auto& [own, other] : { std::make_pair(a, b), std::make_pair(b, a) })
      {
        if (a != b && joins[Index(own)])
        {
          shared[own][other] += this->LengthOf(e);
        }
      }
    }
    std::map<int, int> partner;
    for (const auto& [face, others] : shared)
    {
      partner[face] = std::max_element(others.begin(), others.end(),
        [](const auto& x, const auto& y) {
          return x.second < y.second;
        })->first;
    }
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      const auto [a, b] = facesAt(e);
      const auto isJoined = [&partner](int own, int other)
      {
        const auto found = partner.find(own);
        return found != partner.end() && found->second == other;
      };
      if (a != b && (isJoined(a, b) || isJoined(b, a)))
      {
        this->IsSharp[e] = false;
      }
    }
    return partner.size();
  }

  /// Stores which edges are features.
  void Store(FeatureEdges& features) const
  {
    features.isFeature.assign(this->Surface.triangles.size(), { false, false, false });
    features.count = 0;
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      if (this->IsSharp[e])
      {
        const InnerEdge& edge = this->Edges[e];
        ++features.count;
        features.isFeature[Index(edge.triangle)][Index(edge.side)] = true;
        features.isFeature[Index(edge.other[0])][Index(edge.other[1])] = true;
      }
    }
  }

  const SurfaceMesh& Surface;
  const double Angle;
  const std::vector<std::array<int, 3>> Neighbours;
  std::vector<InnerEdge> Edges;
  std::vector<bool> IsSharp;
  std::vector<bool> IsGiven;                     ///< Between two regions, or of a named line.
  std::size_t LooseNamed = 0;                    ///< Edges of named lines that are left out.
  std::vector<bool> IsOnBoundary;                ///< Per point.
  std::vector<std::vector<std::size_t>> EdgesAt; ///< Per point.
};
}

FeatureEdges FindFeatureEdges(const SurfaceMesh& surface, double angle)
{
  return FeatureSearch(surface, angle).Run();
}

void MergeFaces(const SurfaceMesh& surface, const std::vector<int>& faceOf,
  const std::vector<bool>& joins, FeatureEdges& features)
{
  FeatureSearch(surface, 0.0).Join(faceOf, joins, features);
}
}
