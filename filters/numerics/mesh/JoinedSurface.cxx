#include "JoinedSurface.h"

#include <utility>

namespace crossfield
{
JoinedSurface::JoinedSurface(TriangleMesh triangles, const std::vector<SharedTopology>& parts)
  : MeshTopology(std::move(triangles), false)
{
  TriangleCharts& all = this->charts.emplace();
  all.curvature.resize(this->VertexCount());
  Eigen::Index vertices = 0;
  Eigen::Index boundary = 0;
  for (const SharedTopology& part : parts)
  {
    const TriangleCharts& own = *part->charts;
    all.positions.insert(all.positions.end(), own.positions.begin(), own.positions.end());
    all.corners.insert(all.corners.end(), own.corners.begin(), own.corners.end());
    all.hinges.insert(all.hinges.end(), own.hinges.begin(), own.hinges.end());
    all.curvature.segment(vertices, own.curvature.size()) = own.curvature;
    this->turning.segment(boundary, part->turning.size()) = part->turning;
    for (int vertex = 0; vertex < part->VertexCount(); ++vertex)
    {
      this->corners[static_cast<std::size_t>(vertices + vertex)] = part->corners[vertex];
    }
    vertices += own.curvature.size();
    boundary += part->turning.size();
  }
}
}
