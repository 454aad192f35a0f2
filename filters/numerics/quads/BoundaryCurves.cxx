#include "BoundaryCurves.h"

#include "Index.h"

#include <utility>

namespace crossfield
{
BoundaryCurves::BoundaryCurves(const PlanarTopology& topology, const CurvedBoundary& boundary)
  : Topology(topology)
  , LoopAndEdge(topology.mesh.boundary.size(), { -1, 0 })
{
  std::vector<int> positionAt(topology.mesh.points.size(), -1);
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    positionAt[Index(topology.mesh.boundary[i].vertices[0])] = static_cast<int>(i);
  }
  for (const Loop& loop : topology.AlignedLoops())
  {
    this->Arcs.emplace_back(loop);
  }
  for (std::size_t l = 0; l < this->Arcs.size(); ++l)
  {
    std::vector<int> positions;
    for (const int vertex : topology.alignedVertices[l])
    {
      const int position = positionAt[Index(vertex)];
      this->LoopAndEdge[Index(position)] = { static_cast<int>(l), positions.size() };
      positions.push_back(position);
    }
    this->Positions.push_back(std::move(positions));
  }
  this->Curved = CurvedLoops(boundary, this->Arcs);
}

CurvePlace BoundaryCurves::Place(int boundaryPosition, double fraction) const
{
  const auto& [loop, edge] = this->LoopAndEdge[Index(boundaryPosition)];
  const LoopArc& arc = this->ArcOf(loop);
  return { loop, arc.Start(edge) + fraction * (arc.Start(edge + 1) - arc.Start(edge)) };
}

Point BoundaryCurves::At(const CurvePlace& place) const
{
  return this->Curved.At(this->ArcOf(place.loop), Index(place.loop), place.at);
}

CurvePlace BoundaryCurves::Nearest(int loop, const Point& point) const
{
  return { loop, this->Curved.Nearest(this->ArcOf(loop), Index(loop), point) };
}

Point BoundaryCurves::Tangent(const CurvePlace& place) const
{
  return this->Curved.Derivative(this->ArcOf(place.loop), Index(place.loop), place.at);
}

int BoundaryCurves::CurveAt(const CurvePlace& place) const
{
  return this->Curved.CurveAt(this->ArcOf(place.loop), Index(place.loop), place.at);
}

std::vector<CurvePlace> BoundaryCurves::Corners() const
{
  std::vector<CurvePlace> places;
  for (std::size_t l = 0; l < this->Arcs.size(); ++l)
  {
    const std::vector<int>& vertices = this->Topology.alignedVertices[l];
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      if (this->Topology.corners[Index(vertices[i])])
      {
        places.push_back({ static_cast<int>(l), this->Arcs[l].Start(i) });
      }
    }
  }
  return places;
}

int BoundaryCurves::PositionAt(const CurvePlace& place) const
{
  return this->Positions[Index(place.loop)][this->ArcOf(place.loop).SideAt(place.at).first];
}
}
