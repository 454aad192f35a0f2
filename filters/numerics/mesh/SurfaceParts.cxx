#include "SurfaceParts.h"

#include "Error.h"
#include "UnionFind.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace crossfield
{
namespace
{
using Triangle = std::array<int, 3>;

/// A side of a triangle, with its ends in increasing order.
struct Side
{
  std::array<int, 2> ends;
  int triangle;
  int side;

  bool operator<(const Side& other) const
  {
    return std::tie(this->ends, this->triangle, this->side) <
      std::tie(other.ends, other.triangle, other.side);
  }
};

std::array<int, 2> EndsOf(const Triangle& triangle, std::size_t side)
{
  const auto [least, largest] = std::minmax(triangle[side], triangle[(side + 1) % 3]);
  return { least, largest };
}

/// Returns a count with a noun and the verb, for example "2 triangles were".
std::string CountedWere(std::size_t count, const std::string& what)
{
  return std::to_string(count) + " " + what + (count == 1 ? " was" : "s were");
}

/// Removes the triangles without points.
void RemoveEmpty(SurfaceMesh& surface)
{
  SurfaceMesh kept;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (surface.triangles[t][0] >= 0)
    {
      kept.triangles.push_back(surface.triangles[t]);
      kept.AppendLabels(surface, t);
    }
  }
  kept.points = std::move(surface.points);
  surface = std::move(kept);
}

/// Removes triangles with a point twice and those given before. Returns their number.
std::size_t RemoveRepeated(SurfaceMesh& surface)
{
  std::set<Triangle> known;
  std::size_t removed = 0;
  for (Triangle& triangle : surface.triangles)
  {
    Triangle sorted = triangle;
    std::sort(sorted.begin(), sorted.end());
    if (sorted[0] == sorted[1] || sorted[1] == sorted[2] || !known.insert(sorted).second)
    {
      triangle = { -1, -1, -1 };
      ++removed;
    }
  }
  RemoveEmpty(surface);
  return removed;
}

/// Removes flat triangles: the triangle beyond the longest side is divided at the point on this side.
class FlatTriangles
{
public:
  explicit FlatTriangles(SurfaceMesh& surface)
    : Surface(surface)
  {
  }

  /// Returns the number of those removed.
  std::size_t Remove()
  {
    std::vector<int> flat;
    for (int t = 0; t < static_cast<int>(this->Surface.triangles.size()); ++t)
    {
      if (this->IsFlatTriangle(t))
      {
        flat.push_back(t);
      }
    }
    if (flat.empty())
    {
      return 0;
    }
    for (int t = 0; t < static_cast<int>(this->Surface.triangles.size()); ++t)
    {
      this->Enter(t);
    }
    // A division may make the next triangle flat; a mesh in which that does not end is refused later.
    const std::size_t most = 10 * flat.size();
    std::size_t removed = 0;
    for (; !flat.empty() && removed < most; ++removed)
    {
      const int t = flat.back();
      flat.pop_back();
      this->Divide(t, flat);
    }
    RemoveEmpty(this->Surface);
    return removed;
  }

private:
  bool IsFlatTriangle(int t) const
  {
    return this->Surface.triangles[t][0] >= 0 && IsFlat(this->Surface, this->Surface.triangles[t]);
  }

  void Enter(int t)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->AtEdge[EndsOf(this->Surface.triangles[t], i)].push_back(t);
    }
  }

  void Leave(int t)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      std::vector<int>& at = this->AtEdge[EndsOf(this->Surface.triangles[t], i)];
      at.erase(std::find(at.begin(), at.end(), t));
    }
  }

  std::size_t LongestSide(int t) const
  {
    const Triangle& v = this->Surface.triangles[t];
    std::size_t longest = 0;
    double length = -1.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double here =
        (this->Surface.points[v[(i + 1) % 3]] - this->Surface.points[v[i]]).squaredNorm();
      if (here > length)
      {
        longest = i;
        length = here;
      }
    }
    return longest;
  }

  /// Removes a flat triangle, and adds those that become flat to the list.
  void Divide(int t, std::vector<int>& flat)
  {
    const Triangle gone = this->Surface.triangles[t];
    const std::size_t side = this->LongestSide(t);
    const int middle = gone[(side + 2) % 3];
    this->Leave(t);
    this->Surface.triangles[t] = { -1, -1, -1 };
    const std::vector<int> beyond = this->AtEdge[EndsOf(gone, side)];
    if (beyond.size() != 1) // a boundary, or an edge that is refused later
    {
      return;
    }
    const int other = beyond[0];
    const Triangle whole = this->Surface.triangles[other];
    std::size_t at = 0;
    while (EndsOf(whole, at) != EndsOf(gone, side))
    {
      ++at;
    }
    const int tip = whole[(at + 2) % 3];
    flat.erase(std::remove(flat.begin(), flat.end(), other), flat.end());
    this->Leave(other);
    this->Surface.triangles[other] = { -1, -1, -1 };
    if (tip == middle) // folded onto each other
    {
      return;
    }
    this->Surface.triangles[other] = { whole[at], middle, tip };
    this->Surface.triangles[t] = { middle, whole[(at + 1) % 3], tip };
    if (!this->Surface.regions.empty())
    {
      this->Surface.regions[t] = this->Surface.regions[other];
    }
    if (!this->Surface.lines.empty())
    {
      // The divided side has its line, or those of the short sides, which were at the same place.
      const Triangle ofWhole = this->Surface.lines[other];
      const Triangle ofGone = this->Surface.lines[t];
      const int along = std::max(ofWhole[at], ofGone[side]);
      this->Surface.lines[other] = { std::max(along, ofGone[(side + 1) % 3]), -1,
        ofWhole[(at + 2) % 3] };
      this->Surface.lines[t] = { std::max(along, ofGone[(side + 2) % 3]), ofWhole[(at + 1) % 3],
        -1 };
    }
    for (const int half : { other, t })
    {
      this->Enter(half);
      if (this->IsFlatTriangle(half))
      {
        flat.push_back(half);
      }
    }
  }

  SurfaceMesh& Surface;
  std::map<std::array<int, 2>, std::vector<int>> AtEdge;
};

/// Orients triangles and divides them into parts and points into fans.
class PartSearch
{
public:
  explicit PartSearch(SurfaceMesh& surface)
    : Surface(surface)
    , Beyond(FindNeighbours(surface))
    , Part(surface.triangles.size(), -1)
  {
  }

  SurfaceParts Run()
  {
    SurfaceParts result;
    const std::size_t turned = this->Orient();
    if (turned > 0)
    {
      result.events.push_back(CountedWere(turned, "triangle") + " turned over.");
    }
    const std::size_t split = this->SplitFans();
    if (split > 0)
    {
      result.events.push_back(
        CountedWere(split, "point") + " added where parts of the surface meet in a point only.");
    }
    result.parts = this->CollectParts();
    return result;
  }

private:
  std::string PlaceOf(int vertex) const { return DescribeInSpace(this->Surface.points[vertex]); }

  /// Returns whether two neighbours pass their common side in opposite directions.
  bool Agree(int one, int side, int other) const
  {
    const Triangle& a = this->Surface.triangles[one];
    const Triangle& b = this->Surface.triangles[other];
    const auto from = std::find(b.begin(), b.end(), a[(side + 1) % 3]);
    return b[static_cast<std::size_t>(from - b.begin() + 1) % 3] == a[side];
  }

  void Turn(int t)
  {
    std::swap(this->Surface.triangles[t][1], this->Surface.triangles[t][2]);
    std::swap(this->Beyond[t][0], this->Beyond[t][2]);
    if (!this->Surface.lines.empty())
    {
      std::swap(this->Surface.lines[t][0], this->Surface.lines[t][2]);
    }
  }

  /// Orients the triangles part by part. Returns the number of those turned over.
  std::size_t Orient()
  {
    std::size_t turned = 0;
    for (int first = 0; first < static_cast<int>(this->Part.size()); ++first)
    {
      if (this->Part[first] < 0)
      {
        turned += this->OrientPart(first);
        ++this->Parts;
      }
    }
    return turned;
  }

  std::size_t OrientPart(int first)
  {
    std::vector<int> members = { first };
    std::vector<bool> isTurned = { false };
    bool isClosed = true;
    double volume = 0.0;
    this->Part[first] = this->Parts;
    for (std::size_t next = 0; next < members.size(); ++next)
    {
      const int t = members[next];
      const Triangle& v = this->Surface.triangles[t];
      const SpacePoint& origin = this->Surface.points[this->Surface.triangles[first][0]];
      volume += (this->Surface.points[v[0]] - origin)
                  .cross(this->Surface.points[v[1]] - origin)
                  .dot(this->Surface.points[v[2]] - origin);
      for (int side = 0; side < 3; ++side)
      {
        const int other = this->Beyond[t][side];
        isClosed = isClosed && other >= 0;
        if (other >= 0 && this->Part[other] < 0)
        {
          this->Part[other] = this->Parts;
          members.push_back(other);
          isTurned.push_back(!this->Agree(t, side, other));
          if (isTurned.back())
          {
            this->Turn(other);
          }
        }
        else if (other >= 0 && !this->Agree(t, side, other))
        {
          throw Error(
            "The surface has only one side, as a Möbius strip: its triangles cannot be oriented near " +
            this->PlaceOf(v[side]) + "; cut it there.");
        }
      }
    }
    auto count = static_cast<std::size_t>(std::count(isTurned.begin(), isTurned.end(), true));
    if (isClosed ? volume < 0.0 : 2 * count > members.size())
    {
      std::for_each(members.begin(), members.end(), [this](int t) { this->Turn(t); });
      count = members.size() - count;
    }
    return count;
  }

  /// Gives each fan of triangles a point of its own. Returns the number of points added.
  std::size_t SplitFans()
  {
    std::vector<Triangle>& triangles = this->Surface.triangles;
    UnionFind corners(3 * triangles.size()); // 3 t + i
    std::vector<bool> atBoundary(3 * triangles.size(), false);
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    {
      for (int i = 0; i < 3; ++i)
      {
        const int other = this->Beyond[t][i];
        for (const int end : { i, (i + 1) % 3 })
        {
          if (other < 0)
          {
            atBoundary[3 * t + end] = true;
            continue;
          }
          const Triangle& v = triangles[other];
          const auto corner = std::find(v.begin(), v.end(), triangles[t][end]) - v.begin();
          corners.Join(3 * t + end, 3 * other + static_cast<int>(corner));
        }
      }
    }
    std::map<int, bool> touchesBoundary; // of each fan
    for (int c = 0; c < static_cast<int>(atBoundary.size()); ++c)
    {
      bool& touches = touchesBoundary[corners.Find(c)];
      touches = touches || atBoundary[c];
    }
    const std::size_t before = this->Surface.points.size();
    std::map<int, int> vertexOf; // of each fan
    std::vector<int> fans(before, 0);
    std::vector<bool> isOnBoundary(before, false);
    for (const auto& [fan, touches] : touchesBoundary)
    {
      const int vertex = triangles[fan / 3][fan % 3];
      if (touches && isOnBoundary[vertex])
      {
        throw Error("The boundary of the surface touches itself in the point " +
          this->PlaceOf(vertex) + "; move its parts apart there.");
      }
      isOnBoundary[vertex] = isOnBoundary[vertex] || touches;
      vertexOf[fan] = vertex;
      if (fans[vertex]++ > 0)
      {
        vertexOf[fan] = static_cast<int>(this->Surface.points.size());
        this->Surface.points.push_back(SpacePoint(this->Surface.points[vertex]));
      }
    }
    for (int c = 0; c < static_cast<int>(atBoundary.size()); ++c)
    {
      triangles[c / 3][c % 3] = vertexOf[corners.Find(c)];
    }
    return this->Surface.points.size() - before;
  }

  /// Returns the parts, the largest area first.
  std::vector<SurfaceMesh> CollectParts() const
  {
    std::vector<SurfaceMesh> parts(static_cast<std::size_t>(this->Parts));
    std::vector<double> areas(parts.size(), 0.0);
    std::vector<int> number(this->Surface.points.size(), -1); // each point is in one part
    for (std::size_t t = 0; t < this->Part.size(); ++t)
    {
      const auto p = static_cast<std::size_t>(this->Part[t]);
      Triangle triangle = this->Surface.triangles[t];
      areas[p] += AreaOf(this->Surface, t);
      for (int& vertex : triangle)
      {
        int& own = number[vertex];
        if (own < 0)
        {
          own = static_cast<int>(parts[p].points.size());
          parts[p].points.push_back(this->Surface.points[vertex]);
        }
        vertex = own;
      }
      parts[p].triangles.push_back(triangle);
      parts[p].AppendLabels(this->Surface, t);
    }
    std::vector<std::size_t> order(parts.size());
    for (std::size_t p = 0; p < order.size(); ++p)
    {
      order[p] = p;
    }
    std::stable_sort(order.begin(), order.end(),
      [&areas](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
    std::vector<SurfaceMesh> sorted;
    for (const std::size_t p : order)
    {
      sorted.push_back(std::move(parts[p]));
    }
    return sorted;
  }

  SurfaceMesh& Surface;
  std::vector<std::array<int, 3>>
    Beyond;              ///< Per side of a triangle its neighbour; −1 if it has none.
  std::vector<int> Part; ///< Per triangle.
  int Parts = 0;
};
}

std::vector<std::array<int, 3>> FindNeighbours(const SurfaceMesh& surface)
{
  std::vector<Side> sides;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      sides.push_back({ EndsOf(surface.triangles[t], static_cast<std::size_t>(i)), t, i });
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<std::array<int, 3>> beyond(surface.triangles.size(), { -1, -1, -1 });
  for (std::size_t i = 0; i < sides.size();)
  {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].ends == sides[i].ends)
    {
      ++end;
    }
    if (end - i > 2)
    {
      throw Error("The edge from " + DescribeInSpace(surface.points[sides[i].ends[0]]) + " to " +
        DescribeInSpace(surface.points[sides[i].ends[1]]) + " has " + std::to_string(end - i) +
        " triangles; leave at most two of them.");
    }
    if (end - i == 2)
    {
      beyond[sides[i].triangle][sides[i].side] = sides[i + 1].triangle;
      beyond[sides[i + 1].triangle][sides[i + 1].side] = sides[i].triangle;
    }
    i = end;
  }
  return beyond;
}

double AreaOf(const SurfaceMesh& surface, std::size_t triangle)
{
  const Triangle& v = surface.triangles[triangle];
  const SpacePoint& a = surface.points[v[0]];
  return 0.5 * (surface.points[v[1]] - a).cross(surface.points[v[2]] - a).norm();
}

double AreaOf(const SurfaceMesh& surface)
{
  double area = 0.0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    area += AreaOf(surface, t);
  }
  return area;
}

bool IsFlat(const SurfaceMesh& surface, const Triangle& triangle)
{
  constexpr double Flat = 1e-12;
  const SpacePoint a = surface.points[triangle[1]] - surface.points[triangle[0]];
  const SpacePoint b = surface.points[triangle[2]] - surface.points[triangle[0]];
  const double longest = std::max({ a.squaredNorm(), b.squaredNorm(), (a - b).squaredNorm() });
  return !(a.cross(b).norm() > Flat * longest);
}

SurfaceParts FindSurfaceParts(SurfaceMesh surface)
{
  const std::size_t repeated = RemoveRepeated(surface);
  const std::size_t flat = FlatTriangles(surface).Remove();
  if (surface.triangles.empty())
  {
    throw Error("The surface has no triangle with an area; give one that has.");
  }
  SurfaceParts result = PartSearch(surface).Run();
  if (flat > 0)
  {
    result.events.insert(
      result.events.begin(), CountedWere(flat, "triangle") + " removed, because without an area.");
  }
  if (repeated > 0)
  {
    result.events.insert(result.events.begin(),
      CountedWere(repeated, "triangle") + " removed, because given twice or with a point twice.");
  }
  return result;
}
}
