#include "PeriodicEdges.h"

#include "Error.h"
#include "Index.h"
#include "NodeImages.h"

#include <array>
#include <map>

namespace crossfield
{
namespace
{
/// Returns the ends of the edges of a side: starts and ends in turn.
std::vector<int> EndsOf(const StraightQuads& quads, int side)
{
  std::vector<int> ends;
  for (const StraightEdge& edge : quads.edges)
  {
    if (edge.side == side)
    {
      ends.insert(ends.end(), edge.points.begin(), edge.points.end());
    }
  }
  return ends;
}
}

std::vector<int> MatchEdges(const StraightQuads& quads)
{
  std::vector<int> masters(quads.edges.size(), -1);
  if (quads.periodic.empty())
  {
    return masters;
  }
  std::vector<Eigen::Vector3d> points;
  for (const Point& point : quads.points)
  {
    points.emplace_back(point.x(), point.y(), 0.0);
  }
  std::map<std::array<int, 2>, std::size_t> edgeOf; // by its ends
  for (std::size_t e = 0; e < quads.edges.size(); ++e)
  {
    edgeOf[quads.edges[e].points] = e;
  }
  for (const PairedSides& pair : quads.periodic)
  {
    Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
    motion.topLeftCorner<2, 2>() = pair.motion.Rotation();
    motion.block<2, 1>(0, 3) = pair.motion.shift;
    const std::vector<int> ends = EndsOf(quads, pair.first);
    const std::vector<int> images = FindImages(points, motion, ends, EndsOf(quads, pair.second));
    for (std::size_t i = 0; i < ends.size(); i += 2)
    {
      const auto image = edgeOf.find({ images[i + 1], images[i] });
      if (image == edgeOf.end() || quads.edges[image->second].side != pair.second)
      {
        throw Error("The periodic edge near " + Describe(quads.points[Index(ends[i])]) +
          " has no image on the other side; make the quads again, or remove the field data "
          "PeriodicSides.");
      }
      masters[image->second] = static_cast<int>(edgeOf.at({ ends[i], ends[i + 1] }));
    }
  }
  return masters;
}
}
