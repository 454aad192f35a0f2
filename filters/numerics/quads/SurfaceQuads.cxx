#include "SurfaceQuads.h"

#include "ArcPoints.h"
#include "ArcSpacing.h"
#include "Error.h"
#include "Index.h"
#include "MemoryBudget.h"
#include "QuadBuilder.h"
#include "QuadMesher.h"
#include "SizeSearch.h"
#include "SmoothLoops.h"
#include "Stopwatch.h"
#include "SurfaceQualityMeasure.h"
#include "TargetLengths.h"

#include <algorithm>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns the arcs of one edge that join the same points as another such arc.
std::vector<std::size_t> FindRepeatedEdges(const TMesh& mesh, const std::vector<int>& counts)
{
  const ArcPoints points(mesh, counts);
  UnionFind classes(Index(points.Count()));
  for (const PointLink& link : points.Links())
  {
    classes.Join(link.from, link.to);
  }
  std::set<std::pair<int, int>> edges;
  std::vector<std::size_t> repeated;
  for (std::size_t a = 0; a < counts.size(); ++a)
  {
    if (counts[a] != 1)
    {
      continue;
    }
    const auto half = static_cast<int>(2 * a);
    const std::pair<int, int> ends =
      std::minmax({ classes.Find(points.At(half, 0)), classes.Find(points.At(half, 1)) });
    if (!edges.insert(ends).second)
    {
      repeated.push_back(a);
    }
  }
  return repeated;
}

/// Returns the edge counts for a size, with enough edges around loops without corners.
EdgeCounts CountsFor(const TMesh& mesh, const SmoothLoops& loops, double size, SearchEffort effort)
{
  QuantisationProblem problem = MakeQuantisationProblem(mesh, size);
  for (std::size_t a = 0; a < mesh.arcs.size(); ++a)
  {
    // A closed line of two edges would join the same points twice.
    constexpr int ShortestLine = 3;
    if (mesh.halfEdges[2 * a].node == mesh.halfEdges[2 * a + 1].node)
    {
      problem.lower[a] = std::max(problem.lower[a], ShortestLine);
    }
  }
  EdgeCounts counts = Quantise(mesh, problem, effort);
  if (loops.RaiseTargets(size, counts.counts, problem))
  {
    counts = Quantise(mesh, problem, effort);
  }
  // Around a handle, two arcs of one edge may join the same points.
  constexpr int Repetitions = 5; // each leaves fewer
  for (int i = 0; i < Repetitions; ++i)
  {
    const std::vector<std::size_t> repeated = FindRepeatedEdges(mesh, counts.counts);
    if (repeated.empty())
    {
      break;
    }
    for (const std::size_t arc : repeated)
    {
      problem.lower[arc] = 2;
    }
    counts = Quantise(mesh, problem, effort);
  }
  return counts;
}

/// Names the boundary edges, which follow each other along every loop: a side ends at a corner.
void NameSides(QuadMesh& mesh)
{
  const auto isCorner = [&mesh](const QuadBoundaryEdge& edge)
  { return mesh.points[edge.points[0]].quarterIndex != 0; };
  int outer = 0;
  int hole = 0;
  for (auto begin = mesh.boundary.begin(); begin != mesh.boundary.end();)
  {
    const auto end = std::find_if(begin, mesh.boundary.end(),
      [begin](const QuadBoundaryEdge& edge) { return edge.id != begin->id; });
    const auto first = std::find_if(begin, end, isCorner);
    std::rotate(begin, first == end ? begin : first, end);
    for (auto edge = begin; edge != end; ++edge)
    {
      if (edge == begin || isCorner(*edge))
      {
        const bool isOuter = edge->kind == BoundaryKind::Outer;
        mesh.sideNames.push_back(
          isOuter ? "outer" + std::to_string(outer++) : "hole" + std::to_string(hole++));
      }
      edge->side = static_cast<int>(mesh.sideNames.size()) - 1;
    }
    begin = end;
  }
}
}

QuadResult MakeSurfaceQuads(
  const Layout& layout, const SurfaceQuadOptions& options, const Progress& progress)
{
  RequireSize(options.quadSize, options.quadCount);
  const MeshTopology& topology = *layout.map.topology;
  QuadResult result;
  result.tMesh = layout.tMesh;
  const SmoothLoops loops(topology, result.tMesh);
  result.counts = SearchCounts(
    result.tMesh, options.quadSize, options.quadCount, AreaOf(result.tMesh),
    [&](double size, SearchEffort effort) { return CountsFor(result.tMesh, loops, size, effort); },
    progress.Part(0.0, 0.5));
  result.size = result.counts.size;
  Stopwatch stopwatch;
  RequireMemory(static_cast<double>(CountQuads(result.tMesh, result.counts.counts)) * BytesPerQuad,
    "This number of quads", "use a larger size or fewer quads");
  const MeshBoundary curves(topology);
  result.mesh = BuildQuads(layout.map, curves, result.tMesh, result.counts.counts,
    EqualSpacing(result.tMesh, result.counts.counts), result.size);
  NameSides(result.mesh);
  result.blocks = FindBlocks(result.mesh);
  result.separateBlocks = static_cast<int>(result.blocks.blocks.size());
  result.layoutSeconds = stopwatch.Lap();
  const SurfaceWalk surface(topology);
  if (options.smooth)
  {
    result.smoothing = SmoothQuads(result.mesh, result.blocks, { curves, &surface }, std::nullopt,
      options.hold, progress.Part(0.5, 1.0));
  }
  else
  {
    SetNormals(surface, result.mesh);
  }
  result.smoothSeconds = stopwatch.Lap();
  result.quality = MeasureQuads(result.mesh, result.size);
  result.quality.surface = MeasureOnSurface(surface, result.mesh);
  progress.Report(1.0);
  return result;
}
}
