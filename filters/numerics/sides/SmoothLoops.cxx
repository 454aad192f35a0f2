#include "SmoothLoops.h"

#include "SideArcs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
bool HasCorners(const MeshTopology& topology, const BoundaryLoop& loop)
{
  return std::any_of(loop.edges.begin(), loop.edges.end(),
    [&](int edge) { return topology.corners[topology.BoundaryAt(edge).vertices[0]]; });
}

/// Returns the targets, multiplied by the smallest common factor with which their rounded values add up
/// to `minimum`, and rounded. Equal targets are rounded alike, so symmetric loops stay symmetric.
std::vector<double> RoundedTo(const std::vector<double>& targets, int minimum)
{
  std::vector<double> rounded(targets.size(), 0.0);
  double sum = 0.0;
  while (sum < minimum)
  {
    // The factor at which the next target is rounded up.
    constexpr double Same = 1e-6; // errors of the map
    double factor = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < targets.size(); ++i)
    {
      factor = std::min(factor, targets[i] > 0.0 ? (rounded[i] + 0.5) / targets[i] : factor);
    }
    if (!std::isfinite(factor))
    {
      break;
    }
    sum = 0.0;
    for (std::size_t i = 0; i < targets.size(); ++i)
    {
      rounded[i] = std::floor(factor * (1.0 + Same) * targets[i] + 0.5);
      sum += rounded[i];
    }
  }
  return rounded;
}
}

SmoothLoops::SmoothLoops(const SeamlessMap& map, const MeshBoundary& curves,
  const BoundarySides& sides, const SidePrescriptions& prescribed, const TMesh& mesh)
{
  const SideArcs ofSides(map, curves, sides, mesh);
  std::map<int, Loop> loops = LoopsOf(mesh);
  for (const SidePrescription& one : prescribed)
  {
    for (const int arc : ofSides.Of(one.side))
    {
      loops.erase(mesh.arcs[arc].loop);
    }
  }
  for (auto& [index, loop] : loops)
  {
    if (!HasCorners(*map.topology, map.topology->loops[index]))
    {
      loop.length = ofSides.LengthOf(loop.arcs);
      this->Loops.push_back(std::move(loop));
    }
  }
}

SmoothLoops::SmoothLoops(const MeshTopology& topology, const TMesh& mesh)
{
  for (auto& [index, loop] : LoopsOf(mesh))
  {
    if (!HasCorners(topology, topology.loops[index]))
    {
      for (const int position : topology.loops[index].edges)
      {
        loop.length += topology.Length(topology.EdgeOfBoundary(position));
      }
      this->Loops.push_back(std::move(loop));
    }
  }
}

std::map<int, SmoothLoops::Loop> SmoothLoops::LoopsOf(const TMesh& mesh)
{
  std::map<int, Loop> loops;
  for (int arc = 0; arc < static_cast<int>(mesh.arcs.size()); ++arc)
  {
    if (mesh.arcs[arc].onBoundary)
    {
      loops[mesh.arcs[arc].loop].arcs.push_back(arc);
    }
  }
  return loops;
}

bool SmoothLoops::RaiseTargets(
  double size, const std::vector<int>& counts, QuantisationProblem& problem) const
{
  // Edges shorter than this part of the quads are for tiny holes, which their sizes do not show.
  constexpr double ShortestPart = 0.25;
  // As for prescribed numbers of edges (GradedArcs.cxx).
  constexpr double Preference = 100.0;
  bool isRaised = false;
  for (const Loop& loop : this->Loops)
  {
    const int minimum = static_cast<int>(
      std::min(static_cast<double>(EnoughEdges), std::floor(loop.length / (ShortestPart * size))));
    std::vector<double> targets;
    int edges = 0;
    for (const int arc : loop.arcs)
    {
      targets.push_back(problem.target[arc]);
      edges += counts[arc];
    }
    if (edges >= minimum)
    {
      continue;
    }
    isRaised = true;
    const std::vector<double> raised = RoundedTo(targets, minimum);
    for (std::size_t i = 0; i < loop.arcs.size(); ++i)
    {
      problem.target[loop.arcs[i]] = raised[i];
      problem.weight[loop.arcs[i]] *= Preference;
    }
  }
  return isRaised;
}
}
