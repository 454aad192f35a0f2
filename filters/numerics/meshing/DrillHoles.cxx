#include "DrillHoles.h"

#include "BoundarySingularities.h"
#include "CanonicalFrame.h"
#include "CompleteSector.h"
#include "DomainQueries.h"
#include "Error.h"
#include "HoleRadii.h"
#include "MemoryBudget.h"
#include "MeshBudget.h"
#include "NarrowParts.h"
#include "PlanarMesher.h"
#include "TriangleChoice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace crossfield
{
namespace
{
std::string Describe(std::size_t row, const Singularity& singularity)
{
  return "singularity " + std::to_string(row + 1) + " at " +
    crossfield::Describe(singularity.position);
}

void CheckSingularity(std::size_t row, const Singularity& singularity)
{
  if (!singularity.position.allFinite() || !std::isfinite(singularity.radius))
  {
    throw Error("Row " + std::to_string(row + 1) +
      " of the singularities has a coordinate or radius that is not a finite number; correct it.");
  }
  if (!(singularity.radius > 0.0))
  {
    throw Error("The hole of " + Describe(row, singularity) +
      " has a radius that is not positive; give a positive radius.");
  }
}

void CheckPlacement(const PlanarDomain& domain, const Configuration& configuration)
{
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    const Singularity& here = configuration[i];
    CheckSingularity(i, here);
    if (IsOnBoundary(domain, here.position))
    {
      continue;
    }
    const double distance = SignedDistance(here.position, domain);
    std::ostringstream text;
    text.precision(4);
    // The points of a smaller hole would coincide after rounding.
    const double smallest = 1e-9 * domain.Diagonal();
    if (here.radius < smallest)
    {
      text << "The hole of " << Describe(i, here) << " has a radius of " << here.radius
           << "; give at least " << FormatNumber(smallest) << ", 1e-9 of the domain's diagonal.";
      throw Error(text.str());
    }
    if (distance < 0.0)
    {
      text << "The hole of " << Describe(i, here) << " lies outside the domain; move it inside.";
      throw Error(text.str());
    }
    if (distance <= here.radius)
    {
      text << "The hole of " << Describe(i, here) << " with radius " << here.radius
           << " cuts the boundary, which is only " << distance
           << " away; move it inside or make it smaller.";
      throw Error(text.str());
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      const double apart = (here.position - configuration[j].position).norm();
      if (apart <= here.radius + configuration[j].radius &&
        !IsOnBoundary(domain, configuration[j].position))
      {
        text << "Two holes overlap: the centres of " << Describe(j, configuration[j]) << " and "
             << Describe(i, here) << " are " << apart << " apart and their radii add up to "
             << here.radius + configuration[j].radius << "; move them apart or make them smaller.";
        throw Error(text.str());
      }
    }
  }
}

/// Returns the number of edges of a hole; see DrillOptions::minimumHoleEdges.
int HoleEdges(std::size_t row, const Singularity& hole, double meshSize, int minimum)
{
  const double edges =
    std::max({ static_cast<double>(minimum), 8.0 * std::abs(static_cast<double>(hole.quarterIndex)),
      std::ceil(2.0 * Pi * hole.radius / meshSize) });
  // At the minimum, the mesh has a ring of triangles around the hole, two for each edge.
  RequireMemory(2.0 * edges * MeshBytesPerTriangle,
    "The hole of " + Describe(row, hole) + " with " + std::to_string(std::llround(edges)) +
      " edges",
    "give a smaller quarter index or fewer edges");
  if (edges > std::numeric_limits<int>::max())
  {
    throw Error("The hole of " + Describe(row, hole) +
      " would have more edges than can be "
      "numbered; give a smaller quarter index or fewer edges.");
  }
  return static_cast<int>(edges);
}

/// Returns the polygon of a hole, clockwise, so that the domain is on its left. The first vertex is
/// in the direction `start`.
Loop HolePolygon(const Singularity& singularity, int edges, double start)
{
  Loop polygon;
  for (int i = 0; i < edges; ++i)
  {
    const double angle = start - 2.0 * Pi * i / edges;
    polygon.push_back(
      singularity.position + singularity.radius * Point(std::cos(angle), std::sin(angle)));
  }
  return polygon;
}

/// Returns the marks of the loops of a domain: outer loop, inner loops.
std::vector<BoundaryEdge> LoopMarks(const PlanarDomain& domain)
{
  std::vector<BoundaryEdge> marks;
  for (std::size_t i = 0; i < domain.loops.size(); ++i)
  {
    marks.push_back(
      { { 0, 0 }, i == 0 ? BoundaryKind::Outer : BoundaryKind::Inner, static_cast<int>(i), 0 });
  }
  return marks;
}

/// Throws Error if coordinates are too coarse for the shortest edges: rounding a vertex must not
/// rotate an edge by more than about a thousandth of a radian.
void RequireResolution(
  const std::vector<SizeSource>& sources, double meshSize, const Eigen::AlignedBox2d& box)
{
  constexpr double RoundingsPerEdge = 1000.0;
  double smallest = meshSize;
  for (const SizeSource& source : sources)
  {
    smallest = std::min(smallest, source.size);
  }
  const double reach = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  const double rounding = std::numeric_limits<double>::epsilon() * reach;
  if (smallest < RoundingsPerEdge * rounding)
  {
    std::ostringstream text;
    text.precision(3);
    text << "The mesh needs edges of " << smallest << ", but coordinates as large as " << reach
         << " are rounded by " << rounding
         << "; move the domain to the origin, or use larger holes, segments or mesh sizes.";
    throw Error(text.str());
  }
}

/// Returns the size sources of the boundary: short segments require small triangles around them.
std::vector<SizeSource> BoundarySources(const PlanarDomain& domain)
{
  std::vector<SizeSource> sources;
  for (const Loop& loop : domain.loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const double before = (loop[i] - loop[(i + loop.size() - 1) % loop.size()]).norm();
      const double after = (loop[(i + 1) % loop.size()] - loop[i]).norm();
      sources.push_back({ loop[i], std::min(before, after) });
    }
  }
  return sources;
}

Eigen::AlignedBox2d BoxOf(const Loop& loop)
{
  Eigen::AlignedBox2d box;
  for (const Point& point : loop)
  {
    box.extend(point);
  }
  return box;
}

/// Builds the size field of a domain, in the coordinates of a frame, from the sources of the
/// options and of the boundary and, on request, of narrow parts.
SizeField MakeSizeField(const PlanarDomain& given, double meshSize, const DrillOptions& options,
  const CanonicalFrame& frame)
{
  const PlanarDomain domain{ frame.ToFrame(given.loops) };
  std::vector<SizeSource> sources = options.refinements;
  for (SizeSource& source : sources)
  {
    source.position = frame.ToFrame(source.position);
  }
  const std::vector<SizeSource> boundary = BoundarySources(domain);
  sources.insert(sources.end(), boundary.begin(), boundary.end());
  const Eigen::AlignedBox2d box = BoxOf(domain.loops[0]);
  for (SizeSource& source : sources)
  {
    source.size /= options.refinement;
  }
  meshSize /= options.refinement;
  const auto makeField = [&]
  {
    RequireResolution(sources, meshSize, BoxOf(given.loops[0]));
    if (options.gradation > 0.0) // otherwise SizeField throws
    {
      RequireMemoryForMesh(domain, sources, meshSize, options.gradation);
    }
    return SizeField(sources, meshSize, options.gradation, box);
  };
  SizeField size = makeField();
  if (options.edgesAcross > 0.0)
  {
    // A thousandth is fine enough for any narrow part and bounds the number of triangles.
    const std::vector<SizeSource> narrow =
      FindNarrowParts(domain, size, options.edgesAcross * options.refinement, 1e-3 * meshSize);
    if (!narrow.empty())
    {
      sources.insert(sources.end(), narrow.begin(), narrow.end());
      size = makeField();
    }
  }
  return size;
}
}

double ResolveMeshSize(const DrillOptions& options, const PlanarDomain& domain)
{
  if (options.meshSize < 0.0 || !std::isfinite(options.meshSize))
  {
    throw Error("The mesh size must be positive, or 0 for 1/40 of the domain's diagonal.");
  }
  return options.meshSize > 0.0 ? options.meshSize : domain.Diagonal() / 40.0;
}

TriangleMesh DrillHoles(const PlanarDomain& domain, const Configuration& configuration,
  const DrillOptions& options, const Progress& progress)
{
  const CanonicalFrame frame(domain.loops);
  const double meshSize = ResolveMeshSize(options, domain);
  // before anything of that size is allocated
  RequireMemoryForMesh(domain, {}, meshSize, options.gradation);
  if (options.minimumHoleEdges < 3)
  {
    throw Error("A hole needs at least 3 edges; raise the smallest number of edges of a hole.");
  }
  if (options.mode == DrillMode::Triangle)
  {
    TriangleMesh mesh = TriangulateDomain(domain, LoopMarks(domain),
      MakeSizeField(domain, meshSize, options, frame), progress, {}, frame);
    MarkTriangles(domain, configuration, mesh);
    return mesh;
  }
  const Configuration holes = WithDefaultRadii(domain, configuration, meshSize);
  CheckPlacement(domain, holes);

  PlanarDomain drilled = InsertBoundarySingularities(domain, configuration);
  std::vector<BoundaryEdge> marks = LoopMarks(domain);
  const BoundaryKind kind =
    options.mode == DrillMode::Imprint ? BoundaryKind::ImprintedCircle : BoundaryKind::Hole;
  for (std::size_t i = 0; i < holes.size(); ++i)
  {
    if (IsOnBoundary(domain, holes[i].position))
    {
      continue;
    }
    const int edges = HoleEdges(i, holes[i], meshSize, options.minimumHoleEdges);
    drilled.loops.push_back(HolePolygon(holes[i], edges, frame.GetAngle()));
    marks.push_back({ { 0, 0 }, kind, static_cast<int>(i), holes[i].quarterIndex });
  }

  const SizeField size = MakeSizeField(drilled, meshSize, options, frame);
  if (options.symmetries.reflects && holes.empty())
  {
    const double reach = SymmetryReach * domain.Diagonal();
    const std::optional<MirrorSector> sector =
      CutMirrorSector(drilled, options.symmetries, frame.GetAngle(), options.vertices, reach);
    if (sector)
    {
      return CompleteSector(*sector,
        TriangulateDomain(
          sector->domain, LoopMarks(sector->domain), size, progress, sector->vertices, frame),
        drilled, options.vertices, marks, reach);
    }
  }
  return TriangulateDomain(drilled, marks, size, progress, options.vertices, frame);
}
}
