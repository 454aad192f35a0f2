#include "Elimination.h"

#include "Error.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
Elimination::Row Elimination::Resolve(const Row& row)
{
  Row resolved;
  for (const auto& [unknown, coefficient] : row)
  {
    const auto index = static_cast<std::size_t>(unknown);
    if (!this->IsDependent[index])
    {
      resolved.emplace_back(unknown, coefficient);
      continue;
    }
    Row& own = this->Dependent[index];
    const bool outdated = std::any_of(
      own.begin(), own.end(), [this](const auto& term) { return !this->IsFree(term.first); });
    if (outdated)
    {
      own = this->Resolve(own);
    }
    for (const auto& [other, factor] : own)
    {
      resolved.emplace_back(other, coefficient * factor);
    }
  }
  std::sort(resolved.begin(), resolved.end());
  Row merged;
  for (const auto& [unknown, coefficient] : resolved)
  {
    if (!merged.empty() && merged.back().first == unknown)
    {
      merged.back().second += coefficient;
    }
    else
    {
      merged.emplace_back(unknown, coefficient);
    }
  }
  merged.erase(std::remove_if(
                 merged.begin(), merged.end(), [](const auto& term) { return term.second == 0.0; }),
    merged.end());
  return merged;
}

void Elimination::Impose(const Row& row)
{
  Row remaining = this->Resolve(row);
  if (remaining.empty())
  {
    return;
  }
  // An equation with even coefficients is divided by 2, which is exact.
  while (std::all_of(remaining.begin(), remaining.end(),
    [](const auto& term) { return std::fmod(term.second, 2.0) == 0.0; }))
  {
    for (auto& term : remaining)
    {
      term.second *= 0.5;
    }
  }
  auto pivot = remaining.end();
  for (auto term = remaining.begin(); term != remaining.end(); ++term)
  {
    const auto rank = [this](int unknown) { return this->Rank[unknown]; };
    if (std::abs(term->second) == 1.0 &&
      (pivot == remaining.end() || rank(term->first) < rank(pivot->first)))
    {
      pivot = term;
    }
  }
  if (pivot == remaining.end())
  {
    throw Error("The seams of the seamless map have no integral solution; give the singularities' "
                "and corners' quarter indices so that each is below 2.");
  }
  const auto [unknown, sign] = *pivot;
  remaining.erase(pivot);
  for (auto& term : remaining)
  {
    term.second *= -sign;
  }
  this->IsDependent[unknown] = true;
  this->Dependent[unknown] = std::move(remaining);
}

Eigen::SparseMatrix<double, Eigen::RowMajor> Elimination::Prolongation()
{
  const auto count = static_cast<int>(this->Rank.size());
  std::vector<int> column(this->Rank.size(), -1);
  int columns = 0;
  for (int unknown = 0; unknown < count; ++unknown)
  {
    if (this->IsFree(unknown))
    {
      column[unknown] = columns++;
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(this->Rank.size());
  for (int unknown = 0; unknown < count; ++unknown)
  {
    if (this->IsFree(unknown))
    {
      entries.emplace_back(unknown, column[unknown], 1.0);
      continue;
    }
    for (const auto& [other, factor] : this->Resolve({ { unknown, 1.0 } }))
    {
      entries.emplace_back(unknown, column[other], factor);
    }
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(count, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}
}
