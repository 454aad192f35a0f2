#include "JoinedParts.h"

#include "Error.h"
#include "QuadAdvice.h"
#include "QuadWorkflow.h"
#include "TMeshJoin.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
void Shift(int& index, std::size_t by)
{
  if (index >= 0)
  {
    index += static_cast<int>(by);
  }
}

/// Appends items, each changed by a function.
template <class Item, class Change>
void Append(std::vector<Item>& to, const std::vector<Item>& from, const Change& change)
{
  for (Item item : from)
  {
    change(item);
    to.push_back(std::move(item));
  }
}

template <class Item>
void Append(std::vector<Item>& to, const std::vector<Item>& from)
{
  to.insert(to.end(), from.begin(), from.end());
}

/// Joins a range with the mean of `count` values to one of `before` values.
void Join(const Range& from, std::size_t count, std::size_t before, Range& to)
{
  const double all = static_cast<double>(before + count);
  to.mean = (static_cast<double>(before) * to.mean + static_cast<double>(count) * from.mean) / all;
  to.min = before == 0 ? from.min : std::min(to.min, from.min);
  to.max = before == 0 ? from.max : std::max(to.max, from.max);
}

void Join(const SurfaceQuality& from, std::size_t count, std::size_t before, SurfaceQuality& to)
{
  const double all = static_cast<double>(before + count);
  to.minimumJacobian = std::min(to.minimumJacobian, from.minimumJacobian);
  to.meanDistance = (static_cast<double>(before) * to.meanDistance +
                      static_cast<double>(count) * from.meanDistance) /
    all;
  to.maximumDistance = std::max(to.maximumDistance, from.maximumDistance);
  to.mostBent = from.bent > to.bent ? from.mostBent : to.mostBent;
  to.bent += from.bent;
}

/// Joins the qualities of meshes of `count` and `before` quads.
void Join(const QuadQuality& from, std::size_t count, std::size_t before, QuadQuality& to)
{
  if (before == 0)
  {
    to = from;
    return;
  }
  const auto squares = [](const QuadQuality& quality)
  { return (1.0 + quality.variation * quality.variation) * quality.size.mean * quality.size.mean; };
  const double meanSquare =
    (static_cast<double>(before) * squares(to) + static_cast<double>(count) * squares(from)) /
    static_cast<double>(before + count);
  Append(to.scaledJacobian, from.scaledJacobian);
  Append(to.sizeRatio, from.sizeRatio);
  to.where = from.jacobian.min < to.jacobian.min ? from.where : to.where;
  Join(from.jacobian, count, before, to.jacobian);
  Join(from.eta, count, before, to.eta);
  Join(from.size, count, before, to.size);
  to.variation = std::sqrt(std::max(0.0, meanSquare / (to.size.mean * to.size.mean) - 1.0));
  to.bound = std::min(to.bound, from.bound);
  to.minimumAngle = std::min(to.minimumAngle, from.minimumAngle);
  to.inverted += from.inverted;
  if (from.surface && to.surface)
  {
    Join(*from.surface, count, before, *to.surface);
  }
}

void Join(const EdgeCounts& from, EdgeCounts& to)
{
  to.optimal = (to.counts.empty() || to.optimal) && from.optimal;
  Append(to.counts, from.counts);
  to.cost += from.cost;
  to.bound += from.bound;
  to.nodes += from.nodes;
  to.seconds += from.seconds;
}

void Join(const SmoothingReport& from, bool isFirst, SmoothingReport& to)
{
  to.iterations += from.iterations;
  to.keptStart = (isFirst || to.keptStart) && from.keptStart;
  to.released = to.released || from.released;
  to.moved = std::max(to.moved, from.moved);
  to.symmetries = isFirst ? from.symmetries : std::min(to.symmetries, from.symmetries);
  to.isAsymmetric = to.isAsymmetric || from.isAsymmetric;
}

void Join(const QuadBlocks& from, std::size_t points, QuadBlocks& to)
{
  const std::size_t before = to.blocks.size();
  Append(to.blocks, from.blocks,
    [&](QuadBlock& block)
    {
      for (BlockNeighbour& neighbour : block.neighbours)
      {
        Shift(neighbour.block, before);
      }
      std::for_each(
        block.points.begin(), block.points.end(), [&](int& point) { Shift(point, points); });
    });
  Append(to.block, from.block, [&](int& block) { Shift(block, before); });
  Append(to.i, from.i);
  Append(to.j, from.j);
}

/// Results of parts, joined one after the other.
class JoinedParts
{
public:
  void Add(const PartOfQuads& part, const std::string& prefix)
  {
    const QuadWorkflowResult& from = part.quads;
    std::vector<int> sides;
    for (const std::string& name : from.quads.mesh.sideNames)
    {
      sides.push_back(this->SideOf(name));
    }
    this->AddQuads(from.quads, sides);
    const std::size_t curves = this->Result.boundary.curves.size();
    Append(this->Result.boundary.curves, from.boundary.curves);
    Append(this->Result.boundary.starts, from.boundary.starts,
      [&](CurveStart& start) { Shift(start.curve, curves); });
    Append(this->Result.curves, from.curves,
      [&](CurveReport& report)
      {
        for (int& side : report.sides)
        {
          side = sides[static_cast<std::size_t>(side)];
        }
      });
    this->AddRegions(from);
    this->AddReports(from, part.rows, prefix);
    this->Loops += part.loops;
    ++this->Parts;
  }

  QuadWorkflowResult Get() { return std::move(this->Result); }

private:
  int SideOf(const std::string& name)
  {
    std::vector<std::string>& names = this->Result.quads.mesh.sideNames;
    const auto found = std::find(names.begin(), names.end(), name);
    const auto index = static_cast<int>(found - names.begin());
    if (found == names.end())
    {
      names.push_back(name);
    }
    return index;
  }

  void AddQuads(const QuadResult& from, const std::vector<int>& sides)
  {
    QuadResult& to = this->Result.quads;
    const std::size_t before = to.mesh.quads.size();
    const std::size_t count = from.mesh.quads.size();
    const std::size_t points = to.mesh.points.size();
    to.size = (static_cast<double>(before) * to.size + static_cast<double>(count) * from.size) /
      static_cast<double>(before + count);
    this->AddMesh(from.mesh, sides);
    AppendTMesh(from.tMesh, { this->Cones, this->Loops }, to.tMesh);
    Join(from.counts, to.counts);
    to.counts.size = to.size;
    Join(from.smoothing, before == 0, to.smoothing);
    Join(from.quality, count, before, to.quality);
    Join(from.blocks, points, to.blocks);
    to.separateBlocks += from.separateBlocks;
    to.layoutSeconds += from.layoutSeconds;
    to.smoothSeconds += from.smoothSeconds;
    int cones = 0;
    for (const QuadPoint& point : from.mesh.points)
    {
      cones = std::max(cones, point.cone + 1);
    }
    this->Cones += static_cast<std::size_t>(cones);
    this->Result.part.resize(before + count, this->Parts);
  }

  void AddMesh(const QuadMesh& from, const std::vector<int>& sides)
  {
    QuadMesh& to = this->Result.quads.mesh;
    const std::size_t points = to.points.size();
    const std::size_t patches = this->Result.quads.tMesh.patches.size();
    Append(to.points, from.points,
      [&](QuadPoint& point)
      {
        Shift(point.curve.loop, this->Loops);
        Shift(point.cone, this->Cones);
      });
    Append(to.quads, from.quads,
      [&](std::array<int, 4>& quad)
      { std::for_each(quad.begin(), quad.end(), [&](int& point) { Shift(point, points); }); });
    Append(to.targetLengths, from.targetLengths);
    Append(to.patch, from.patch, [&](int& patch) { Shift(patch, patches); });
    Append(to.normals, from.normals);
    Append(to.boundary, from.boundary,
      [&](QuadBoundaryEdge& edge)
      {
        std::for_each(
          edge.points.begin(), edge.points.end(), [&](int& point) { Shift(point, points); });
        Shift(edge.id, this->Loops);
        Shift(edge.curve, this->Result.boundary.curves.size());
        edge.side = edge.side < 0 ? -1 : sides[static_cast<std::size_t>(edge.side)];
      });
    Append(to.periodic, from.periodic,
      [&](PairedSides& pair)
      {
        pair.first = sides[static_cast<std::size_t>(pair.first)];
        pair.second = sides[static_cast<std::size_t>(pair.second)];
        for (std::array<int, 2>& nodes : pair.nodes)
        {
          Shift(nodes[0], points);
          Shift(nodes[1], points);
        }
      });
  }

  void AddRegions(const QuadWorkflowResult& from)
  {
    QuadWorkflowResult& to = this->Result;
    const std::size_t regions = to.regions.size();
    to.materials = from.materials;
    Append(to.regions, from.regions);
    Append(to.region, from.region, [&](int& region) { Shift(region, regions); });
  }

  void AddReports(
    const QuadWorkflowResult& from, const std::vector<std::size_t>& rows, const std::string& prefix)
  {
    QuadWorkflowResult& to = this->Result;
    const auto name = [&prefix](std::string& sentence) { sentence = prefix + sentence; };
    Append(to.singularities, from.singularities);
    to.moved = std::max(to.moved, from.moved);
    if (from.moves)
    {
      to.moves = to.moves ? std::move(to.moves) : std::vector<SingularityMove>();
      Append(*to.moves, *from.moves, [&](SingularityMove& move) { move.row = rows[move.row]; });
    }
    Append(to.corners, from.corners);
    to.ambiguousCorners += from.ambiguousCorners;
    Append(to.events, from.events, name);
    Append(to.attempts, from.attempts, [&](AttemptReport& attempt) { name(attempt.what); });
    Append(to.warnings, from.warnings, name);
    Append(to.holonomyDefect, from.holonomyDefect);
    Append(to.layers, from.layers);
    if (from.sizes)
    {
      to.sizes = to.sizes ? std::move(to.sizes) : SizeReport();
      to.sizes->Add(*from.sizes);
    }
    this->AddRepair(from);
    this->AddBlockCounts(from.blocks);
    for (double QuadSeconds::*stage :
      { &QuadSeconds::choose, &QuadSeconds::mesh, &QuadSeconds::map, &QuadSeconds::clean,
        &QuadSeconds::trace, &QuadSeconds::integers, &QuadSeconds::layout, &QuadSeconds::smooth })
    {
      to.seconds.*stage += from.seconds.*stage;
    }
  }

  void AddRepair(const QuadWorkflowResult& from)
  {
    QuadWorkflowResult& to = this->Result;
    if (from.repair)
    {
      to.repair = to.repair ? std::move(to.repair) : HolonomyRepair();
      Append(to.repair->singularities, from.repair->singularities);
      to.repair->largestMove = std::max(to.repair->largestMove, from.repair->largestMove);
      Append(to.repair->before, from.repair->before);
      Append(to.repair->after, from.repair->after);
      to.repair->steps += from.repair->steps;
    }
    // The map with the largest strain is reported.
    if (from.flattening &&
      (!to.flattening || from.flattening->predictedStrain > to.flattening->predictedStrain))
    {
      to.flattening = from.flattening;
    }
  }

  void AddBlockCounts(const BlockCounts& from)
  {
    for (std::optional<int> BlockCounts::*count :
      { &BlockCounts::none, &BlockCounts::clean, &BlockCounts::coarse })
    {
      std::optional<int>& to = this->Result.blocks.*count;
      const std::optional<int>& more = from.*count;
      to = this->Parts == 0 ? more : to && more ? std::optional<int>(*to + *more) : std::nullopt;
    }
  }

  QuadWorkflowResult Result;
  std::size_t Loops = 0; ///< Of the parts so far.
  std::size_t Cones = 0; ///< Of the parts so far.
  int Parts = 0;         ///< Number of parts so far.
};
}

QuadWorkflowResult JoinQuads(
  std::size_t parts, const std::function<PartOfQuads(std::size_t part)>& make)
{
  if (parts == 1)
  {
    QuadWorkflowResult result = make(0).quads;
    result.part.assign(result.quads.mesh.quads.size(), 0);
    return result;
  }
  JoinedParts joined;
  for (std::size_t p = 0; p < parts; ++p)
  {
    const std::string number = "Part " + std::to_string(p + 1);
    try
    {
      joined.Add(make(p), number + ": ");
    }
    catch (const Error& error)
    {
      throw Error(number + " of " + std::to_string(parts) + " (1 is the largest): " + error.what(),
        error.GetKind());
    }
  }
  return joined.Get();
}

QuadWorkflowResult MakeQuadsOfParts(
  const std::vector<DomainPart>& parts, const QuadRequest& request, const Progress& progress)
{
  const std::vector<PartRequest> requests = SplitRequest(parts, request);
  double done = 0.0;
  QuadWorkflowResult result = JoinQuads(parts.size(),
    [&](std::size_t p)
    {
      const double begin = done;
      done = parts.size() == 1 ? 1.0 : std::min(1.0, done + requests[p].share);
      return PartOfQuads{ MakeQuadMesh(
                            parts[p].domain, requests[p].request, progress.Part(begin, done)),
        parts[p].domain.loops.size(), requests[p].rows };
    });
  if (parts.size() == 1)
  {
    return result;
  }
  const bool isPrescribed =
    !request.sideRequests.empty() || request.minimumSize > 0.0 || request.maximumSize > 0.0;
  const std::string warning = DescribeCount(request, isPrescribed, result.quads);
  if (!warning.empty())
  {
    result.warnings.push_back(warning);
  }
  return result;
}
}
