#include "MergedQuads.h"

#include "Candidates.h"
#include "MeshGrade.h"
#include "PatternStart.h"
#include "QuadBudget.h"
#include "SizingChoice.h"
#include "Stopwatch.h"

#include <optional>
#include <utility>

namespace crossfield
{
namespace
{
QuadOptions OptionsFor(const PlanarDomain& domain, const ResolvedRequest& request)
{
  QuadOptions options;
  options.quadSize = request.quadSize;
  options.quadCount = request.quadCount;
  options.sizes.sizing = request.sizing.value_or(Sizing::Conformal);
  options.sides = request.sides;
  options.curves = request.curves;
  options.prescribed = request.prescribed;
  options.hold = request.hold;
  options.nodes = request.nodes;
  if (request.targets)
  {
    RelativeSizes sizes = RelativeTo(*request.targets);
    options.sizes.field = std::move(sizes.field);
    options.quadSize *= sizes.mean;
    RequireQuadSize(domain, options.quadSize);
  }
  return options;
}

/// Moves singularities so that separatrices meet, if that gives a mesh as good with fewer blocks.
void Clean(const PlanarDomain& domain, const ResolvedRequest& request, MergedQuads& merged,
  const Progress& progress)
{
  CleanOptions options;
  options.map = merged.map;
  options.meshSize = request.meshSize;
  options.quads = merged.options;
  // Not with layers: the singularities of a pattern are as close to holes as the rows of a layer.
  const bool isPattern = !request.singularities && request.layers.empty() &&
    StartFromPattern(domain, request, merged.mesh, options, progress.Part(0.0, 0.2));
  CleanBlocksResult clean =
    CleanBlocks(domain, std::move(merged.mesh), options, progress.Part(0.2, 1.0));
  merged.mesh = std::move(clean.mesh);
  merged.map = std::move(options.map);
  merged.blocks.clean = static_cast<int>(merged.mesh.quads.blocks.blocks.size());
  merged.moved = clean.largestMove;
  merged.events.push_back(DescribeClean(clean, isPattern, merged.blocks));
}

/// Returns layouts with quads whose separatrices are merged without moving singularities.
MeshedLayout WithMergedBlocks(
  const MeshedLayout& meshed, QuadOptions options, const Progress& progress)
{
  options.coarse = true;
  return { meshed.layouts, MakeQuads(meshed.layouts, options, progress) };
}

/// Merges separatrices without moving singularities, in the layout with the fewest blocks: in that
/// where they were moved or, if that has more blocks, in `start`, whose map has the options `map`.
void Merge(const MeshedLayout& start, const SeamlessMapOptions& map, MergedQuads& merged,
  const Progress& progress)
{
  MeshedLayout& clean = merged.mesh;
  // Layouts without moves are the same.
  const bool isMoved = clean.layouts.Single().map.topology != start.layouts.Single().map.topology;
  std::vector<MeshedLayout> results;
  ProgressOfParts shared(progress);
  AcceptFirst(
    isMoved ? 2 : 1, CandidateBatch(clean.quads.mesh.quads.size()),
    [&](std::size_t i)
    {
      const double done = isMoved ? 0.5 * static_cast<double>(i) : 0.0;
      return WithMergedBlocks(i == 0 ? clean : start, merged.options,
        shared.Get().Part(done, isMoved ? done + 0.5 : 1.0));
    },
    [&](std::size_t, MeshedLayout result)
    {
      results.push_back(std::move(result));
      return false;
    });
  if (IsCoarser(results[0].quads, clean.quads))
  {
    clean.quads = std::move(results[0].quads);
  }
  if (isMoved && IsCoarser(results[1].quads, clean.quads))
  {
    clean = std::move(results[1]);
    merged.map = map;
    merged.moved = 0.0;
    merged.events.front() = "Blocks were merged without moving singularities.";
  }
  merged.blocks.coarse = static_cast<int>(clean.quads.blocks.blocks.size());
}
}

MergedQuads MakeMergedQuads(const PlanarDomain& domain, const ResolvedRequest& request,
  Layout layout, const SeamlessMapOptions& map, const Progress& progress)
{
  const bool coarse = request.merge == BlockMerge::Coarse;
  const bool clean = !request.hold && request.merge != BlockMerge::None;
  MergedQuads merged;
  merged.map = map;
  merged.options = OptionsFor(domain, request);
  merged.mesh.layouts = LayoutSet(std::move(layout), request.periodic);
  const Progress making = progress.Part(0.0, clean ? 0.2 : 1.0);
  merged.mesh.quads = MakeQuads(merged.mesh.layouts, merged.options, making.Part(0.0, 0.5));
  merged.blocks.none = merged.mesh.quads.separateBlocks;
  const std::optional<MeshedLayout> start = coarse ? std::make_optional(merged.mesh) : std::nullopt;
  Stopwatch clock;
  if (clean)
  {
    Clean(domain, request, merged, progress.Part(0.2, 0.8));
  }
  else if (request.merge != BlockMerge::None)
  {
    merged.events.emplace_back(
      "Singularities were not moved to merge blocks, because they are held.");
  }
  // Whether separatrices meet is decided with the sizes of the map, whose quads show it best.
  if (IsSizingFree(request))
  {
    const SizingFreedom freedom = request.hold ? SizingFreedom::Held
      : request.singularities                  ? SizingFreedom::PreferHeld
                                               : SizingFreedom::Free;
    for (std::string& event : ChooseSizing(merged.mesh, merged.options, freedom,
           clean ? progress.Part(0.8, 0.9) : making.Part(0.5, 1.0)))
    {
      merged.events.push_back(std::move(event));
    }
  }
  const auto blocks = static_cast<int>(merged.mesh.quads.blocks.blocks.size());
  (clean ? merged.blocks.clean : merged.blocks.none) = blocks;
  if (start)
  {
    Merge(*start, map, merged, progress.Part(0.9, 1.0));
  }
  merged.cleanSeconds = clean ? clock.Lap() : 0.0;
  return merged;
}
}
