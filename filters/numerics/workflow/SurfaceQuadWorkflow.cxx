#include "SurfaceQuadWorkflow.h"

#include "Error.h"
#include "JoinedParts.h"
#include "QuadAdvice.h"
#include "Stopwatch.h"
#include "SurfaceChoice.h"
#include "SurfaceDivision.h"
#include "SurfaceMap.h"
#include "SurfaceQuads.h"
#include "SurfaceTopology.h"
#include "TMeshPatches.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Makes quads of a part. `chooses` is set if its cones are only those of corners.
PartOfQuads MakeQuadsOfPart(
  ConedSurface& part, bool chooses, const SurfaceQuadOptions& options, const Progress& progress)
{
  PartOfQuads made;
  QuadWorkflowResult& result = made.quads;
  Stopwatch clock;
  if (chooses)
  {
    std::vector<Cone> cones =
      ChooseSurfaceCones(*part.topology, part.cones, progress.Part(0.0, 0.4));
    part.cones.insert(part.cones.begin(), cones.begin(), cones.end());
    result.seconds.choose = clock.Lap();
  }
  if (part.GivenQuarters() != part.RequiredQuarters())
  {
    throw Error(DescribeQuarters(part), Error::Kind::Inconsistent);
  }
  Layout layout;
  layout.map = SolveSurfaceMap(part.topology, part.cones, progress.Part(0.4, 0.6));
  result.seconds.map = clock.Lap();
  layout.separatrices = TraceSeparatrices(layout.map, progress.Part(0.6, 0.7));
  layout.tMesh = MakeTMesh(layout.map, layout.separatrices);
  result.seconds.trace = clock.Lap();
  result.quads = MakeSurfaceQuads(layout, options, progress.Part(0.7, 1.0));
  result.seconds.integers = result.quads.counts.seconds;
  result.seconds.layout = result.quads.layoutSeconds;
  result.seconds.smooth = result.quads.smoothSeconds;
  result.holonomyDefect = layout.map.holonomyDefect;
  result.blocks.none = result.quads.separateBlocks;
  if (options.coarse)
  {
    result.blocks.coarse = static_cast<int>(result.quads.blocks.blocks.size());
  }
  result.events = part.events;
  if (result.quads.quality.inverted > 0)
  {
    result.warnings.push_back(CountInverted(result.quads.quality) + "; use smaller quads.");
  }
  const SurfaceQuality& onSurface = *result.quads.quality.surface;
  if (onSurface.bent > 0)
  {
    result.warnings.push_back("The surface turns by more than 60 degrees within " +
      std::to_string(onSurface.bent) + (onSurface.bent == 1 ? " quad" : " quads") + ", most near " +
      DescribePlace(onSurface.mostBent) +
      "; use smaller quads where it is curved. Sharp edges are not followed yet.");
  }
  made.loops = part.topology->loops.size();
  return made;
}

/// Makes quads with the triangles of a surface as they are.
QuadWorkflowResult MakeQuadsOfTriangles(
  const SurfaceMesh& surface, const SurfaceRequest& request, const Progress& progress)
{
  Stopwatch clock;
  ConedSurfaces found =
    PlaceCones(surface, request.singularities.value_or(std::vector<SurfaceSingularity>()));
  const double placeSeconds = clock.Lap();
  double area = 0.0;
  for (const ConedSurface& part : found.parts)
  {
    area += part.topology->Area();
  }
  double done = 0.0;
  QuadWorkflowResult result = JoinQuads(found.parts.size(),
    [&](std::size_t p)
    {
      const double share = found.parts[p].topology->Area() / area;
      const auto count = static_cast<int>(std::max(1.0, std::round(share * request.quadCount)));
      const double begin = done;
      done = std::min(1.0, done + share);
      return MakeQuadsOfPart(found.parts[p], !request.singularities,
        { request.quadSize, count, request.hold, true, request.coarse },
        progress.Part(begin, done));
    });
  result.seconds.mesh = placeSeconds;
  result.events.insert(result.events.begin(), found.events.begin(), found.events.end());
  return result;
}
}

QuadWorkflowResult MakeQuadsOfSurface(
  const SurfaceMesh& surface, const SurfaceRequest& request, const Progress& progress)
{
  constexpr int MaximumDivisions = 2;
  constexpr std::size_t MaximumTriangles = 200000; // a map of these takes ten seconds
  RequireSize(request.quadSize, request.quadCount);
  SurfaceMesh divided;
  const SurfaceMesh* triangles = &surface;
  for (int divisions = 0;; ++divisions)
  {
    const double done = divisions == 0 ? 0.0 : 0.6 + 0.2 * (divisions - 1);
    try
    {
      QuadWorkflowResult result = MakeQuadsOfTriangles(
        *triangles, request, progress.Part(done, divisions == 0 ? 0.6 : done + 0.2));
      if (divisions > 0)
      {
        result.events.push_back("The triangles of the surface were divided into " +
          std::to_string(divisions == 1 ? 4 : 16) + " each: with larger ones there is no map.");
      }
      progress.Report(1.0);
      return result;
    }
    catch (const Error& error)
    {
      if (error.GetKind() != Error::Kind::CoarseMesh || error.GetCause().empty() ||
        4 * triangles->triangles.size() > MaximumTriangles)
      {
        throw;
      }
      if (divisions == MaximumDivisions)
      {
        throw Error(error.GetCause() + ", even with its triangles divided into 16",
          "give other singularities, or a surface with more even triangles", error.GetKind());
      }
    }
    divided = Divided(*triangles);
    triangles = &divided;
  }
}
}
