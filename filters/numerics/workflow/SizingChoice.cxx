#include "SizingChoice.h"

#include "Candidates.h"
#include "MeshGrade.h"
#include "OptimizerReport.h"

#include <array>
#include <utility>

namespace crossfield
{
std::vector<std::string> ChooseSizing(
  MeshedLayout& meshed, QuadOptions& options, const Progress& progress)
{
  // The smaller the weight, the better the shapes and the farther from uniform the sizes. A smaller
  // one is tried where larger ones cost shape.
  constexpr std::array<double, 3> SizeParts = { 0.5, 0.2, 0.05 };
  const double variation = meshed.quads.quality.variation;
  const double bound = meshed.quads.quality.bound;
  const auto gradeOf = [&](const QuadResult& quads)
  { return GradeOf(quads, options.quadSize, options.quadCount, bound); };
  MeshGrade best = gradeOf(meshed.quads);
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
      const MeshGrade grade = gradeOf(uniform);
      if (grade < best)
      {
        best = grade;
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
