#include "MetricDerivatives.h"

#include "Index.h"
#include "SymmetricAssembly.h"

namespace crossfield
{
namespace
{
/// Calls function(edge, a, b) once per edge, with its end points.
template <typename Function>
void ForEachEdge(const ConeMetric& metric, const Function& function)
{
  const auto& triangles = metric.Triangles();
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
  {
    const ConeMetric::Triangle& triangle = triangles[t];
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (triangle.neighbours[i] < t)
      {
        function(triangle.edges[i], triangle.vertices[i], triangle.vertices[(i + 1) % 3]);
      }
    }
  }
}
}

MetricDerivatives::MetricDerivatives(const ConeMetric& metric)
  : Metric(metric)
{
  this->Angles.reserve(metric.Triangles().size());
  for (int t = 0; t < static_cast<int>(metric.Triangles().size()); ++t)
  {
    this->Angles.push_back(metric.AnglesOf(t));
  }
}

Eigen::VectorXd MetricDerivatives::AngleDefects() const
{
  Eigen::VectorXd defects(static_cast<Eigen::Index>(this->Metric.Points().size()));
  for (int v = 0; v < static_cast<int>(defects.size()); ++v)
  {
    defects[v] = 0.5 * Pi * this->Metric.QuartersAt(v);
  }
  for (std::size_t t = 0; t < this->Angles.size(); ++t)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      defects[this->Metric.Triangles()[t].vertices[i]] -= this->Angles[t].angle[i];
    }
  }
  return defects;
}

std::array<MetricDerivatives::Term, 3> MetricDerivatives::AngleDerivative(
  int triangle, int corner) const
{
  const auto& edges = this->Metric.Triangles()[triangle].edges;
  const auto& cotangent = this->Angles[triangle].cotangent;
  const auto i = Index(corner);
  const std::size_t j = (i + 1) % 3;
  const std::size_t k = (i + 2) % 3;
  // Side j is opposite to vertex i, side k to j, side i to k.
  return { Term(edges[j], cotangent[j] + cotangent[k]), Term(edges[k], -cotangent[k]),
    Term(edges[i], -cotangent[j]) };
}

Eigen::VectorXd MetricDerivatives::AngleSumChanges(const Eigen::VectorXd& edges) const
{
  Eigen::VectorXd sums =
    Eigen::VectorXd::Zero(static_cast<Eigen::Index>(this->Metric.Points().size()));
  for (int t = 0; t < static_cast<int>(this->Angles.size()); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      for (const auto& [edge, value] : this->AngleDerivative(t, i))
      {
        sums[this->Metric.Triangles()[t].vertices[i]] += value * edges[edge];
      }
    }
  }
  return sums;
}

Eigen::VectorXd MetricDerivatives::Pullback(const Eigen::VectorXd& vertices) const
{
  Eigen::VectorXd result =
    Eigen::VectorXd::Zero(static_cast<Eigen::Index>(this->Metric.LogLengths().size()));
  for (int t = 0; t < static_cast<int>(this->Angles.size()); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      for (const auto& [edge, value] : this->AngleDerivative(t, i))
      {
        result[edge] += value * vertices[this->Metric.Triangles()[t].vertices[i]];
      }
    }
  }
  return result;
}

Eigen::SparseMatrix<double> MetricDerivatives::Laplacian() const
{
  Eigen::VectorXd diagonal =
    Eigen::VectorXd::Zero(static_cast<Eigen::Index>(this->Metric.Points().size()));
  std::vector<double> weights(this->Metric.LogLengths().size(), 0.0);
  for (std::size_t t = 0; t < this->Angles.size(); ++t)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      weights[this->Metric.Triangles()[t].edges[(i + 1) % 3]] += 0.5 * this->Angles[t].cotangent[i];
    }
  }
  std::vector<SymmetricEntry> offDiagonal;
  offDiagonal.reserve(weights.size());
  ForEachEdge(this->Metric,
    [&](int edge, int a, int b)
    {
      const double weight = weights[edge];
      diagonal[a] += weight;
      diagonal[b] += weight;
      offDiagonal.push_back({ a, b, -weight });
    });
  return AssembleSymmetric(diagonal, offDiagonal);
}

Eigen::VectorXd ConformalChanges(const ConeMetric& metric, const Eigen::VectorXd& vertices)
{
  Eigen::VectorXd edges(static_cast<Eigen::Index>(metric.LogLengths().size()));
  ForEachEdge(
    metric, [&](int edge, int a, int b) { edges[edge] = 0.5 * (vertices[a] + vertices[b]); });
  return edges;
}

Eigen::VectorXd ConformalPullback(const ConeMetric& metric, const Eigen::VectorXd& edges)
{
  Eigen::VectorXd vertices =
    Eigen::VectorXd::Zero(static_cast<Eigen::Index>(metric.Points().size()));
  ForEachEdge(metric,
    [&](int edge, int a, int b)
    {
      vertices[a] += 0.5 * edges[edge];
      vertices[b] += 0.5 * edges[edge];
    });
  return vertices;
}
}
