#include "RegionQuads.h"

#include "BoundarySingularities.h"
#include "BoundarySymmetry.h"
#include "HeldNodes.h"
#include "Index.h"
#include "NodePositions.h"
#include "OptimizerReport.h"
#include "Outcome.h"
#include "PoincareHopf.h"
#include "QuadAdvice.h"
#include "QuadBudget.h"
#include "QuadMesher.h"
#include "QuadSteps.h"
#include "RegionJoin.h"
#include "RegionRequests.h"
#include "RegionSides.h"
#include "RegionSizes.h"
#include "RegionTurns.h"
#include "Segment.h"
#include "SharpTips.h"
#include "WeldRegions.h"

#include <algorithm>
#include <cmath>
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
  refuse(request.merge == BlockMerge::Clean, "Moves of singularities that merge blocks",
    "Merge, --merge clean");
}

/// Returns the point of a polyline nearest to a place.
Point NearestOn(const std::vector<Point>& line, const Point& place)
{
  Point offset = place - line.front();
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    const Point other = OffsetFromSegment(place, line[i - 1], line[i]);
    offset = other.norm() < offset.norm() ? other : offset;
  }
  return place - offset;
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
  {
    RegionRequests requests = SplitForRegions(set, parts, request);
    this->Requests = std::move(requests.ofRegions);
    this->NodeCorners = std::move(requests.nodeCorners);
    this->Targets = std::move(requests.targets);
  }

  QuadWorkflowResult Run(const Progress& progress)
  {
    this->LayOutRegions(progress.Part(0.0, 0.6));
    this->Joined = JoinRegions(this->Set, this->Regions, this->Targets);
    const QuadOptions options = this->MakeOptions();
    QuadResult quads = MakeQuads(this->Joined.layouts, options, progress.Part(0.6, 1.0));
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
        throw this->ErrorOf(r, error);
      }
      done = end;
    }
  }

  /// Returns the error of a region with the name of its material, and the remedy that was found for it.
  Error ErrorOf(std::size_t region, const Error& error) const
  {
    const std::string start = DescribeRegion(this->Set, region) + ": ";
    if (error.GetKind() != Error::Kind::CoarseMesh || error.GetCause().empty())
    {
      return Error(start + error.what(), error.GetKind());
    }
    return { start + error.GetCause(), this->FindRemedy(region), error.GetKind() };
  }

  /// Returns how far the sharp corners of a region must be cut off until it can be laid out by itself, in words;
  /// an empty text if that does not help.
  std::string FindRemedy(std::size_t region) const
  {
    const PlanarDomain& domain = this->Parts[region].domain;
    QuadRequest request = this->Requests[region].request;
    request.corners.clear(); // those with prescribed indices would stay
    for (const double part : TipLengths)
    {
      const double length = part * domain.Diagonal();
      const std::optional<CutDomain> cut = CutSharpTips(domain, request, length);
      LaidOutRegion trial;
      QuadSeconds seconds;
      const bool helps = cut &&
        Try(
          [&]
          {
            PlaceSingularities(cut->domain, cut->request, seconds, {}, trial);
            LayOutRegion({}, trial);
            return true;
          })
          .value;
      if (helps)
      {
        return "cut off its corners below 45° " + FormatShort(length) +
          " before their tips, with which it has quads by itself";
      }
    }
    return "";
  }

  void LayOutRegions(const Progress& progress)
  {
    this->Regions.resize(this->Parts.size());
    this->ForRegions(progress.Part(0.0, 0.7),
      [&](std::size_t r, const Progress& part)
      {
        PlaceSingularities(this->Parts[r].domain, this->Requests[r].request, this->Result.seconds,
          part, this->Regions[r]);
      });
    this->TurnRoundRegions();
    this->ForRegions(progress.Part(0.7, 1.0),
      [&](std::size_t r, const Progress& part) { LayOutRegion(part, this->Regions[r]); });
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

  QuadOptions MakeOptions()
  {
    QuadOptions options;
    options.quadSize = this->Request.quadSize;
    options.quadCount = this->Request.quadCount;
    options.sides = this->Joined.sides;
    options.curves = this->Joined.curves;
    options.prescribed = this->Joined.prescribed;
    options.hold = this->Request.hold;
    options.nodes = this->Request.nodes;
    options.coarse = this->Request.merge == BlockMerge::Coarse;
    if (this->Set.outlines.size() == 1)
    {
      options.symmetries = FindSymmetries(this->Set.outlines[0]).Elements();
    }
    const bool hasSizes = std::any_of(this->Regions.begin(), this->Regions.end(),
      [](const LaidOutRegion& region) { return region.request.targets.has_value(); });
    if (hasSizes)
    {
      this->Sizes = JoinTargets(this->Regions);
      const RelativeSizes sizes = RelativeTo(*this->Sizes);
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
      options.sizes = { Sizing::Field,
        CommonSizes(this->Set, this->NodeCorners, this->Regions, this->Request.meshSize) };
    }
    return options;
  }

  /// Sets what the result says about singularities, corners and regions.
  void DescribeResult(const QuadResult& quads)
  {
    QuadWorkflowResult& result = this->Result;
    const SeamlessMap& map = this->Joined.layouts.Single().map;
    result.materials = this->Set.materials;
    result.holonomyDefect = map.holonomyDefect;
    result.flattening = map.flattening;
    Configuration chosen;
    for (std::size_t r = 0; r < this->Regions.size(); ++r)
    {
      const QuadWorkflowResult& own = this->Regions[r].result;
      chosen.insert(chosen.end(), own.singularities.begin(), own.singularities.end());
      result.corners.insert(result.corners.end(), own.corners.begin(), own.corners.end());
      const std::string prefix =
        this->Set.materials.size() > 1 ? this->NameOf(r) + ": " : std::string();
      for (const std::string& event : own.events)
      {
        result.events.push_back(prefix + event);
      }
      const PlanarDomain& domain = this->Regions[r].domain;
      RegionReport report;
      report.material = this->Set.regions[r].material;
      report.requiredQuarters =
        CountQuarters(InsertBoundarySingularities(domain, own.singularities).loops, 0,
          DefaultCornerAngle, own.corners)
          .requiredInteriorQuarters;
      // Those on the boundary are corners, which reduce what is required.
      for (const Singularity& one : own.singularities)
      {
        report.givenQuarters += IsOnBoundary(domain, one.position) ? 0 : one.quarterIndex;
      }
      result.regions.push_back(report);
    }
    NodePositions nodes = FindNodePositions(map, quads.mesh, chosen, chosen);
    result.singularities = std::move(nodes.singularities);
    result.moved = nodes.moved;
    result.events.insert(result.events.end(), nodes.events.begin(), nodes.events.end());
    if (this->Request.singularities)
    {
      this->AddMoves(chosen);
    }
    if (this->Sizes)
    {
      if (this->Request.quadSize == 0.0 && this->Request.quadCount > 0)
      {
        this->Sizes->Multiply(quads.size / this->Sizes->mean);
      }
      result.sizes = MeasureSizes(quads, *this->Sizes);
    }
    result.boundary = this->Joined.curves;
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
        this->Joined.patches.begin(), this->Joined.patches.end(), static_cast<std::size_t>(patch));
      region.push_back(static_cast<int>(after - this->Joined.patches.begin()) - 1);
      ++this->Result.regions[Index(region.back())].quads;
    }
    for (std::size_t i = 0; i < this->Set.interfaces.size(); ++i)
    {
      const InterfacePiece& piece = this->Set.interfaces[i];
      const PairedSides& pair = quads.mesh.periodic[i];
      quads.mesh.sideNames[Index(pair.first)] = piece.side + (piece.isOpen ? ".left" : "");
      quads.mesh.sideNames[Index(pair.second)] = piece.side + (piece.isOpen ? ".right" : "");
      this->PlaceOnPiece(piece, pair, quads.mesh);
    }
    const double bound = quads.quality.bound; // with the angles of regions at nodes
    WeldRegions(quads.mesh);
    this->Result.interfaces = MeasureInterfaces(quads.mesh);
    quads.blocks = FindBlocks(quads.mesh, region);
    quads.separateBlocks = static_cast<int>(quads.blocks.blocks.size());
    (this->Request.merge == BlockMerge::Coarse ? this->Result.blocks.coarse
                                               : this->Result.blocks.none) = quads.separateBlocks;
    quads.quality = MeasureQuads(quads.mesh, quads.size);
    quads.quality.bound = bound;
    this->Result.part.assign(quads.mesh.quads.size(), 0);
    this->Result.quads = std::move(quads);
  }

  /// Moves the nodes of a piece, whose sides are apart if it is a slit, to its line and its ends.
  static void PlaceOnPiece(const InterfacePiece& piece, const PairedSides& pair, QuadMesh& mesh)
  {
    const auto move = [&mesh](const std::array<int, 2>& nodes, const Point& place)
    {
      for (const int node : nodes)
      {
        mesh.points[Index(node)].MoveTo(place);
      }
    };
    if (piece.IsSlit())
    {
      for (const std::array<int, 2>& nodes : pair.nodes)
      {
        const Point middle =
          0.5 * (mesh.points[Index(nodes[0])].InPlane() + mesh.points[Index(nodes[1])].InPlane());
        move(nodes, NearestOn(piece.line, middle));
      }
    }
    if (!piece.isClosed)
    {
      move(pair.nodes.front(), piece.line.front());
      move(pair.nodes.back(), piece.line.back());
    }
  }

  void AddWarnings()
  {
    QuadWorkflowResult& result = this->Result;
    const bool isPrescribed = !this->Joined.prescribed.empty() || this->Request.minimumSize > 0.0 ||
      this->Request.maximumSize > 0.0;
    const QuadResult& quads = result.quads;
    std::vector<double> areas;
    std::vector<std::string> names;
    for (std::size_t r = 0; r < this->Parts.size(); ++r)
    {
      areas.push_back(this->Parts[r].domain.Area());
      names.push_back(this->NameOf(r));
    }
    for (const std::string& warning : { quads.quality.inverted > 0
             ? DescribeInverted(quads.quality, {}, this->Request.singularities.has_value())
             : std::string(),
           result.sizes ? DescribeMissedSizes(*result.sizes) : std::string(),
           DescribeCount(this->Request, isPrescribed, quads), DescribeArea(quads),
           DescribeRegionAreas(quads.mesh, result.region, areas, names),
           DescribeMissedPlaces(this->Request.nodes, quads.mesh), DescribeLostSides(quads.mesh),
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
  const QuadRequest& Request;
  std::vector<PartRequest> Requests;
  std::vector<std::vector<RegionCorner>> NodeCorners; ///< Per node of the set.
  std::vector<std::string> Targets;                   ///< RegionRequests::targets.
  LaidOutRegions Regions;
  std::optional<SizeTargets> Sizes; ///< Of all regions, if sizes are requested.
  JoinedRegions Joined;
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
