#include "GradedArcs.h"

#include "SideArcs.h"

#include <numeric>
#include <utility>

namespace crossfield
{
GradedArcs::GradedArcs(const SeamlessMap& map, const MeshBoundary& curves,
  const BoundarySides& sides, const SidePrescriptions& prescribed, const TMesh& mesh)
  : Prescribed(prescribed)
{
  for (std::size_t i = 0; i < prescribed.size(); ++i)
  {
    if (!prescribed[i].isGraded && prescribed[i].count == 0 && prescribed[i].size <= 0.0)
    {
      continue;
    }
    const SideArcs arcs(map, curves, sides, mesh);
    for (std::vector<int>& part : arcs.PartsOf(prescribed[i].side))
    {
      this->Parts.push_back({ {}, { 0.0 }, i });
      for (const int arc : part)
      {
        std::vector<double>& ends = this->Parts.back().ends;
        ends.push_back(ends.back() + arcs.LengthOf({ arc }));
      }
      this->Parts.back().arcs = std::move(part);
    }
  }
}

void GradedArcs::SetTargets(std::vector<double>& targets) const
{
  const auto sumOf = [&targets](const Part& part)
  {
    return std::accumulate(part.arcs.begin(), part.arcs.end(), 0.0,
      [&targets](double sum, int arc) { return sum + targets[arc]; });
  };
  std::vector<double> ofSide(this->Prescribed.size(), 0.0);
  for (const Part& part : this->Parts)
  {
    ofSide[part.side] += sumOf(part);
  }
  for (const Part& part : this->Parts)
  {
    const SidePrescription& one = this->Prescribed[part.side];
    const double factor = one.count > 0 ? one.count / ofSide[part.side] : 1.0;
    if (!one.isGraded)
    {
      for (std::size_t i = 0; i < part.arcs.size(); ++i)
      {
        double& target = targets[part.arcs[i]];
        target = one.count > 0 ? factor * target : (part.ends[i + 1] - part.ends[i]) / one.size;
      }
      continue;
    }
    double count = factor * sumOf(part);
    if (one.progression.HasLengths())
    {
      count = CountForLengths(part.ends.back(), one.progression);
    }
    for (std::size_t i = 0; i < part.arcs.size(); ++i)
    {
      const auto within = [&](double length)
      { return EdgesWithin(length, part.ends.back(), count, one.progression); };
      targets[part.arcs[i]] = within(part.ends[i + 1]) - within(part.ends[i]);
    }
  }
}

std::vector<int> GradedArcs::ArcsWithCounts() const
{
  std::vector<int> arcs;
  for (const Part& part : this->Parts)
  {
    if (!this->Prescribed[part.side].isGraded)
    {
      arcs.insert(arcs.end(), part.arcs.begin(), part.arcs.end());
    }
  }
  return arcs;
}

void GradedArcs::SetWeights(QuantisationProblem& problem) const
{
  // Arcs across the domain, whose targets are those of the size field, give way to these. A size of a side is a
  // part of that field, and bounds of its edges are sums.
  constexpr double Preference = 100.0;
  for (const Part& part : this->Parts)
  {
    if (this->Prescribed[part.side].size > 0.0)
    {
      continue;
    }
    for (const int arc : part.arcs)
    {
      problem.weight[arc] *= Preference;
    }
  }
}
}
