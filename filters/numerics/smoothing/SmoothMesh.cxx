#include "SmoothMesh.h"

#include "Error.h"
#include "QuadBlocks.h"
#include "QuadSizes.h"
#include "QuadsOnSurface.h"
#include "TangentFrames.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace crossfield
{
namespace
{
/// Weight of size against shape for equal sizes: both count the same.
constexpr double UniformSizePart = 0.5;

/// Fewest quads of a block on the mean for coarser meshes to be of use: one keeps about a quarter.
constexpr std::size_t QuadsOfBlock = 16;

/// Makes a QuadMesh of quads alone.
class MeshReading
{
public:
  /// `surface` is null in the plane.
  MeshReading(
    const PlainQuads& plain, const MeshSmoothingOptions& options, const QuadsOnSurface* surface)
    : Options(options)
    , Surface(surface)
  {
    if (plain.quads.empty())
    {
      throw Error("The mesh has no quads; give a quad mesh.");
    }
    this->Mesh.points.resize(plain.points.size());
    for (std::size_t p = 0; p < plain.points.size(); ++p)
    {
      QuadPoint& point = this->Mesh.points[p];
      point.place = plain.points[p];
      point.triangle = surface == nullptr ? -1 : surface->TriangleOf(static_cast<int>(p));
      if (point.triangle >= 0)
      {
        point.place = surface->NearestTo(point.place, static_cast<int>(p));
      }
    }
    this->Mesh.quads = plain.quads;
    if (surface != nullptr)
    {
      SetNormals(surface->Walk(), this->Mesh);
    }
    this->FindTwins();
    this->Orient();
    this->FindLoops();
    this->SetTargets();
  }

  /// Returns the side of squares that share the area.
  double MeanSize() const
  {
    double area = 0.0;
    for (int quad = 0; quad < static_cast<int>(this->Mesh.quads.size()); ++quad)
    {
      area += this->AreaOf(quad);
    }
    return std::sqrt(area / static_cast<double>(this->Mesh.quads.size()));
  }

  QuadMesh Mesh;
  std::vector<ClosedPolyline<SpacePoint>> Loops; ///< The boundary, with the domain on its left.

private:
  int StartOf(int side) const { return this->Mesh.quads[side / 4][side % 4]; }
  int EndOf(int side) const { return this->Mesh.quads[side / 4][(side + 1) % 4]; }
  std::string Near(int side) const
  {
    return " near " + DescribePlace(this->Mesh.points[this->StartOf(side)].place);
  }

  /// Finds the other side of the edge of each side; −1 on the boundary. QuadMesh::Twins requires quads
  /// that are oriented alike.
  void FindTwins()
  {
    std::vector<int> sides(4 * this->Mesh.quads.size());
    std::iota(sides.begin(), sides.end(), 0);
    const auto edgeOf = [this](int side) {
      return std::pair<int, int>(std::minmax({ this->StartOf(side), this->EndOf(side) }));
    };
    std::sort(sides.begin(), sides.end(),
      [&](int a, int b) { return std::pair(edgeOf(a), a) < std::pair(edgeOf(b), b); });
    this->Twins.assign(sides.size(), -1);
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      const int side = sides[i];
      const auto edge = edgeOf(side);
      if (edge.first == edge.second)
      {
        throw Error("A quad" + this->Near(side) + " has a point twice; remove it.");
      }
      if (i + 2 < sides.size() && edgeOf(sides[i + 2]) == edge)
      {
        throw Error("An edge" + this->Near(side) +
          " has more than two quads; give a mesh whose edges have at most two.");
      }
      if (i + 1 < sides.size() && edgeOf(sides[i + 1]) == edge)
      {
        this->Twins[side] = sides[i + 1];
        this->Twins[sides[i + 1]] = side;
      }
    }
  }

  /// Orients the quads of each connected part alike, so that its area is positive.
  void Orient()
  {
    std::vector<int> turned(this->Mesh.quads.size(), -1); // −1: not reached
    for (std::size_t seed = 0; seed < turned.size(); ++seed)
    {
      if (turned[seed] >= 0)
      {
        continue;
      }
      turned[seed] = 0;
      std::vector<int> part = { static_cast<int>(seed) };
      double area = 0.0;
      for (std::size_t next = 0; next < part.size(); ++next)
      {
        const int quad = part[next];
        const int turn = turned[quad];
        area += (turn == 0 ? 1.0 : -1.0) * this->AreaOf(quad);
        for (int side = 4 * quad; side < 4 * quad + 4; ++side)
        {
          const int twin = this->Twins[side];
          if (twin < 0)
          {
            continue;
          }
          const int wanted = this->StartOf(side) == this->StartOf(twin) ? 1 - turn : turn;
          int& other = turned[twin / 4];
          if (other >= 0 && other != wanted)
          {
            throw Error("The quads" + this->Near(side) +
              " cannot be oriented; give the mesh of an orientable surface.");
          }
          if (other < 0)
          {
            other = wanted;
            part.push_back(twin / 4);
          }
        }
      }
      if (area == 0.0)
      {
        throw Error(
          "The quads" + this->Near(4 * part[0]) + " have no area; give a mesh in the plane.");
      }
      for (const int quad : part)
      {
        turned[quad] ^= area < 0.0 ? 1 : 0;
      }
    }
    for (std::size_t q = 0; q < turned.size(); ++q)
    {
      if (turned[q] == 1)
      {
        // Corners 0, 3, 2, 1: side s becomes side 3 − s.
        auto& quad = this->Mesh.quads[q];
        std::swap(quad[1], quad[3]);
        std::reverse(this->Twins.begin() + static_cast<std::ptrdiff_t>(4 * q),
          this->Twins.begin() + static_cast<std::ptrdiff_t>(4 * q + 4));
      }
    }
  }

  double AreaOf(int quad) const
  {
    const auto& corners = this->Mesh.quads[quad];
    const auto at = [&](std::size_t i) -> const SpacePoint&
    { return this->Mesh.points[corners[i]].place; };
    const SpacePoint normal =
      this->Surface == nullptr ? SpacePoint(SpacePoint::UnitZ()) : this->Mesh.normals[quad];
    return 0.5 * (at(2) - at(0)).cross(at(3) - at(1)).dot(normal);
  }

  /// Collects the loops of the boundary and places its points on them.
  void FindLoops()
  {
    std::vector<int> next(this->Mesh.points.size(), -1);
    for (int side = 0; side < static_cast<int>(this->Twins.size()); ++side)
    {
      ++this->Mesh.points[this->StartOf(side)].valence;
      if (this->Twins[side] >= 0)
      {
        continue;
      }
      int& end = next[this->StartOf(side)];
      if (end >= 0)
      {
        throw Error("The boundary touches itself" + this->Near(side) +
          "; give the parts of the mesh that meet there points of their own.");
      }
      end = this->EndOf(side);
    }
    for (int start = 0; start < static_cast<int>(next.size()); ++start)
    {
      if (next[start] < 0)
      {
        continue;
      }
      std::vector<int> around;
      std::vector<SpacePoint> loop;
      for (int p = start; next[p] >= 0;)
      {
        around.push_back(p);
        loop.push_back(this->Mesh.points[p].place);
        p = std::exchange(next[p], -1);
      }
      this->PlaceOn(ClosedPolyline<SpacePoint>(std::move(loop)), around);
    }
    for (QuadPoint& point : this->Mesh.points)
    {
      point.quarterIndex = (point.curve.loop < 0 ? 4 : 2) - point.valence;
      point.fixed = point.fixed || point.valence == 0;
    }
  }

  void PlaceOn(ClosedPolyline<SpacePoint> loop, const std::vector<int>& around)
  {
    const auto number = static_cast<int>(this->Loops.size());
    const auto count = around.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      QuadPoint& point = this->Mesh.points[around[i]];
      point.curve = { number, loop.Start(i) };
      const SpacePoint before = point.place - loop.Vertices()[(i + count - 1) % count];
      const SpacePoint after = loop.Vertices()[(i + 1) % count] - point.place;
      const double turn = std::atan2(before.cross(after).norm(), before.dot(after));
      point.fixed = !this->Options.slides || IsCorner(turn, this->Options.cornerAngle);
      this->Mesh.boundary.push_back(
        { { around[i], around[(i + 1) % count] }, BoundaryKind::Outer, number });
    }
    this->Loops.push_back(std::move(loop));
  }

  /// Sets target lengths: those that the quads have, or those of squares that share the area.
  void SetTargets()
  {
    this->Mesh.targetLengths.resize(this->Mesh.quads.size());
    this->Mesh.patch.assign(this->Mesh.quads.size(), 0);
    if (!this->Options.uniform)
    {
      SetMeasuredLengths(this->Mesh);
      return;
    }
    const double size = this->MeanSize();
    std::fill(this->Mesh.targetLengths.begin(), this->Mesh.targetLengths.end(),
      std::array<double, 2>{ size, size });
  }

  const MeshSmoothingOptions& Options;
  const QuadsOnSurface* const Surface;
  std::vector<int> Twins; ///< Side s of quad q is 4 q + s.
};

/// Moves points of the boundary, which slid along edges of the quads, to the surface, or to its boundary.
void MoveBoundary(
  const QuadsOnSurface& surface, const std::vector<SpacePoint>& given, double size, QuadMesh& mesh)
{
  constexpr double Near = 0.25; // of a quad
  bool isOnBoundary = true;
  for (std::size_t p = 0; p < given.size(); ++p)
  {
    isOnBoundary = isOnBoundary &&
      (mesh.points[p].curve.loop < 0 || surface.IsOnBoundary(given[p], Near * size));
  }
  for (std::size_t p = 0; p < given.size(); ++p)
  {
    QuadPoint& point = mesh.points[p];
    if (point.curve.loop >= 0)
    {
      point.place = isOnBoundary ? surface.NearestOnBoundary(point.place)
                                 : surface.NearestTo(point.place, static_cast<int>(p));
    }
  }
}
}

SmoothedMesh SmoothMesh(const PlainQuads& mesh, const MeshSmoothingOptions& options,
  const Progress& progress, const SurfaceMesh* surface)
{
  std::optional<QuadsOnSurface> located;
  if (surface != nullptr)
  {
    located.emplace(*surface, mesh.points, mesh.quads);
  }
  MeshReading reading(mesh, options, located ? &*located : nullptr);
  progress.Report(0.1);
  QuadMesh& quads = reading.Mesh;
  const double size = reading.MeanSize();
  SmoothedMesh result;
  result.before = MeasureQuads(quads, size);
  QuadBlocks blocks = FindBlocks(quads);
  if (QuadsOfBlock * blocks.blocks.size() > quads.quads.size())
  {
    blocks = {};
  }
  const BoundaryCurves curves(reading.Loops);
  SmoothQuads(quads, blocks, { curves, located ? &located->Walk() : nullptr },
    options.uniform ? std::optional<double>(UniformSizePart) : std::nullopt, false,
    progress.Part(0.2, 1.0));
  if (located)
  {
    MoveBoundary(*located, mesh.points, size, quads);
  }
  result.after = MeasureQuads(quads, size);
  for (const QuadPoint& point : quads.points)
  {
    result.points.push_back(point.place);
  }
  return result;
}
}
