#include "ConeDescent.h"

#include "EdgeDistances.h"
#include "Index.h"
#include "PoincareHopf.h"
#include "VertexPotential.h"

#include <array>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Singularities that move, and their function F.
class ConeDescent
{
public:
  ConeDescent(const SharedTopology& topology, const std::vector<Cone>& cones,
    const std::vector<Cone>& corners)
    : Topology(*topology)
    , Potential(topology)
    , Distances(*topology)
    , Areas(Eigen::VectorXd::Zero(topology->VertexCount()))
    , Cones(cones)
  {
    for (int t = 0; t < this->Topology.TriangleCount(); ++t)
    {
      for (const int vertex : this->Topology.mesh.triangles[t])
      {
        this->Areas[vertex] += this->Topology.AreaOf(t) / 3.0;
      }
    }
    this->Area = this->Areas.sum();
    std::vector<Cone> all = cones;
    all.insert(all.end(), corners.begin(), corners.end());
    this->Quarters = QuartersOfVertices(this->Topology, all);
  }

  /// Moves one singularity after the other to the best of the vertices at a distance relative to √area, until none
  /// moves.
  void Run(double distance, double lambda, const Progress& progress)
  {
    constexpr int MaximumSweeps = 30; // 3 to 10 are usual
    double lowest = this->EnergyWith(lambda);
    bool moves = true;
    for (int sweep = 0; moves && sweep < MaximumSweeps; ++sweep)
    {
      progress.Report(static_cast<double>(sweep) / MaximumSweeps);
      moves = false;
      for (std::size_t i = 0; i < this->Cones.size(); ++i)
      {
        const int start = this->Cones[i].vertex;
        int best = start;
        for (const int vertex : this->Distances.Around(start, distance * std::sqrt(this->Area)))
        {
          if (this->Quarters[Index(vertex)] != 0)
          {
            continue;
          }
          this->Move(i, vertex);
          const double energy = this->EnergyWith(lambda);
          if (energy < lowest)
          {
            lowest = energy;
            best = vertex;
          }
          this->Move(i, start);
        }
        this->Move(i, best);
        moves = moves || best != start;
      }
    }
  }

  const std::vector<Cone>& GetCones() const { return this->Cones; }

private:
  void Move(std::size_t cone, int vertex)
  {
    int& from = this->Quarters[Index(this->Cones[cone].vertex)];
    std::swap(from, this->Quarters[Index(vertex)]);
    this->Cones[cone].vertex = vertex;
  }

  /// Returns F.
  double EnergyWith(double lambda) const
  {
    constexpr double Repulsion = 0.1; // measured: without W, quads are not better on average
    const VertexPotential::Solution solution = this->Potential.Solve(this->Quarters);
    Eigen::VectorXd h = 0.25 * solution.potential.head(this->Areas.size());
    const Eigen::VectorXd sources =
      0.25 * this->Potential.GetOperator().Apply(solution.potential).head(this->Areas.size());
    h.array() -= this->Areas.dot(h) / this->Area;
    double w = 0.5 * sources.dot(h);
    for (const Cone& cone : this->Cones)
    {
      const double strength = 0.5 * Pi * cone.quarterIndex;
      w += strength * strength * std::log(this->Areas[cone.vertex] / this->Area) / (8.0 * Pi);
    }
    double defects = 0.0;
    for (const double defect : solution.holonomyDefect)
    {
      defects += 0.0625 * defect * defect; // of 4θ
    }
    return this->Areas.dot(h.cwiseAbs2()) / this->Area + Repulsion * w + lambda * defects;
  }

  const MeshTopology& Topology;
  const VertexPotential Potential;
  const EdgeDistances Distances;
  Eigen::VectorXd Areas; ///< A third of the triangles at each vertex.
  double Area = 0.0;
  std::vector<Cone> Cones;
  std::vector<int> Quarters; ///< Per vertex.
};
}

std::vector<Cone> MovedCones(
  const SharedTopology& topology, const std::vector<Cone>& cones, const Progress& progress)
{
  std::vector<Cone> inside;
  std::vector<Cone> corners;
  for (const Cone& cone : cones)
  {
    (cone.onBoundary ? corners : inside).push_back(cone);
  }
  // With a large weight from the start, no single move would leave the first places without defects.
  constexpr std::array<std::pair<double, double>, 3> Stages = { { { 0.02, 0.3 }, { 0.02, 3.0 },
    { 0.01, 30.0 } } };
  ConeDescent descent(topology, inside, corners);
  double done = 0.0;
  for (const auto& [distance, lambda] : Stages)
  {
    const double end = done + 1.0 / Stages.size();
    descent.Run(distance, lambda, progress.Part(done, end));
    done = end;
  }
  progress.Report(1.0);
  std::vector<Cone> moved = cones;
  std::size_t next = 0;
  for (Cone& cone : moved)
  {
    if (!cone.onBoundary)
    {
      cone = descent.GetCones()[next++];
    }
  }
  return moved;
}
}
