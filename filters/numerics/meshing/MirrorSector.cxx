#include "MirrorSector.h"

#include "Index.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace crossfield
{
namespace
{
/// The two rays between which a sector is, in coordinates in which the first one is the positive x
/// axis.
class Rays
{
public:
  Rays(const Point& centre, double start, int order, double reach)
    : Centre(centre)
    , Turn(start)
    , Second(order == 1 ? Point(-1.0, 0.0) : Point(std::cos(Pi / order), std::sin(Pi / order)))
    , Reach(reach)
  {
  }

  Point ToRays(const Point& point) const
  {
    return this->Turn.inverse() * Point(point - this->Centre);
  }

  /// Returns the distance from the line of the first or second ray, positive on the side of the
  /// sector.
  double Distance(const Point& local, int ray) const
  {
    return ray == 0 ? local.y() : Cross(local, this->Second);
  }
  bool IsInside(const Point& local) const
  {
    return this->Distance(local, 0) > this->Reach && this->Distance(local, 1) > this->Reach;
  }
  /// Returns the ray that a point is on, −1 for none. The centre is on the first.
  int RayOf(const Point& local) const
  {
    for (const int ray : { 0, 1 })
    {
      if (std::abs(this->Distance(local, ray)) <= this->Reach &&
        this->Along(local, ray) >= -this->Reach)
      {
        return ray;
      }
    }
    return -1;
  }
  /// Returns the position of a point of a ray along the sector's border, which leads from the far
  /// end of the second ray to the centre, at 0, and along the first ray; the sector is on its left.
  double Position(const Point& local, int ray) const
  {
    return ray == 0 ? this->Along(local, 0) : -this->Along(local, 1);
  }

private:
  double Along(const Point& local, int ray) const
  {
    return ray == 0 ? local.x() : local.dot(this->Second);
  }

  const Point Centre;
  const Eigen::Rotation2Dd Turn;
  const Point Second; ///< Unit vector of the second ray.
  const double Reach;
};

/// A vertex of the boundary.
struct Vertex
{
  Point place = Point::Zero();
  Point local = Point::Zero(); ///< In coordinates of the rays.
  int ray = -1;                ///< The ray that it is on, −1 for none.
};

/// Returns the vertices of a loop, with one wherever it crosses a ray.
std::vector<Vertex> WithCrossings(const Loop& loop, const Rays& rays, double reach)
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
  SectorCut(const PlanarDomain& given, const Rays& rays, double reach)
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

  const Rays& Border;
  const double Reach;
  std::vector<Chain> Chains;
  std::vector<Chain> Whole; ///< Loops inside the sector.
};

/// Returns the isometry that reflects a sector in its first mirror line, or not, and turns it.
Isometry ImageOf(const MirrorSector& sector, bool reflected, int turns)
{
  const double angle = 2.0 * Pi * turns / sector.group.order;
  return { sector.group.centre, angle + (reflected ? 2.0 * sector.start : 0.0), reflected };
}

/// Numbers the images of the vertices of a sector's mesh.
class SectorImages
{
public:
  SectorImages(const MirrorSector& sector, const TriangleMesh& mesh, double reach)
    : Sector(sector)
    , Mesh(mesh)
    , Places(mesh.points.size(), Place::Inside)
    , Numbers(Index(2 * sector.group.order), std::vector<int>(mesh.points.size(), -1))
  {
    const Rays rays(sector.group.centre, sector.start, sector.group.order, reach);
    for (const BoundaryEdge& edge : mesh.boundary)
    {
      const int vertex = edge.vertices[0];
      const Point local = rays.ToRays(mesh.points[vertex]);
      const int ray = rays.RayOf(local);
      this->Places[vertex] = sector.group.order > 1 && local.norm() <= reach ? Place::Centre
        : ray == 0                                                           ? Place::FirstLine
        : ray == 1                                                           ? Place::SecondLine
                                                                             : Place::Inside;
    }
  }

  /// Returns the number of a vertex of the sector, or of its image in the first mirror line, after
  /// some turns.
  int Number(int vertex, bool reflected, int turns)
  {
    // Images on mirror lines have one number, that of the image without a reflection.
    const int order = this->Sector.group.order;
    if (this->Places[vertex] == Place::Centre)
    {
      turns = 0;
    }
    else if (this->Places[vertex] == Place::SecondLine && reflected)
    {
      turns = (turns + order - 1) % order;
    }
    reflected = reflected && this->Places[vertex] == Place::Inside;
    int& number = this->Numbers[Index(2 * turns + (reflected ? 1 : 0))][vertex];
    if (number < 0)
    {
      number = static_cast<int>(this->Points.size());
      const Point& point = this->Mesh.points[vertex];
      this->Points.push_back(
        turns == 0 && !reflected ? point : ImageOf(this->Sector, reflected, turns)(point));
    }
    return number;
  }

  /// Returns the place of a numbered image.
  Point& PlaceOf(int number) { return this->Points[number]; }
  std::vector<Point> ReleasePoints() { return std::move(this->Points); }

private:
  enum class Place
  {
    Inside,
    FirstLine,
    SecondLine,
    Centre
  };

  const MirrorSector& Sector;
  const TriangleMesh& Mesh;
  std::vector<Place> Places;
  std::vector<std::vector<int>> Numbers; ///< Of vertices, per image.
  std::vector<Point> Points;
};

/// Returns the place on the boundary of the domain that an image of a boundary vertex has but for
/// rounding: a vertex of a loop, or the nearest point of a segment. `hint` is where the search
/// begins, and the segment found.
Point RestoredPlace(const Loop& loop, const Point& image, double reach, std::size_t& hint)
{
  const std::size_t count = loop.size();
  for (std::size_t distance = 0; distance <= count / 2 + 1; ++distance)
  {
    for (const std::size_t segment :
      { (hint + distance) % count, (hint + count - distance % count) % count })
    {
      const Point& from = loop[segment];
      const Point& to = loop[(segment + 1) % count];
      const Point along = to - from;
      const double part = (image - from).dot(along) / along.squaredNorm();
      const Point place = from + part * along;
      if ((image - place).norm() > reach || part * along.norm() < -reach ||
        (1.0 - part) * along.norm() < -reach)
      {
        continue;
      }
      hint = segment;
      return (image - from).norm() <= reach ? from : (image - to).norm() <= reach ? to : place;
    }
  }
  return image; // the boundary is symmetric up to `reach` only
}

/// Returns the loop of the whole domain that each boundary edge of a sector's mesh is part of, −1
/// for mirror lines.
std::vector<int> LoopsOfEdges(const MirrorSector& sector, const TriangleMesh& mesh)
{
  std::vector<int> edgeFrom(mesh.points.size(), -1);
  for (std::size_t e = 0; e < mesh.boundary.size(); ++e)
  {
    edgeFrom[mesh.boundary[e].vertices[0]] = static_cast<int>(e);
  }
  const auto sideAt = [&](int vertex) {
    return sector.loopOfSide.find({ mesh.points[vertex].x(), mesh.points[vertex].y() });
  };
  std::vector<int> loops(mesh.boundary.size(), -1);
  for (const BoundaryEdge& first : mesh.boundary)
  {
    const auto side = sideAt(first.vertices[0]);
    if (side == sector.loopOfSide.end())
    {
      continue;
    }
    int edge = edgeFrom[first.vertices[0]];
    do
    {
      loops[edge] = side->second;
      edge = edgeFrom[mesh.boundary[edge].vertices[1]];
    } while (sideAt(mesh.boundary[edge].vertices[0]) == sector.loopOfSide.end());
  }
  return loops;
}
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
  const Rays rays(group.centre, sector.start, sector.group.order, reach);
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

TriangleMesh CompleteSector(const MirrorSector& sector, const TriangleMesh& mesh,
  const PlanarDomain& domain, const std::vector<Point>& vertices,
  const std::vector<BoundaryEdge>& marks, double reach)
{
  const std::vector<int> loops = LoopsOfEdges(sector, mesh);
  std::vector<std::size_t> hints(domain.loops.size(), 0);
  SectorImages images(sector, mesh, reach);
  TriangleMesh whole;
  for (int turns = 0; turns < sector.group.order; ++turns)
  {
    for (const bool reflected : { false, true })
    {
      const auto image = [&](int vertex) { return images.Number(vertex, reflected, turns); };
      for (const auto& [a, b, c] : mesh.triangles)
      {
        const std::array<int, 3> corners = { image(a), image(reflected ? c : b),
          image(reflected ? b : c) };
        whole.triangles.push_back(corners);
      }
      std::map<int, std::size_t> imageOfLoop = { { 0, 0 } };
      for (std::size_t e = 0; e < mesh.boundary.size(); ++e)
      {
        if (loops[e] < 0)
        {
          continue;
        }
        if (imageOfLoop.count(loops[e]) == 0)
        {
          imageOfLoop[loops[e]] =
            ImageOfInnerLoop(domain, ImageOf(sector, reflected, turns), Index(loops[e]));
        }
        const auto& [from, to] = mesh.boundary[e].vertices;
        const std::size_t loop = imageOfLoop[loops[e]];
        for (const int vertex : mesh.boundary[e].vertices)
        {
          Point& place = images.PlaceOf(image(vertex));
          place = RestoredPlace(domain.loops[loop], place, reach, hints[loop]);
        }
        BoundaryEdge edge = marks[loop];
        edge.vertices = { image(reflected ? to : from), image(reflected ? from : to) };
        whole.boundary.push_back(edge);
      }
    }
  }
  whole.points = images.ReleasePoints();
  for (const Point& given : vertices)
  {
    const auto image = std::find_if(whole.points.begin(), whole.points.end(),
      [&](const Point& point) { return (point - given).norm() <= reach; });
    if (image != whole.points.end())
    {
      *image = given;
    }
  }
  return whole;
}
}
