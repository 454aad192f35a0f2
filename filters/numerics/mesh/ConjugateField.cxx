#include "ConjugateField.h"

#include "TriangleArea.h"

#include <algorithm>

namespace crossfield
{
Eigen::MatrixXd IntegrateConjugate(const TriangleMesh& mesh, const EdgeNumbering& edges,
  const Eigen::MatrixXd& gradients, int firstEdge, const Eigen::VectorXd& firstValues,
  const std::vector<LogSource>& logs)
{
  const Eigen::Index functions = firstValues.size();
  Eigen::MatrixXd values(functions, edges.Count());
  std::vector<bool> known(static_cast<std::size_t>(edges.Count()), false);
  std::vector<int> queue = { firstEdge };
  queue.reserve(known.size());
  known[static_cast<std::size_t>(firstEdge)] = true;
  values.col(firstEdge) = firstValues;
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    const int from = queue[next];
    for (int t : edges.triangles[static_cast<std::size_t>(from)])
    {
      if (t < 0)
      {
        continue;
      }
      const auto& ofTriangle = edges.ofTriangle[static_cast<std::size_t>(t)];
      const auto& triangle = mesh.triangles[static_cast<std::size_t>(t)];
      const auto point = [&](std::size_t i) -> const Point&
      { return mesh.points[static_cast<std::size_t>(triangle[i % 3])]; };
      const auto i = static_cast<std::size_t>(
        std::find(ofTriangle.begin(), ofTriangle.end(), from) - ofTriangle.begin());
      for (std::size_t other : { i + 1, i + 2 })
      {
        const int to = ofTriangle[other % 3];
        if (known[static_cast<std::size_t>(to)])
        {
          continue;
        }
        known[static_cast<std::size_t>(to)] = true;
        queue.push_back(to);
        // From the midpoint of edge i to that of edge `other`.
        const Point start = 0.5 * (point(i) + point(i + 1));
        const Point end = 0.5 * (point(other) + point(other + 1));
        const double turn = SumOfTurns(logs.data(), logs.data() + logs.size(), start, end);
        for (Eigen::Index c = 0; c < functions; ++c)
        {
          // rot g · Δ = g × Δ
          values(c, to) =
            values(c, from) + Cross(gradients.block<2, 1>(2 * c, t), end - start) + turn;
        }
      }
    }
  }
  return values;
}

double GradientEnergy(const TriangleMesh& mesh, const Eigen::MatrixXd& gradients)
{
  double energy = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const double area = TriangleArea(mesh, mesh.triangles[t]);
    energy += 0.5 * area * gradients.col(static_cast<Eigen::Index>(t)).squaredNorm();
  }
  return energy;
}
}
