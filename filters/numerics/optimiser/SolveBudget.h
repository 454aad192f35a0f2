#pragma once

#include <cstddef>
#include <limits>

namespace crossfield
{
/// Number of solves that a search may use. One solve is an evaluation of W on a factored mesh, which
/// costs two or three back-substitutions. The search is limited by this count and not by time, so
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

/// What meshing and factoring a domain costs, in solves, as measured on meshes of 1,000 to 20,000
/// triangles.
constexpr std::size_t SolvesOfFactorisation = 20;
}
