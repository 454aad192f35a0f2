#include "NodePositions.h"

#include <algorithm>
#include <sstream>

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

std::string DescribeMove(std::size_t row, const Point& from, const Point& to, double edge)
{
  std::ostringstream text;
  text.precision(3);
  text << "Singularity " << row + 1 << " moved by " << (to - from).norm() << ", "
       << (to - from).norm() / edge << " quads, from " << Describe(from) << " to its node at "
       << Describe(to) << ".";
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

NodePositions FindNodePositions(const SeamlessMap& map, const QuadMesh& mesh,
  const Configuration& singularities, const Configuration& start)
{
  constexpr double Noticeable = 0.1; // of an edge
  NodePositions result;
  result.singularities = singularities;
  const std::vector<Node> nodes = FindNodes(map, mesh, singularities.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    Point& position = result.singularities[i].position;
    if (nodes[i].point != nullptr)
    {
      position = nodes[i].point->InPlane();
    }
    const double moved = (position - start[i].position).norm();
    result.moved = std::max(result.moved, moved);
    if (nodes[i].point != nullptr && moved > Noticeable * nodes[i].edge)
    {
      result.events.push_back(DescribeMove(i, start[i].position, position, nodes[i].edge));
    }
  }
  return result;
}
}
