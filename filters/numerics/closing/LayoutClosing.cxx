#include "LayoutClosing.h"

#include "ArcDerivatives.h"
#include "ClosingStep.h"
#include "DomainQueries.h"
#include "Error.h"
#include "Index.h"
#include "Parts.h"
#include "Quantisation.h"
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
/// Numbers of steps without half the residual after which exact closing steps aside, and gives up.
constexpr int IdleBeforeAside = 4;
constexpr int MaximumIdle = 16;

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
    problem.lower[arc] = 1;
  }
  return Quantise(tMesh, problem, SearchEffort::Quick).counts;
}

/// Returns the length, in quads, below which an arc has vanished.
double LengthToleranceFor(const Layout& layout, const ClosingOptions& options)
{
  return options.exact ? SameIsoline * layout.map.Extent() / options.size : LengthTolerance;
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
  /// `defects` are the values that holonomy defects should have; 0 if empty.
  Linearisation(const PlanarDomain& domain, const Layout& layout,
    const std::vector<double>& defects, const ClosingOptions& options)
    : Start(layout)
    , Options(options)
    , Response(layout.map, layout.map.flattening ? nullptr : layout.potential)
    , Scale(Clearances(domain, Response, Response.GetMoving().size()))
  {
    this->Conditions.defects = this->Response.GetDefectDerivatives() * this->Scale.asDiagonal();
    this->Conditions.defect.resize(this->Conditions.defects.rows());
    for (Eigen::Index k = 0; k < this->Conditions.defect.size(); ++k)
    {
      const auto loop = static_cast<std::size_t>(k);
      const double defect = layout.map.holonomyDefect[loop];
      this->Conditions.defect[k] =
        0.25 * (defects.empty() ? defect : WrapAngle(defect - defects[loop]));
    }
    const ArcPaths paths(layout.map, layout.tMesh);
    if (options.exact)
    {
      this->Conditions.exact = true;
      for (const ArcPath& path : paths.Joined())
      {
        this->Joined.push_back(this->RowOf(path));
      }
    }
    this->ChooseArcs(paths);
  }

  double LargestLength() const
  {
    return this->Arcs.empty() ? 0.0 : this->Conditions.length.maxCoeff();
  }
  double LargestDefect() const
  {
    return this->Conditions.defect.size() == 0 ? 0.0
                                               : this->Conditions.defect.cwiseAbs().maxCoeff();
  }

  /// Returns the singularities after the step, and sets whether it was shortened. Every singularity
  /// also moves at a right angle to its step by `aside` times its length: where steps alternate
  /// between two triangulations, this leads to others.
  Configuration Next(double aside, bool& shortened) const
  {
    Eigen::Matrix2d turn;
    turn << 1.0, -aside, aside, 1.0;
    Configuration next = this->Start.singularities;
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
      next[cone.row].position +=
        fraction * this->Scale[2 * m] * (turn * this->Step.moves.segment<2>(2 * m));
    }
    return next;
  }

private:
  /// Returns the derivatives of a path in clearances and quads.
  Eigen::RowVectorXd RowOf(const ArcPath& path) const
  {
    return DifferentiateArc(this->Response, path) * this->Scale.asDiagonal() / this->Options.size;
  }

  /// Sets conditions for all arcs without edges that are not left out, then for separatrices that
  /// are joined.
  void SetConditions(const std::vector<int>& counts, const std::vector<int>& leftOut)
  {
    this->Arcs.clear();
    for (int arc = 0; arc < static_cast<int>(counts.size()); ++arc)
    {
      const bool isLeftOut = std::find(leftOut.begin(), leftOut.end(), arc) != leftOut.end();
      if (counts[arc] == 0 && !isLeftOut && this->Rows[arc].size() > 0)
      {
        this->Arcs.push_back(arc);
      }
    }
    const auto count = static_cast<Eigen::Index>(this->Arcs.size());
    const auto joined = static_cast<Eigen::Index>(this->Joined.size());
    this->Conditions.lengths.resize(count + joined, this->Response.Columns());
    this->Conditions.length = Eigen::VectorXd::Zero(count + joined);
    for (Eigen::Index row = 0; row < joined; ++row)
    {
      this->Conditions.lengths.row(count + row) = this->Joined[row];
    }
    for (Eigen::Index row = 0; row < count; ++row)
    {
      const std::size_t arc = Index(this->Arcs[row]);
      this->Conditions.lengths.row(row) = this->Rows[arc];
      this->Conditions.length[row] = this->Start.tMesh.arcs[arc].length / this->Options.size;
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
      if (counts[arc] == 0 && !this->IsKnown[arc])
      {
        this->IsKnown[arc] = true;
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
          const int arc = arcs[i];
          if (const std::optional<ArcPath> path = paths.Of(arc))
          {
            this->Rows[arc] = this->RowOf(*path);
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
    { return CoarseCounts(this->Start.tMesh, this->Options, coarseness, kept); };
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
      // Joined separatrices, whose rows follow those of arcs, are not given up.
      std::vector<Eigen::Index>& rows = this->Step.unreachable;
      rows.erase(
        std::remove_if(rows.begin(), rows.end(),
          [&](Eigen::Index row) { return row >= static_cast<Eigen::Index>(this->Arcs.size()); }),
        rows.end());
      if (rows.empty())
      {
        return;
      }
      const bool isLast = problems == MaximumProblems;
      const std::size_t before = kept.size();
      for (const Eigen::Index row : rows)
      {
        const int arc = this->Arcs[row];
        (isLast || fine[arc] == 0 ? leftOut : kept).push_back(arc);
      }
      if (kept.size() > before)
      {
        counts = countsFor(this->Options.coarseness, kept);
        ++problems;
      }
    }
  }

  const Layout& Start;
  const ClosingOptions& Options;
  const PositionResponse Response;
  const Eigen::VectorXd Scale;            ///< Clearances.
  std::vector<Eigen::RowVectorXd> Rows;   ///< Derivatives of arcs; empty if they have no path.
  std::vector<bool> IsKnown;              ///< Whether the row of an arc was computed.
  std::vector<int> Arcs;                  ///< The arcs of the conditions.
  std::vector<Eigen::RowVectorXd> Joined; ///< Derivatives of offsets between joined separatrices.
  ClosingConditions Conditions;
  ClosingStep Step;
};
}

std::vector<int> FindArcsToClose(const TMesh& tMesh, const ClosingOptions& options)
{
  const std::vector<int> counts = CoarseCounts(tMesh, options, options.coarseness, {});
  std::vector<int> arcs;
  for (int arc = 0; arc < static_cast<int>(counts.size()); ++arc)
  {
    if (counts[arc] == 0)
    {
      arcs.push_back(arc);
    }
  }
  return arcs;
}

ClosingResult CloseLayout(
  const PlanarDomain& domain, Layout start, const ClosingOptions& options, const Progress& progress)
{
  ClosingResult result;
  const Configuration first = start.singularities;
  const std::vector<double> defects =
    options.exact ? start.map.holonomyDefect : std::vector<double>();
  result.layout = std::move(start);
  double previous = 0.0;
  bool shortened = true;
  double best = std::numeric_limits<double>::infinity();
  int lastGain = 0; // number of maps when the residual was last halved
  for (;;)
  {
    // Derivatives are inaccurate where a flat metric differs from that of the potential.
    if ((result.layout.map.flattening && !options.exact) || !HasMoving(result.layout.map))
    {
      return result;
    }
    const Linearisation linearised(domain, result.layout, defects, options);
    const double tolerance = LengthToleranceFor(result.layout, options);
    result.longest = linearised.LargestLength();
    result.converged = result.longest < tolerance && linearised.LargestDefect() < DefectTolerance;
    const double residual =
      std::max(result.longest / tolerance, linearised.LargestDefect() / DefectTolerance);
    if (residual < 0.5 * best)
    {
      best = residual;
      lastGain = result.maps;
    }
    const int idle = result.maps - lastGain;
    const bool stalls = options.exact
      ? idle == MaximumIdle
      : !shortened && residual > (1.0 - MinimumReduction) * previous;
    if (result.converged || stalls || result.maps == options.maximumMaps)
    {
      return result;
    }
    previous = residual;
    // Farther each time, at last by 32 times a step that is small then.
    const double aside = options.exact && idle > 0 && idle % IdleBeforeAside == 0
      ? 0.5 * std::pow(4.0, idle / IdleBeforeAside)
      : 0.0;
    const Configuration next = linearised.Next(aside, shortened);
    if (LargestMove(first, next) > options.maximumMove)
    {
      return result;
    }
    try
    {
      const Progress part = progress.Part(static_cast<double>(result.maps) / options.maximumMaps,
        static_cast<double>(result.maps + 1) / options.maximumMaps);
      const SharedPlanarTopology topology = ShareTopology(options.mesh(next, part.Part(0.0, 0.3)));
      result.layout = LayOut(topology, next, options.map, true, part.Part(0.3, 1.0));
    }
    catch (const Error&)
    {
      return result; // the step led to singularities without a layout
    }
    ++result.maps;
  }
}
}
