#include "TangentFrames.h"

#include "Index.h"
#include "Parts.h"

namespace crossfield
{
TangentFrames::TangentFrames(const QuadMesh& mesh, const SurfaceWalk* surface)
  : Surface(surface)
{
  if (surface == nullptr)
  {
    return;
  }
  std::vector<SpacePoint> normals(mesh.points.size());
  this->Points.resize(mesh.points.size());
  ForRanges(static_cast<std::ptrdiff_t>(mesh.points.size()),
    [&](int begin, int end)
    {
      for (std::size_t p = Index(begin); p < Index(end); ++p)
      {
        PointFrame& frame = this->Points[p];
        frame.origin = mesh.points[p].place;
        frame.place = surface->Find(mesh.points[p].triangle, frame.origin);
        normals[p] = surface->NormalAt(frame.place);
        frame.axes = AxesOf(normals[p]);
      }
    });
  this->Quads.resize(mesh.quads.size());
  ForRanges(static_cast<std::ptrdiff_t>(mesh.quads.size()),
    [&](int begin, int end)
    {
      for (std::size_t q = Index(begin); q < Index(end); ++q)
      {
        SpacePoint normal = SpacePoint::Zero();
        for (const int p : mesh.quads[q])
        {
          normal += normals[p];
        }
        const TangentAxes axes = AxesOf(normal.normalized());
        const SpacePoint& origin = this->Points[mesh.quads[q][0]].origin;
        for (std::size_t c = 0; c < 4; ++c)
        {
          const PointFrame& frame = this->Points[mesh.quads[q][c]];
          this->Quads[q][c] = { axes.transpose() * (frame.origin - origin),
            axes.transpose() * frame.axes };
        }
      }
    });
}

double TangentFrames::Move(int point, const Point& coordinates, QuadPoint& moved) const
{
  if (this->Surface == nullptr)
  {
    moved.MoveTo(coordinates);
    return 0.0;
  }
  const PointFrame& frame = this->Points[point];
  if (coordinates.isZero(0.0))
  {
    moved.place = frame.origin;
    moved.triangle = frame.place.triangle;
    return 0.0;
  }
  const SpacePoint step = frame.axes * coordinates;
  const MeshPlace reached = this->Surface->Walk(frame.place, step);
  moved.place = this->Surface->PlaceOf(reached);
  moved.triangle = reached.triangle;
  return (moved.place - (frame.origin + step)).norm();
}

void TangentFrames::MoveTo(int point, const SpacePoint& place, QuadPoint& moved) const
{
  moved.place = place;
  if (this->Surface != nullptr)
  {
    moved.triangle = this->Surface->Approach(this->Points[point].place, place).triangle;
  }
}

std::vector<SpacePoint> NormalsAtPoints(const SurfaceWalk& surface, const QuadMesh& mesh)
{
  std::vector<SpacePoint> normals;
  normals.reserve(mesh.points.size());
  for (const QuadPoint& point : mesh.points)
  {
    normals.push_back(surface.NormalAt(surface.Find(point.triangle, point.place)));
  }
  return normals;
}

void SetNormals(const SurfaceWalk& surface, QuadMesh& mesh)
{
  const std::vector<SpacePoint> normals = NormalsAtPoints(surface, mesh);
  mesh.normals.assign(mesh.quads.size(), SpacePoint::Zero());
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    for (const int p : mesh.quads[q])
    {
      mesh.normals[q] += normals[p];
    }
    mesh.normals[q].normalize();
  }
}
}
