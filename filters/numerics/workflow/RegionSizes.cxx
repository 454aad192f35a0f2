#include "RegionSizes.h"

#include "BoundarySingularities.h"
#include "HField.h"
#include "MeshForPoints.h"
#include "P1Interpolation.h"
#include "PoincareHopf.h"
#include "SegmentSearch.h"
#include "SizeExtension.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace crossfield
{
namespace
{
/// Returns the quarter index that a boundary has by the smallest rotation at one of its vertices; 0 if
/// there is none.
int OutlineIndexAt(const PlanarDomain& outline, const Point& place)
{
  for (std::size_t l = 0; l < outline.loops.size(); ++l)
  {
    const Loop& loop = outline.loops[l];
    const auto found = std::find(loop.begin(), loop.end(), place);
    if (found != loop.end())
    {
      return SmallestRotationIndex(
        MakeCorner(outline.loops, l, static_cast<std::size_t>(found - loop.begin())).Turning());
    }
  }
  return 0;
}

/// Returns whether a corner of a region is at a node.
bool IsAtNode(const std::vector<std::vector<RegionCorner>>& nodeCorners, const Point& place)
{
  return std::any_of(nodeCorners.begin(), nodeCorners.end(),
    [&place](const std::vector<RegionCorner>& corners)
    {
      return std::any_of(corners.begin(), corners.end(),
        [&place](const RegionCorner& one) { return one.corner.position == place; });
    });
}
}

SizeTargets JoinTargets(const LaidOutRegions& regions)
{
  struct Sized
  {
    SegmentSearch boundary;
    SizeFunction length;
  };
  auto all = std::make_shared<std::vector<Sized>>();
  double area = 0.0;
  double quads = 0.0;
  for (const LaidOutRegion& region : regions)
  {
    const double own = region.domain.Area();
    const double mean = region.request.targets ? region.request.targets->mean
      : region.request.quadSize > 0.0          ? region.request.quadSize
                                               : std::sqrt(own / region.request.quadCount);
    all->push_back({ SegmentSearch(region.domain),
      region.request.targets ? region.request.targets->length
                             : SizeFunction([mean](const Point&) { return mean; }) });
    area += own;
    quads += own / (mean * mean);
  }
  SizeTargets joined;
  joined.mean = std::sqrt(area / quads);
  joined.length = [all](const Point& place)
  {
    const Sized* nearest = nullptr;
    double largest = 0.0;
    for (const Sized& one : *all)
    {
      const double distance = one.boundary.SignedDistance(place);
      if (nearest == nullptr || distance > largest)
      {
        largest = distance;
        nearest = &one;
      }
    }
    return nearest->length(place);
  };
  return joined;
}

SizeFunction CommonSizes(const RegionSet& set,
  const std::vector<std::vector<RegionCorner>>& nodeCorners, const LaidOutRegions& regions,
  double meshSize)
{
  struct Part
  {
    SegmentSearch boundary;
    P1Interpolation sizes;
  };
  auto all = std::make_shared<std::vector<Part>>();
  for (const PlanarDomain& outline : set.outlines)
  {
    const SegmentSearch boundary(outline);
    const double reach = BoundaryReach * outline.Diagonal();
    Configuration singularities;
    std::vector<CornerChoice> corners;
    std::vector<Point> kept; // nodes with another index than their angle has
    const auto addCorner = [&](const CornerChoice& choice)
    {
      if (std::abs(boundary.SignedDistance(choice.position)) <= reach)
      {
        corners.push_back(choice);
      }
    };
    for (std::size_t n = 0; n < set.nodes.size(); ++n)
    {
      const RegionNode& node = set.nodes[n];
      const int index = IndexAt(node, nodeCorners[n]);
      if (node.isOnBoundary)
      {
        if (index != OutlineIndexAt(outline, node.place))
        {
          addCorner({ node.place, index });
          kept.push_back(node.place);
        }
      }
      else if (index != 0 && boundary.SignedDistance(node.place) > 0.0)
      {
        singularities.push_back({ node.place, index });
      }
    }
    for (const LaidOutRegion& region : regions)
    {
      const SegmentSearch own(region.domain);
      for (const Singularity& one : region.result.singularities)
      {
        // One on the boundary of the region is part of the index of its corner.
        if (own.SignedDistance(one.position) > reach &&
          boundary.SignedDistance(one.position) > reach)
        {
          singularities.push_back(one);
        }
      }
      for (const CornerChoice& choice : region.result.corners)
      {
        if (IsAtNode(nodeCorners, choice.position))
        {
          continue;
        }
        if (boundary.SignedDistance(choice.position) <= reach)
        {
          addCorner(choice);
          kept.push_back(choice.position);
        }
        else if (choice.quarterIndex != 0) // on an interface, which is smooth on its other side
        {
          singularities.push_back({ choice.position, choice.quarterIndex });
        }
      }
    }
    // Singularities of regions may have been moved between two vertices of the outline.
    Configuration onBoundary;
    for (const CornerChoice& corner : corners)
    {
      onBoundary.push_back({ corner.position, corner.quarterIndex });
    }
    const SharedPlanarTopology topology = ShareTopology(MeshThroughPoints(
      InsertBoundarySingularities(outline, onBoundary), singularities, meshSize, {}, 1.0, kept));
    const Eigen::VectorXd sizes =
      SolveHField(topology, singularities, corners).h.array().exp().matrix();
    const double mean = EquivalentSize(topology->mesh, sizes);
    all->push_back({ boundary, P1Interpolation(topology->mesh, sizes / mean) });
  }
  return [all](const Point& place)
  {
    const Part* inside = &all->front();
    for (std::size_t i = 1; i < all->size(); ++i)
    {
      const Part& part = (*all)[i];
      if (part.boundary.SignedDistance(place) > inside->boundary.SignedDistance(place))
      {
        inside = &part;
      }
    }
    return inside->sizes.At(place);
  };
}
}
