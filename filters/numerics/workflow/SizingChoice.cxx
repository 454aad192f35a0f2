#include "SizingChoice.h"

#include "Candidates.h"
#include "MeshGrade.h"
#include "OptimizerReport.h"
#include "TargetLengths.h"

#include <array>
#include <utility>

namespace crossfield
{
namespace
{
/// Part of the way to uniform sizes, and whether singularities move on it.
struct SizingStep
{
  double sizePart = 0.5;
  bool hold = false;
};

/// Returns whether a mesh of given singularities is so good that neither its sizes need to change nor
/// singularities to move for a better one.
bool IsGoodInPlace(const MeshGrade& grade)
{
  // Of sizes, relative to their mean: most are within a factor of two of it.
  constexpr double TolerableVariation = 0.5;
  return grade.inverted == 0 && grade.area <= 0.0 && grade.shape <= 0.0 &&
    grade.variation <= TolerableVariation - GoodVariation;
}

/// Returns the steps to try, in this order.
std::vector<SizingStep> StepsFor(SizingFreedom freedom)
{
  // The smaller the weight, the better the shapes and the farther from uniform the sizes. A smaller
  // one is tried where larger ones cost shape.
  constexpr std::array<double, 3> SizeParts = { 0.5, 0.2, 0.05 };
  std::vector<SizingStep> steps;
  for (const bool hold : { true, false })
  {
    const bool isTried = hold ? freedom != SizingFreedom::Free : freedom != SizingFreedom::Held;
    for (const double part : SizeParts)
    {
      if (isTried)
      {
        steps.push_back({ part, hold });
      }
    }
  }
  return steps;
}

/// Returns whether uniform sizes may cost neither shapes nor blocks: a mesh with conformal ones has
/// valid quads, the right number of them, and sizes that are not so different that they matter more.
bool IsShapeKept(const MeshGrade& conformal)
{
  // One quad in twenty differs from the mean size by more than 60 %.
  constexpr double LargestVariation = 0.3;
  return conformal.inverted == 0 && conformal.count == 0.0 &&
    conformal.variation <= LargestVariation - GoodVariation;
}

/// Returns whether uniform sizes have the shapes and the blocks of a mesh with conformal ones.
bool KeepsShape(const QuadResult& uniform, double conformalJacobian, std::size_t conformalBlocks)
{
  // Of the minimum scaled Jacobian: less is not noticed.
  constexpr double KeptPart = 0.975;
  return uniform.quality.jacobian.min >= KeptPart * conformalJacobian &&
    uniform.blocks.blocks.size() <= conformalBlocks;
}

std::vector<std::size_t> ArcsWithoutEdges(const QuadResult& quads)
{
  std::vector<std::size_t> arcs;
  for (std::size_t arc = 0; arc < quads.counts.counts.size(); ++arc)
  {
    if (quads.counts.counts[arc] == 0)
    {
      arcs.push_back(arc);
    }
  }
  return arcs;
}
}

std::vector<std::string> ChooseSizing(
  MeshedLayout& meshed, QuadOptions& options, SizingFreedom freedom, const Progress& progress)
{
  const std::vector<SizingStep> steps = StepsFor(freedom);
  const double variation = meshed.quads.quality.variation;
  const double bound = meshed.quads.quality.bound;
  // A requested size stands for a number of quads too: with few quads, uniform sizes may miss it by far.
  const double wanted = freedom != SizingFreedom::Free && options.quadSize > 0.0
    ? AreaOf(meshed.quads.tMesh) / options.quadSize / options.quadSize
    : 0.0;
  const auto gradeOf = [&](const QuadResult& quads)
  {
    return wanted >= 1.0 ? GradeOf(quads, 0.0, static_cast<int>(wanted), bound)
                         : GradeOf(quads, options.quadSize, options.quadCount, bound);
  };
  MeshGrade best = gradeOf(meshed.quads);
  bool isChanged = false;
  QuadOptions given = options;
  const bool isShapeKept = IsShapeKept(best);
  if (isShapeKept)
  {
    given.arcsWithoutEdges = ArcsWithoutEdges(meshed.quads);
  }
  const double jacobian = meshed.quads.quality.jacobian.min;
  const std::size_t blocks = meshed.quads.blocks.blocks.size();
  const auto optionsFor = [&](std::size_t i)
  {
    QuadOptions other = given;
    other.sizes.sizing = Sizing::Uniform;
    other.sizePart = steps[i].sizePart;
    other.hold = steps[i].hold;
    return other;
  };
  if (best.IsGood() || (freedom != SizingFreedom::Free && IsGoodInPlace(best)))
  {
    return {};
  }
  const std::size_t quads = meshed.quads.mesh.quads.size();
  // All steps have the same edge counts.
  const QuadResult draft = MakeDraftQuads(meshed.layouts, optionsFor(0), progress.Part(0.0, 0.4));
  const Progress smoothing = progress.Part(0.4, 1.0);
  ProgressOfParts shared(smoothing);
  AcceptFirst(
    steps.size(), CandidateBatch(quads),
    [&](std::size_t i)
    {
      const double done = static_cast<double>(i) / static_cast<double>(steps.size());
      QuadResult uniform = draft;
      SmoothDraftQuads(meshed.layouts, optionsFor(i), uniform, shared.Get().Part(done, 1.0));
      return uniform;
    },
    [&](std::size_t i, QuadResult uniform)
    {
      QuadOptions other = optionsFor(i);
      const MeshGrade grade = gradeOf(uniform);
      if (grade < best && (!isShapeKept || KeepsShape(uniform, jacobian, blocks)))
      {
        best = grade;
        meshed.quads = std::move(uniform);
        options = std::move(other);
        options.arcsWithoutEdges.clear(); // they are those of these layouts only
        isChanged = true;
      }
      const bool movesNext = i + 1 < steps.size() && steps[i].hold && !steps[i + 1].hold;
      return freedom == SizingFreedom::PreferHeld && steps[i].hold
        ? IsGoodInPlace(movesNext ? best : grade)
        : grade.shape <= 0.0 && isChanged;
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
