#include "SizingChoice.h"

#include "Candidates.h"
#include "OptimizerReport.h"
#include "SizeSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace crossfield
{
namespace
{
/// Part of the attainable minimum scaled Jacobian from which a mesh needs no improvement.
constexpr double GoodShape = 0.8;

/// What a mesh lacks: quads that are not inverted, their number, shape, uniform sizes, in this order.
struct Shortfall
{
  int inverted;
  double count; ///< Excess of the relative error of the number of quads.
  double shape; ///< Missing part of the minimum scaled Jacobian.
  double sizes; ///< Excess of the variation of sizes.

  /// `bound` is the attainable minimum scaled Jacobian of the mesh with conformal sizes: nodes that
  /// move along the boundary may lower it, which is no merit.
  Shortfall(const QuadResult& quads, const QuadOptions& options, double bound)
    : Shortfall(quads.quality, std::max(bound, quads.quality.bound))
  {
    if (options.quadSize == 0.0)
    {
      const auto size = static_cast<double>(quads.mesh.quads.size());
      this->count = std::max(0.0, std::abs(size / options.quadCount - 1.0) - CountTolerance);
    }
  }

  bool IsGood() const { return this->inverted == 0 && this->shape == 0.0 && this->sizes == 0.0; }
  bool IsBelow(const Shortfall& other) const
  {
    return std::tie(this->inverted, this->count, this->shape, this->sizes) <
      std::tie(other.inverted, other.count, other.shape, other.sizes);
  }

private:
  Shortfall(const QuadQuality& quality, double bound)
    : inverted(quality.inverted)
    , count(0.0)
    , shape(std::max(0.0, GoodShape - quality.jacobian.min / bound))
    , sizes(std::max(0.0, quality.variation - GoodVariation))
  {
  }
};
}

std::vector<std::string> ChooseSizing(
  MeshedLayout& meshed, QuadOptions& options, const Progress& progress)
{
  // The smaller the weight, the better the shapes and the farther from uniform the sizes. A smaller
  // one is tried where larger ones cost shape.
  constexpr std::array<double, 3> SizeParts = { 0.5, 0.2, 0.05 };
  const double variation = meshed.quads.quality.variation;
  const double bound = meshed.quads.quality.bound;
  Shortfall best(meshed.quads, options, bound);
  bool isChanged = false;
  const QuadOptions given = options;
  const auto optionsFor = [&](std::size_t i)
  {
    QuadOptions other = given;
    other.sizes.sizing = Sizing::Uniform;
    other.sizePart = SizeParts[i];
    return other;
  };
  if (best.IsGood())
  {
    return {};
  }
  const std::size_t quads = meshed.quads.mesh.quads.size();
  ProgressOfParts shared(progress);
  AcceptFirst(
    SizeParts.size(), CandidateBatch(quads),
    [&](std::size_t i)
    {
      const double done = static_cast<double>(i) / SizeParts.size();
      return MakeQuads(meshed.layouts, optionsFor(i), shared.Get().Part(done, 1.0));
    },
    [&](std::size_t i, QuadResult uniform)
    {
      QuadOptions other = optionsFor(i);
      const Shortfall shortfall(uniform, other, bound);
      if (shortfall.IsBelow(best))
      {
        best = shortfall;
        meshed.quads = std::move(uniform);
        options = std::move(other);
        isChanged = true;
      }
      return best.shape <= 0.0;
    });
  if (!isChanged)
  {
    return {};
  }
  return {
    "Nodes were moved for uniform sizes: the standard deviation of the sizes of quads changed "
    "from " +
    FormatShort(variation) + " to " + FormatShort(meshed.quads.quality.variation) +
    " of their mean."
  };
}
}
