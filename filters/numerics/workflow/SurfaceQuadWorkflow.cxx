#include "SurfaceQuadWorkflow.h"

#include "BodyQuads.h"
#include "Error.h"
#include "InterfaceMeasures.h"
#include "JoinedParts.h"
#include "OptimizerReport.h"
#include "Stopwatch.h"
#include "SurfaceParts.h"
#include "SurfaceRefinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace crossfield
{
namespace
{
/// Makes quads with the triangles of a surface as they are.
QuadWorkflowResult MakeQuadsOfTriangles(const SurfaceMesh& surface, const SurfaceRequest& request,
  bool joinsAll, const Progress& progress)
{
  Stopwatch clock;
  FeaturedParts found = FindFeaturedParts(surface,
    request.singularities.value_or(std::vector<SurfaceSingularity>()), request.featureAngle);
  const double partSeconds = clock.Lap();
  std::vector<double> areas;
  for (const FeaturedPart& part : found.parts)
  {
    areas.push_back(AreaOf(part.surface));
  }
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  double done = 0.0;
  QuadWorkflowResult result = JoinQuads(found.parts.size(),
    [&](std::size_t p)
    {
      const double share = areas[p] / area;
      const int count = request.quadCount == 0
        ? 0
        : static_cast<int>(std::max(1.0, std::round(share * request.quadCount)));
      const double begin = done;
      done = std::min(1.0, done + share);
      return MakeQuadsOfBody(found.parts[p], request, count, joinsAll, progress.Part(begin, done));
    });
  for (const SurfaceSideRequest& one : request.sides)
  {
    RequireSide(result.quads.mesh.sideNames, one.side);
  }
  result.seconds.mesh = partSeconds;
  result.interfaces = MeasureInterfaces(result.quads.mesh);
  result.events.insert(result.events.begin(), found.events.begin(), found.events.end());
  return result;
}

/// Returns the surface with its repaired parts divided until no side is longer than a length.
SurfaceMesh RefinedParts(const SurfaceMesh& surface, double length)
{
  SurfaceMesh all;
  for (SurfaceMesh& part : FindSurfaceParts(surface).parts)
  {
    const SurfaceMesh refined = Refined(std::move(part), length);
    const auto first = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), refined.points.begin(), refined.points.end());
    for (std::size_t t = 0; t < refined.triangles.size(); ++t)
    {
      const std::array<int, 3>& v = refined.triangles[t];
      all.triangles.push_back({ first + v[0], first + v[1], first + v[2] });
      all.AppendLabels(refined, t);
    }
  }
  return all;
}
}

QuadWorkflowResult MakeQuadsOfSurface(
  const SurfaceMesh& surface, const SurfaceRequest& request, const Progress& progress)
{
  constexpr int MaximumRefinements = 2;
  constexpr double MaximumTriangles = 200000; // a map of these takes ten seconds
  const int count = request.quadCount == 0 && request.HasSizes() ? DefaultQuads : request.quadCount;
  RequireSize(request.quadSize, count);
  const double area = AreaOf(surface);
  SurfaceMesh refined;
  const SurfaceMesh* triangles = &surface;
  double next = request.quadSize > 0.0 ? request.quadSize : std::sqrt(area / count);
  double longest = 0.0; // side of the triangles in use
  for (int refinements = 0;; ++refinements)
  {
    const double done = refinements == 0 ? 0.0 : 0.6 + 0.2 * (refinements - 1);
    try
    {
      QuadWorkflowResult result =
        MakeQuadsOfTriangles(*triangles, request, refinements == MaximumRefinements,
          progress.Part(done, refinements == 0 ? 0.6 : done + 0.2));
      if (refinements > 0)
      {
        result.events.push_back(
          "The triangles of the surface were divided, on the same surface, until their sides were "
          "at most " +
          FormatShort(longest) + " long: with larger ones there is no map.");
      }
      progress.Report(1.0);
      return result;
    }
    catch (const Error& error)
    {
      // Equilateral triangles with sides of this length; others are up to three times as many.
      const bool fits = area / (0.43 * next * next) < MaximumTriangles;
      if (error.GetKind() != Error::Kind::CoarseMesh || error.GetCause().empty() || !fits)
      {
        throw;
      }
      if (refinements == MaximumRefinements)
      {
        throw Error(error.GetCause() + ", even with the sides of triangles at most " +
            FormatShort(longest) + " long",
          "give other singularities, or a surface with more even triangles", error.GetKind());
      }
    }
    longest = next;
    refined = RefinedParts(surface, longest);
    triangles = &refined;
    next *= 0.5;
  }
}
}
