#include "MirrorSector.h"

#include "MirrorRays.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace crossfield
{
namespace
{
/// A vertex of the boundary.
struct Vertex
{
  Point place = Point::Zero();
  Point local = Point::Zero(); ///< In coordinates of the rays.
  int ray = -1;                ///< The ray that it is on, −1 for none.
};

/// Returns the vertices of a loop, with one wherever it crosses a ray.
std::vector<Vertex> WithCrossings(const Loop& loop, const MirrorRays& rays, double reach)
{
  std::vector<Vertex> vertices;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point along = loop[(i + 1) % loop.size()] - loop[i];
    const Point from = rays.ToRays(loop[i]);
    const Point to = rays.ToRays(loop[(i + 1) % loop.size()]);
    vertices.push_back({ loop[i], from, rays.RayOf(from) });
    for (const int crossed : { 0, 1 })
    {
      const double before = rays.Distance(from, crossed);
      const double after = rays.Distance(to, crossed);
      if (std::min(before, after) < -reach && std::max(before, after) > reach)
      {
        const Point place = loop[i] + before / (before - after) * along;
        const Point local = rays.ToRays(place);
        if (rays.RayOf(local) == crossed)
        {
          vertices.push_back({ place, local, crossed });
        }
      }
    }
  }
  return vertices;
}

/// A part of the boundary inside a sector, from ray to ray.
struct Chain
{
  std::vector<Vertex> vertices;
  int loop = 0;
};

class SectorCut
{
public:
  SectorCut(const PlanarDomain& given, const MirrorRays& rays, double reach)
    : Border(rays)
    , Reach(reach)
  {
    for (std::size_t l = 0; l < given.loops.size(); ++l)
    {
      this->Divide(WithCrossings(given.loops[l], rays, reach), static_cast<int>(l));
    }
  }

  /// Joins the chains along the rays, with the points that are on these. Returns whether that is
  /// possible.
  bool Join(std::vector<Vertex> onRays, bool needsCentre, MirrorSector& sector)
  {
    const auto isFromRayToRay = [](const Chain& chain)
    { return chain.vertices.front().ray >= 0 && chain.vertices.back().ray >= 0; };
    if (this->Chains.empty() ||
      !std::all_of(this->Chains.begin(), this->Chains.end(), isFromRayToRay))
    {
      return false;
    }
    struct End
    {
      double position;
      std::size_t chain;
      bool entersDomain; ///< The border of the sector enters the domain where a chain ends.
    };
    std::vector<End> ends;
    for (std::size_t c = 0; c < this->Chains.size(); ++c)
    {
      const Vertex& first = this->Chains[c].vertices.front();
      const Vertex& last = this->Chains[c].vertices.back();
      ends.push_back({ this->Border.Position(last.local, last.ray), c, true });
      ends.push_back({ this->Border.Position(first.local, first.ray), c, false });
    }
    std::sort(
      ends.begin(), ends.end(), [](const End& a, const End& b) { return a.position < b.position; });
    std::vector<std::size_t> following(this->Chains.size());
    std::vector<std::vector<Vertex>> between(this->Chains.size());
    if (needsCentre)
    {
      onRays.push_back({ sector.group.centre, Point::Zero(), 0 });
    }
    for (std::size_t i = 0; i < ends.size(); i += 2)
    {
      if (!ends[i].entersDomain || ends[i + 1].entersDomain)
      {
        return false;
      }
      following[ends[i].chain] = ends[i + 1].chain;
      between[ends[i].chain] = this->Between(onRays, ends[i].position, ends[i + 1].position);
    }
    Loop outer;
    std::size_t joined = 0;
    std::size_t chain = 0;
    do
    {
      const std::vector<Vertex>& vertices = this->Chains[chain].vertices;
      for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
      {
        Add(vertices[i], this->Chains[chain].loop, outer, sector);
      }
      Add(vertices.back(), MirrorLine, outer, sector);
      for (const Vertex& vertex : between[chain])
      {
        Add(vertex, MirrorLine, outer, sector);
      }
      chain = following[chain];
      ++joined;
    } while (chain != 0 && joined <= this->Chains.size());
    sector.domain.loops = { std::move(outer) };
    for (const Chain& inner : this->Whole)
    {
      Loop loop;
      for (const Vertex& vertex : inner.vertices)
      {
        Add(vertex, inner.loop, loop, sector);
      }
      sector.domain.loops.push_back(std::move(loop));
    }
    return joined == this->Chains.size();
  }

private:
  static constexpr int MirrorLine = -1;

  /// Collects the parts of a loop that are inside the sector.
  void Divide(const std::vector<Vertex>& vertices, int loop)
  {
    const std::size_t count = vertices.size();
    const auto isInside = [&](std::size_t i)
    {
      return this->Border.IsInside(
        0.5 * (vertices[i % count].local + vertices[(i + 1) % count].local));
    };
    std::size_t first = 0;
    while (first < count && vertices[first].ray < 0)
    {
      ++first;
    }
    if (first == count)
    {
      if (isInside(0))
      {
        this->Whole.push_back({ vertices, loop });
      }
      return;
    }
    bool continues = false;
    for (std::size_t i = first; i < first + count; ++i)
    {
      const Vertex& vertex = vertices[i % count];
      if (!isInside(i))
      {
        continues = false;
        continue;
      }
      if (!continues || vertex.ray >= 0)
      {
        this->Chains.push_back({ { vertex }, loop });
      }
      this->Chains.back().vertices.push_back(vertices[(i + 1) % count]);
      continues = true;
    }
  }

  /// Returns the points strictly between two positions on the border, in its direction.
  std::vector<Vertex> Between(const std::vector<Vertex>& points, double from, double to) const
  {
    std::vector<Vertex> between;
    const auto position = [this](const Vertex& vertex)
    { return this->Border.Position(vertex.local, vertex.ray); };
    std::copy_if(points.begin(), points.end(), std::back_inserter(between),
      [&](const Vertex& vertex)
      { return position(vertex) > from + this->Reach && position(vertex) < to - this->Reach; });
    std::sort(between.begin(), between.end(),
      [&](const Vertex& a, const Vertex& b) { return position(a) < position(b); });
    // A singularity at the centre is there already.
    between.erase(
      std::unique(between.begin(), between.end(),
        [&](const Vertex& a, const Vertex& b) { return position(b) - position(a) <= this->Reach; }),
      between.end());
    return between;
  }

  static void Add(const Vertex& vertex, int loopOfSide, Loop& loop, MirrorSector& sector)
  {
    loop.push_back(vertex.place);
    sector.loopOfSide[{ vertex.place.x(), vertex.place.y() }] = loopOfSide;
  }

  const MirrorRays& Border;
  const double Reach;
  std::vector<Chain> Chains;
  std::vector<Chain> Whole; ///< Loops inside the sector.
};
}

std::optional<MirrorSector> CutMirrorSector(const PlanarDomain& domain, const SymmetryGroup& group,
  double from, const std::vector<Point>& vertices, double reach)
{
  MirrorSector sector;
  sector.group = group;
  // Triangles at the centre cannot be better than the angle between two mirror lines, 15° with 12.
  constexpr int MaximumOrder = 12;
  while (sector.group.order > MaximumOrder || group.order % sector.group.order != 0)
  {
    --sector.group.order;
  }
  const double period = Pi / group.order;
  const double ahead = std::fmod(group.axis - from, period);
  sector.start = from + (ahead < -AngleRounding ? ahead + period : ahead);
  const MirrorRays rays(group.centre, sector.start, sector.group.order, reach);
  std::vector<Vertex> onRays;
  for (const Point& point : vertices)
  {
    const Point local = rays.ToRays(point);
    const int ray = rays.RayOf(local);
    if (ray >= 0)
    {
      onRays.push_back({ point, local, ray });
    }
    else if (rays.IsInside(local))
    {
      sector.vertices.push_back(point);
    }
  }
  SectorCut cut(domain, rays, reach);
  if (!cut.Join(std::move(onRays), sector.group.order > 1, sector))
  {
    return std::nullopt;
  }
  return sector;
}
}
