#include "SurfaceQuadWorkflow.h"

#include "BodyQuads.h"
#include "InterfaceMeasures.h"
#include "JoinedParts.h"
#include "Stopwatch.h"
#include "SurfaceParts.h"
#include "TriangleDivision.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace crossfield
{
namespace
{
/// Returns the name of a line between two regions that is given as `B+A` instead of `A+B`, other names as they are.
std::string InOrderOfRegions(const std::string& side, const std::vector<std::string>& regions)
{
  for (std::size_t b = 1; b < regions.size(); ++b)
  {
    for (std::size_t a = 0; a < b; ++a)
    {
      if (side == regions[b] + "+" + regions[a])
      {
        return regions[a] + "+" + regions[b];
      }
    }
  }
  return side;
}
}

QuadWorkflowResult MakeQuadsOfSurface(
  const SurfaceMesh& surface, const SurfaceRequest& given, const Progress& progress)
{
  SurfaceRequest request = given;
  for (SurfaceSideRequest& one : request.sides)
  {
    one.side = InOrderOfRegions(one.side, request.names.regions);
  }
  const int wanted =
    request.quadCount == 0 && request.HasSizes() ? DefaultQuads : request.quadCount;
  RequireSize(request.quadSize, wanted);
  Stopwatch clock;
  const FeaturedParts found = FindFeaturedParts(surface,
    request.singularities.value_or(std::vector<SurfaceSingularity>()), request.featureAngle);
  const double partSeconds = clock.Lap();
  std::vector<double> areas;
  for (const FeaturedPart& part : found.parts)
  {
    areas.push_back(AreaOf(part.surface));
  }
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  const double length = request.quadSize > 0.0 ? request.quadSize : std::sqrt(area / wanted);
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
      TriangleDivision division(found.parts[p], length, request.featureAngle);
      PartOfQuads made = division.Run([&](FeaturedPart& part, bool isLast, const Progress& steps)
        { return MakeQuadsOfBody(part, request, count, isLast, steps); },
        progress.Part(begin, done));
      const std::string event = division.Event();
      if (!event.empty())
      {
        made.quads.events.push_back(event);
      }
      return made;
    });
  for (const SurfaceSideRequest& one : request.sides)
  {
    RequireSide(result.quads.mesh.sideNames, one.side);
  }
  result.seconds.mesh = partSeconds;
  result.interfaces = MeasureInterfaces(result.quads.mesh);
  result.events.insert(result.events.begin(), found.events.begin(), found.events.end());
  progress.Report(1.0);
  return result;
}
}
