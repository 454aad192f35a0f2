#include "SurfaceCones.h"

#include "Error.h"
#include "PoincareHopf.h"
#include "SurfaceParts.h"
#include "SurfaceTopology.h"
#include "VertexPlacement.h"
#include "VertexPotential.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// A part of a surface with vertices at its singularities.
struct PlacedPart
{
  SurfaceMesh surface;
  std::vector<Cone> cones;
  std::vector<std::string> events;
};

double LongestSide(const SurfaceMesh& surface, int triangle)
{
  const auto& v = surface.triangles[triangle];
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    longest = std::max(longest, (surface.points[v[(i + 1) % 3]] - surface.points[v[i]]).norm());
  }
  return longest;
}

/// Places singularities on vertices of the nearest parts.
std::vector<PlacedPart> PlaceSingularities(
  std::vector<SurfaceMesh> surfaces, const std::vector<SurfaceSingularity>& singularities)
{
  std::vector<PlacedPart> parts(surfaces.size());
  std::vector<VertexPlacement> placements;
  placements.reserve(parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    parts[p].surface = std::move(surfaces[p]);
    placements.emplace_back(parts[p].surface);
  }
  for (std::size_t i = 0; i < singularities.size(); ++i)
  {
    const SurfaceSingularity& one = singularities[i];
    const std::string what =
      "Singularity " + std::to_string(i + 1) + " at " + DescribeInSpace(one.place);
    std::size_t nearest = 0;
    SurfacePoint point;
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      const SurfacePoint here = FindNearest(parts[p].surface, one.place);
      if (p == 0 || here.distance < point.distance)
      {
        nearest = p;
        point = here;
      }
    }
    PlacedPart& part = parts[nearest];
    // The triangles of a curved surface are off it by less.
    if (!(point.distance <= LongestSide(part.surface, point.triangle)))
    {
      throw Error(what + " is " + FormatNumber(point.distance) +
        " off the surface; move it to the nearest point of it, " + DescribeInSpace(point.place) +
        ".");
    }
    if (one.quarterIndex == 0)
    {
      continue;
    }
    const auto placed = placements[nearest].Place(point);
    if (!placed)
    {
      throw Error(
        what + " has no vertex of its own inside the surface; use smaller triangles there.");
    }
    if (placed->distance > 0.0)
    {
      part.events.push_back(what + " is at the vertex " +
        DescribeInSpace(part.surface.points[placed->vertex]) +
        ", since triangles would be too thin otherwise.");
    }
    part.cones.push_back({ placed->vertex, one.quarterIndex, false, static_cast<int>(i) });
  }
  return parts;
}

/// Adds the corners of the boundary, with the quarter indices nearest to their angles, at most 1: maps have no corner
/// without an angle.
void AddCorners(const MeshTopology& topology, std::vector<Cone>& cones)
{
  constexpr int Maximum = 1;
  for (int i = 0; i < static_cast<int>(topology.mesh.boundary.size()); ++i)
  {
    const int vertex = topology.BoundaryAt(i).vertices[0];
    const auto nearest = static_cast<int>(std::lround(topology.turning[i] / (0.5 * Pi)));
    const int quarters = std::min(Maximum, nearest);
    if (topology.corners[vertex] && quarters != 0)
    {
      cones.push_back({ vertex, quarters, true, -1 });
    }
  }
}

/// Adds the numbers and corners of a part.
void AddNumbers(const ConedSurface& part, SurfaceCheck& check)
{
  const MeshTopology& topology = *part.topology;
  check.eulerCharacteristic += topology.edges.EulerCharacteristic(topology.mesh);
  check.requiredQuarters += part.RequiredQuarters();
  check.givenQuarters += part.GivenQuarters();
  check.totalCurvature += topology.charts->curvature.sum() / (2.0 * Pi);
  check.tangentTurning += topology.turning.sum() / (2.0 * Pi);
  const std::vector<int> quarters = QuartersOfVertices(topology, part.cones);
  for (int i = 0; i < static_cast<int>(topology.mesh.boundary.size()); ++i)
  {
    const int vertex = topology.BoundaryAt(i).vertices[0];
    if (quarters[vertex] != 0)
    {
      check.corners.push_back(
        { topology.PositionOf(vertex), Pi - topology.turning[i], quarters[vertex] });
    }
  }
}

int SumOf(const std::vector<Cone>& cones, bool onBoundary)
{
  int sum = 0;
  for (const Cone& cone : cones)
  {
    sum += cone.onBoundary == onBoundary ? cone.quarterIndex : 0;
  }
  return sum;
}
}

int ConedSurface::RequiredQuarters() const
{
  return 4 * this->topology->edges.EulerCharacteristic(this->topology->mesh) -
    SumOf(this->cones, true);
}

int ConedSurface::GivenQuarters() const
{
  return SumOf(this->cones, false);
}

std::string DescribeQuarters(const ConedSurface& part)
{
  const std::string corners = part.topology->loops.empty()
    ? ""
    : " whose corners have " + std::to_string(SumOf(part.cones, true));
  return "The quarter indices of singularities add up to " + std::to_string(part.GivenQuarters()) +
    ", and a surface of Euler characteristic " +
    std::to_string(part.topology->edges.EulerCharacteristic(part.topology->mesh)) + corners +
    " needs " + std::to_string(part.RequiredQuarters()) + "; give singularities with this sum.";
}

ConedSurfaces PlaceCones(SurfaceMesh surface, const std::vector<SurfaceSingularity>& singularities)
{
  SurfaceParts found = FindSurfaceParts(std::move(surface));
  ConedSurfaces result;
  result.events = std::move(found.events);
  for (PlacedPart& part : PlaceSingularities(std::move(found.parts), singularities))
  {
    result.parts.push_back({ std::make_shared<const SurfaceTopology>(std::move(part.surface)),
      std::move(part.cones), std::move(part.events) });
    AddCorners(*result.parts.back().topology, result.parts.back().cones);
  }
  return result;
}

SurfaceCheck CheckSurface(const ConedSurfaces& surfaces)
{
  SurfaceCheck check;
  for (const ConedSurface& part : surfaces.parts)
  {
    AddNumbers(part, check);
  }
  for (std::size_t p = 0; p < surfaces.parts.size(); ++p)
  {
    if (surfaces.parts[p].GivenQuarters() != surfaces.parts[p].RequiredQuarters())
    {
      check.reason = surfaces.parts.size() == 1 ? "" : "Part " + std::to_string(p + 1) + ": ";
      check.reason += DescribeQuarters(surfaces.parts[p]);
      return check;
    }
  }
  check.consistent = true;
  double largest = 0.0;
  for (const ConedSurface& part : surfaces.parts)
  {
    for (const double defect : VertexPotential(part.topology)
                                 .Solve(QuartersOfVertices(*part.topology, part.cones))
                                 .holonomyDefect)
    {
      check.holonomyDefect.push_back(defect);
      largest = std::max(largest, std::abs(defect));
    }
  }
  check.reason = "The quarter indices of singularities and corners add up to 4χ";
  check.reason += largest > NoticeableDefect
    ? "; crosses do not close up around a handle or loop by " + CrossAngle(largest) +
      ", so quads are stretched there."
    : ".";
  return check;
}
}
