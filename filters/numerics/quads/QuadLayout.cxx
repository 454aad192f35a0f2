#include "QuadLayout.h"

#include "ArcPoints.h"
#include "ChartWalk.h"
#include "Error.h"
#include "Index.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// A point on a side of a face: how far along, and where in the map.
struct SidePoint
{
  double along = 0.0;
  int point = 0;
  int half = 0;
  double within = 0.0; ///< Of the half-edge.
};

class Layout
{
public:
  Layout(const SeamlessMap& map, const TMesh& mesh, const std::vector<int>& counts, double size)
    : Map(map)
    , Lines(mesh)
    , Counts(counts)
    , Points(mesh, counts)
    , Classes(Index(this->Points.Count()))
    , Curves(*map.topology)
    , Size(size)
  {
    for (const PointLink& link : this->Points.Links())
    {
      this->Classes.Join(link.from, link.to);
    }
  }

  QuadMesh Lay()
  {
    this->Reserve();
    this->PlaceArcPoints();
    for (std::size_t f = 0; f < this->Lines.patches.size(); ++f)
    {
      this->LayFace(f);
    }
    this->LayBoundary();
    this->CountValences();
    this->HoldCorners();
    return std::move(this->Mesh);
  }

private:
  /// Room for all quads, and for as many points.
  void Reserve()
  {
    std::size_t quads = 0;
    for (const TPatch& face : this->Lines.patches)
    {
      quads += Index(this->Points.SideCount(face, 0)) * Index(this->Points.SideCount(face, 1));
    }
    this->Mesh.points.reserve(quads + Index(this->Points.Count()));
    this->Mesh.quads.reserve(quads);
    this->Mesh.wanted.reserve(quads);
    this->Mesh.face.reserve(quads);
  }

  /// The place at a length within a half-edge; its rotation is the half-edge's direction.
  ChartPlace PlaceOn(int half, double within, int* position = nullptr) const
  {
    const TArc& arc = this->Lines.arcs[Index(half / 2)];
    double rest = half % 2 == 0 ? within : arc.length - within;
    const ChartPiece* at = &arc.pieces.front();
    for (const ChartPiece& piece : arc.pieces)
    {
      at = &piece;
      const double length = (piece.to - piece.from).norm();
      if (rest <= length)
      {
        break;
      }
      rest -= &piece == &arc.pieces.back() ? 0.0 : length;
    }
    const double length = (at->to - at->from).norm();
    const double fraction = length > 0.0 ? std::clamp(rest / length, 0.0, 1.0) : 0.0;
    if (position != nullptr)
    {
      *position = at->position;
    }
    return { at->triangle, at->from + fraction * (at->to - at->from),
      (at->direction + (half % 2 == 0 ? 0 : 2)) % 4 };
  }

  CurvePlace CurveOn(int half, double within) const
  {
    int position = -1;
    const ChartPlace place = this->PlaceOn(half, within, &position);
    const MeshTopology& topology = *this->Map.topology;
    const auto& sides = topology.edges.ofTriangle[Index(place.triangle)];
    const auto side = static_cast<int>(
      std::find(sides.begin(), sides.end(), topology.EdgeOfBoundary(position)) - sides.begin());
    const Point& from = this->Map.At(place.triangle, side);
    const double length = (this->Map.At(place.triangle, (side + 1) % 3) - from).norm();
    return this->Curves.Place(position, std::clamp((place.w - from).norm() / length, 0.0, 1.0));
  }

  /// Of the points of a class the one whose place counts: cones, then the boundary, then the first.
  int RankOf(const QuadPoint& point) const
  {
    return point.cone >= 0 ? 3 : point.curve.loop >= 0 ? 2 : 1;
  }

  void Offer(int point, const QuadPoint& candidate)
  {
    const int representative = this->Classes.Find(point);
    int& number = this->Numbers[Index(representative)];
    if (number < 0)
    {
      number = static_cast<int>(this->Mesh.points.size());
      this->Mesh.points.push_back(candidate);
    }
    else if (this->RankOf(candidate) > this->RankOf(this->Mesh.points[Index(number)]))
    {
      this->Mesh.points[Index(number)] = candidate;
    }
  }

  void PlaceArcPoints()
  {
    this->Numbers.assign(Index(this->Points.Count()), -1);
    for (std::size_t a = 0; a < this->Counts.size(); ++a)
    {
      const TArc& arc = this->Lines.arcs[a];
      const auto half = static_cast<int>(2 * a);
      const int count = std::max(1, this->Counts[a]);
      for (int j = 0; j <= count; ++j)
      {
        const int point = j == 0 || j == count ? this->Points.At(half + (j == 0 ? 0 : 1), 0)
                                               : this->Points.At(half, j);
        this->Offer(point, this->ArcPoint(arc, half, j, count, point));
      }
    }
  }

  QuadPoint ArcPoint(const TArc& arc, int half, int j, int count, int number) const
  {
    QuadPoint point;
    const double within = arc.length * j / count;
    const ChartPlace place = this->PlaceOn(half, within);
    point.scale = PlaneScale(this->Map, place.triangle);
    if (arc.onBoundary)
    {
      point.curve = this->CurveOn(half, within);
      point.place = this->Curves.At(point.curve);
    }
    else
    {
      point.place = PlanePoint(this->Map, place);
    }
    const bool node = j == 0 || j == count;
    const int cone = node ? this->Lines.nodes[Index(number)].cone : -1;
    // From an arc inside, a corner would not be known to be on the boundary.
    const bool known = cone >= 0 && (arc.onBoundary || !this->Map.cones[Index(cone)].onBoundary);
    if (known)
    {
      point.cone = cone;
      point.asked = this->Map.cones[Index(cone)].quarterIndex;
      point.place = this->Lines.nodes[Index(number)].place;
      point.fixed = true;
    }
    return point;
  }

  std::vector<SidePoint> SideOf(const TPatch& face, std::size_t side) const
  {
    std::vector<SidePoint> points;
    double start = 0.0;
    for (const int half : face.sides[side])
    {
      const double length = this->Lines.arcs[Index(half / 2)].length;
      const int count = this->Counts[Index(half / 2)];
      for (int j = points.empty() ? 0 : 1; j <= count && count > 0; ++j)
      {
        const double within = length * j / count;
        points.push_back({ start + within, this->Points.At(half, j), half, within });
      }
      start += length;
    }
    return points;
  }

  void LayFace(std::size_t f)
  {
    const TPatch& face = this->Lines.patches[f];
    const int a = this->Points.SideCount(face, 0);
    const int b = this->Points.SideCount(face, 1);
    if (a == 0 || b == 0)
    {
      return;
    }
    const double width = this->Lines.SideLength(face, 0);
    const double height = this->Lines.SideLength(face, 1);
    const std::array<std::vector<SidePoint>, 4> sides = { this->SideOf(face, 0),
      this->SideOf(face, 1), this->SideOf(face, 2), this->SideOf(face, 3) };
    const auto number = [this](int point)
    { return this->Numbers[Index(this->Classes.Find(point))]; };
    std::vector<int> lattice(Index(a + 1) * Index(b + 1));
    std::vector<Point> places(lattice.size());
    const auto at = [a](int i, int j) { return Index(j) * Index(a + 1) + Index(i); };
    for (int i = 0; i <= a; ++i)
    {
      const SidePoint& low = sides[0][Index(i)];
      const SidePoint& high = sides[2][Index(a - i)];
      lattice[at(i, 0)] = number(low.point);
      places[at(i, 0)] = { low.along, 0.0 };
      lattice[at(i, b)] = number(high.point);
      places[at(i, b)] = { width - high.along, height };
    }
    for (int j = 0; j <= b; ++j)
    {
      const SidePoint& right = sides[1][Index(j)];
      const SidePoint& left = sides[3][Index(b - j)];
      lattice[at(a, j)] = number(right.point);
      places[at(a, j)] = { width, right.along };
      lattice[at(0, j)] = number(left.point);
      places[at(0, j)] = { 0.0, height - left.along };
    }
    for (int i = 1; i < a; ++i)
    {
      const double s = static_cast<double>(i) / a;
      ChartPlace place = this->PlaceOn(sides[0][Index(i)].half, sides[0][Index(i)].within);
      for (int j = 1; j < b; ++j)
      {
        const double t = static_cast<double>(j) / b;
        // Coons: opposite sides agree with the corners, so that each coordinate is one blend.
        places[at(i, j)] = { (1.0 - t) * places[at(i, 0)].x() + t * places[at(i, b)].x(),
          (1.0 - s) * places[at(0, j)].y() + s * places[at(a, j)].y() };
        place = WalkStraight(this->Map, place, places[at(i, j)] - places[at(i, j - 1)]);
        QuadPoint point;
        point.place = PlanePoint(this->Map, place);
        point.scale = PlaneScale(this->Map, place.triangle);
        lattice[at(i, j)] = static_cast<int>(this->Mesh.points.size());
        this->Mesh.points.push_back(point);
      }
    }
    // A side that is drawn out of nothing is wanted at a quarter of the size at least.
    const double least = 0.25 * this->Size;
    for (int j = 0; j < b; ++j)
    {
      for (int i = 0; i < a; ++i)
      {
        const std::array<std::size_t, 4> c = { at(i, j), at(i + 1, j), at(i + 1, j + 1),
          at(i, j + 1) };
        double scale = 0.0;
        for (const std::size_t corner : c)
        {
          scale += 0.25 * this->Mesh.points[Index(lattice[corner])].scale;
        }
        const double wide =
          0.5 * (places[c[1]].x() - places[c[0]].x() + places[c[2]].x() - places[c[3]].x());
        const double high =
          0.5 * (places[c[3]].y() - places[c[0]].y() + places[c[2]].y() - places[c[1]].y());
        this->Mesh.quads.push_back({ lattice[c[0]], lattice[c[1]], lattice[c[2]], lattice[c[3]] });
        this->Mesh.wanted.push_back(
          { scale * std::max(least, wide), scale * std::max(least, high) });
        this->Mesh.face.push_back(static_cast<int>(f));
      }
    }
  }

  void LayBoundary()
  {
    for (std::size_t a = 0; a < this->Counts.size(); ++a)
    {
      const TArc& arc = this->Lines.arcs[a];
      if (!arc.onBoundary)
      {
        continue;
      }
      const BoundaryEdge& edge = this->Map.topology->BoundaryAt(arc.pieces.front().position);
      for (int j = 0; j < this->Counts[a]; ++j)
      {
        const auto half = static_cast<int>(2 * a);
        const auto number = [this, half](int k)
        { return this->Numbers[Index(this->Classes.Find(this->Points.At(half, k)))]; };
        this->Mesh.boundary.push_back({ { number(j), number(j + 1) }, edge.kind, edge.id });
      }
    }
  }

  void CountValences()
  {
    for (const auto& quad : this->Mesh.quads)
    {
      for (const int point : quad)
      {
        ++this->Mesh.points[Index(point)].valence;
      }
    }
    const MeshTopology& topology = *this->Map.topology;
    if (this->Mesh.EulerCharacteristic() != topology.edges.EulerCharacteristic(topology.mesh))
    {
      throw Error("The quads do not cover the domain; use a smaller size.");
    }
    for (const QuadPoint& point : this->Mesh.points)
    {
      if (point.valence != (point.curve.loop < 0 ? 4 : 2) - point.asked)
      {
        throw Error("The point at " + Describe(point.place) + " got " +
          std::to_string(point.valence) + " quads; use a smaller size.");
      }
    }
  }

  /// Moves the nearest point of the boundary to every corner that is no cone.
  void HoldCorners()
  {
    for (const CurvePlace& corner : this->Curves.Corners())
    {
      const Point place = this->Curves.At(corner);
      QuadPoint* nearest = nullptr;
      double distance = 2.0 * this->Curves.Length(corner.loop);
      for (QuadPoint& point : this->Mesh.points)
      {
        if (point.curve.loop == corner.loop && (point.place - place).norm() < distance)
        {
          distance = (point.place - place).norm();
          nearest = &point;
        }
      }
      if (nearest != nullptr && !nearest->fixed)
      {
        nearest->curve = corner;
        nearest->place = place;
        nearest->fixed = true;
      }
    }
  }

  const SeamlessMap& Map;
  const TMesh& Lines;
  const std::vector<int>& Counts;
  const ArcPoints Points;
  UnionFind Classes;
  const BoundaryCurves Curves;
  const double Size;
  std::vector<int> Numbers; ///< In the mesh, of every class.
  QuadMesh Mesh;
};
}

QuadMesh LayQuads(
  const SeamlessMap& map, const TMesh& mesh, const std::vector<int>& counts, double size)
{
  return Layout(map, mesh, counts, size).Lay();
}
}
