#include "CoarseBlocks.h"

#include "Candidates.h"
#include "Chords.h"
#include "MeshGrade.h"
#include "Parts.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace crossfield
{
namespace
{
/// Counts of few edges.
struct CoarseSolution
{
  double size = 0.0;
  EdgeCounts counts;
};

/// Returns the different solutions for sizes from that of the result up to that of the domain.
std::vector<CoarseSolution> CoarseSolutions(
  const BlockSteps& steps, double area, const QuadResult& result)
{
  std::vector<CoarseSolution> solutions;
  const double largest = std::sqrt(area);
  for (double size = result.size; size < largest; size *= std::sqrt(2.0))
  {
    solutions.push_back({ size, {} });
  }
  ForParts(solutions.size(),
    [&](std::size_t i)
    {
      QuantisationProblem problem = steps.problemFor(solutions[i].size);
      problem.sums.clear(); // they hold once the blocks are refined
      solutions[i].counts = Quantise(result.tMesh, problem, SearchEffort::Quick);
    });
  solutions.erase(std::unique(solutions.begin(), solutions.end(),
                    [](const CoarseSolution& a, const CoarseSolution& b)
                    { return a.counts.counts == b.counts.counts; }),
    solutions.end());
  return solutions;
}

/// Returns a result, with counts and blocks, but no mesh, of the target size with the blocks of a coarse solution; nothing if
/// prescribed numbers do not fit them.
std::optional<QuadResult> Refined(
  const BlockSteps& steps, const CoarseSolution& coarse, const QuadResult& result)
{
  const Chords chords(result.tMesh, coarse.counts.counts);
  if (chords.Refine(steps.problemFor(coarse.size)).empty())
  {
    return std::nullopt;
  }
  QuadResult refined;
  refined.tMesh = result.tMesh;
  refined.counts = steps.search(
    [&](double size, SearchEffort)
    {
      const QuantisationProblem problem = steps.problemFor(size);
      EdgeCounts counts = coarse.counts;
      counts.counts = chords.Refine(problem);
      counts.cost = problem.Cost(counts.counts);
      counts.bound = result.counts.bound;
      counts.optimal = false;
      counts.seconds = 0.0;
      return counts;
    });
  refined.counts.seconds = result.counts.seconds;
  refined.size = refined.counts.size;
  const std::optional<QuadMesh> draft = steps.draft(refined);
  if (!draft)
  {
    return std::nullopt;
  }
  refined.blocks = FindBlocks(*draft);
  return refined;
}

/// Returns the results of all coarse solutions with fewer blocks, the fewest first.
std::vector<QuadResult> FindCandidates(
  const BlockSteps& steps, double area, const QuadResult& result)
{
  const std::vector<CoarseSolution> solutions = CoarseSolutions(steps, area, result);
  std::vector<QuadResult> candidates;
  AcceptFirst(
    solutions.size(), CandidateBatch(result.mesh.quads.size()),
    [&](std::size_t i) { return Refined(steps, solutions[i], result); },
    [&](std::size_t, std::optional<QuadResult> candidate)
    {
      if (candidate)
      {
        candidates.push_back(std::move(*candidate));
      }
      return false;
    });
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const QuadResult& a, const QuadResult& b)
    { return a.blocks.blocks.size() < b.blocks.blocks.size(); });
  candidates.erase(std::find_if(candidates.begin(), candidates.end(),
                     [&](const QuadResult& candidate)
                     { return candidate.blocks.blocks.size() >= result.blocks.blocks.size(); }),
    candidates.end());
  return candidates;
}
}

void UseFewestBlocks(
  const BlockSteps& steps, double area, QuadResult& result, const Progress& progress)
{
  std::vector<QuadResult> candidates = FindCandidates(steps, area, result);
  const auto count = static_cast<double>(candidates.size());
  ProgressOfParts shared(progress);
  AcceptFirst(
    candidates.size(), CandidateBatch(result.mesh.quads.size()),
    [&](std::size_t i)
    {
      QuadResult candidate = std::move(candidates[i]);
      const auto done = static_cast<double>(i);
      steps.make(candidate, shared.Get().Part(done / count, (done + 1.0) / count));
      return candidate;
    },
    [&](std::size_t, QuadResult candidate)
    {
      if (!IsAsGood(candidate.quality, result.quality, CoarseTolerance))
      {
        return false;
      }
      candidate.separateBlocks = result.separateBlocks;
      result = std::move(candidate);
      return true;
    });
}
}
