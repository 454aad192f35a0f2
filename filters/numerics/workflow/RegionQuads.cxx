#include "RegionQuads.h"

#include "BoundarySymmetry.h"
#include "CurveSteps.h"
#include "HField.h"
#include "Index.h"
#include "JoinLayouts.h"
#include "MeshForPoints.h"
#include "NodePositions.h"
#include "Outcome.h"
#include "P1Interpolation.h"
#include "PeriodicSteps.h"
#include "PoincareHopf.h"
#include "QuadAdvice.h"
#include "QuadBudget.h"
#include "QuadMesher.h"
#include "QuadSteps.h"
#include "RegionNodes.h"
#include "SegmentSearch.h"
#include "SizeExtension.h"
#include "SizeTargets.h"
#include "WeldRegions.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <optional>
#include <utility>

namespace crossfield
{
namespace
{
/// Throws Error if a request has what is not available for several regions.
void RequireAvailable(const QuadRequest& request)
{
  const auto refuse = [](bool isRequested, const char* what, const char* option)
  {
    if (isRequested)
    {
      throw Error(std::string(what) +
        " are not available for several materials yet; leave them out (" + option +
        "), or mesh one material by itself.");
    }
  };
  const auto has = [&request](const auto& isWanted)
  { return std::any_of(request.sideRequests.begin(), request.sideRequests.end(), isWanted); };
  refuse(has([](const SideRequest& one) { return one.layer.has_value(); }), "Boundary layers",
    "Layers, --layers");
  refuse(has([](const SideRequest& one) { return !one.partner.empty(); }), "Periodic sides",
    "Periodic, --periodic");
  refuse(request.merge != BlockMerge::None, "Merged blocks", "Merge, --merge");
}

/// A region up to its layout.
struct LaidOutRegion
{
  PlanarDomain domain; ///< With curves sampled.
  ResolvedRequest request;
  std::optional<QuadSteps> placed; ///< With singularities, before the layout; refers to `domain`.
  QuadWorkflowResult result;
  Layout layout;
};

/// Chooses the singularities of a region unless they are given.
void Place(const PlanarDomain& polygons, const QuadRequest& own, QuadSeconds& seconds,
  const Progress& progress, LaidOutRegion& region)
{
  CurvedRequest curved = WithCurves(polygons, Resolve(polygons, own));
  region.domain = std::move(curved.domain);
  region.request = WithSizeTargets(region.domain, curved.request);
  region.placed.emplace(region.domain, region.request, seconds);
  region.placed->Place(progress);
}

/// Lays out a region, on a finer mesh or with the holonomy repaired if it fails otherwise.
void LayOut(const Progress& progress, LaidOutRegion& region)
{
  std::optional<Error> error;
  for (const bool repairs : { false, true })
  {
    for (const double refinement : { 1.0, 2.0 })
    {
      Outcome<bool> outcome = Try(
        [&]
        {
          QuadSteps steps = *region.placed;
          if (repairs)
          {
            steps.RepairHolonomy({});
          }
          region.layout = steps.LayOutOnly(refinement, progress);
          region.result = steps.GetResult();
          return true;
        });
      if (outcome.value)
      {
        return;
      }
      error = error ? error : outcome.error;
      if (outcome.error->GetKind() != Error::Kind::CoarseMesh)
      {
        break;
      }
    }
    if (error->GetKind() != Error::Kind::CoarseMesh || region.domain.loops.size() < 2)
    {
      break;
    }
  }
  throw Error(*error);
}

/// Returns what a region's energy is with singularities turned about a centre, beside others, but for a
/// constant: −Σ k_i k_j log |x_i − x_j|.
double EnergyOfTurn(const Configuration& own, const Configuration& others, const Isometry& turn)
{
  double energy = 0.0;
  for (const Singularity& one : own)
  {
    const Point place = turn(one.position);
    for (const Singularity& other : others)
    {
      energy -= one.quarterIndex * other.quarterIndex * std::log((place - other.position).norm());
    }
  }
  return energy;
}

/// Returns the rotation of singularities about a centre with the lowest energy, the identity if none is
/// lower by more than rounding.
Isometry LowestTurn(const Configuration& own, const Configuration& others, const Point& centre)
{
  constexpr int Directions = 360; // more than minima
  const auto energyAt = [&](double angle) {
    return EnergyOfTurn(own, others, { centre, angle, false });
  };
  double best = 0.0;
  constexpr double Rounding = 1e-9;
  const double present = energyAt(0.0);
  double lowest = present;
  for (int i = 1; i < Directions; ++i)
  {
    const double angle = 2.0 * Pi * i / Directions;
    if (energyAt(angle) < lowest - Rounding)
    {
      lowest = energyAt(angle);
      best = angle;
    }
  }
  double low = best - 2.0 * Pi / Directions;
  double high = best + 2.0 * Pi / Directions;
  constexpr int Thirds = 60; // (2/3)⁶⁰ of the interval
  for (int i = 0; i < Thirds; ++i)
  {
    const double third = (high - low) / 3.0;
    if (energyAt(low + third) < energyAt(high - third))
    {
      high -= third;
    }
    else
    {
      low += third;
    }
  }
  const double angle = 0.5 * (low + high);
  return { centre, energyAt(angle) < present - Rounding ? angle : 0.0, false };
}

/// Returns the quarter index that a boundary has by the smallest rotation at one of its vertices; 0 if
/// there is none.
int OutlineIndexAt(const PlanarDomain& outline, const Point& place)
{
  for (std::size_t l = 0; l < outline.loops.size(); ++l)
  {
    const Loop& loop = outline.loops[l];
    const auto found = std::find(loop.begin(), loop.end(), place);
    if (found != loop.end())
    {
      return SmallestRotationIndex(
        MakeCorner(outline.loops, l, static_cast<std::size_t>(found - loop.begin())).Turning());
    }
  }
  return 0;
}

/// Returns a request with what it prescribes for an interface, by the names of its materials in either
/// order or a given one, prescribed for each of its pieces.
QuadRequest ForPieces(const RegionSet& set, QuadRequest request)
{
  std::vector<SideRequest> expanded;
  for (const SideRequest& one : request.sideRequests)
  {
    const std::size_t before = expanded.size();
    for (const InterfacePiece& piece : set.interfaces)
    {
      const auto nameOf = [&](int region)
      { return set.materials[Index(set.regions[Index(region)].material)]; };
      const std::string reversed = nameOf(piece.regions[1]) + "+" + nameOf(piece.regions[0]);
      if (piece.side == one.side || piece.name == one.side || reversed == one.side)
      {
        expanded.push_back(one);
        expanded.back().side = piece.name;
      }
    }
    if (expanded.size() == before)
    {
      expanded.push_back(one);
    }
  }
  request.sideRequests = std::move(expanded);
  return request;
}

/// Removes sizes inside of materials from a request, and returns them per material; 0 without one.
std::vector<double> TakeSizesInside(const RegionSet& set, QuadRequest& request)
{
  std::vector<double> sizes(set.materials.size(), 0.0);
  const auto take = [&](const SideRequest& one)
  {
    const auto found = std::find(set.materials.begin(), set.materials.end(), one.side);
    if (one.inside <= 0.0 || found == set.materials.end())
    {
      return false;
    }
    sizes[static_cast<std::size_t>(found - set.materials.begin())] = one.inside;
    return true;
  };
  std::vector<SideRequest>& all = request.sideRequests;
  all.erase(std::remove_if(all.begin(), all.end(), take), all.end());
  const bool hasSizes =
    std::any_of(sizes.begin(), sizes.end(), [](double size) { return size > 0.0; });
  if (hasSizes && request.quadSize == 0.0 && request.quadCount == 0)
  {
    double area = 0.0;
    for (const PlanarDomain& outline : set.outlines)
    {
      area += outline.Area();
    }
    request.quadSize = std::sqrt(area / DefaultQuads);
  }
  return sizes;
}

/// Requests the sizes inside of materials in their regions, and at the interfaces of others with them.
void AddSizesInside(
  const RegionSet& set, const std::vector<double>& sizes, std::vector<PartRequest>& requests)
{
  const auto sizeOf = [&](int region) { return sizes[Index(set.regions[Index(region)].material)]; };
  for (std::size_t r = 0; r < requests.size(); ++r)
  {
    QuadRequest& own = requests[r].request;
    const double size = sizeOf(static_cast<int>(r));
    if (size > 0.0)
    {
      own.minimumSize = own.maximumSize = size;
      own.quadSize = 0.0;
      own.quadCount = 0;
    }
  }
  for (const InterfacePiece& piece : set.interfaces)
  {
    for (const std::size_t end : { std::size_t(0), std::size_t(1) })
    {
      const double size = sizeOf(piece.regions[end]);
      const int other = piece.regions[1 - end];
      if (size <= 0.0 || sizeOf(other) > 0.0)
      {
        continue;
      }
      std::vector<SideRequest>& all = requests[Index(other)].request.sideRequests;
      const bool isGiven = std::any_of(all.begin(), all.end(),
        [&piece](const SideRequest& one) { return one.side == piece.name && one.size > 0.0; });
      if (!isGiven)
      {
        all.emplace_back();
        all.back().side = piece.name;
        all.back().size = size;
      }
    }
  }
}

/// Makes the quads of a set.
class RegionMesher
{
public:
  RegionMesher(
    const RegionSet& set, const std::vector<DomainPart>& parts, const QuadRequest& request)
    : Set(set)
    , Parts(parts)
    , Request(request)
    , SizesInside(TakeSizesInside(set, this->Request))
    , Requests(SplitRequest(parts, ForPieces(set, this->Request)))
  {
    AddSizesInside(set, this->SizesInside, this->Requests);
    std::vector<std::vector<CornerChoice>> given;
    for (const PartRequest& one : this->Requests)
    {
      given.push_back(one.request.corners);
    }
    this->NodeCorners = FindNodeCorners(set, given);
    for (const std::vector<RegionCorner>& corners : this->NodeCorners)
    {
      for (const RegionCorner& one : corners)
      {
        std::vector<CornerChoice>& own = this->Requests[one.region].request.corners;
        const bool isGiven = std::any_of(own.begin(), own.end(),
          [&one](const CornerChoice& choice) { return choice.position == one.corner.position; });
        if (!isGiven && one.quarterIndex != SmallestRotationIndex(one.corner.Turning()))
        {
          own.push_back({ one.corner.position, one.quarterIndex });
        }
      }
    }
  }

  QuadWorkflowResult Run(const Progress& progress)
  {
    this->LayOutRegions(progress.Part(0.0, 0.6));
    this->Join();
    const QuadOptions options = this->MakeOptions();
    QuadResult quads = MakeQuads(this->Layouts, options, progress.Part(0.6, 1.0));
    this->DescribeResult(quads);
    this->Weld(std::move(quads));
    this->AddWarnings();
    return std::move(this->Result);
  }

private:
  const std::string& NameOf(std::size_t region) const
  {
    return this->Set.materials[Index(this->Set.regions[region].material)];
  }

  /// Calls a step for each region, with its part of the progress.
  template <class Step>
  void ForRegions(const Progress& progress, const Step& step)
  {
    double done = 0.0;
    for (std::size_t r = 0; r < this->Parts.size(); ++r)
    {
      const double end = std::min(1.0, done + this->Requests[r].share);
      try
      {
        step(r, progress.Part(done, end));
      }
      catch (const Error& error)
      {
        throw Error("Material '" + this->NameOf(r) + "' near " +
            Describe(this->Parts[r].domain.loops[0][0]) + ": " + error.what(),
          error.GetKind());
      }
      done = end;
    }
  }

  void LayOutRegions(const Progress& progress)
  {
    this->Regions.resize(this->Parts.size());
    this->ForRegions(progress.Part(0.0, 0.7),
      [&](std::size_t r, const Progress& part)
      {
        Place(this->Parts[r].domain, this->Requests[r].request, this->Result.seconds, part,
          this->Regions[r]);
      });
    this->TurnRoundRegions();
    this->ForRegions(progress.Part(0.7, 1.0),
      [&](std::size_t r, const Progress& part) { LayOut(part, this->Regions[r]); });
    this->UpdateNodeCorners();
  }

  /// Turns the chosen singularities of round regions to where they and those of the other regions have
  /// the lowest energy: by themselves such regions have no preferred direction.
  void TurnRoundRegions()
  {
    constexpr int Round = 12; // fewest symmetries: a regular polygon without corners
    constexpr int Sweeps = 2; // with several, each depends on the others
    for (int sweep = 0; sweep < Sweeps; ++sweep)
    {
      for (std::size_t r = 0; r < this->Regions.size(); ++r)
      {
        LaidOutRegion& region = this->Regions[r];
        const SymmetryGroup group = FindSymmetries(region.domain);
        if (group.order < Round || this->Requests[r].request.singularities ||
          region.request.targets)
        {
          continue;
        }
        Configuration others;
        for (std::size_t o = 0; o < this->Regions.size(); ++o)
        {
          const Configuration& those = this->Regions[o].placed->GetResult().singularities;
          others.insert(others.end(), o == r ? those.end() : those.begin(), those.end());
        }
        const Configuration own = region.placed->GetResult().singularities;
        const Isometry best = LowestTurn(own, others, group.centre);
        if (best.angle != 0.0)
        {
          Configuration turned = own;
          for (Singularity& one : turned)
          {
            one.position = best(one.position);
          }
          region.placed->MoveTo(std::move(turned));
        }
      }
    }
  }

  /// Sets the indices of corners at nodes to those used, which differ where a singularity is there.
  void UpdateNodeCorners()
  {
    for (std::vector<RegionCorner>& corners : this->NodeCorners)
    {
      for (RegionCorner& corner : corners)
      {
        for (const CornerChoice& used : this->Regions[corner.region].result.corners)
        {
          if (used.position == corner.corner.position)
          {
            corner.quarterIndex = used.quarterIndex;
          }
        }
      }
    }
  }

  /// Joins the layouts, sides and curves of all regions, and pairs the sides of interfaces.
  void Join()
  {
    std::vector<Layout> layouts;
    for (LaidOutRegion& region : this->Regions)
    {
      layouts.push_back(std::move(region.layout));
    }
    JoinedLayouts joined = JoinLayouts(layouts);
    this->Patches = joined.patches;
    std::vector<std::vector<int>> sides; // per region, of its sides in those of all
    for (std::size_t r = 0; r < this->Regions.size(); ++r)
    {
      const ResolvedRequest& own = this->Regions[r].request;
      const PlanarDomain& domain = this->Regions[r].domain;
      const std::vector<LoopArc> arcs(domain.loops.begin(), domain.loops.end());
      sides.push_back(this->AddSides(r, own.sides, arcs, joined.loops[r]));
      this->AddCurves(own.curves, arcs, joined.loops[r]);
      for (SidePrescription prescribed : own.prescribed)
      {
        prescribed.side = sides[r][Index(prescribed.side)];
        const bool isNew = std::none_of(this->Prescribed.begin(), this->Prescribed.end(),
          [&prescribed](const SidePrescription& one) { return one.side == prescribed.side; });
        if (isNew) // otherwise the side is on several regions
        {
          this->Prescribed.push_back(prescribed);
        }
      }
    }
    std::vector<PairedSides> pairs;
    for (const InterfacePiece& piece : this->Set.interfaces)
    {
      PairedSides pair;
      const auto sideIn = [&](int region)
      {
        return sides[Index(region)]
                    [Index(this->Regions[Index(region)].request.sides.Find(piece.name))];
      };
      pair.first = sideIn(piece.regions[0]);
      pair.second = sideIn(piece.regions[1]);
      pair.name = "The interface " + piece.name;
      pair.isClosed = piece.isClosed;
      pair.isInterface = true;
      this->PrescribeForSecond(pair);
      pairs.push_back(std::move(pair));
    }
    this->Layouts = LayoutSet(std::move(joined.layout), std::move(pairs));
  }

  /// Prescribes for the second side of a pair what is prescribed for the first.
  void PrescribeForSecond(const PairedSides& pair)
  {
    SidePrescriptions& all = this->Prescribed;
    all.erase(std::remove_if(all.begin(), all.end(),
                [&pair](const SidePrescription& one) { return one.side == pair.second; }),
      all.end());
    const auto first = std::find_if(all.begin(), all.end(),
      [&pair](const SidePrescription& one) { return one.side == pair.first; });
    if (first != all.end())
    {
      all.push_back(Reversed(*first, pair.second));
    }
  }

  /// Adds the sides of a region, and returns their numbers in those of all. Sides of equal names are one,
  /// but for the two sides of an interface.
  std::vector<int> AddSides(std::size_t region, const BoundarySides& sides,
    const std::vector<LoopArc>& arcs, const std::vector<int>& loops)
  {
    std::vector<int> numbers;
    for (const std::string& name : sides.names)
    {
      const bool isSecond = std::any_of(this->Set.interfaces.begin(), this->Set.interfaces.end(),
        [&](const InterfacePiece& piece)
        { return piece.name == name && Index(piece.regions[1]) == region; });
      const int known = isSecond ? -1 : this->Sides.Find(name);
      numbers.push_back(known < 0 ? static_cast<int>(this->Sides.names.size()) : known);
      if (known < 0)
      {
        this->Sides.names.push_back(name);
      }
    }
    const SidesAlong along(sides, arcs);
    for (std::size_t l = 0; l < arcs.size(); ++l)
    {
      for (const LoopSide& start : along.On(l))
      {
        this->Sides.starts.push_back(
          { arcs[l].At(start.at), numbers[Index(start.side)], start.isFixed, loops[l] });
      }
    }
    return numbers;
  }

  void AddCurves(
    const CurvedBoundary& curves, const std::vector<LoopArc>& arcs, const std::vector<int>& loops)
  {
    const auto first = static_cast<int>(this->Curves.curves.size());
    this->Curves.curves.insert(
      this->Curves.curves.end(), curves.curves.begin(), curves.curves.end());
    const CurvesAlong along(curves, arcs);
    for (std::size_t l = 0; l < arcs.size(); ++l)
    {
      for (const double at : along.StartsOn(l))
      {
        const int curve = along.At(l, at);
        this->Curves.starts.push_back({ arcs[l].At(at), curve < 0 ? -1 : first + curve, loops[l] });
      }
    }
  }

  QuadOptions MakeOptions() const
  {
    QuadOptions options;
    options.quadSize = this->Request.quadSize;
    options.quadCount = this->Request.quadCount;
    options.sides = this->Sides;
    options.curves = this->Curves;
    options.prescribed = this->Prescribed;
    options.hold = this->Request.hold;
    const bool hasSizes = std::any_of(this->Regions.begin(), this->Regions.end(),
      [](const LaidOutRegion& region) { return region.request.targets.has_value(); });
    if (hasSizes)
    {
      const RelativeSizes sizes = RelativeTo(this->JoinTargets());
      options.sizes = { Sizing::Field, sizes.field };
      const bool isFixed = this->Request.quadSize > 0.0 || this->Request.quadCount == 0;
      options.quadSize = isFixed ? sizes.mean : 0.0;
    }
    else if (this->Request.sizing == Sizing::Uniform)
    {
      options.sizes.sizing = Sizing::Uniform;
    }
    else
    {
      options.sizes = { Sizing::Field, this->CommonSizes() };
    }
    return options;
  }

  /// Returns the target sizes of the region that contains each place.
  SizeTargets JoinTargets() const
  {
    struct Sized
    {
      SegmentSearch boundary;
      SizeFunction length;
    };
    auto all = std::make_shared<std::vector<Sized>>();
    double area = 0.0;
    double quads = 0.0;
    for (const LaidOutRegion& region : this->Regions)
    {
      const double own = region.domain.Area();
      const double mean = region.request.targets ? region.request.targets->mean
                                                 : std::sqrt(own / region.request.quadCount);
      all->push_back({ SegmentSearch(region.domain),
        region.request.targets ? region.request.targets->length
                               : SizeFunction([mean](const Point&) { return mean; }) });
      area += own;
      quads += own / (mean * mean);
    }
    SizeTargets joined;
    joined.mean = std::sqrt(area / quads);
    joined.length = [all](const Point& place)
    {
      const Sized* nearest = nullptr;
      double largest = 0.0;
      for (const Sized& one : *all)
      {
        const double distance = one.boundary.SignedDistance(place);
        if (nearest == nullptr || distance > largest)
        {
          largest = distance;
          nearest = &one;
        }
      }
      return nearest->length(place);
    };
    return joined;
  }

  /// Returns e^H of the singularities of all regions and of their nodes (docs/method.md §21.4).
  SizeFunction CommonSizes() const
  {
    struct Part
    {
      SegmentSearch boundary;
      P1Interpolation sizes;
    };
    auto all = std::make_shared<std::vector<Part>>();
    for (const PlanarDomain& outline : this->Set.outlines)
    {
      const SegmentSearch boundary(outline);
      const double reach = BoundaryReach * outline.Diagonal();
      Configuration singularities;
      std::vector<CornerChoice> corners;
      std::vector<Point> kept; // nodes with another index than their angle has
      const auto addCorner = [&](const CornerChoice& choice)
      {
        if (std::abs(boundary.SignedDistance(choice.position)) <= reach)
        {
          corners.push_back(choice);
        }
      };
      for (std::size_t n = 0; n < this->Set.nodes.size(); ++n)
      {
        const RegionNode& node = this->Set.nodes[n];
        const int index = IndexAt(node, this->NodeCorners[n]);
        if (node.isOnBoundary)
        {
          if (index != OutlineIndexAt(outline, node.place))
          {
            addCorner({ node.place, index });
            kept.push_back(node.place);
          }
        }
        else if (index != 0 && boundary.SignedDistance(node.place) > 0.0)
        {
          singularities.push_back({ node.place, index });
        }
      }
      for (const LaidOutRegion& region : this->Regions)
      {
        const SegmentSearch own(region.domain);
        for (const Singularity& one : region.result.singularities)
        {
          // One on the boundary of the region is part of the index of its corner.
          if (own.SignedDistance(one.position) > reach &&
            boundary.SignedDistance(one.position) > reach)
          {
            singularities.push_back(one);
          }
        }
        for (const CornerChoice& choice : region.result.corners)
        {
          if (!this->IsNode(choice.position))
          {
            addCorner(choice);
            kept.push_back(choice.position);
          }
        }
      }
      const SharedPlanarTopology topology = ShareTopology(
        MeshThroughPoints(outline, singularities, this->Request.meshSize, {}, 1.0, kept));
      const Eigen::VectorXd sizes =
        SolveHField(topology, singularities, corners).h.array().exp().matrix();
      const double mean = EquivalentSize(topology->mesh, sizes);
      all->push_back({ boundary, P1Interpolation(topology->mesh, sizes / mean) });
    }
    return [all](const Point& place)
    {
      const Part* inside = &all->front();
      for (const Part& part : *all)
      {
        if (part.boundary.SignedDistance(place) > inside->boundary.SignedDistance(place))
        {
          inside = &part;
        }
      }
      return inside->sizes.At(place);
    };
  }

  bool IsNode(const Point& place) const
  {
    return std::any_of(this->Set.nodes.begin(), this->Set.nodes.end(),
      [&place](const RegionNode& node) { return node.place == place; });
  }

  /// Sets what the result says about singularities, corners and regions.
  void DescribeResult(const QuadResult& quads)
  {
    QuadWorkflowResult& result = this->Result;
    const SeamlessMap& map = this->Layouts.Single().map;
    result.materials = this->Set.materials;
    result.holonomyDefect = map.holonomyDefect;
    result.flattening = map.flattening;
    Configuration chosen;
    for (std::size_t r = 0; r < this->Regions.size(); ++r)
    {
      const QuadWorkflowResult& own = this->Regions[r].result;
      chosen.insert(chosen.end(), own.singularities.begin(), own.singularities.end());
      result.corners.insert(result.corners.end(), own.corners.begin(), own.corners.end());
      const std::string prefix = this->NameOf(r) + ": ";
      for (const std::string& event : own.events)
      {
        result.events.push_back(prefix + event);
      }
      RegionReport report;
      report.material = this->Set.regions[r].material;
      report.requiredQuarters =
        CountQuarters(this->Regions[r].domain.loops, 0, DefaultCornerAngle, own.corners)
          .requiredInteriorQuarters;
      for (const Singularity& one : own.singularities)
      {
        report.givenQuarters += one.quarterIndex;
      }
      result.regions.push_back(report);
    }
    NodePositions nodes = FindNodePositions(map, quads.mesh, chosen, chosen);
    result.singularities = std::move(nodes.singularities);
    result.moved = nodes.moved;
    if (this->Request.singularities)
    {
      this->AddMoves(chosen);
    }
    result.boundary = this->Curves;
    result.blocks.none = quads.separateBlocks;
    result.seconds.integers += quads.counts.seconds;
    result.seconds.layout += quads.layoutSeconds;
    result.seconds.smooth += quads.smoothSeconds;
  }

  /// Adds the moves of given singularities, with their rows in the request.
  void AddMoves(const Configuration& chosen)
  {
    std::vector<std::size_t> rows;
    for (std::size_t r = 0; r < this->Regions.size(); ++r)
    {
      const bool areGiven = this->Requests[r].request.singularities.has_value();
      for (std::size_t i = 0; i < this->Regions[r].result.singularities.size(); ++i)
      {
        rows.push_back(areGiven && i < this->Requests[r].rows.size() ? this->Requests[r].rows[i]
                                                                     : std::size_t(-1));
      }
    }
    std::vector<SingularityMove> moves;
    for (SingularityMove move :
      FindMoves(chosen, this->Result.singularities, this->Set.outlines.front().Diagonal()))
    {
      if (rows[move.row] != std::size_t(-1))
      {
        move.row = rows[move.row];
        moves.push_back(move);
      }
    }
    this->Result.moves = std::move(moves);
  }

  /// Makes one mesh of those of the regions.
  void Weld(QuadResult quads)
  {
    std::vector<int>& region = this->Result.region;
    for (const int patch : quads.mesh.patch)
    {
      const auto after = std::upper_bound(
        this->Patches.begin(), this->Patches.end(), static_cast<std::size_t>(patch));
      region.push_back(static_cast<int>(after - this->Patches.begin()) - 1);
      ++this->Result.regions[Index(region.back())].quads;
    }
    for (std::size_t i = 0; i < this->Set.interfaces.size(); ++i)
    {
      const PairedSides& pair = this->Layouts.pairs[i];
      for (const int side : { pair.first, pair.second })
      {
        quads.mesh.sideNames[Index(side)] = this->Set.interfaces[i].side;
      }
    }
    WeldRegions(quads.mesh);
    quads.blocks = FindBlocks(quads.mesh, region);
    quads.separateBlocks = static_cast<int>(quads.blocks.blocks.size());
    this->Result.blocks.none = quads.separateBlocks;
    quads.quality = MeasureQuads(quads.mesh, quads.size);
    this->Result.part.assign(quads.mesh.quads.size(), 0);
    this->Result.quads = std::move(quads);
  }

  void AddWarnings()
  {
    QuadWorkflowResult& result = this->Result;
    const bool isPrescribed = !this->Prescribed.empty() || this->Request.minimumSize > 0.0 ||
      this->Request.maximumSize > 0.0;
    const QuadResult& quads = result.quads;
    for (const std::string& warning : { quads.quality.inverted > 0
             ? DescribeInverted(quads.quality, {}, this->Request.singularities.has_value())
             : std::string(),
           DescribeCount(this->Request, isPrescribed, quads), DescribeArea(quads),
           DescribeWorstQuad(quads.mesh, quads.quality) })
    {
      if (!warning.empty())
      {
        result.warnings.push_back(warning);
      }
    }
  }

  const RegionSet& Set;
  const std::vector<DomainPart>& Parts;
  QuadRequest Request;
  const std::vector<double> SizesInside; ///< Per material.
  std::vector<PartRequest> Requests;
  std::vector<std::vector<RegionCorner>> NodeCorners; ///< Per node of the set.
  std::deque<LaidOutRegion> Regions; ///< Steps refer to domains, which do not move.
  std::vector<std::size_t> Patches;  ///< First patch of each region, and their number.
  BoundarySides Sides;               ///< Of all regions.
  CurvedBoundary Curves;
  SidePrescriptions Prescribed;
  LayoutSet Layouts;
  QuadWorkflowResult Result;
};
}

QuadWorkflowResult MakeQuadsOfRegions(const RegionSet& set, const std::vector<DomainPart>& parts,
  const QuadRequest& request, const Progress& progress)
{
  RequireAvailable(request);
  return RegionMesher(set, parts, request).Run(progress);
}
}
