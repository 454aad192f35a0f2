#include "NodePositions.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace crossfield
{
namespace
{
/// Node of a singularity and the mean length of the edges there.
struct Node
{
  const QuadPoint* point = nullptr; ///< Null if the singularity has no node of its own.
  double edge = 0.0;
};

/// Returns the node of each of a number of singularities.
std::vector<Node> FindNodes(const SeamlessMap& map, const QuadMesh& mesh, std::size_t count)
{
  std::vector<Node> nodes(count);
  for (const std::array<int, 4>& quad : mesh.quads)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      const QuadPoint& point = mesh.points[quad[i]];
      const int row = point.cone < 0 ? -1 : map.cones[point.cone].row;
      if (row >= 0)
      {
        // Each quad adds the edge that follows; the one before belongs to its neighbour.
        const QuadPoint& next = mesh.points[quad[(i + 1) % 4]];
        Node& node = nodes[row];
        node.point = &point;
        node.edge += (next.place - point.place).norm() / point.valence;
      }
    }
  }
  return nodes;
}

std::string DescribeMove(std::size_t row, const SpacePoint& from, const SpacePoint& to, double edge)
{
  std::ostringstream text;
  text.precision(3);
  text << "Singularity " << row + 1 << " moved by " << (to - from).norm() << ", "
       << (to - from).norm() / edge << " quads, from " << DescribePlace(from) << " to its node at "
       << DescribePlace(to) << ".";
  return text.str();
}
}

std::vector<SingularityMove> FindMoves(
  const Configuration& from, const Configuration& to, double extent)
{
  constexpr double Rounding = 1e-9; // of the extent; coordinates of files have as many digits
  std::vector<SingularityMove> moves;
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    const SingularityMove move{ i, from[i].position, to[i].position };
    if (move.Distance() > Rounding * extent)
    {
      moves.push_back(move);
    }
  }
  return moves;
}

NodePlaces FindNodePlaces(const SeamlessMap& map, const QuadMesh& mesh,
  std::vector<SpacePoint> places, const std::vector<SpacePoint>& start)
{
  constexpr double Noticeable = 0.1; // of an edge
  NodePlaces result;
  const std::vector<Node> nodes = FindNodes(map, mesh, places.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const Node& node = nodes[i];
    places[i] = node.point == nullptr ? places[i] : node.point->place;
    const double moved = (places[i] - start[i]).norm();
    result.moved = std::max(result.moved, moved);
    if (node.point != nullptr && moved > Noticeable * node.edge)
    {
      result.events.push_back(DescribeMove(i, start[i], places[i], node.edge));
    }
  }
  result.places = std::move(places);
  return result;
}

NodePositions FindNodePositions(const SeamlessMap& map, const QuadMesh& mesh,
  const Configuration& singularities, const Configuration& start)
{
  const auto placesOf = [](const Configuration& configuration)
  {
    std::vector<SpacePoint> places;
    for (const Singularity& one : configuration)
    {
      places.emplace_back(one.position.x(), one.position.y(), 0.0);
    }
    return places;
  };
  NodePlaces nodes = FindNodePlaces(map, mesh, placesOf(singularities), placesOf(start));
  NodePositions result{ singularities, nodes.moved, std::move(nodes.events) };
  for (std::size_t i = 0; i < singularities.size(); ++i)
  {
    result.singularities[i].position = nodes.places[i].head<2>();
  }
  return result;
}
}
