#include "FeatureCut.h"

#include "BoundaryCorners.h"
#include "Index.h"
#include "SurfaceParts.h"
#include "UnionFind.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
class FeatureCutter
{
public:
  FeatureCutter(const SurfaceMesh& surface, const FeatureEdges& features)
    : Surface(surface)
    , Features(features)
    , Neighbours(FindNeighbours(surface))
    , Fans(3 * surface.triangles.size())
    , Face(surface.triangles.size(), -1)
  {
    this->JoinFans();
  }

  CutSurface Run()
  {
    this->CollectFaces();
    this->FindNodes();
    this->FollowLines();
    this->Result.faceOf = std::move(this->Face);
    return std::move(this->Result);
  }

private:
  /// A side of a triangle, with the triangle on its left.
  struct Half
  {
    int triangle = 0;
    int side = 0;
  };

  int PointAt(int triangle, int corner) const
  {
    return this->Surface.triangles[Index(triangle)][Index(corner % 3)];
  }
  int BeyondOf(const Half& half) const
  {
    return this->Neighbours[Index(half.triangle)][Index(half.side)];
  }
  bool IsFeature(const Half& half) const
  {
    return this->Features.isFeature[Index(half.triangle)][Index(half.side)];
  }
  /// Returns the number of the name of the line along an edge, −1 without one.
  int NameOf(const Half& half) const
  {
    const auto on = [this](const Half& one)
    { return this->Surface.LinesOf(Index(one.triangle))[Index(one.side)]; };
    return this->BeyondOf(half) < 0 ? on(half) : std::max(on(half), on(this->TwinOf(half)));
  }
  /// Returns the corner of a triangle at a point.
  int CornerAt(int triangle, int point) const
  {
    const auto& v = this->Surface.triangles[Index(triangle)];
    return static_cast<int>(std::find(v.begin(), v.end(), point) - v.begin());
  }
  /// Returns the other side of an edge inside of the surface.
  Half TwinOf(const Half& half) const
  {
    const int other = this->BeyondOf(half);
    return { other, this->CornerAt(other, this->PointAt(half.triangle, half.side + 1)) };
  }
  int FanAt(int triangle, int corner) { return this->Fans.Find(3 * triangle + corner % 3); }
  /// Returns the point of the face of a triangle at its corner.
  int FacePointAt(int triangle, int corner)
  {
    return this->PointOfFan.at(this->FanAt(triangle, corner));
  }

  template <typename Visit>
  void ForHalves(const Visit& visit)
  {
    for (int t = 0; t < static_cast<int>(this->Face.size()); ++t)
    {
      for (int i = 0; i < 3; ++i)
      {
        visit(Half{ t, i });
      }
    }
  }

  /// Joins the corners of triangles that are neighbours across edges that are not sharp.
  void JoinFans()
  {
    this->ForHalves(
      [&](const Half& half)
      {
        if (this->BeyondOf(half) < 0 || this->IsFeature(half))
        {
          return;
        }
        const Half twin = this->TwinOf(half);
        this->Fans.Join(3 * half.triangle + half.side, 3 * twin.triangle + (twin.side + 1) % 3);
        this->Fans.Join(3 * half.triangle + (half.side + 1) % 3, 3 * twin.triangle + twin.side);
      });
  }

  void CollectFaces()
  {
    UnionFind sets(this->Face.size());
    this->ForHalves(
      [&](const Half& half)
      {
        if (this->BeyondOf(half) >= 0 && !this->IsFeature(half))
        {
          sets.Join(half.triangle, this->BeyondOf(half));
        }
      });
    std::map<int, double> areas;
    for (int t = 0; t < static_cast<int>(this->Face.size()); ++t)
    {
      areas[sets.Find(t)] += AreaOf(this->Surface, Index(t));
    }
    std::vector<std::pair<int, double>> sorted(areas.begin(), areas.end());
    std::stable_sort(sorted.begin(), sorted.end(),
      [](const auto& x, const auto& y) { return x.second > y.second; });
    std::map<int, int> number;
    for (const auto& [set, area] : sorted)
    {
      number.emplace(set, static_cast<int>(number.size()));
    }
    this->Result.faces.resize(number.size());
    for (int t = 0; t < static_cast<int>(this->Face.size()); ++t)
    {
      const int face = this->Face[Index(t)] = number.at(sets.Find(t));
      SurfaceMesh& mesh = this->Result.faces[Index(face)];
      std::array<int, 3> triangle{};
      for (int i = 0; i < 3; ++i)
      {
        const auto [found, isNew] =
          this->PointOfFan.emplace(this->FanAt(t, i), static_cast<int>(mesh.points.size()));
        if (isNew)
        {
          mesh.points.push_back(this->Surface.points[Index(this->PointAt(t, i))]);
        }
        triangle[Index(i)] = found->second;
      }
      mesh.triangles.push_back(triangle);
    }
    this->Result.boundaryNames.resize(this->Result.faces.size());
    this->ForHalves(
      [&](const Half& half)
      {
        if (this->BeyondOf(half) < 0 && this->NameOf(half) >= 0)
        {
          this->Result.boundaryNames[Index(this->Face[Index(half.triangle)])].emplace(
            this->FacePointAt(half.triangle, half.side), this->NameOf(half));
        }
      });
  }

  /// Finds the points of sharp edges that are nodes.
  void FindNodes()
  {
    struct Fan
    {
      double angle = 0.0;
      FacePoint corner;
    };
    std::map<int, int> sides; // number of sharp edges, per point of one and where names change
    std::map<int, std::set<int>> names; // of sharp edges, per point
    std::map<int, std::set<int>> namesOfBoundary;
    std::set<int> onBoundary;
    this->ForHalves(
      [&](const Half& half)
      {
        const std::array<int, 2> ends = { this->PointAt(half.triangle, half.side),
          this->PointAt(half.triangle, half.side + 1) };
        if (this->IsFeature(half))
        {
          ++sides[ends[0]];
          sides.emplace(ends[1], 0);
        }
        for (const int end : ends)
        {
          if (this->IsFeature(half))
          {
            names[end].insert(this->NameOf(half));
          }
          else if (this->BeyondOf(half) < 0)
          {
            namesOfBoundary[end].insert(this->NameOf(half));
          }
        }
      });
    for (const auto& [point, different] : namesOfBoundary)
    {
      if (different.size() > 1)
      {
        sides.emplace(point, 0);
      }
    }
    this->ForHalves(
      [&](const Half& half)
      {
        for (const int end : { half.side, half.side + 1 })
        {
          if (this->BeyondOf(half) < 0 && sides.count(this->PointAt(half.triangle, end)) > 0)
          {
            onBoundary.insert(this->PointAt(half.triangle, end));
          }
        }
      });
    std::map<int, std::map<int, Fan>> fans; // per point and fan
    this->ForHalves(
      [&](const Half& half)
      {
        const int point = this->PointAt(half.triangle, half.side);
        if (sides.count(point) == 0)
        {
          return;
        }
        const SpacePoint& at = this->Surface.points[Index(point)];
        const SpacePoint a =
          this->Surface.points[Index(this->PointAt(half.triangle, half.side + 1))] - at;
        const SpacePoint b =
          this->Surface.points[Index(this->PointAt(half.triangle, half.side + 2))] - at;
        Fan& fan = fans[point][this->FanAt(half.triangle, half.side)];
        fan.angle += std::atan2(a.cross(b).norm(), a.dot(b));
        fan.corner = { this->Face[Index(half.triangle)],
          this->FacePointAt(half.triangle, half.side) };
      });
    for (const auto& [point, ofPoint] : fans)
    {
      const bool touches = onBoundary.count(point) > 0;
      const bool hasCorner = std::any_of(ofPoint.begin(), ofPoint.end(),
        [](const auto& entry) { return IsCorner(Pi - entry.second.angle); });
      const auto found = names.find(point);
      const bool changesName = found != names.end() && found->second.size() > 1;
      if (sides.at(point) == 2 && !touches && !hasCorner && !changesName)
      {
        continue;
      }
      FeatureNode node;
      node.isOnBoundary = touches;
      for (const auto& [key, fan] : ofPoint)
      {
        node.corners.push_back(fan.corner);
      }
      this->Nodes.insert(point);
      this->Result.nodes.push_back(std::move(node));
    }
  }

  void FollowLines()
  {
    std::vector<std::array<bool, 3>> isVisited(this->Face.size(), { false, false, false });
    for (const bool fromNodes : { true, false })
    {
      this->ForHalves(
        [&](const Half& half)
        {
          const bool isNode = this->Nodes.count(this->PointAt(half.triangle, half.side)) > 0;
          if (this->IsFeature(half) && isNode == fromNodes &&
            !isVisited[Index(half.triangle)][Index(half.side)])
          {
            this->Follow(half, isVisited);
          }
        });
    }
  }

  /// Adds both halves of a line that returns to its node, with another node between them. On one side it may be a whole
  /// loop and on the other, where a line of its own ends at the node, not.
  void AddInHalves(const FeatureLine& line)
  {
    const std::size_t middle = line.points[0].size() / 2;
    FeatureLine first;
    FeatureLine second;
    first.faces = second.faces = line.faces;
    first.name = second.name = line.name;
    FeatureNode node;
    for (const std::size_t side : { 0, 1 })
    {
      const std::vector<int>& points = line.points[side];
      const auto at = points.begin() + static_cast<std::ptrdiff_t>(middle);
      first.points[side].assign(points.begin(), at + 1);
      second.points[side].assign(at, points.end());
      node.corners.push_back({ line.faces[side], *at });
    }
    this->Result.lines.push_back(std::move(first));
    this->Result.lines.push_back(std::move(second));
    this->Result.nodes.push_back(std::move(node));
  }

  /// Adds the line that starts with a side.
  void Follow(const Half& first, std::vector<std::array<bool, 3>>& isVisited)
  {
    FeatureLine line;
    line.name = this->NameOf(first);
    const int start = this->PointAt(first.triangle, first.side);
    Half half = first;
    while (true)
    {
      const Half twin = this->TwinOf(half);
      isVisited[Index(half.triangle)][Index(half.side)] = true;
      isVisited[Index(twin.triangle)][Index(twin.side)] = true;
      line.points[0].push_back(this->FacePointAt(half.triangle, half.side));
      line.points[1].push_back(this->FacePointAt(twin.triangle, twin.side + 1));
      const int end = this->PointAt(half.triangle, half.side + 1);
      if (end == start || this->Nodes.count(end) > 0)
      {
        const bool endsInNode = this->Nodes.count(end) > 0;
        line.isClosed = !endsInNode;
        line.faces = { this->Face[Index(half.triangle)], this->Face[Index(twin.triangle)] };
        if (endsInNode)
        {
          line.points[0].push_back(this->FacePointAt(half.triangle, half.side + 1));
          line.points[1].push_back(this->FacePointAt(twin.triangle, twin.side));
        }
        if (endsInNode && end == start)
        {
          this->AddInHalves(line);
        }
        else
        {
          this->Result.lines.push_back(std::move(line));
        }
        return;
      }
      // Around the end, inside of the face.
      half.side = (half.side + 1) % 3;
      while (!this->IsFeature(half))
      {
        const Half across = this->TwinOf(half);
        half = { across.triangle, (across.side + 1) % 3 };
      }
    }
  }

  const SurfaceMesh& Surface;
  const FeatureEdges& Features;
  const std::vector<std::array<int, 3>> Neighbours;
  UnionFind Fans;                ///< Of corners 3 t + i.
  std::vector<int> Face;         ///< Per triangle.
  std::map<int, int> PointOfFan; ///< In its face.
  std::set<int> Nodes;           ///< Points.
  CutSurface Result;
};
}

CutSurface CutAlongFeatures(const SurfaceMesh& surface, const FeatureEdges& features)
{
  return FeatureCutter(surface, features).Run();
}
}
