#include "LayoutClosing.h"

#include "ArcDerivatives.h"
#include "ClosingStep.h"
#include "DomainQueries.h"
#include "Error.h"
#include "Index.h"
#include "MeshForPoints.h"
#include "Parts.h"
#include "Quantisation.h"
#include "TMeshPatches.h"
#include "TargetLengths.h"
#include "TraceGraph.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Tolerances at which a layout is closed: an arc far below half a quad gets no edges, and defects
/// are below the error of the map.
constexpr double LengthTolerance = 0.02; // quads
constexpr double DefectTolerance = 0.01; // radians of θ
/// Maximum move of a singularity in a step, in clearances.
constexpr double LargestStep = 0.4;
/// Minimum reduction of the longest arc or the largest defect by a step that was not shortened.
constexpr double MinimumReduction = 0.2;

/// Returns the edge counts for quads larger by `coarseness`; those of some arcs are at least 1.
std::vector<int> CoarseCounts(const TMesh& tMesh, const ClosingOptions& options, double coarseness,
  const std::vector<int>& kept)
{
  std::vector<double> target = TargetLengths(tMesh, options.sizes);
  for (double& length : target)
  {
    length /= coarseness * options.size;
  }
  QuantisationProblem problem = MakeQuantisationProblem(tMesh, std::move(target));
  for (const int arc : kept)
  {
    problem.lower[Index(arc)] = 1;
  }
  return Quantise(tMesh, problem, SearchEffort::Quick).counts;
}

/// Returns whether a map has singularities inside.
bool HasMoving(const SeamlessMap& map)
{
  return std::any_of(map.cones.begin(), map.cones.end(),
    [](const Cone& cone) { return cone.row >= 0 && !cone.onBoundary; });
}

/// Returns the clearance of every moving singularity, for both of its coordinates.
Eigen::VectorXd Clearances(
  const PlanarDomain& domain, const PositionResponse& response, std::size_t count)
{
  Eigen::VectorXd clearances(static_cast<Eigen::Index>(2 * count));
  for (std::size_t m = 0; m < count; ++m)
  {
    const Point& position = response.PositionOf(m);
    double clearance = SignedDistance(position, domain);
    for (std::size_t n = 0; n < count; ++n)
    {
      if (n != m)
      {
        clearance = std::min(clearance, 0.5 * (response.PositionOf(n) - position).norm());
      }
    }
    clearances.segment<2>(static_cast<Eigen::Index>(2 * m)).setConstant(clearance);
  }
  return clearances;
}

/// One linearisation: conditions at a layout, and the step that follows.
class Linearisation
{
public:
  Linearisation(
    const PlanarDomain& domain, const ClosingLayout& layout, const ClosingOptions& options)
    : Layout(layout)
    , Options(options)
    , Response(layout.map, layout.potential)
    , Scale(Clearances(domain, Response, Response.GetMoving().size()))
  {
    this->Conditions.defects = this->Response.GetDefectDerivatives() * this->Scale.asDiagonal();
    this->Conditions.defect.resize(this->Conditions.defects.rows());
    for (Eigen::Index k = 0; k < this->Conditions.defect.size(); ++k)
    {
      this->Conditions.defect[k] = 0.25 * layout.map.holonomyDefect[static_cast<std::size_t>(k)];
    }
    const ArcPaths paths(layout.map, layout.tMesh);
    this->ChooseArcs(paths);
  }

  /// Returns whether there is no condition that can be fulfilled.
  bool IsEmpty() const { return this->Conditions.length.size() == 0; }
  double LargestLength() const
  {
    return this->IsEmpty() ? 0.0 : this->Conditions.length.maxCoeff();
  }
  double LargestDefect() const
  {
    return this->Conditions.defect.size() == 0 ? 0.0
                                               : this->Conditions.defect.cwiseAbs().maxCoeff();
  }

  /// Returns the singularities after the step, and sets whether it was shortened.
  Configuration Next(bool& shortened) const
  {
    Configuration next = this->Layout.singularities;
    double largest = 0.0;
    const auto count = static_cast<Eigen::Index>(this->Response.GetMoving().size());
    for (Eigen::Index m = 0; m < count; ++m)
    {
      largest = std::max(largest, this->Step.moves.segment<2>(2 * m).norm());
    }
    shortened = largest > LargestStep;
    const double fraction = shortened ? LargestStep / largest : 1.0;
    for (Eigen::Index m = 0; m < count; ++m)
    {
      const Cone& cone = this->Response.ConeOf(static_cast<std::size_t>(m));
      next[Index(cone.row)].position +=
        fraction * this->Scale[2 * m] * this->Step.moves.segment<2>(2 * m);
    }
    return next;
  }

private:
  /// Sets conditions for all arcs without edges that are not left out.
  void SetConditions(const std::vector<int>& counts, const std::vector<int>& leftOut)
  {
    this->Arcs.clear();
    std::vector<Eigen::RowVectorXd> rows;
    for (int arc = 0; arc < static_cast<int>(counts.size()); ++arc)
    {
      const bool isLeftOut = std::find(leftOut.begin(), leftOut.end(), arc) != leftOut.end();
      if (counts[Index(arc)] == 0 && !isLeftOut && this->Rows[Index(arc)].size() > 0)
      {
        this->Arcs.push_back(arc);
      }
    }
    const auto count = static_cast<Eigen::Index>(this->Arcs.size());
    this->Conditions.lengths.resize(count, this->Response.Columns());
    this->Conditions.length.resize(count);
    for (Eigen::Index row = 0; row < count; ++row)
    {
      const std::size_t arc = Index(this->Arcs[static_cast<std::size_t>(row)]);
      this->Conditions.lengths.row(row) = this->Rows[arc];
      this->Conditions.length[row] = this->Layout.tMesh.arcs[arc].length / this->Options.size;
    }
  }

  /// Computes the rows of arcs without edges that are not known yet.
  void DifferentiateArcs(const ArcPaths& paths, const std::vector<int>& counts)
  {
    this->Rows.resize(counts.size());
    this->IsKnown.resize(counts.size(), false);
    std::vector<int> arcs;
    for (int arc = 0; arc < static_cast<int>(counts.size()); ++arc)
    {
      if (counts[Index(arc)] == 0 && !this->IsKnown[Index(arc)])
      {
        this->IsKnown[Index(arc)] = true;
        arcs.push_back(arc);
      }
    }
    // A row takes a tenth of a millisecond to a millisecond.
    constexpr std::ptrdiff_t MinimumArcs = 4;
    ForRanges(
      static_cast<std::ptrdiff_t>(arcs.size()),
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          const int arc = arcs[Index(i)];
          if (const std::optional<ArcPath> path = paths.Of(arc))
          {
            this->Rows[Index(arc)] = DifferentiateArc(this->Response, *path) *
              this->Scale.asDiagonal() / this->Options.size;
          }
        }
      },
      MinimumArcs);
  }

  /// Chooses the arcs that should vanish and can. An arc that no move shortens enough gets an edge,
  /// or is left out if it has no edges even with quads of the target size.
  void ChooseArcs(const ArcPaths& paths)
  {
    // Integer problems of a large T-mesh take as long as a map. What remains is left out.
    constexpr int MaximumProblems = 10;
    const auto countsFor = [this](double coarseness, const std::vector<int>& kept)
    { return CoarseCounts(this->Layout.tMesh, this->Options, coarseness, kept); };
    const std::vector<int> fine = countsFor(1.0, {});
    std::vector<int> kept;
    std::vector<int> leftOut;
    std::vector<int> counts = countsFor(this->Options.coarseness, kept);
    int problems = 1;
    for (;;)
    {
      this->DifferentiateArcs(paths, counts);
      this->SetConditions(counts, leftOut);
      this->Step = SolveClosing(this->Conditions);
      if (this->Step.unreachable.empty())
      {
        return;
      }
      const bool isLast = problems == MaximumProblems;
      const std::size_t before = kept.size();
      for (const Eigen::Index row : this->Step.unreachable)
      {
        const int arc = this->Arcs[static_cast<std::size_t>(row)];
        (isLast || fine[Index(arc)] == 0 ? leftOut : kept).push_back(arc);
      }
      if (kept.size() > before)
      {
        counts = countsFor(this->Options.coarseness, kept);
        ++problems;
      }
    }
  }

  const ClosingLayout& Layout;
  const ClosingOptions& Options;
  const PositionResponse Response;
  const Eigen::VectorXd Scale;          ///< Clearances.
  std::vector<Eigen::RowVectorXd> Rows; ///< Derivatives of arcs; empty if they have no path.
  std::vector<bool> IsKnown;            ///< Whether the row of an arc was computed.
  std::vector<int> Arcs;                ///< The arcs of the conditions.
  ClosingConditions Conditions;
  ClosingStep Step;
};
}

ClosingLayout LayOut(const PlanarDomain& domain, const Configuration& singularities,
  const SeamlessMapOptions& options, double meshSize, const Progress& progress)
{
  const SharedPlanarTopology topology =
    ShareTopology(MeshThroughPoints(domain, singularities, meshSize, progress.Part(0.0, 0.3)));
  auto potential = std::make_shared<const PotentialSolver>(topology, progress.Part(0.3, 0.5));
  SeamlessMap map =
    SolveSeamlessMap(topology, singularities, options, progress.Part(0.5, 0.9), potential);
  TMesh tMesh = MakeTMesh(map, TraceSeparatrices(map, progress.Part(0.9, 1.0)));
  return { singularities, std::move(map), std::move(tMesh), std::move(potential) };
}

std::vector<int> FindArcsToClose(const TMesh& tMesh, const ClosingOptions& options)
{
  const std::vector<int> counts = CoarseCounts(tMesh, options, options.coarseness, {});
  std::vector<int> arcs;
  for (int arc = 0; arc < static_cast<int>(counts.size()); ++arc)
  {
    if (counts[Index(arc)] == 0)
    {
      arcs.push_back(arc);
    }
  }
  return arcs;
}

ClosingResult CloseLayout(const PlanarDomain& domain, ClosingLayout start,
  const ClosingOptions& options, const Progress& progress)
{
  ClosingResult result;
  result.layout = std::move(start);
  double previous = 0.0;
  bool shortened = true;
  for (;;)
  {
    // Flat metrics are on another triangulation of the domain than the potential.
    if (result.layout.map.flattening || !HasMoving(result.layout.map))
    {
      return result;
    }
    const Linearisation linearised(domain, result.layout, options);
    result.longest = linearised.LargestLength();
    result.converged =
      result.longest < LengthTolerance && linearised.LargestDefect() < DefectTolerance;
    const double residual =
      std::max(result.longest / LengthTolerance, linearised.LargestDefect() / DefectTolerance);
    const bool stalls = !shortened && residual > (1.0 - MinimumReduction) * previous;
    if (result.converged || stalls || result.maps == options.maximumMaps)
    {
      return result;
    }
    previous = residual;
    try
    {
      result.layout = LayOut(domain, linearised.Next(shortened), options.map, options.meshSize,
        progress.Part(static_cast<double>(result.maps) / options.maximumMaps,
          static_cast<double>(result.maps + 1) / options.maximumMaps));
    }
    catch (const Error&)
    {
      return result; // the step led to singularities without a layout
    }
    ++result.maps;
  }
}
}
