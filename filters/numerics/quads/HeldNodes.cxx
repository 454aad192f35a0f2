#include "HeldNodes.h"

#include "BoundaryCorners.h"
#include "Error.h"
#include "Index.h"
#include "RegionSet.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace crossfield
{
namespace
{
double ExtentOf(const QuadMesh& mesh)
{
  Eigen::AlignedBox2d box;
  for (const QuadPoint& point : mesh.points)
  {
    box.extend(point.InPlane());
  }
  return box.diagonal().norm();
}

/// Returns the position on the boundary at a place, with loop −1 if there is none.
CurvePlace BoundaryAt(const MeshBoundary& curves, const Point& place, double reach)
{
  for (int loop = 0; loop < static_cast<int>(curves.GetArcs().size()); ++loop)
  {
    const CurvePlace nearest = curves.Nearest(loop, place);
    if ((curves.At(nearest) - place).norm() <= reach)
    {
      return nearest;
    }
  }
  return {};
}

/// Returns the length of the longest edge of each point.
std::vector<double> LongestEdges(const QuadMesh& mesh)
{
  std::vector<double> longest(mesh.points.size(), 0.0);
  for (const std::array<int, 4>& quad : mesh.quads)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      const std::size_t a = Index(quad[c]);
      const std::size_t b = Index(quad[(c + 1) % 4]);
      const double length = (mesh.points[a].InPlane() - mesh.points[b].InPlane()).norm();
      longest[a] = std::max(longest[a], length);
      longest[b] = std::max(longest[b], length);
    }
  }
  return longest;
}
}

void PlaceNodes(const MeshBoundary& curves, const std::vector<Point>& places, QuadMesh& mesh)
{
  if (places.empty())
  {
    return;
  }
  const double extent = ExtentOf(mesh);
  const double reach = BoundaryReach * extent;
  const bool hasSlits = std::any_of(mesh.periodic.begin(), mesh.periodic.end(),
    [](const PairedSides& pair) { return pair.spans.has_value(); });
  const double fromBoundary = hasSlits ? SlitWidth * extent : reach; // slits are still open
  const std::vector<double> longest = LongestEdges(mesh);
  for (const Point& place : places)
  {
    const CurvePlace onBoundary = BoundaryAt(curves, place, fromBoundary);
    std::size_t best = 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      const QuadPoint& point = mesh.points[p];
      const double distance = (point.InPlane() - place).norm();
      const bool mayMove = !point.fixed && point.cone < 0 && point.curve.loop == onBoundary.loop;
      if (distance < smallest && (mayMove || distance <= reach))
      {
        smallest = distance;
        best = p;
      }
    }
    if (smallest > longest[best])
    {
      throw Error("There is no node for the place " + Describe(place) +
        ": the nearest one that may move is farther away than one quad; use smaller quads there, "
        "or leave one of several places out that are near each other.");
    }
    QuadPoint& node = mesh.points[best];
    node.fixed = node.held = true;
    if (smallest > reach)
    {
      node.MoveTo(place);
      node.curve = onBoundary;
    }
  }
}

std::string DescribeMissedPlaces(const std::vector<Point>& places, const QuadMesh& mesh)
{
  const double reach = BoundaryReach * ExtentOf(mesh);
  std::string missed;
  for (const Point& place : places)
  {
    const bool isNode = std::any_of(mesh.points.begin(), mesh.points.end(),
      [&](const QuadPoint& point) { return (point.InPlane() - place).norm() <= reach; });
    missed += isNode ? "" : (missed.empty() ? "" : ", ") + Describe(place);
  }
  return missed.empty() ? missed
                        : "No node is at " + missed +
      ", as requested, because later steps, such as layers, move nodes there.";
}
}
