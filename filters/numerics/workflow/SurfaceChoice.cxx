#include "SurfaceChoice.h"

#include "EdgeDistances.h"
#include "Error.h"
#include "Index.h"
#include "SmoothCrosses.h"
#include "SurfaceIndices.h"
#include "SurfaceTopology.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <utility>

namespace crossfield
{
namespace
{
Error TooFewPoints(const MeshTopology& topology, int vertex)
{
  return { "The surface has too few points near " + topology.Where(vertex) +
      " for its singularities",
    "divide its triangles", Error::Kind::CoarseMesh };
}

/// Indices inside the surface, which change place.
class IndexList
{
public:
  explicit IndexList(const MeshTopology& topology)
    : Topology(topology)
    , Distances(topology)
    , Size(std::sqrt(topology.Area()))
  {
  }

  /// Adds an index to the inner vertex nearest to one. Throws Error if there is none.
  void Add(int vertex, int quarters)
  {
    bool isAdded = quarters == 0;
    this->Distances.VisitFrom(vertex,
      [&](int inside, double)
      {
        this->Quarters[inside] += quarters;
        isAdded = true;
        return false;
      });
    if (!isAdded)
    {
      throw TooFewPoints(this->Topology, vertex);
    }
  }

  /// Leaves out pairs of one positive and one negative quarter that are nearer than a part of the size, the nearest pairs
  /// first.
  void Cancel(double part)
  {
    struct Pair
    {
      double distance;
      int positive;
      int negative;
    };
    std::vector<Pair> pairs;
    for (const auto& [vertex, quarters] : this->Quarters)
    {
      if (quarters <= 0)
      {
        continue;
      }
      const int positive = vertex;
      this->Distances.VisitFrom(vertex,
        [&](int other, double distance)
        {
          if (this->At(other) < 0)
          {
            pairs.push_back({ distance, positive, other });
          }
          return distance < part * this->Size;
        });
    }
    std::stable_sort(pairs.begin(), pairs.end(),
      [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
    for (const Pair& pair : pairs)
    {
      int& positive = this->Quarters[pair.positive];
      int& negative = this->Quarters[pair.negative];
      const int common = std::min(positive, -negative);
      if (common > 0)
      {
        positive -= common;
        negative += common;
      }
    }
  }

  /// Divides indices of several quarters: each quarter but one goes to a vertex at a distance of a part of the
  /// size, as far as possible from the others.
  void Divide(double part)
  {
    const std::map<int, int> before = this->Quarters;
    for (const auto& [vertex, quarters] : before)
    {
      const int sign = quarters < 0 ? -1 : 1;
      for (int i = 1; i < std::abs(quarters); ++i)
      {
        int farthest = -1;
        double largest = -1.0;
        const int from = vertex;
        this->Distances.VisitFrom(vertex,
          [&](int other, double distance)
          {
            double free = std::numeric_limits<double>::infinity();
            for (const auto& [taken, index] : this->Quarters)
            {
              free = index == 0
                ? free
                : std::min(free,
                    (this->Topology.PositionOf(taken) - this->Topology.PositionOf(other)).norm());
            }
            if (free > largest)
            {
              largest = free;
              farthest = other;
            }
            return distance < part * this->Size;
          });
        if (farthest >= 0 && largest > 0.0)
        {
          this->Quarters[from] -= sign;
          this->Quarters[farthest] += sign;
        }
      }
    }
  }

  std::vector<Cone> Cones() const
  {
    std::vector<Cone> cones;
    for (const auto& [vertex, quarters] : this->Quarters)
    {
      if (quarters != 0)
      {
        cones.push_back({ vertex, quarters, false, static_cast<int>(cones.size()) });
      }
    }
    return cones;
  }

private:
  int At(int vertex) const
  {
    const auto found = this->Quarters.find(vertex);
    return found == this->Quarters.end() ? 0 : found->second;
  }

  const MeshTopology& Topology;
  const EdgeDistances Distances;
  const double Size;
  std::map<int, int> Quarters;
};
}

std::vector<Cone> ChooseSurfaceCones(const MeshTopology& topology, const std::vector<Cone>& corners,
  bool withoutPairs, const Progress& progress)
{
  // Four quads of a mesh of a thousand, which hardly resolves nearer pairs.
  constexpr double Nearest = 0.12;
  // Where a singularity of several quarters is divided.
  constexpr double Apart = 0.04;
  const Eigen::VectorXd angle = SmoothCrosses(topology, progress);
  std::map<int, int> prescribed;
  for (const Cone& corner : corners)
  {
    prescribed[corner.vertex] = corner.quarterIndex;
  }
  IndexList indices(topology);
  for (const VertexSingularity& one : FindSurfaceSingularities(topology, angle, true))
  {
    const auto corner = prescribed.find(one.vertex);
    const int given = corner == prescribed.end() ? 0 : std::exchange(corner->second, 0);
    indices.Add(one.vertex, one.quarterIndex - given);
  }
  for (const auto& [vertex, quarters] : prescribed) // where the crosses have none
  {
    indices.Add(vertex, -quarters);
  }
  indices.Cancel(withoutPairs ? std::numeric_limits<double>::infinity() : Nearest);
  indices.Divide(Apart);
  std::vector<Cone> cones = indices.Cones();
  for (const Cone& cone : cones)
  {
    if (std::abs(cone.quarterIndex) > 1)
    {
      throw TooFewPoints(topology, cone.vertex);
    }
  }
  return cones;
}

std::vector<SurfaceSingularity> ChooseSurfaceSingularities(
  const FeaturedPart& part, const Progress& progress)
{
  const SurfaceBody body = PlaceCones(part);
  std::vector<SurfaceSingularity> chosen;
  const double share = 1.0 / static_cast<double>(body.faces.size());
  double done = 0.0;
  for (const ConedSurface& face : body.faces)
  {
    for (const Cone& cone :
      ChooseSurfaceCones(*face.topology, face.cones, false, progress.Part(done, done + share)))
    {
      chosen.push_back({ face.topology->PositionOf(cone.vertex), cone.quarterIndex });
    }
    done += share;
  }
  return chosen;
}

std::vector<SurfaceSingularity> ChooseSurfaceSingularities(
  const SurfaceMesh& surface, double featureAngle, const Progress& progress)
{
  const FeaturedParts found = FindFeaturedParts(surface, {}, featureAngle);
  std::vector<SurfaceSingularity> chosen;
  const double share = 1.0 / static_cast<double>(found.parts.size());
  double done = 0.0;
  for (const FeaturedPart& part : found.parts)
  {
    const std::vector<SurfaceSingularity> more =
      ChooseSurfaceSingularities(part, progress.Part(done, done + share));
    chosen.insert(chosen.end(), more.begin(), more.end());
    done += share;
  }
  return chosen;
}
}
