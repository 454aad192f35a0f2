#include "SurfaceQualityMeasure.h"

#include "TangentFrames.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace crossfield
{
SurfaceQuality MeasureOnSurface(const SurfaceWalk& surface, const QuadMesh& mesh)
{
  constexpr double LeastCosine = 0.5; // of 60°
  const std::vector<SpacePoint> normals = NormalsAtPoints(surface, mesh);
  SurfaceQuality quality;
  double smallestCosine = 1.0;
  double distances = 0.0;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    const std::array<int, 4>& quad = mesh.quads[q];
    const auto at = [&](std::size_t c) -> const SpacePoint&
    { return mesh.points[quad[c % 4]].place; };
    const SpacePoint centre = 0.25 * (at(0) + at(1) + at(2) + at(3));
    double cosine = 1.0;
    for (std::size_t c = 0; c < 4; ++c)
    {
      const SpacePoint next = at(c + 1) - at(c);
      const SpacePoint last = at(c + 3) - at(c);
      quality.minimumJacobian = std::min(quality.minimumJacobian,
        next.cross(last).dot(mesh.normals[q]) / std::sqrt(next.squaredNorm() * last.squaredNorm()));
      for (std::size_t other = 0; other < c; ++other)
      {
        cosine = std::min(cosine, normals[quad[c]].dot(normals[quad[other]]));
      }
    }
    quality.bent += cosine < LeastCosine ? 1 : 0;
    if (cosine < smallestCosine)
    {
      smallestCosine = cosine;
      quality.mostBent = centre;
    }
    // A search from one corner can end on another face, if the corner is on a sharp edge of a thin part.
    double distance = std::numeric_limits<double>::infinity();
    for (const int corner : quad)
    {
      const MeshPlace nearest = surface.Find(mesh.points[corner].triangle, centre);
      distance = std::min(distance, (surface.PlaceOf(nearest) - centre).norm());
    }
    distances += distance;
    quality.maximumDistance = std::max(quality.maximumDistance, distance);
  }
  quality.meanDistance = distances / static_cast<double>(mesh.quads.size());
  return quality;
}
}
