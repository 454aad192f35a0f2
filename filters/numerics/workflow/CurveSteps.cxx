#include "CurveSteps.h"

#include "CurveSampling.h"
#include "DrillHoles.h"
#include "MakePlanarDomain.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
/// Shortest segment that a curve is divided into for its turning, relative to the mesh size: a small
/// fillet has no more segments than its few quads can follow.
constexpr double ShortestPart = 0.1;
}

CurvedRequest WithCurves(const PlanarDomain& domain, const ResolvedRequest& request)
{
  CurvedRequest result{ domain, request };
  if (request.curveRequest.IsEmpty() && request.givenCurves.curves.empty())
  {
    return result;
  }
  const CurvesOfSegments curves =
    FindCurves(domain, result.request.sides, request.curveRequest, request.givenCurves);
  if (curves.curves.empty())
  {
    return result;
  }
  DrillOptions options;
  options.meshSize = request.meshSize;
  const double size = ResolveMeshSize(options, domain);
  std::vector<Point> kept;
  for (const CornerChoice& corner : request.corners)
  {
    kept.push_back(corner.position);
  }
  if (request.singularities)
  {
    for (const Singularity& singularity : *request.singularities)
    {
      kept.push_back(singularity.position);
    }
  }
  SampledDomain sampled =
    SampleCurves(domain, result.request.sides, curves, { size, ShortestPart * size }, kept);
  for (std::size_t i = 0; i < request.corners.size(); ++i)
  {
    result.request.corners[i].position = sampled.kept[i];
  }
  for (std::size_t i = request.corners.size(); i < kept.size(); ++i)
  {
    (*result.request.singularities)[i - request.corners.size()].position = sampled.kept[i];
  }
  result.domain = MakePlanarDomain(std::move(sampled.domain.loops));
  result.request.sides = std::move(sampled.sides);
  result.request.curves = std::move(sampled.boundary);
  return result;
}

std::vector<CurveReport> MeasureCurves(
  const PlanarDomain& given, const CurvedBoundary& boundary, const QuadMesh& mesh)
{
  std::vector<CurveReport> reports(boundary.curves.size());
  const std::vector<LoopArc> arcs(given.loops.begin(), given.loops.end());
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    if (edge.curve < 0)
    {
      continue;
    }
    CurveReport& report = reports[edge.curve];
    ++report.edges;
    if (edge.side >= 0 &&
      std::find(report.sides.begin(), report.sides.end(), edge.side) == report.sides.end())
    {
      report.sides.push_back(edge.side);
    }
    for (const int point : edge.points)
    {
      const Point place = mesh.points[point].InPlane();
      double distance = std::numeric_limits<double>::infinity();
      for (const LoopArc& arc : arcs)
      {
        distance = std::min(distance, (arc.At(arc.Nearest(place)) - place).norm());
      }
      report.moved = std::max(report.moved, distance);
    }
  }
  return reports;
}
}
