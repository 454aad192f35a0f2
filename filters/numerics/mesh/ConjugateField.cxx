#include "ConjugateField.h"

#include "BothHalves.h"
#include "TriangleArea.h"

#include <algorithm>
#include <array>

namespace crossfield
{
Eigen::MatrixXd IntegrateConjugate(const TriangleMesh& mesh, const EdgeNumbering& edges,
  const Eigen::MatrixXd& gradients, int firstEdge, const Eigen::VectorXd& firstValues,
  const std::vector<LogSource>& logs)
{
  const Eigen::Index functions = firstValues.size();
  Eigen::MatrixXd values(functions, edges.Count());
  std::vector<char> known(static_cast<std::size_t>(edges.Count()), 0);
  // Breadth-first search. Each triangle is entered once, through an edge with known values, and
  // these are continued to its other two edges.
  std::vector<char> passed(mesh.triangles.size(), 0);
  struct Entry
  {
    int triangle;
    int edge;
  };
  std::vector<Entry> queue;
  queue.reserve(mesh.triangles.size());
  const auto reach = [&](int edge)
  {
    known[static_cast<std::size_t>(edge)] = 1;
    for (const int t : edges.triangles[static_cast<std::size_t>(edge)])
    {
      if (t >= 0 && passed[static_cast<std::size_t>(t)] == 0)
      {
        queue.push_back({ t, edge });
      }
    }
  };
  values.col(firstEdge) = firstValues;
  reach(firstEdge);
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    const auto [t, from] = queue[next];
    if (passed[static_cast<std::size_t>(t)] == 0)
    {
      passed[static_cast<std::size_t>(t)] = 1;
      const auto& ofTriangle = edges.ofTriangle[static_cast<std::size_t>(t)];
      const auto& triangle = mesh.triangles[static_cast<std::size_t>(t)];
      const auto point = [&](std::size_t i) -> const Point&
      { return mesh.points[static_cast<std::size_t>(triangle[i % 3])]; };
      const auto i = static_cast<std::size_t>(
        std::find(ofTriangle.begin(), ofTriangle.end(), from) - ofTriangle.begin());
      for (std::size_t other : { i + 1, i + 2 })
      {
        const int to = ofTriangle[other % 3];
        if (known[static_cast<std::size_t>(to)] != 0)
        {
          continue;
        }
        // Step from the midpoint of edge i to that of edge `other`.
        const Point start = 0.5 * (point(i) + point(i + 1));
        const Point end = 0.5 * (point(other) + point(other + 1));
        const double turn = SumOfTurns(logs.data(), logs.data() + logs.size(), start, end);
        for (Eigen::Index c = 0; c < functions; ++c)
        {
          // rot g · Δ = g × Δ
          values(c, to) =
            values(c, from) + Cross(gradients.block<2, 1>(2 * c, t), end - start) + turn;
        }
        reach(to);
      }
    }
  }
  return values;
}

double GradientEnergy(const TriangleMesh& mesh, const Eigen::MatrixXd& gradients)
{
  std::array<double, 2> energies = { 0.0, 0.0 };
  const auto count = static_cast<int>(mesh.triangles.size());
  ForBothHalves(count >= MinimumParallelCount,
    [&](std::size_t half)
    {
      double energy = 0.0;
      const auto [begin, end] = HalfRange(count, half);
      for (int t = begin; t < end; ++t)
      {
        const double area = TriangleArea(mesh, mesh.triangles[static_cast<std::size_t>(t)]);
        energy += 0.5 * area * gradients.col(t).squaredNorm();
      }
      energies[half] = energy;
    });
  return energies[0] + energies[1];
}
}
