#include "MeshBoundary.h"

namespace crossfield
{
namespace
{
std::vector<ClosedPolyline<SpacePoint>> LoopsInSpace(const MeshTopology& topology)
{
  std::vector<ClosedPolyline<SpacePoint>> loops;
  for (const std::vector<int>& vertices : topology.alignedVertices)
  {
    std::vector<SpacePoint> places;
    places.reserve(vertices.size());
    for (const int vertex : vertices)
    {
      places.push_back(topology.PositionOf(vertex));
    }
    loops.emplace_back(std::move(places));
  }
  return loops;
}
}

MeshBoundary::MeshBoundary(const PlanarTopology& topology, const CurvedBoundary& boundary)
  : BoundaryCurves(topology.AlignedLoops(), boundary)
  , Topology(topology)
{
  this->NumberSides();
}

MeshBoundary::MeshBoundary(const MeshTopology& topology)
  : BoundaryCurves(LoopsInSpace(topology))
  , Topology(topology)
{
  this->NumberSides();
  for (const std::vector<int>& positions : this->Positions)
  {
    std::vector<int>& triangles = this->Triangles.emplace_back();
    for (const int position : positions)
    {
      triangles.push_back(topology.SideOfBoundary(position).first);
    }
  }
}

void MeshBoundary::NumberSides()
{
  const MeshTopology& topology = this->Topology;
  this->LoopAndEdge.assign(topology.mesh.boundary.size(), { -1, 0 });
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
  const double start = this->StartOf(loop, edge);
  return { loop, start + fraction * (this->StartOf(loop, edge + 1) - start) };
}

std::vector<CurvePlace> MeshBoundary::Corners() const
{
  std::vector<CurvePlace> places;
  for (std::size_t l = 0; l < this->Topology.alignedVertices.size(); ++l)
  {
    const std::vector<int>& vertices = this->Topology.alignedVertices[l];
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      if (this->Topology.corners[vertices[i]])
      {
        const auto loop = static_cast<int>(l);
        places.push_back({ loop, this->StartOf(loop, i) });
      }
    }
  }
  return places;
}

int MeshBoundary::PositionAt(const CurvePlace& place) const
{
  return this->Positions[place.loop][this->SideAt(place)];
}
}
