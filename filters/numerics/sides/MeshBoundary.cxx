#include "MeshBoundary.h"

namespace crossfield
{
MeshBoundary::MeshBoundary(const PlanarTopology& topology, const CurvedBoundary& boundary)
  : BoundaryCurves(topology.AlignedLoops(), boundary)
  , Topology(topology)
  , LoopAndEdge(topology.mesh.boundary.size(), { -1, 0 })
{
  std::vector<int> positionAt(topology.mesh.points.size(), -1);
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    positionAt[topology.mesh.boundary[i].vertices[0]] = static_cast<int>(i);
  }
  for (std::size_t l = 0; l < topology.alignedVertices.size(); ++l)
  {
    std::vector<int> positions;
    for (const int vertex : topology.alignedVertices[l])
    {
      const int position = positionAt[vertex];
      this->LoopAndEdge[position] = { static_cast<int>(l), positions.size() };
      positions.push_back(position);
    }
    this->Positions.push_back(std::move(positions));
  }
}

CurvePlace MeshBoundary::Place(int boundaryPosition, double fraction) const
{
  const auto& [loop, edge] = this->LoopAndEdge[boundaryPosition];
  const LoopArc& arc = this->ArcOf(loop);
  return { loop, arc.Start(edge) + fraction * (arc.Start(edge + 1) - arc.Start(edge)) };
}

std::vector<CurvePlace> MeshBoundary::Corners() const
{
  std::vector<CurvePlace> places;
  for (std::size_t l = 0; l < this->GetArcs().size(); ++l)
  {
    const std::vector<int>& vertices = this->Topology.alignedVertices[l];
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      if (this->Topology.corners[vertices[i]])
      {
        places.push_back({ static_cast<int>(l), this->GetArcs()[l].Start(i) });
      }
    }
  }
  return places;
}

int MeshBoundary::PositionAt(const CurvePlace& place) const
{
  return this->Positions[place.loop][this->ArcOf(place.loop).SideAt(place.at).first];
}
}
