#include "ArcSpacing.h"

#include "Index.h"
#include "UnionFind.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace crossfield
{
namespace
{
/// Largest ratio of the widths of neighbouring strips, as that of the rows of layers.
constexpr double LargestRatio = 1.2;

/// The strips of quads through the edges on the arcs of a T-mesh. Edges are numbered along arcs; a
/// strip has the number of one of its edges.
class Strips
{
public:
  Strips(const TMesh& mesh, const std::vector<int>& counts)
    : Mesh(mesh)
    , Counts(counts)
    , Offsets{ 0 }
  {
    for (const int count : counts)
    {
      this->Offsets.push_back(this->Offsets.back() + count);
    }
    this->FindStrips();
    this->FindNeighbours();
  }

  /// Returns the strip of edge j of an arc.
  int At(std::size_t arc, int j) const { return this->Of[this->Offsets[arc] + j]; }

  /// Returns factors for the widths of all strips, limited by those of the strips through some
  /// arcs.
  std::vector<double> Factors(const std::vector<int>& arcs) const
  {
    std::vector<double> logarithms(this->Of.size(), 0.0);
    std::vector<double> edges(this->Of.size(), 0.0);
    for (std::size_t a = 0; a < this->Counts.size(); ++a)
    {
      for (int j = 0; j < this->Counts[a]; ++j)
      {
        logarithms[this->At(a, j)] += std::log(this->Mesh.arcs[a].length / this->Counts[a]);
        edges[this->At(a, j)] += 1.0;
      }
    }
    for (std::size_t i = 0; i < logarithms.size(); ++i)
    {
      logarithms[i] /= std::max(1.0, edges[i]);
    }
    std::vector<int> sources;
    for (const int arc : arcs)
    {
      for (int j = 0; j < this->Counts[arc]; ++j)
      {
        sources.push_back(this->At(static_cast<std::size_t>(arc), j));
      }
    }
    std::vector<double> factors = this->Limit(logarithms, sources);
    for (std::size_t i = 0; i < factors.size(); ++i)
    {
      factors[i] = std::exp(factors[i] - logarithms[i]);
    }
    this->FitToArcs(factors);
    return factors;
  }

private:
  /// Returns the edges along a side of a patch.
  std::vector<int> AlongSide(const TPatch& patch, std::size_t side) const
  {
    std::vector<int> edges;
    for (const int half : patch.sides[side])
    {
      const int count = this->Counts[half / 2];
      for (int j = 0; j < count; ++j)
      {
        edges.push_back(this->Offsets[half / 2] + (half % 2 == 0 ? j : count - 1 - j));
      }
    }
    return edges;
  }

  void FindStrips()
  {
    UnionFind sets(Index(this->Offsets.back()));
    for (const TPatch& patch : this->Mesh.patches)
    {
      for (const std::size_t side : { 0, 1 })
      {
        const std::vector<int> edges = this->AlongSide(patch, side);
        const std::vector<int> opposite = this->AlongSide(patch, side + 2);
        for (std::size_t i = 0; i < edges.size(); ++i)
        {
          sets.Join(edges[i], opposite[edges.size() - 1 - i]);
        }
      }
    }
    for (int i = 0; i < this->Offsets.back(); ++i)
    {
      this->Of.push_back(sets.Find(i));
    }
  }

  void FindNeighbours()
  {
    this->Neighbours.resize(this->Of.size());
    std::vector<int> beside(this->Mesh.halfEdges.size(), -1); // the strip along a half-edge
    for (const TPatch& patch : this->Mesh.patches)
    {
      for (std::size_t side = 0; side < 4; ++side)
      {
        const std::vector<int> edges = this->AlongSide(patch, side);
        for (std::size_t i = 1; i < edges.size(); ++i)
        {
          this->AddNeighbours(this->Of[edges[i - 1]], this->Of[edges[i]]);
        }
        const std::vector<int> across = this->AlongSide(patch, (side + 1) % 4);
        for (const int half : patch.sides[side])
        {
          beside[half] = across.empty() ? -1 : this->Of[across.front()];
        }
      }
    }
    for (std::size_t half = 0; half < beside.size(); half += 2)
    {
      if (beside[half] >= 0 && beside[half + 1] >= 0)
      {
        this->AddNeighbours(beside[half], beside[half + 1]);
      }
    }
  }

  /// Makes the mean of the factors on each arc 1, which all factors equal to 1 do, by iterative
  /// proportional fitting. Otherwise a side of one arc and the opposite one of several would be
  /// divided differently.
  void FitToArcs(std::vector<double>& factors) const
  {
    constexpr int Rounds = 50;
    for (int round = 0; round < Rounds; ++round)
    {
      for (std::size_t a = 0; a < this->Counts.size(); ++a)
      {
        double sum = 0.0;
        for (int j = 0; j < this->Counts[a]; ++j)
        {
          sum += factors[this->At(a, j)];
        }
        for (int j = 0; j < this->Counts[a]; ++j)
        {
          factors[this->At(a, j)] *= this->Counts[a] / sum;
        }
      }
    }
  }

  void AddNeighbours(int one, int other)
  {
    this->Neighbours[one].push_back(other);
    this->Neighbours[other].push_back(one);
  }

  /// Limits each value to source + distance · ln 1.2 for all sources, by Dijkstra's algorithm, then
  /// from below in the same way.
  std::vector<double> Limit(std::vector<double> values, const std::vector<int>& sources) const
  {
    for (const double sign : { 1.0, -1.0 })
    {
      using Entry = std::pair<double, int>;
      std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
      for (const int source : sources)
      {
        queue.emplace(sign * values[source], source);
      }
      while (!queue.empty())
      {
        const auto [value, strip] = queue.top();
        queue.pop();
        const double limit = value + std::log(LargestRatio);
        for (const int next : this->Neighbours[strip])
        {
          if (value == sign * values[strip] && limit < sign * values[next])
          {
            values[next] = sign * limit;
            queue.emplace(limit, next);
          }
        }
      }
    }
    return values;
  }

  const TMesh& Mesh;
  const std::vector<int>& Counts;
  std::vector<int> Offsets; ///< Number of the first edge of every arc.
  std::vector<int> Of;      ///< Strip per edge.
  std::vector<std::vector<int>> Neighbours;
};
}

std::vector<std::vector<double>> EqualSpacing(const TMesh& mesh, const std::vector<int>& counts)
{
  std::vector<std::vector<double>> spacing;
  for (std::size_t a = 0; a < counts.size(); ++a)
  {
    const int count = std::max(1, counts[a]);
    spacing.emplace_back();
    for (int j = 0; j <= count; ++j)
    {
      spacing.back().push_back(mesh.arcs[a].length * j / count);
    }
  }
  return spacing;
}

std::vector<std::vector<double>> GradualSpacing(
  const TMesh& mesh, const std::vector<int>& counts, const std::vector<int>& prescribed)
{
  std::vector<std::vector<double>> spacing = EqualSpacing(mesh, counts);
  const Strips strips(mesh, counts);
  const std::vector<double> factors = strips.Factors(prescribed);
  for (std::size_t a = 0; a < counts.size(); ++a)
  {
    std::vector<double>& places = spacing[a];
    for (int j = 0; j < counts[a]; ++j)
    {
      places[j + 1] = places[j] + factors[strips.At(a, j)];
    }
    const double factor = mesh.arcs[a].length / places.back();
    for (double& place : places)
    {
      place *= factor;
    }
    places.back() = mesh.arcs[a].length;
  }
  return spacing;
}
}
