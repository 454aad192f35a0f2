#include "VertexWays.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

namespace crossfield
{
namespace
{
/// A part of a side of a triangle that is seen from a cone. Positions are relative to the cone, in the chart of
/// the triangle where the view starts.
struct View
{
  double distance; ///< Of the nearest point of the part.
  int number;      ///< Order in which views were found, which breaks ties.
  int triangle;    ///< Beyond the side.
  int side;        ///< In that triangle.
  /// Maps the chart of the triangle to that of the start.
  SeamTransition unfolding;
  Point right; ///< Directions between which the side is seen.
  Point left;

  bool operator<(const View& other) const // the priority queue has the greatest on top
  {
    return this->distance > other.distance ||
      (this->distance == other.distance && this->number > other.number);
  }
};

/// Returns the transition that applies the second one after the first.
SeamTransition After(const SeamTransition& first, const SeamTransition& second)
{
  return { (first.rotation + second.rotation) % 4,
    TurnByQuarters(first.translation, second.rotation) + second.translation };
}

/// Returns the point of a line through two points in a direction from the origin.
Point Along(const Point& direction, const Point& from, const Point& to)
{
  const Point side = to - from;
  return Cross(from, side) / Cross(direction, side) * direction;
}

/// Returns the distance of the origin from a segment.
double DistanceTo(const Point& from, const Point& to)
{
  const Point side = to - from;
  const double at = std::clamp(-from.dot(side) / side.squaredNorm(), 0.0, 1.0);
  return (from + at * side).norm();
}

class WaySearch
{
public:
  explicit WaySearch(const SeamlessMap& map)
    : Map(map)
    , Topology(*map.topology)
    , IsCone(static_cast<std::size_t>(map.topology->VertexCount()), false)
  {
    for (const Cone& cone : map.cones)
    {
      this->IsCone[cone.vertex] = true;
    }
  }

  std::vector<ConeWay> Run()
  {
    for (int t = 0; t < this->Topology.TriangleCount(); ++t)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        if (this->IsCone[this->Topology.mesh.triangles[t][corner]])
        {
          this->Start(t, corner);
        }
      }
    }
    const std::size_t most = 30 * this->Topology.mesh.triangles.size();
    std::size_t visited = 0;
    while (!this->Views.empty() && this->Views.top().distance <= this->Reach() && visited < most)
    {
      const View view = this->Views.top();
      this->Views.pop();
      this->Visit(view);
      ++visited;
    }
    const double reach = this->Reach();
    this->Ways.erase(std::remove_if(this->Ways.begin(), this->Ways.end(),
                       [reach](const ConeWay& way) { return way.vector.norm() > reach; }),
      this->Ways.end());
    return std::move(this->Ways);
  }

private:
  /// Returns the length up to which ways are wanted.
  double Reach()
  {
    constexpr double Longer = 1.5;
    const std::size_t enough = this->Map.cones.size();
    if (this->Lengths.size() < enough)
    {
      return std::numeric_limits<double>::infinity();
    }
    std::nth_element(this->Lengths.begin(),
      this->Lengths.begin() + static_cast<std::ptrdiff_t>(enough) - 1, this->Lengths.end());
    return Longer * this->Lengths[enough - 1];
  }

  void AddWay(const Point& vector, double share)
  {
    this->Ways.push_back({ vector, share });
    this->Lengths.push_back(vector.norm());
  }

  /// Looks from a corner of a triangle across the opposite side.
  void Start(int triangle, int corner)
  {
    const Point& origin = this->Map.At(triangle, corner);
    const Point right = this->Map.At(triangle, (corner + 1) % 3) - origin;
    const Point left = this->Map.At(triangle, (corner + 2) % 3) - origin;
    if (this->IsCone[this->Topology.mesh.triangles[triangle][(corner + 1) % 3]])
    {
      this->AddWay(right, 1.0); // the other side belongs to the next triangle
    }
    this->Look({ 0, -origin }, triangle, (corner + 1) % 3, right, left);
  }

  /// Adds the view across a side of a triangle whose chart has an unfolding.
  void Look(
    const SeamTransition& unfolding, int triangle, int side, const Point& right, const Point& left)
  {
    const int next = this->Topology.Neighbour(triangle, side);
    // Thinner views are rounding errors at vertices that others see one behind the other.
    if (next < 0 || !(Cross(right, left) > AngleRounding * right.norm() * left.norm()))
    {
      return;
    }
    const Point from = unfolding(this->Map.At(triangle, side));
    const Point to = unfolding(this->Map.At(triangle, (side + 1) % 3));
    const double distance = DistanceTo(Along(right, from, to), Along(left, from, to));
    this->Views.push({ distance, this->Count++, next,
      this->Topology.SideOf(next, this->Topology.EdgeOf(triangle, side)),
      After(this->Map.Across(triangle, side).Inverse(), unfolding), right, left });
  }

  void Visit(const View& view)
  {
    const int corner = (view.side + 2) % 3; // opposite
    const Point place = view.unfolding(this->Map.At(view.triangle, corner));
    const double fromRight = Cross(view.right, place);
    const double toLeft = Cross(place, view.left);
    // A way through a vertex is at the ends of two views.
    const double inside =
      std::min(fromRight / view.right.norm(), toLeft / view.left.norm()) / place.norm();
    if (this->IsCone[this->Topology.mesh.triangles[view.triangle][corner]] &&
      inside >= -AngleRounding)
    {
      this->AddWay(place, inside <= AngleRounding ? 0.5 : 1.0);
    }
    // The entered side is passed from the left end of the view to its right end.
    const int rightSide = (view.side + 1) % 3;
    const int leftSide = (view.side + 2) % 3;
    const bool isInside = fromRight > 0.0 && toLeft > 0.0;
    if (fromRight > 0.0)
    {
      this->Look(
        view.unfolding, view.triangle, rightSide, view.right, isInside ? place : view.left);
    }
    if (toLeft > 0.0)
    {
      this->Look(view.unfolding, view.triangle, leftSide, isInside ? place : view.right, view.left);
    }
  }

  const SeamlessMap& Map;
  const MeshTopology& Topology;
  std::vector<bool> IsCone;
  std::priority_queue<View> Views;
  std::vector<ConeWay> Ways;
  std::vector<double> Lengths; ///< Of the ways.
  int Count = 0;
};
}

std::vector<ConeWay> WaysBetweenCones(const SeamlessMap& map)
{
  return map.cones.empty() ? std::vector<ConeWay>() : WaySearch(map).Run();
}
}
