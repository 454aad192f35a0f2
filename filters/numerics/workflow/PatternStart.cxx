#include "PatternStart.h"

#include "CrossDirection.h"
#include "HolePattern.h"
#include "MeshForPoints.h"
#include "MeshGrade.h"
#include "Outcome.h"
#include "RequestedSingularities.h"

#include <sstream>
#include <utility>

namespace crossfield
{
bool StartFromPattern(const PlanarDomain& domain, const ResolvedRequest& request,
  MeshedLayout& start, CleanOptions& options, const Progress& progress)
{
  const std::vector<RoundHole> holes = FindRoundHoles(domain);
  constexpr std::size_t Fewest = 2; // a single hole has no neighbours to line up with
  if (holes.size() < Fewest)
  {
    return false;
  }
  SeamlessMapOptions map = options.map;
  Outcome<MeshedLayout> pattern = Try(
    [&]
    {
      const PlanarDomain filled = FillHoles(domain, holes);
      AutomaticConfiguration choice = ChooseSingularities(filled, request, progress.Part(0.0, 0.5));
      map.corners = choice.corners;
      const auto layOut = [&](const PlanarDomain& on, const Configuration& singularities)
      {
        return LayOut(ShareTopology(MeshThroughPoints(on, singularities, options.meshSize, {}, 1.0,
                        options.quads.sides.FixedPlaces())),
          singularities, map, true);
      };
      const Layout field = layOut(filled, choice.singularities);
      Configuration singularities =
        PatternAroundHoles(holes, CrossAnglesAt(field.map, Centres(holes)));
      singularities.insert(
        singularities.end(), choice.singularities.begin(), choice.singularities.end());
      LayoutSet layouts(layOut(domain, singularities), start.layouts.pairs);
      QuadResult quads = MakeQuads(layouts, options.quads);
      return MeshedLayout{ std::move(layouts), std::move(quads) };
    });
  progress.Report(1.0);
  if (!pattern.value)
  {
    return false; // the pattern has no layout
  }
  const QuadResult& quads = pattern.value->quads;
  if (quads.blocks.blocks.size() >= start.quads.blocks.blocks.size() ||
    !IsAsClean(quads, start.quads, request.quadSize, request.quadCount))
  {
    return false;
  }
  start = std::move(*pattern.value);
  options.map = std::move(map);
  return true;
}

std::string DescribeClean(const CleanBlocksResult& clean, bool isPattern, const BlockCounts& blocks)
{
  std::ostringstream text;
  text.precision(3);
  if (isPattern)
  {
    text << "Four singularities around every round hole give a mesh as good with fewer blocks. ";
  }
  if (clean.accepted)
  {
    text << "Singularities were moved by at most " << clean.largestMove
         << " so that separatrices meet. ";
  }
  if (isPattern || clean.accepted)
  {
    text << "There are " << *blocks.clean << " blocks instead of " << *blocks.none << ".";
  }
  else
  {
    text << "No mesh with fewer blocks is as good.";
  }
  return text.str();
}
}
