#include "QuadSteps.h"

#include "IndexSplit.h"
#include "LayerSteps.h"
#include "MergedQuads.h"
#include "MeshForPoints.h"
#include "NodePositions.h"
#include "OptimizerReport.h"
#include "Outcome.h"
#include "PoincareHopf.h"
#include "QuadAdvice.h"
#include "RequestedSingularities.h"
#include "Stopwatch.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// Part of a side on which the first height of its layer must hold for there to be no warning.
constexpr double EnoughInBounds = 0.9;

/// Adds the seconds of its scope to a number, also if an exception leaves it.
class ScopedSeconds
{
public:
  explicit ScopedSeconds(double& seconds)
    : Seconds(seconds)
  {
  }
  ScopedSeconds(const ScopedSeconds&) = delete;
  ScopedSeconds& operator=(const ScopedSeconds&) = delete;
  ~ScopedSeconds() { this->Seconds += this->Clock.Lap(); }

private:
  double& Seconds;
  Stopwatch Clock;
};

/// Returns call(). If it throws Error, adds its seconds to a number; otherwise its value has the
/// times of its stages.
template <typename Call>
auto WithSecondsOfFailure(double& seconds, const Call& call)
{
  Stopwatch clock;
  auto outcome = Try(call);
  if (!outcome.value)
  {
    seconds += clock.Lap();
    throw Error(*outcome.error);
  }
  return std::move(*outcome.value);
}

/// Throws Error if a singularity on the boundary makes the quarter index there 2 or more, which
/// leaves no angle for a quad. Capping changes corners of the domain only.
void RequireAngles(const PlanarDomain& domain, const Configuration& singularities,
  const std::vector<CountedCorner>& corners)
{
  const double reach = BoundaryReach * domain.Diagonal();
  for (const CountedCorner& corner : corners)
  {
    const bool isSingular = std::any_of(singularities.begin(), singularities.end(),
      [&](const Singularity& singularity)
      {
        return singularity.quarterIndex > 0 &&
          (singularity.position - corner.position).norm() <= reach;
      });
    if (isSingular && corner.quarterIndex > 1)
    {
      throw Error("With the singularities at " + Describe(corner.position) +
        ", the boundary there has quarter index " + std::to_string(corner.quarterIndex) +
        ", which leaves no angle for a quad; give singularities of index 1 inside the domain "
        "instead.");
    }
  }
}
}

QuadSteps::QuadSteps(const PlanarDomain& domain, ResolvedRequest request, QuadSeconds& seconds)
  : Domain(domain)
  , Request(std::move(request))
  , Total(this->Request.quadCount)
  , Seconds(seconds)
{
  RequireLayers(this->Request.layers, this->Request.sides.names, domain.Diagonal());
  if (!this->Request.layers.empty() && this->Request.quadSize == 0.0)
  {
    this->Request.quadCount = CountBeforeLayers(domain, this->Request);
    if (this->Request.targets)
    {
      this->Request.targets->Multiply(
        std::sqrt(static_cast<double>(this->Total) / this->Request.quadCount));
    }
  }
  this->MapOptions.corners = CompleteCorners(domain, this->Request);
  this->MapOptions.capCorners = this->Request.capCorners;
}

void QuadSteps::Place(const Progress& progress)
{
  this->Choose(progress.Part(0.0, 0.9));
  this->Split();
  this->RepairOnRequest(progress.Part(0.9, 1.0));
}

void QuadSteps::Choose(const Progress& progress)
{
  if (this->Request.singularities)
  {
    this->Result.singularities = *this->Request.singularities;
    if (this->Request.targets && this->Request.pairs > 0)
    {
      this->AddPairs(progress);
    }
    return;
  }
  const ScopedSeconds timed(this->Seconds.choose);
  AutomaticConfiguration choice = ChooseSingularities(this->Domain, this->Request, progress);
  this->Others = std::move(choice.others);
  this->Use(std::move(choice));
}

/// Adds pairs to given singularities for target sizes.
void QuadSteps::AddPairs(const Progress& progress)
{
  const ScopedSeconds timed(this->Seconds.choose);
  const std::optional<SizedConfiguration> added = WithPairs(this->Domain, this->Request, progress);
  if (!added || added->singularities.size() == this->Result.singularities.size())
  {
    this->AddEvent("No pair of singularities brings sizes closer to the target sizes.");
    return;
  }
  const std::size_t pairs = (added->singularities.size() - this->Result.singularities.size()) / 2;
  this->Result.singularities = added->singularities;
  this->AddEvent(std::to_string(pairs) + (pairs == 1 ? " pair" : " pairs") + " of singularities " +
    (pairs == 1 ? "was" : "were") +
    " added for the target sizes; the standard deviation of the logarithm of size "
    "over target size is " +
    FormatShort(added->spread) + ".");
}

void QuadSteps::Use(AutomaticConfiguration choice)
{
  this->Result.singularities = std::move(choice.singularities);
  this->Result.events = std::move(choice.events);
  this->Result.optimum = std::move(choice.optimum);
  this->MapOptions.corners = std::move(choice.corners);
}

void QuadSteps::UseChoice(std::size_t choice)
{
  if (choice > 0)
  {
    this->Use(this->Others[choice - 1]);
    this->Split();
    this->RepairOnRequest({});
  }
}

/// Splits large quarter indices on request; otherwise throws Error for those without a node.
void QuadSteps::Split()
{
  if (this->Request.split)
  {
    SplitConfiguration split =
      SplitIndices(this->Domain, this->Result.singularities, 1.5 * this->SideLength());
    this->Result.singularities = std::move(split.singularities);
    this->AddEvents(split.events);
  }
  RequireNodes(this->Domain, this->Result.singularities);
  this->Start = this->BeforeRepair = this->Result.singularities;
}

void QuadSteps::RepairOnRequest(const Progress& progress)
{
  if (!this->Request.repairHolonomy)
  {
    return;
  }
  const ScopedSeconds timed(this->Seconds.choose);
  Outcome<HolonomyRepair> repair = Try(
    [&]
    {
      return RepairForMap(
        this->Domain, this->BeforeRepair, this->MapOptions, this->Request.meshSize, progress);
    });
  if (!repair.value)
  {
    if (this->Request.singularities)
    {
      throw Error(*repair.error);
    }
    this->AddEvent("The holonomy was not repaired. " + std::string(repair.error->what()));
    return;
  }
  const double part = this->Request.repairPart;
  for (std::size_t i = 0; part < 1.0 && i < this->BeforeRepair.size(); ++i)
  {
    Point& position = repair.value->singularities[i].position;
    position = (1.0 - part) * this->BeforeRepair[i].position + part * position;
  }
  repair.value->largestMove *= part;
  this->UseRepair(std::move(*repair.value));
}

void QuadSteps::RepairHolonomy(const Progress& progress)
{
  std::optional<HolonomyRepair> repair = this->FindRepair(progress);
  if (!repair)
  {
    throw Error("The holonomy needs no repair, or none was found.");
  }
  this->UseRepair(std::move(*repair));
  this->Motion = "so that grid lines close up around the inner loops";
}

void QuadSteps::MoveToMinimumEnergy(const Progress& progress)
{
  const ScopedSeconds timed(this->Seconds.choose);
  OptimizerResult minimum =
    MinimiseEnergy(this->Domain, this->Request, this->BeforeRepair, progress);
  this->Result.singularities = std::move(minimum.configuration);
  this->Motion = "towards a minimum of the energy"; // the run may end before it
}

void QuadSteps::DoNotMerge()
{
  this->Request.merge = BlockMerge::None;
  this->AddEvent("Blocks were not merged, because that leaves too few rows for the layers.");
}

QuadWorkflowResult QuadSteps::MakeQuads(double refinement, const Progress& progress)
{
  if (refinement > 1.0)
  {
    this->AddEvent("The triangle mesh was refined once, to edges half as long.");
  }
  const double laidOut = this->Request.merge == BlockMerge::None ? 0.6 : 0.2;
  Layout layout = this->MakeLayout(refinement, progress.Part(0.0, laidOut));
  this->MakeQuadsOf(std::move(layout), progress.Part(laidOut, 1.0));
  return std::move(this->Result);
}

void QuadSteps::MoveTo(Configuration singularities)
{
  this->Result.singularities = this->Start = this->BeforeRepair = std::move(singularities);
}

Layout QuadSteps::LayOutOnly(double refinement, const Progress& progress)
{
  Layout layout = this->MakeLayout(refinement, progress);
  this->Describe(layout);
  return layout;
}

/// Returns a mesh with edges divided by `refinement`.
SharedPlanarTopology QuadSteps::MakeMesh(double refinement, const Progress& progress)
{
  const ScopedSeconds timed(this->Seconds.mesh);
  SharedPlanarTopology topology =
    ShareTopology(MeshThroughPoints(this->Domain, this->Result.singularities,
      this->Request.meshSize, progress, refinement, this->Request.sides.FixedPlaces()));
  RequireAngles(this->Domain, this->Result.singularities, this->CornersOn(*topology));
  return topology;
}

/// Meshes, solves for the map and traces the separatrices.
Layout QuadSteps::MakeLayout(double refinement, const Progress& progress)
{
  const SharedPlanarTopology topology = this->MakeMesh(refinement, progress.Part(0.0, 0.2));
  Layout layout = WithSecondsOfFailure(this->Seconds.map,
    [&]
    {
      return LayOut(topology, this->Result.singularities, this->MapOptions,
        this->Request.merge != BlockMerge::None, progress.Part(0.2, 1.0));
    });
  this->Seconds.map += layout.mapSeconds;
  this->Seconds.trace += layout.traceSeconds;
  return layout;
}

/// Makes the quads of a layout, merges blocks and adds layers.
void QuadSteps::MakeQuadsOf(Layout layout, const Progress& progress)
{
  MergedQuads merged = WithSecondsOfFailure(this->Seconds.layout,
    [&]
    {
      return MakeMergedQuads(
        this->Domain, this->Request, std::move(layout), this->MapOptions, progress);
    });
  this->MapOptions = std::move(merged.map);
  this->AddEvents(merged.events);
  this->Result.blocks = merged.blocks;
  const Layout& used = merged.mesh.layouts.Single();
  if (this->Request.merge != BlockMerge::None)
  {
    this->Result.singularities = this->BeforeRepair = used.singularities;
  }
  this->Describe(used);
  QuadResult& quads = merged.mesh.quads;
  this->Seconds.clean += merged.cleanSeconds;
  this->Seconds.integers += quads.counts.seconds;
  this->Seconds.layout += quads.layoutSeconds;
  this->Seconds.smooth += quads.smoothSeconds;
  if (!this->Request.layers.empty())
  {
    const ScopedSeconds timed(this->Seconds.layout);
    this->Result.layers = AddLayersForCount(
      this->Domain, this->Request, this->Total, merged.mesh.layouts, merged.options, quads);
  }
  if (this->Request.targets)
  {
    this->Result.sizes = MeasureSizes(quads, *this->Request.targets);
    this->Result.sizes->nodesAdded = this->CountAddedNodes();
  }
  NodePositions nodes =
    FindNodePositions(used.map, quads.mesh, this->Result.singularities, this->BeforeRepair);
  this->Result.singularities = std::move(nodes.singularities);
  this->Result.moved = std::max(merged.moved, nodes.moved);
  this->AddEvents(nodes.events);
  if (this->Request.singularities)
  {
    this->Result.moves =
      FindMoves(this->Start, this->Result.singularities, this->Domain.Diagonal());
  }
  if (quads.smoothing.isAsymmetric)
  {
    this->AddEvent(
      "The quads have no symmetry, because the nodes of periodic sides would not match then.");
  }
  this->Result.quads = std::move(quads);
  this->AddWarnings();
}

/// Returns the number of singularities beyond those that are given, or that the boundary requires.
int QuadSteps::CountAddedNodes() const
{
  const Configuration& used = this->Result.singularities;
  if (this->Request.singularities)
  {
    return static_cast<int>(used.size()) - static_cast<int>(this->Request.singularities->size());
  }
  int sum = 0;
  int count = 0;
  for (const Singularity& singularity : used)
  {
    sum += singularity.quarterIndex;
    count += std::abs(singularity.quarterIndex);
  }
  return count - std::abs(sum);
}

/// Returns the corners of a mesh with their quarter indices.
std::vector<CountedCorner> QuadSteps::CornersOn(const PlanarTopology& topology) const
{
  const PlacedConfiguration placed =
    PlaceForMap(topology, this->Result.singularities, this->MapOptions);
  return CountMeshQuarters(topology, placed.corners).corners;
}

/// Sets what the result says about a map.
void QuadSteps::Describe(const Layout& layout)
{
  this->Result.holonomyDefect = layout.map.holonomyDefect;
  this->Result.flattening = layout.map.flattening;
  this->Result.corners.clear();
  for (const CountedCorner& corner : this->CornersOn(*RequirePlanar(layout.map.topology)))
  {
    this->Result.corners.push_back({ corner.position, corner.quarterIndex });
  }
}

void QuadSteps::AddEvents(const std::vector<std::string>& events)
{
  this->Result.events.insert(this->Result.events.end(), events.begin(), events.end());
}

void QuadSteps::UseRepair(HolonomyRepair repair)
{
  this->Result.singularities = repair.singularities;
  this->Result.repair = std::move(repair);
}

/// Returns a repair of the holonomy that was not requested; none if there is nothing to repair or
/// it is impossible.
std::optional<HolonomyRepair> QuadSteps::FindRepair(const Progress& progress)
{
  if (this->Result.repair || this->Domain.loops.size() < 2)
  {
    return std::nullopt;
  }
  const ScopedSeconds timed(this->Seconds.choose);
  Outcome<HolonomyRepair> repair = Try(
    [&]
    {
      return RepairForMap(
        this->Domain, this->BeforeRepair, this->MapOptions, this->Request.meshSize, progress);
    });
  const bool isNoticeable = repair.value &&
    std::any_of(repair.value->before.begin(), repair.value->before.end(),
      [](double defect) { return std::abs(defect) > NoticeableDefect; });
  return isNoticeable ? std::move(repair.value) : std::nullopt;
}

void QuadSteps::AddWarnings()
{
  QuadWorkflowResult& result = this->Result;
  result.warnings = DescribeFlatNodes(this->Domain, result.singularities);
  if (result.sizes)
  {
    const std::string missed = DescribeMissedSizes(*result.sizes);
    const std::string others = missed.empty() || !this->Request.singularities
      ? std::string()
      : DescribeOthersForSizes(this->Domain, this->Request);
    for (const std::string& warning :
      { this->Request.targets->warning, others.empty() ? missed : missed + " " + others })
    {
      if (!warning.empty())
      {
        result.warnings.push_back(warning);
      }
    }
  }
  if (!this->Motion.empty())
  {
    const std::string sentence = "The singularities were moved " + this->Motion + ", by up to " +
      FormatShort(result.moved) + ", because there were no valid quads without this.";
    // A user who gave positions must learn of it.
    (result.moves ? result.warnings : result.events).push_back(sentence);
  }
  for (const LayerReport& layer : result.layers)
  {
    if (!layer.lack.empty())
    {
      result.warnings.push_back(Sentence(layer.lack + "; heights of neighbours differ by up to " +
          FormatNumber(layer.largestRatio, 3) + " : 1, and the first row has the given height on " +
          FormatNumber(100.0 * layer.partInBounds, 3) + " % of the side",
        "use smaller quads, or a larger growth"));
    }
    else if (layer.partInBounds < EnoughInBounds)
    {
      result.warnings.push_back("The first row of the layer of '" + layer.name + "' is " +
        FormatNumber(layer.minimumHeight, 3) + " to " + FormatNumber(layer.maximumHeight, 3) +
        " high; within 5 % of the given height on " + FormatNumber(100.0 * layer.partInBounds, 3) +
        " % of the side only.");
    }
  }
  if (!this->Request.split)
  {
    this->AddEvents(DescribeCrowdedNodes(this->Domain, result.singularities));
  }
  if (result.flattening && result.flattening->PredictedStretch() > NoticeableStretch)
  {
    const std::optional<HolonomyRepair> repair = this->FindRepair();
    result.warnings.push_back(
      DescribeStretch(*result.flattening, repair ? RepairAdvice(*repair) : std::string()));
  }
}

/// Returns the side length of quads that the request asks for.
double QuadSteps::SideLength() const
{
  return this->Request.quadSize > 0.0 && this->Request.sizing != Sizing::Field
    ? this->Request.quadSize
    : std::sqrt(this->Domain.Area() / this->Request.quadCount);
}
}
