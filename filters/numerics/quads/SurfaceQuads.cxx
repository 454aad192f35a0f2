#include "SurfaceQuads.h"

#include "ArcSpacing.h"
#include "BoundaryOrder.h"
#include "CoarseBlocks.h"
#include "Error.h"
#include "Index.h"
#include "LineSides.h"
#include "MemoryBudget.h"
#include "NodePairs.h"
#include "PrescribedSums.h"
#include "QuadBuilder.h"
#include "QuadMesher.h"
#include "RepeatedEdges.h"
#include "SizeSearch.h"
#include "SmoothLoops.h"
#include "Stopwatch.h"
#include "SurfaceQualityMeasure.h"
#include "TargetLengths.h"
#include "WeldRegions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
/// Points, quads, lattices, energy, corrections, and the planes of points and quads: 1,230 bytes per quad were measured
/// with 400,000 quads.
constexpr double BytesPerSurfaceQuad = 1500.0;

/// Rotates the edges of loops of the boundary, which are before those of lines, so that each loop begins with a side.
void StartAtSides(QuadMesh& mesh)
{
  const auto last = std::find_if(mesh.boundary.begin(), mesh.boundary.end(),
    [](const QuadBoundaryEdge& edge) { return edge.kind == BoundaryKind::Interface; });
  for (auto begin = mesh.boundary.begin(); begin != last;)
  {
    const auto end = std::find_if(
      begin, last, [begin](const QuadBoundaryEdge& edge) { return edge.id != begin->id; });
    int before = std::prev(end)->side;
    const auto first = std::find_if(begin, end,
      [&](const QuadBoundaryEdge& edge) { return std::exchange(before, edge.side) != edge.side; });
    std::rotate(begin, first == end ? begin : first, end);
    begin = end;
  }
}

/// Makes meshes of one layout.
class SurfaceMesher
{
public:
  SurfaceMesher(const LayoutSet& layouts, const SurfaceQuadOptions& options)
    : Map(layouts.Single().map)
    , Options(options)
    , Separatrices(layouts.Single().tMesh)
    , Pairs(layouts.pairs)
    , Sides(layouts.sides)
    , Loops(*this->Map.topology, this->Separatrices)
    , Curves(*this->Map.topology)
    , Surface(*this->Map.topology)
    , Area(this->Options.targets.IsEmpty() ? AreaOf(this->Separatrices)
                                           : this->Options.targets.CountOn(*this->Map.topology))
    , Lengths(this->Options.targets.IsEmpty()
          ? TargetLengths(this->Separatrices, {})
          : TargetLengths(this->Map, this->Separatrices, this->Options.targets))
    , SideOfArc(SidesOfArcs(this->Pairs, this->Curves, this->Separatrices))
    , Sums(SumsOfPairs(this->Pairs, this->SideOfArc))
    , Names(NamesOfSides(layouts, this->SideOfArc))
  {
    this->AddCounts();
    if (!this->Pairs.empty() && this->Options.targets.IsEmpty())
    {
      MatchFaces(this->Separatrices, FacesOfArcs(*this->Map.topology, this->Separatrices),
        SumsOfPairs(this->Pairs, this->SideOfArc), this->Lengths);
    }
  }

  QuadResult Make(const Progress& progress) const
  {
    QuadResult result;
    result.tMesh = this->Separatrices;
    try
    {
      KnownCounts known;
      result.counts = this->SearchKnown(known, progress.Part(0.0, 0.4));
    }
    catch (const Error&)
    {
      this->RequireCounts();
      throw;
    }
    result.size = this->SizeOf(result.counts.size);
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
    const std::vector<int> faceOfArc = FacesOfArcs(*this->Map.topology, result.tMesh);
    for (const int patch : result.mesh.patch)
    {
      result.face.push_back(
        faceOfArc[Index(result.tMesh.patches[Index(patch)].sides[0].front() / 2)]);
    }
    if (!this->Pairs.empty())
    {
      this->Weld(result);
    }
    progress.Report(1.0);
    return result;
  }

private:
  bool HasTargets() const { return !this->Options.targets.IsEmpty(); }

  /// Returns the side length of equal quads for a size of Search, which is a factor of target sizes.
  double SizeOf(double searched) const
  {
    return this->HasTargets() ? searched * std::sqrt(this->Map.topology->Area() / this->Area)
                              : searched;
  }

  /// Adds the sums that prescribed numbers of edges are. Throws Error if there is no such side.
  void AddCounts()
  {
    std::vector<std::string> known = this->Sides.ofPairs;
    known.insert(known.end(), this->Names.ofLoops.begin(), this->Names.ofLoops.end());
    for (const SurfaceSideRequest& one : this->Options.sides)
    {
      RequireSide(known, one.side);
      CountSum sum;
      sum.minimum = sum.maximum = one.count;
      sum.name = one.side + ":" + std::to_string(one.count);
      if (one.size > 0.0)
      {
        constexpr double Tolerance = 1.2;
        const double edges = this->LengthOf(one.side) / one.size;
        sum.minimum = static_cast<int>(std::ceil(edges / Tolerance));
        sum.maximum = std::max(sum.minimum, static_cast<int>(std::floor(edges * Tolerance)));
        sum.name = "The size of '" + one.side + "'";
      }
      for (std::size_t a = 0; a < this->Separatrices.arcs.size(); ++a)
      {
        const TArc& arc = this->Separatrices.arcs[a];
        const bool isCounted = this->SideOfArc[a] < 0 || this->SideOfArc[a] % 2 == 0;
        if (arc.onBoundary && isCounted && this->NameOf(arc) == one.side)
        {
          sum.terms.emplace_back(static_cast<int>(a), 1);
        }
      }
      this->Sums.push_back(std::move(sum));
    }
  }

  /// Returns the length of a side or line, along the edges of the surface.
  double LengthOf(const std::string& side) const
  {
    const MeshTopology& topology = *this->Map.topology;
    double length = 0.0;
    for (std::size_t entry = 0; entry < this->Names.ofEntries.size(); ++entry)
    {
      length += this->Names.ofEntries[entry] == side
        ? topology.Length(topology.EdgeOfBoundary(static_cast<int>(entry)))
        : 0.0;
    }
    const auto& lines = this->Sides.ofPairs; // which are the boundary of two faces
    return std::find(lines.begin(), lines.end(), side) == lines.end() ? length : 0.5 * length;
  }

  /// Throws Error if the two sides of lines cannot have equal numbers of edges.
  void RequireCounts() const
  {
    const QuantisationProblem problem = this->ProblemFor(std::sqrt(this->Area));
    if (this->Sums.empty() || FindFeasibleCounts(this->Separatrices, problem))
    {
      return;
    }
    if (!this->Options.sides.empty())
    {
      throw Error(DescribeConflict(this->Separatrices, problem));
    }
    const std::vector<std::string> names = FindConflict(this->Separatrices, problem);
    throw Error("No numbers of edges fit the faces on both sides of " +
        std::to_string(names.size()) + " lines, one with t" + names.front().substr(1),
      "give other singularities, or follow fewer edges (FeatureAngle, --feature-angle)",
      Error::Kind::Inconsistent);
  }

  EdgeCounts Search(const BlockSteps::CountsOf& countsOf, const Progress& progress) const
  {
    return SearchCounts(this->Separatrices, this->Options.quadSize, this->Options.quadCount,
      this->Area, countsOf, progress);
  }

  /// Searches with what other sizes have found.
  EdgeCounts SearchKnown(KnownCounts& known, const Progress& progress) const
  {
    const auto countsOf = [&](double size, SearchEffort effort)
    { return this->CountsFor(size, effort, known); };
    if (this->Options.quadSize > 0.0)
    {
      return this->Search(countsOf, progress);
    }
    const auto estimate = [&](double size)
    { return CountQuads(this->Separatrices, RelaxCounts(this->ProblemFor(size), known)); };
    return SearchCountsByEstimates(
      this->Separatrices, this->Options.quadCount, this->Area, countsOf, estimate, progress);
  }

  QuantisationProblem ProblemFor(double size) const
  {
    std::vector<double> target = this->Lengths;
    for (double& length : target)
    {
      length /= size;
    }
    for (std::size_t s = this->Pairs.size(); s < this->Sums.size(); ++s)
    {
      this->Scale(this->Sums[s], target);
    }
    QuantisationProblem problem = MakeQuantisationProblem(this->Separatrices, std::move(target));
    problem.sums = this->Sums;
    if (!this->Sums.empty() || this->HasTargets())
    {
      BalanceTargets(this->Separatrices, problem);
    }
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

  /// Multiplies targets of arcs so that they add up to a prescribed number, or to one in its range.
  static void Scale(const CountSum& sum, std::vector<double>& target)
  {
    double present = 0.0;
    for (const auto& [arc, factor] : sum.terms)
    {
      present += target[Index(arc)];
    }
    const double wanted =
      std::clamp(present, static_cast<double>(sum.minimum), static_cast<double>(sum.maximum));
    for (const auto& [arc, factor] : sum.terms)
    {
      target[Index(arc)] *= wanted / present;
    }
  }

  /// Returns the edge counts for a size, with enough edges around loops without corners.
  EdgeCounts CountsFor(double size, SearchEffort effort, KnownCounts& known) const
  {
    QuantisationProblem problem = this->ProblemFor(size);
    double seconds = 0.0;
    const auto solve = [&]
    {
      EdgeCounts solved = Quantise(this->Separatrices, problem, effort, &known);
      solved.seconds = seconds += solved.seconds;
      return solved;
    };
    EdgeCounts counts = solve();
    if (this->Loops.RaiseTargets(this->SizeOf(size), counts.counts, problem))
    {
      counts = solve();
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
      counts = solve();
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
    QuadMesh mesh = BuildQuads(this->Map, this->Curves, result.tMesh, counts,
      EqualSpacing(result.tMesh, counts), result.size);
    for (const std::string& name : this->Sides.ofPairs)
    {
      mesh.sideNames.insert(mesh.sideNames.end(), 2, name);
    }
    std::map<std::string, int> sides; // of the boundary
    for (const std::string& name : this->Names.ofLoops)
    {
      sides.emplace(name, static_cast<int>(mesh.sideNames.size()));
      mesh.sideNames.push_back(name);
    }
    std::size_t edge = 0; // edges are those of arcs, one after the other
    for (std::size_t a = 0; a < counts.size(); ++a)
    {
      const TArc& arc = result.tMesh.arcs[a];
      if (!arc.onBoundary)
      {
        continue;
      }
      int side = this->SideOfArc[a];
      if (side < 0)
      {
        side = sides.at(this->NameOf(arc));
      }
      for (int i = 0; i < counts[a]; ++i)
      {
        mesh.boundary[edge++].side = side;
      }
    }
    if (this->Pairs.empty())
    {
      StartAtSides(mesh);
      return mesh;
    }
    mesh.periodic = this->Pairs;
    FindPairs(this->Curves, mesh);
    MatchPairs(this->Curves, mesh);
    OrderOnBoundary(mesh, this->Curves);
    MatchPairs(this->Curves, mesh);
    return mesh;
  }

  /// Sets the target sizes of quads, and their lengths, whose total area is that of the surface.
  void SetTargets(QuadResult& result) const
  {
    QuadMesh& mesh = result.mesh;
    const MeshTopology& topology = *this->Map.topology;
    std::vector<double> ofPoints;
    for (const QuadPoint& point : mesh.points)
    {
      ofPoints.push_back(this->Options.targets.At(topology, point.triangle, point.place));
    }
    result.targets.clear();
    double squares = 0.0;
    for (const std::array<int, 4>& quad : mesh.quads)
    {
      double size = 0.0;
      for (const int point : quad)
      {
        size += 0.25 * ofPoints[Index(point)];
      }
      result.targets.push_back(size);
      squares += size * size;
    }
    const double factor = std::sqrt(topology.Area() / squares);
    const double mean = std::sqrt(squares / static_cast<double>(mesh.quads.size()));
    for (std::size_t q = 0; q < mesh.quads.size(); ++q)
    {
      mesh.targetLengths[q] = { factor * result.targets[q], factor * result.targets[q] };
    }
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      mesh.points[p].scale = ofPoints[p] / mean;
    }
  }

  const std::string& NameOf(const TArc& arc) const
  {
    return this->Names.ofEntries[Index(arc.pieces.front().position)];
  }

  /// Makes one mesh of those of the faces.
  void Weld(QuadResult& result) const
  {
    WeldRegions(result.mesh);
    StartAtSides(result.mesh);
    result.blocks = FindBlocks(result.mesh, result.face);
    result.separateBlocks = static_cast<int>(result.blocks.blocks.size());
    const std::optional<SurfaceQuality> onSurface = result.quality.surface;
    const double bound = result.quality.bound; // with the angles of faces at nodes
    result.quality = MeasureQuads(result.mesh, result.size);
    result.quality.surface = onSurface;
    result.quality.bound = bound;
    for (QuadBoundaryEdge& one : result.mesh.boundary)
    {
      one.kind = one.kind == BoundaryKind::Interface ? BoundaryKind::Feature : one.kind;
    }
  }

  /// Builds, smooths and measures the quads of a result with counts.
  void Build(QuadResult& result, const Progress& progress) const
  {
    Stopwatch stopwatch;
    const auto quads = static_cast<double>(CountQuads(result.tMesh, result.counts.counts));
    RequireMemory(
      quads * BytesPerSurfaceQuad, "This number of quads", "use a larger size or fewer quads");
    result.mesh = this->QuadsOf(result);
    result.blocks = FindBlocks(result.mesh);
    std::optional<double> sizePart;
    if (this->HasTargets())
    {
      constexpr double Half = 0.5; // as in the plane
      sizePart = Half;
      this->SetTargets(result);
    }
    result.layoutSeconds += stopwatch.Lap();
    if (this->Options.smooth)
    {
      result.smoothing = SmoothQuads(result.mesh, result.blocks, { this->Curves, &this->Surface },
        sizePart, this->Options.hold, progress);
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
  const std::vector<PairedSides>& Pairs;
  const FaceSides& Sides;
  const SmoothLoops Loops;
  const MeshBoundary Curves;
  const SurfaceWalk Surface;
  const double Area;
  std::vector<double> Lengths;      ///< Target counts for size 1.
  const std::vector<int> SideOfArc; ///< −1 inside of faces and on the boundary of the whole.
  std::vector<CountSum> Sums;       ///< Those of pairs, and prescribed ones.
  const SurfaceSideNames Names;
};
}

QuadResult MakeSurfaceQuads(
  const LayoutSet& layouts, const SurfaceQuadOptions& options, const Progress& progress)
{
  RequireSize(options.quadSize, options.quadCount);
  return SurfaceMesher(layouts, options).Make(progress);
}
}
