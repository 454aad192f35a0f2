#pragma once

#include <cstddef>
#include <limits>

namespace crossfield
{
/// Number of solves that a search may use. One solve is an evaluation of W on a factored mesh of usual
/// size, which takes a few back-substitutions. The search is limited by this count and not by time, so
/// that its result is the same on every machine.
class SolveBudget
{
public:
  explicit SolveBudget(std::size_t maximumSolves = std::numeric_limits<std::size_t>::max())
    : Maximum(maximumSolves)
  {
  }

  void Spend(std::size_t solves) { this->Count += solves; }
  std::size_t GetSpent() const { return this->Count; }
  std::size_t GetMaximum() const { return this->Maximum; }
  bool IsSpent() const { return this->Count >= this->Maximum; }

private:
  std::size_t Maximum;
  std::size_t Count = 0;
};

/// Returns what an evaluation of W costs, in solves: one, and one more for every 10,000 vertices and
/// for every 200,000 logarithms at points of the boundary, which take as long as the
/// back-substitutions on a usual mesh of 5,000 vertices.
inline std::size_t SolvesOfEvaluation(
  std::size_t vertices, std::size_t singularities, std::size_t boundaryPoints)
{
  return 1 + vertices / 10000 + singularities * boundaryPoints / 200000;
}

/// Estimate of what meshing and factoring a domain costs, in solves; not measured.
constexpr std::size_t SolvesOfFactorisation = 20;
}
