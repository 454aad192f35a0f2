#include "SurfaceQuads.h"

#include "ArcPoints.h"
#include "ArcSpacing.h"
#include "CoarseBlocks.h"
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
/// Points, quads, lattices, energy, corrections, and the planes of points and quads: 1,230 bytes per quad were measured
/// with 400,000 quads.
constexpr double BytesPerSurfaceQuad = 1500.0;

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

/// Makes meshes of one layout.
class SurfaceMesher
{
public:
  SurfaceMesher(const Layout& layout, const SurfaceQuadOptions& options)
    : Map(layout.map)
    , Options(options)
    , Separatrices(layout.tMesh)
    , Loops(*layout.map.topology, layout.tMesh)
    , Curves(*layout.map.topology)
    , Surface(*layout.map.topology)
    , Area(AreaOf(layout.tMesh))
  {
  }

  QuadResult Make(const Progress& progress) const
  {
    QuadResult result;
    result.tMesh = this->Separatrices;
    result.counts = this->Search([this](double size, SearchEffort effort)
      { return this->CountsFor(size, effort); },
      progress.Part(0.0, 0.4));
    result.size = result.counts.size;
    this->Build(result, progress.Part(0.4, this->Options.coarse ? 0.7 : 1.0));
    result.separateBlocks = static_cast<int>(result.blocks.blocks.size());
    if (this->Options.coarse)
    {
      UseFewestBlocks(
        { [this](double size) { return this->ProblemFor(size); },
          [this](const BlockSteps::CountsOf& countsOf) { return this->Search(countsOf, {}); },
          [this](const QuadResult& draft) { return this->Draft(draft); },
          [this](QuadResult& candidate, const Progress& part) { this->Build(candidate, part); } },
        this->Area, result, progress.Part(0.7, 1.0));
    }
    progress.Report(1.0);
    return result;
  }

private:
  EdgeCounts Search(const BlockSteps::CountsOf& countsOf, const Progress& progress) const
  {
    return SearchCounts(this->Separatrices, this->Options.quadSize, this->Options.quadCount,
      this->Area, countsOf, progress);
  }

  QuantisationProblem ProblemFor(double size) const
  {
    QuantisationProblem problem = MakeQuantisationProblem(this->Separatrices, size);
    for (std::size_t a = 0; a < this->Separatrices.arcs.size(); ++a)
    {
      // A closed line of two edges would join the same points twice.
      constexpr int ShortestLine = 3;
      if (this->Separatrices.halfEdges[2 * a].node == this->Separatrices.halfEdges[2 * a + 1].node)
      {
        problem.lower[a] = std::max(problem.lower[a], ShortestLine);
      }
    }
    return problem;
  }

  /// Returns the edge counts for a size, with enough edges around loops without corners.
  EdgeCounts CountsFor(double size, SearchEffort effort) const
  {
    QuantisationProblem problem = this->ProblemFor(size);
    EdgeCounts counts = Quantise(this->Separatrices, problem, effort);
    if (this->Loops.RaiseTargets(size, counts.counts, problem))
    {
      counts = Quantise(this->Separatrices, problem, effort);
    }
    // Around a handle, two arcs of one edge may join the same points.
    constexpr int Repetitions = 5; // each leaves fewer
    for (int i = 0; i < Repetitions; ++i)
    {
      const std::vector<std::size_t> repeated =
        FindRepeatedEdges(this->Separatrices, counts.counts);
      if (repeated.empty())
      {
        break;
      }
      for (const std::size_t arc : repeated)
      {
        problem.lower[arc] = 2;
      }
      counts = Quantise(this->Separatrices, problem, effort);
    }
    return counts;
  }

  /// Returns quads at their places in the map; nothing if edges would be repeated.
  std::optional<QuadMesh> Draft(const QuadResult& result) const
  {
    if (!FindRepeatedEdges(result.tMesh, result.counts.counts).empty())
    {
      return std::nullopt;
    }
    return this->QuadsOf(result);
  }

  QuadMesh QuadsOf(const QuadResult& result) const
  {
    const std::vector<int>& counts = result.counts.counts;
    return BuildQuads(this->Map, this->Curves, result.tMesh, counts,
      EqualSpacing(result.tMesh, counts), result.size);
  }

  /// Builds, smooths and measures the quads of a result with counts.
  void Build(QuadResult& result, const Progress& progress) const
  {
    Stopwatch stopwatch;
    const auto quads = static_cast<double>(CountQuads(result.tMesh, result.counts.counts));
    RequireMemory(
      quads * BytesPerSurfaceQuad, "This number of quads", "use a larger size or fewer quads");
    result.mesh = this->QuadsOf(result);
    NameSides(result.mesh);
    result.blocks = FindBlocks(result.mesh);
    result.layoutSeconds += stopwatch.Lap();
    if (this->Options.smooth)
    {
      result.smoothing = SmoothQuads(result.mesh, result.blocks, { this->Curves, &this->Surface },
        std::nullopt, this->Options.hold, progress);
    }
    else
    {
      SetNormals(this->Surface, result.mesh);
    }
    result.smoothSeconds += stopwatch.Lap();
    result.quality = MeasureQuads(result.mesh, result.size);
    result.quality.surface = MeasureOnSurface(this->Surface, result.mesh);
  }

  const SeamlessMap& Map;
  const SurfaceQuadOptions& Options;
  const TMesh& Separatrices;
  const SmoothLoops Loops;
  const MeshBoundary Curves;
  const SurfaceWalk Surface;
  const double Area;
};
}

QuadResult MakeSurfaceQuads(
  const Layout& layout, const SurfaceQuadOptions& options, const Progress& progress)
{
  RequireSize(options.quadSize, options.quadCount);
  return SurfaceMesher(layout, options).Make(progress);
}
}
