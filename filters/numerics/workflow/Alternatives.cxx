#include "Alternatives.h"

#include "MeshGrade.h"
#include "SizeSearch.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace crossfield
{
Alternative AlternativeOf(
  const QuadResult& quads, std::size_t nodes, double quadSize, int quadCount)
{
  const QuadQuality& quality = quads.quality;
  Alternative one;
  one.nodes = static_cast<int>(nodes);
  one.blocks = static_cast<int>(quads.blocks.blocks.size());
  one.scaledJacobian = quality.jacobian.min;
  one.sizeVariation = quality.variation;
  one.attained = quality.bound > 0.0 ? quality.jacobian.min / quality.bound : 0.0;
  one.symmetries = quads.smoothing.symmetries;
  // Edge counts with many symmetries leave larger steps from one number of quads to the next.
  one.excess = CountExcess(quads, quadSize, quadCount);
  one.isValid = quality.inverted == 0 && one.excess <= CountTolerance;
  return one;
}

std::vector<std::size_t> OrderAlternatives(
  const std::vector<Alternative>& alternatives, std::optional<MeshPreference> preference)
{
  constexpr double SeenInShape = 0.03;
  constexpr double WorthOfSizes = 0.05; // of shape
  constexpr double SeenInSizes = 0.1;
  double attained = 0.0;
  double jacobian = 0.0;
  double variation = std::numeric_limits<double>::infinity();
  for (const Alternative& one : alternatives)
  {
    if (one.isValid)
    {
      attained = std::max(attained, one.attained);
      jacobian = std::max(jacobian, one.scaledJacobian);
      variation = std::min(variation, one.sizeVariation);
    }
  }
  const auto key = [&](const Alternative& one)
  {
    // Variations of sizes are what target sizes ask for.
    const bool isSized = one.met.has_value();
    const double seen = isSized ? WorthOfSizes : SeenInShape;
    const bool isPoor = (one.attained < attained - seen && one.scaledJacobian < jacobian - seen) ||
      (!isSized && preference != MeshPreference::Uniform &&
        one.sizeVariation > variation + SeenInSizes);
    const double first = !preference          ? (isSized ? one.nodes : one.rank)
      : *preference == MeshPreference::Nodes  ? one.nodes
      : *preference == MeshPreference::Blocks ? one.blocks
                                              : one.sizeVariation;
    const double cost =
      (isSized ? 0.0 : one.sizeVariation / SeenInSizes) - one.scaledJacobian / SeenInShape;
    return std::make_tuple(!one.isValid, -one.met.value_or(1.0), isPoor, first,
      preference ? 0 : -one.symmetries, one.excess > 0.0, one.blocks, one.nodes, cost);
  };
  std::vector<std::size_t> order(alternatives.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return key(alternatives[a]) < key(alternatives[b]); });
  return order;
}
}
