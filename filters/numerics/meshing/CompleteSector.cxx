#include "CompleteSector.h"

#include "Index.h"
#include "MirrorRays.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace crossfield
{
namespace
{
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
    const MirrorRays rays(sector.group.centre, sector.start, sector.group.order, reach);
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
