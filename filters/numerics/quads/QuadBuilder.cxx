#include "QuadBuilder.h"

#include "ArcPoints.h"
#include "ArcPosition.h"
#include "BoundaryOrder.h"
#include "ChartWalk.h"
#include "Index.h"
#include "Parts.h"
#include "QuadNodes.h"
#include "QuadSides.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// A point on a side of a patch.
struct SidePoint
{
  double along = 0.0; ///< Distance from the start of the side.
  int point = 0;
  int half = 0;
  double within = 0.0; ///< Distance from the start of the half-edge.
};

/// A lattice of points that covers a patch.
struct PatchLattice
{
  int columns = 0;              ///< Quads along side 0.
  int rows = 0;                 ///< Quads along side 1.
  std::vector<int> points;      ///< In the mesh, (columns + 1) (rows + 1), columns fastest.
  std::vector<Point> positions; ///< In the patch, side 0 along the x axis.

  std::size_t At(int i, int j) const { return Index(j) * Index(this->columns + 1) + Index(i); }
};

/// Where the inner points and the quads of a patch begin in the mesh.
struct PatchPlace
{
  int point = 0;
  int quad = 0;
};

/// Minimum number of quads in a part: half a millisecond.
constexpr std::ptrdiff_t MinimumBuilt = 5000;

class QuadBuilder
{
public:
  QuadBuilder(const SeamlessMap& map, const MeshBoundary& curves, const TMesh& mesh,
    const std::vector<int>& counts, const std::vector<std::vector<double>>& spacing, double size)
    : Map(map)
    , Separatrices(mesh)
    , Counts(counts)
    , Spacing(spacing)
    , Points(mesh, counts)
    , Classes(Index(this->Points.Count()))
    , Curves(curves)
    , Size(size)
  {
    for (const PointLink& link : this->Points.Links())
    {
      this->Classes.Join(link.from, link.to);
    }
  }

  QuadMesh Build(const BoundarySides& sides)
  {
    this->PlaceArcPoints();
    this->BuildPatches();
    this->AddBoundary();
    CountValences(*this->Map.topology, this->Mesh);
    FixCorners(this->Curves, this->Mesh);
    OrderOnBoundary(this->Mesh, this->Curves);
    if (this->Curves.IsInPlane())
    {
      NameBoundary(sides, this->Curves, this->Mesh);
    }
    return std::move(this->Mesh);
  }

private:
  /// Builds all patches, in parts of about as many quads.
  void BuildPatches()
  {
    const std::size_t patches = this->Separatrices.patches.size();
    std::vector<PatchPlace> places(patches + 1);
    places[0].point = static_cast<int>(this->Mesh.points.size());
    for (std::size_t f = 0; f < patches; ++f)
    {
      const int columns = this->Points.SideCount(this->Separatrices.patches[f], 0);
      const int rows = this->Points.SideCount(this->Separatrices.patches[f], 1);
      places[f + 1] = places[f];
      if (columns > 0 && rows > 0)
      {
        places[f + 1].point += (columns - 1) * (rows - 1);
        places[f + 1].quad += columns * rows;
      }
    }
    const int quads = places.back().quad;
    this->Mesh.points.resize(Index(places.back().point));
    this->Mesh.quads.resize(Index(quads));
    this->Mesh.targetLengths.resize(Index(quads));
    this->Mesh.patch.resize(Index(quads));
    for (int point = 0; point < this->Points.Count(); ++point)
    {
      this->PointNumbers.push_back(this->Numbers[this->Classes.Find(point)]);
    }
    const std::size_t parts = PartCount(quads, MinimumBuilt);
    const auto firstOf = [&](int quad)
    {
      return static_cast<std::size_t>(
        std::lower_bound(places.begin(), places.end(), quad,
          [](const PatchPlace& place, int bound) { return place.quad < bound; }) -
        places.begin());
    };
    ForParts(parts,
      [&](std::size_t part)
      {
        const auto [begin, end] = PartRange(quads, part, parts);
        const std::size_t last = part + 1 == parts ? patches : firstOf(end);
        for (std::size_t f = part == 0 ? 0 : firstOf(begin); f < last; ++f)
        {
          this->BuildPatch(f, places[f]);
        }
      });
  }

  /// Returns the point at a distance along a half-edge.
  ArcPosition FindOn(int half, double within) const
  {
    const TArc& arc = this->Separatrices.arcs[half / 2];
    return FindOnArc(arc, half % 2 == 0 ? within : arc.length - within);
  }

  /// Returns the position at a distance along a half-edge. Its rotation is the direction of the
  /// half-edge.
  ChartPlace PlaceOn(int half, double within) const
  {
    const ArcPosition at = this->FindOn(half, within);
    return { at.piece->triangle, at.w, (at.piece->direction + (half % 2 == 0 ? 0 : 2)) % 4 };
  }

  CurvePlace CurveOn(int half, double within) const
  {
    const ArcPosition at = this->FindOn(half, within);
    return FindOnBoundary(this->Map, this->Curves, *at.piece, at.w);
  }

  /// Returns the rank by which coincident points take their position: cones and fixed nodes,
  /// then the boundary, then the first.
  int RankOf(const QuadPoint& point) const
  {
    return point.cone >= 0 || point.fixed ? 3 : point.curve.loop >= 0 ? 2 : 1;
  }

  /// Stores a candidate for the point of a class if it is the first, or of higher rank than the one
  /// stored.
  void AddCandidate(int point, const QuadPoint& candidate)
  {
    const int representative = this->Classes.Find(point);
    int& number = this->Numbers[representative];
    if (number < 0)
    {
      number = static_cast<int>(this->Mesh.points.size());
      this->Mesh.points.push_back(candidate);
    }
    else if (this->RankOf(candidate) > this->RankOf(this->Mesh.points[number]))
    {
      this->Mesh.points[number] = candidate;
    }
  }

  void PlaceArcPoints()
  {
    this->Numbers.assign(Index(this->Points.Count()), -1);
    for (std::size_t a = 0; a < this->Counts.size(); ++a)
    {
      const TArc& arc = this->Separatrices.arcs[a];
      const auto half = static_cast<int>(2 * a);
      const int count = std::max(1, this->Counts[a]);
      for (int j = 0; j <= count; ++j)
      {
        const int point = j == 0 || j == count ? this->Points.At(half + (j == 0 ? 0 : 1), 0)
                                               : this->Points.At(half, j);
        this->AddCandidate(point, this->ArcPoint(arc, half, j, count, point));
      }
    }
  }

  QuadPoint ArcPoint(const TArc& arc, int half, int j, int count, int number) const
  {
    QuadPoint point;
    const double within = this->Spacing[half / 2][j];
    const ChartPlace place = this->PlaceOn(half, within);
    point.scale = PlaneScale(this->Map, place.triangle);
    point.triangle = place.triangle;
    if (arc.onBoundary)
    {
      point.curve = this->CurveOn(half, within);
      point.place = this->Curves.PlaceAt(point.curve);
    }
    else
    {
      point.place = this->Map.PlaceOf(place.triangle, place.w);
    }
    const bool node = j == 0 || j == count;
    const int cone = node ? this->Separatrices.nodes[number].cone : -1;
    // A corner takes its position from a boundary arc, whose points have a location on the
    // boundary.
    const bool isCone = cone >= 0 && (arc.onBoundary || !this->Map.cones[cone].onBoundary);
    if (isCone)
    {
      point.cone = cone;
      point.quarterIndex = this->Map.cones[cone].quarterIndex;
    }
    if (isCone || (node && arc.onBoundary && this->Separatrices.nodes[number].isFixed))
    {
      point.place = this->Separatrices.nodes[number].place;
      point.fixed = true;
    }
    return point;
  }

  /// Returns the points along a side.
  std::vector<SidePoint> SideOf(const TPatch& patch, std::size_t side) const
  {
    std::vector<SidePoint> points;
    double start = 0.0;
    for (const int half : patch.sides[side])
    {
      const double length = this->Separatrices.arcs[half / 2].length;
      const int count = this->Counts[half / 2];
      for (int j = points.empty() ? 0 : 1; j <= count && count > 0; ++j)
      {
        const double within =
          half % 2 == 0 ? this->Spacing[half / 2][j] : length - this->Spacing[half / 2][count - j];
        points.push_back({ start + within, this->Points.At(half, j), half, within });
      }
      start += length;
    }
    return points;
  }

  /// Stores the quads of a patch, and its inner points.
  void BuildPatch(std::size_t f, const PatchPlace& at)
  {
    const TPatch& patch = this->Separatrices.patches[f];
    PatchLattice lattice;
    lattice.columns = this->Points.SideCount(patch, 0);
    lattice.rows = this->Points.SideCount(patch, 1);
    if (lattice.columns == 0 || lattice.rows == 0)
    {
      return;
    }
    lattice.points.resize(Index(lattice.columns + 1) * Index(lattice.rows + 1));
    lattice.positions.resize(lattice.points.size());
    const std::vector<SidePoint> first = this->SideOf(patch, 0);
    this->PlaceSides(patch, first, lattice);
    this->PlaceInnerPoints(first, at.point, lattice);
    this->StoreQuads(lattice, static_cast<int>(f), at.quad);
  }

  /// Sets the points on the sides of a lattice; `first` are those of side 0.
  void PlaceSides(
    const TPatch& patch, const std::vector<SidePoint>& first, PatchLattice& lattice) const
  {
    const int a = lattice.columns;
    const int b = lattice.rows;
    const double width = this->Separatrices.SideLength(patch, 0);
    const double height = this->Separatrices.SideLength(patch, 1);
    const std::vector<SidePoint> second = this->SideOf(patch, 1);
    const std::vector<SidePoint> third = this->SideOf(patch, 2);
    const std::vector<SidePoint> fourth = this->SideOf(patch, 3);
    const auto set = [&](int i, int j, const SidePoint& point, const Point& position)
    {
      lattice.points[lattice.At(i, j)] = this->PointNumbers[point.point];
      lattice.positions[lattice.At(i, j)] = position;
    };
    for (int i = 0; i <= a; ++i)
    {
      const SidePoint& low = first[i];
      const SidePoint& high = third[a - i];
      set(i, 0, low, { low.along, 0.0 });
      set(i, b, high, { width - high.along, height });
    }
    for (int j = 0; j <= b; ++j)
    {
      const SidePoint& right = second[j];
      const SidePoint& left = fourth[b - j];
      set(a, j, right, { width, right.along });
      set(0, j, left, { 0.0, height - left.along });
    }
  }

  /// Stores the inner points of a lattice by Coons' formula, in the mesh from `next` on. Each
  /// column starts at its point `first` on side 0.
  void PlaceInnerPoints(const std::vector<SidePoint>& first, int next, PatchLattice& lattice)
  {
    const int a = lattice.columns;
    const int b = lattice.rows;
    std::vector<Point>& positions = lattice.positions;
    for (int i = 1; i < a; ++i)
    {
      const double s = static_cast<double>(i) / a;
      ChartPlace place = this->PlaceOn(first[i].half, first[i].within);
      for (int j = 1; j < b; ++j)
      {
        const double t = static_cast<double>(j) / b;
        // Opposite sides agree with the corners, so each coordinate is one blend.
        Point& position = positions[lattice.At(i, j)];
        position = { (1.0 - t) * positions[lattice.At(i, 0)].x() +
            t * positions[lattice.At(i, b)].x(),
          (1.0 - s) * positions[lattice.At(0, j)].y() + s * positions[lattice.At(a, j)].y() };
        place = WalkStraight(this->Map, place, position - positions[lattice.At(i, j - 1)]);
        QuadPoint point;
        point.place = this->Map.PlaceOf(place.triangle, place.w);
        point.scale = PlaneScale(this->Map, place.triangle);
        point.triangle = place.triangle;
        lattice.points[lattice.At(i, j)] = next;
        this->Mesh.points[next++] = point;
      }
    }
  }

  /// Stores the quads of a lattice with their target lengths, in the mesh from `next` on.
  void StoreQuads(const PatchLattice& lattice, int patch, int next)
  {
    // A side of nearly zero length gets a target of a quarter of the size.
    const double minimum = 0.25 * this->Size;
    for (int j = 0; j < lattice.rows; ++j)
    {
      for (int i = 0; i < lattice.columns; ++i, ++next)
      {
        const std::array<std::size_t, 4> c = { lattice.At(i, j), lattice.At(i + 1, j),
          lattice.At(i + 1, j + 1), lattice.At(i, j + 1) };
        double scale = 0.0;
        std::array<Point, 4> p;
        std::array<int, 4> quad{};
        for (std::size_t k = 0; k < 4; ++k)
        {
          quad[k] = lattice.points[c[k]];
          p[k] = lattice.positions[c[k]];
          scale += 0.25 * this->Mesh.points[quad[k]].scale;
        }
        const double wide = 0.5 * (p[1].x() - p[0].x() + p[2].x() - p[3].x());
        const double high = 0.5 * (p[3].y() - p[0].y() + p[2].y() - p[1].y());
        this->Mesh.quads[next] = quad;
        double longest = 0.0;
        for (std::size_t k = 0; k < 4; ++k)
        {
          longest = std::max(longest,
            (this->Mesh.points[quad[k]].place - this->Mesh.points[quad[(k + 1) % 4]].place).norm());
        }
        // Where the map changes size within a quad, e^H at its corners says little.
        const auto limited = [&](double length)
        { return std::clamp(scale * std::max(minimum, length), 0.25 * longest, 2.0 * longest); };
        this->Mesh.targetLengths[next] = { limited(wide), limited(high) };
        this->Mesh.patch[next] = patch;
      }
    }
  }

  void AddBoundary()
  {
    for (std::size_t a = 0; a < this->Counts.size(); ++a)
    {
      const TArc& arc = this->Separatrices.arcs[a];
      if (!arc.onBoundary)
      {
        continue;
      }
      const BoundaryEdge& edge = this->Map.topology->BoundaryAt(arc.pieces.front().position);
      for (int j = 0; j < this->Counts[a]; ++j)
      {
        const auto half = static_cast<int>(2 * a);
        const auto number = [this, half](int k)
        { return this->PointNumbers[this->Points.At(half, k)]; };
        this->Mesh.boundary.push_back({ { number(j), number(j + 1) }, edge.kind, edge.id });
      }
    }
  }

  const SeamlessMap& Map;
  const TMesh& Separatrices;
  const std::vector<int>& Counts;
  const std::vector<std::vector<double>>& Spacing; ///< Distances of the points along every arc.
  const ArcPoints Points;
  UnionFind Classes;
  const MeshBoundary& Curves;
  const double Size;
  std::vector<int>
    Numbers; ///< Index in the mesh of every class of coincident points, −1 if it has none yet.
  std::vector<int> PointNumbers; ///< That of the class of every point.
  QuadMesh Mesh;
};
}

QuadMesh BuildQuads(const SeamlessMap& map, const MeshBoundary& curves, const TMesh& mesh,
  const std::vector<int>& counts, const std::vector<std::vector<double>>& spacing, double size,
  const BoundarySides& sides)
{
  return QuadBuilder(map, curves, mesh, counts, spacing, size).Build(sides);
}
}
