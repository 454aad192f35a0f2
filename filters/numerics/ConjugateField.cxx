#include "ConjugateField.h"

namespace crossfield
{
Eigen::VectorXd IntegrateConjugate(const TriangleMesh& mesh, const EdgeNumbering& edges,
  const Eigen::Matrix2Xd& gradients, int firstEdge, double firstValue,
  const std::vector<LogSource>& logs)
{
  const auto midpoint = [&](int edge)
  {
    const auto& ends = edges.vertices[static_cast<std::size_t>(edge)];
    return Point(0.5 *
      (mesh.points[static_cast<std::size_t>(ends[0])] +
        mesh.points[static_cast<std::size_t>(ends[1])]));
  };
  Eigen::VectorXd values = Eigen::VectorXd::Zero(edges.Count());
  std::vector<bool> known(static_cast<std::size_t>(edges.Count()), false);
  std::vector<int> queue = { firstEdge };
  queue.reserve(known.size());
  known[static_cast<std::size_t>(firstEdge)] = true;
  values[firstEdge] = firstValue;
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    const int from = queue[next];
    for (int triangle : edges.triangles[static_cast<std::size_t>(from)])
    {
      if (triangle < 0)
      {
        continue;
      }
      const Point gradient = gradients.col(triangle);
      for (int to : edges.ofTriangle[static_cast<std::size_t>(triangle)])
      {
        if (!known[static_cast<std::size_t>(to)])
        {
          known[static_cast<std::size_t>(to)] = true;
          // rot g · Δ = g × Δ
          values[to] = values[from] + Cross(gradient, midpoint(to) - midpoint(from));
          for (const LogSource& log : logs)
          {
            values[to] += log.strength * log.Turn(midpoint(from), midpoint(to));
          }
          queue.push_back(to);
        }
      }
    }
  }
  return values;
}

double GradientEnergy(const TriangleMesh& mesh, const Eigen::Matrix2Xd& gradients)
{
  double energy = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& triangle = mesh.triangles[t];
    const Point& p0 = mesh.points[static_cast<std::size_t>(triangle[0])];
    const double area = 0.5 *
      Cross(mesh.points[static_cast<std::size_t>(triangle[1])] - p0,
        mesh.points[static_cast<std::size_t>(triangle[2])] - p0);
    energy += 0.5 * area * gradients.col(static_cast<Eigen::Index>(t)).squaredNorm();
  }
  return energy;
}
}
