#include "SurfaceWalk.h"

#include "Error.h"
#include "TriangleWalk.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

namespace crossfield
{
TangentAxes AxesOf(const SpacePoint& normal)
{
  // The axis of space that is farthest from the normal is the first.
  Eigen::Index farthest = 0;
  normal.cwiseAbs().minCoeff(&farthest);
  TangentAxes axes;
  axes.col(0) = SpacePoint::Unit(farthest) - normal[farthest] * normal;
  axes.col(0).normalize();
  axes.col(1) = normal.cross(axes.col(0));
  return axes;
}

SurfaceWalk::SurfaceWalk(const MeshTopology& topology)
  : Topology(topology)
  , Normals(topology.mesh.points.size(), SpacePoint::Zero())
{
  for (int t = 0; t < topology.TriangleCount(); ++t)
  {
    const SpacePoint normal = topology.NormalOf(t);
    for (int i = 0; i < 3; ++i)
    {
      const Point next = topology.At(t, (i + 1) % 3) - topology.At(t, i);
      const Point last = topology.At(t, (i + 2) % 3) - topology.At(t, i);
      this->Normals[topology.mesh.triangles[t][i]] += AngleBetween(next, last) * normal;
    }
  }
  for (SpacePoint& normal : this->Normals)
  {
    normal.normalize();
  }
}

TangentAxes SurfaceWalk::FrameOf(int triangle) const
{
  const auto& v = this->Topology.mesh.triangles[triangle];
  const SpacePoint origin = this->Topology.PositionOf(v[0]);
  TangentAxes inSpace;
  inSpace << this->Topology.PositionOf(v[1]) - origin, this->Topology.PositionOf(v[2]) - origin;
  const Point corner = this->Topology.At(triangle, 0);
  Eigen::Matrix2d inChart;
  inChart << this->Topology.At(triangle, 1) - corner, this->Topology.At(triangle, 2) - corner;
  return inSpace * inChart.inverse();
}

template <typename AtVertex>
SpacePoint SurfaceWalk::Interpolate(const MeshPlace& place, const AtVertex& atVertex) const
{
  const std::array<double, 3> weights = WeightsAt(this->Topology.ChartOf(place.triangle), place.at);
  SpacePoint sum = SpacePoint::Zero();
  for (std::size_t i = 0; i < 3; ++i)
  {
    sum += weights[i] * atVertex(this->Topology.mesh.triangles[place.triangle][i]);
  }
  return sum;
}

SpacePoint SurfaceWalk::PlaceOf(const MeshPlace& place) const
{
  return this->Interpolate(place, [this](int vertex) { return this->Topology.PositionOf(vertex); });
}

SpacePoint SurfaceWalk::NormalAt(const MeshPlace& place) const
{
  return this->Interpolate(place, [this](int vertex) { return this->Normals[vertex]; })
    .normalized();
}

MeshPlace SurfaceWalk::Walk(MeshPlace from, const SpacePoint& step) const
{
  Point rest = this->FrameOf(from.triangle).transpose() * step;
  if (!(rest.norm() > 0.0))
  {
    return from;
  }
  rest *= step.norm() / rest.norm();
  int entered = -1;
  // A straight path meets every triangle a few times at most.
  for (int passed = 0; passed <= 4 * this->Topology.TriangleCount(); ++passed)
  {
    const int triangle = from.triangle;
    const PathExit exit =
      FindExit(this->Topology.ChartOf(triangle), from.at, from.at + rest, entered);
    if (exit.side < 0)
    {
      from.at += rest;
      return from;
    }
    from.at += exit.fraction * rest;
    rest *= 1.0 - exit.fraction;
    const int next = this->Topology.Neighbour(triangle, exit.side);
    if (next < 0)
    {
      return from;
    }
    entered = this->Topology.SideOf(next, this->Topology.EdgeOf(triangle, exit.side));
    // The side has the same ends in both charts, in opposite order.
    const Point own = this->Topology.At(triangle, exit.side);
    const Point other = this->Topology.At(next, (entered + 1) % 3);
    const Point along = this->Topology.At(triangle, (exit.side + 1) % 3) - own;
    const Point alongOther = this->Topology.At(next, entered) - other;
    const double cosine = along.dot(alongOther) / along.squaredNorm();
    const double sine = Cross(along, alongOther) / along.squaredNorm();
    const auto turned = [&](const Point& vector) -> Point
    { return cosine * vector + sine * TurnedLeft(vector); };
    from = { next, other + turned(from.at - own) };
    rest = turned(rest);
  }
  throw Error("A straight path on the surface does not end near " +
    this->Topology.Where(this->Topology.mesh.triangles[from.triangle][0]) + "; use a finer mesh.");
}

MeshPlace SurfaceWalk::Approach(MeshPlace from, const SpacePoint& place) const
{
  // Each walk reduces the distance by a factor of the angle between the triangles at its ends.
  constexpr int Walks = 4;
  for (int walk = 0; walk < Walks; ++walk)
  {
    const SpacePoint rest = place - this->PlaceOf(from);
    const SpacePoint normal = this->Topology.NormalOf(from.triangle);
    from = this->Walk(from, rest - rest.dot(normal) * normal);
  }
  return from;
}
}
