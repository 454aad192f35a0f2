#include "NodeIndices.h"

#include "CornerEnergy.h"
#include "Index.h"
#include "PoincareHopf.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace crossfield
{
namespace
{
/// Smallest angle of a quad at a node for another index than that of the smallest rotation, and its
/// distance from 180°: the scaled Jacobian there is at most the sine of the angle, 0.57.
constexpr double SmallestAngle = 35.0 / 180.0 * Pi;

/// Indices of the first corners of a node with the least energy.
struct Choice
{
  double energy = std::numeric_limits<double>::infinity();
  std::vector<int> indices;
};

class NodeSearch
{
public:
  NodeSearch(const std::vector<NodeCorners>& nodes, const std::vector<int>& required)
    : Nodes(nodes)
    , Quarter(InteriorQuarterEnergy(InteriorCoefficient::Logarithm))
    , Missing(required)
    , Indices(nodes.size())
  {
    for (std::size_t n = 0; n < nodes.size(); ++n)
    {
      for (const NodeCorner& corner : nodes[n].corners)
      {
        this->Indices[n].push_back(Candidates(corner)[0]);
        this->Missing[Index(corner.region)] -= this->Indices[n].back();
      }
    }
  }

  std::vector<std::vector<int>> Run()
  {
    constexpr int MostSweeps = 100; // each but the last lowers the energy; three suffice mostly
    bool changes = true;
    for (int sweep = 0; sweep < MostSweeps && changes; ++sweep)
    {
      changes = false;
      for (std::size_t n = 0; n < this->Nodes.size(); ++n)
      {
        changes = this->Improve(n) || changes;
      }
    }
    return this->Indices;
  }

private:
  /// Returns the possible indices of a corner, that of the smallest rotation first (1 if it is larger).
  static std::vector<int> Candidates(const NodeCorner& corner)
  {
    if (corner.prescribed)
    {
      return { *corner.prescribed };
    }
    const int nearest = std::min(1, SmallestRotationIndex(Pi - corner.angle));
    std::vector<int> candidates = { nearest };
    for (const int index : { nearest + 1, nearest - 1 })
    {
      const double angle = corner.angle / (2 - index);
      if (index <= 1 && angle >= SmallestAngle && angle <= Pi - SmallestAngle)
      {
        candidates.push_back(index);
      }
    }
    return candidates;
  }

  double EnergyOf(const NodeCorner& corner, int index) const
  {
    return CornerEnergy(corner.angle, index) +
      this->Quarter * std::abs(this->Missing[Index(corner.region)] - index);
  }

  /// Returns the number of quads of a node whose angles are nearest to 90°: in the plane 4 inside.
  static int RegularQuads(const NodeCorners& node)
  {
    const double angle = std::accumulate(node.corners.begin(), node.corners.end(), 0.0,
      [](double sum, const NodeCorner& corner) { return sum + corner.angle; });
    return node.isOnBoundary ? 2 - SmallestRotationIndex(Pi - angle)
                             : static_cast<int>(std::lround(angle / (0.5 * Pi)));
  }

  /// Chooses the indices of one node for those of the others. Returns whether that lowers the energy.
  bool Improve(std::size_t n)
  {
    const NodeCorners& node = this->Nodes[n];
    std::vector<int>& indices = this->Indices[n];
    for (std::size_t i = 0; i < indices.size(); ++i)
    {
      this->Missing[Index(node.corners[i].region)] += indices[i];
    }
    std::map<int, Choice> choices; // by the number of quads
    choices[0].energy = 0.0;
    for (const NodeCorner& corner : node.corners)
    {
      std::map<int, Choice> next;
      for (const auto& [quads, choice] : choices)
      {
        for (const int index : Candidates(corner))
        {
          Choice& best = next[quads + 2 - index];
          const double energy = choice.energy + this->EnergyOf(corner, index);
          if (energy < best.energy)
          {
            best = { energy, choice.indices };
            best.indices.push_back(index);
          }
        }
      }
      choices = std::move(next);
    }
    const int regular = RegularQuads(node);
    const auto total = [&](int quads, double energy)
    { return energy + this->Quarter * std::abs(quads - regular); };
    double present = 0.0;
    int presentQuads = 0;
    for (std::size_t i = 0; i < indices.size(); ++i)
    {
      present += this->EnergyOf(node.corners[i], indices[i]);
      presentQuads += 2 - indices[i];
    }
    // An exact tie, as of three angles of 120°, keeps what the node has.
    constexpr double Rounding = 1e-9;
    double lowest = total(presentQuads, present) - Rounding;
    bool changes = false;
    for (const auto& [quads, choice] : choices)
    {
      if (total(quads, choice.energy) < lowest)
      {
        lowest = total(quads, choice.energy);
        indices = choice.indices;
        changes = true;
      }
    }
    for (std::size_t i = 0; i < indices.size(); ++i)
    {
      this->Missing[Index(node.corners[i].region)] -= indices[i];
    }
    return changes;
  }

  const std::vector<NodeCorners>& Nodes;
  const double Quarter;
  std::vector<int> Missing; ///< Per region, what its singularities must have.
  std::vector<std::vector<int>> Indices;
};
}

int IndexOfNode(const std::vector<int>& quarterIndices, bool isOnBoundary)
{
  const int quads = std::accumulate(quarterIndices.begin(), quarterIndices.end(), 0,
    [](int sum, int index) { return sum + 2 - index; });
  return (isOnBoundary ? 2 : 4) - quads;
}

std::vector<std::vector<int>> ChooseNodeIndices(
  const std::vector<NodeCorners>& nodes, const std::vector<int>& required)
{
  return NodeSearch(nodes, required).Run();
}
}
