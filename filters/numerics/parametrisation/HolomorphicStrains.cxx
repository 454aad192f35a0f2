#include "HolomorphicStrains.h"

#include <algorithm>
#include <numeric>

namespace crossfield
{
namespace
{
/// Returns the value below which |q| is on the given part of the area.
double AreaQuantile(
  const Eigen::VectorXd& values, const std::vector<double>& areas, double quantile)
{
  std::vector<int> order(areas.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&values](int a, int b) { return std::pair(values[a], a) < std::pair(values[b], b); });
  const double limit = quantile * std::accumulate(areas.begin(), areas.end(), 0.0);
  double below = 0.0;
  for (const int t : order)
  {
    below += areas[t];
    if (below >= limit)
    {
      return values[t];
    }
  }
  return values[order.back()];
}
}

HolomorphicStrains::HolomorphicStrains(const MetricDerivatives& derivatives,
  const LoopAlignment& alignment, const Eigen::MatrixXd& potentials)
  : Metric(derivatives.GetMetric())
{
  const auto loops = static_cast<Eigen::Index>(alignment.rows.size());
  const auto edges = static_cast<Eigen::Index>(this->Metric.LogLengths().size());
  const auto triangles = static_cast<int>(this->Metric.Triangles().size());
  this->Differentials.resize(edges, loops);
  for (Eigen::Index j = 0; j < loops; ++j)
  {
    this->Differentials.col(j) = -derivatives.Pullback(potentials.col(j));
    for (const auto& [edge, value] : alignment.rows[j])
    {
      this->Differentials(edge, j) += value;
    }
  }
  this->Quadratic.resize(triangles, loops);
  for (int t = 0; t < triangles; ++t)
  {
    const ConeMetric::Triangle& triangle = this->Metric.Triangles()[t];
    const auto& angle = derivatives.AnglesOf(t).angle;
    this->Areas.push_back(this->Metric.AreaOf(t));
    // Squares of the directions 1, −e^{−iα_1} and −e^{iα_0}.
    this->Squares.push_back(
      { Complex(1.0), std::polar(1.0, -2.0 * angle[1]), std::polar(1.0, 2.0 * angle[0]) });
    for (Eigen::Index j = 0; j < loops; ++j)
    {
      Complex sum = 0.0;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const double weight = triangle.neighbours[i] < 0 ? 1.0 : 0.5;
        sum += weight * this->Differentials(triangle.edges[i], j) * std::conj(this->Squares[t][i]);
      }
      this->Quadratic(t, j) = sum;
    }
  }
  // Two rounds remove the difference between neighbouring triangles that an edge value leaves.
  this->Average();
  this->Average();
}

void HolomorphicStrains::Average()
{
  const Eigen::MatrixXcd before = this->Quadratic;
  for (int t = 0; t < static_cast<int>(this->Squares.size()); ++t)
  {
    const ConeMetric::Triangle& triangle = this->Metric.Triangles()[t];
    double count = 1.0;
    for (int i = 0; i < 3; ++i)
    {
      if (triangle.neighbours[i] >= 0)
      {
        const auto [neighbour, side] = this->Metric.Across({ t, i });
        // Q d² of the common side is the same in both charts.
        const Complex turn = this->Squares[neighbour][side] * std::conj(this->Squares[t][i]);
        this->Quadratic.row(t) += turn * before.row(neighbour);
        count += 1.0;
      }
    }
    this->Quadratic.row(t) /= count;
  }
}

HolomorphicStrains::Strains HolomorphicStrains::For(
  const Eigen::VectorXd& coefficients, double quantile) const
{
  const auto triangles = static_cast<Eigen::Index>(this->Areas.size());
  Eigen::VectorXd magnitude = Eigen::VectorXd::Ones(triangles);
  if (!coefficients.isZero(0.0))
  {
    magnitude = (this->Quadratic * coefficients).cwiseAbs();
    for (Eigen::Index t = 0; t < triangles; ++t)
    {
      magnitude[t] /= this->Areas[t];
    }
    magnitude = magnitude.cwiseMax(AreaQuantile(magnitude, this->Areas, quantile));
  }
  Eigen::VectorXd denominators = magnitude;
  for (Eigen::Index t = 0; t < triangles; ++t)
  {
    denominators[t] *= this->Areas[t];
  }
  Strains strains;
  strains.edges = Eigen::MatrixXd::Zero(this->Differentials.rows(), this->Differentials.cols());
  for (Eigen::Index t = 0; t < triangles; ++t)
  {
    const ConeMetric::Triangle& triangle = this->Metric.Triangles()[t];
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double part = triangle.neighbours[i] < 0 ? 1.0 : 0.5;
      const Complex square = this->Squares[t][i];
      // Re(μ conj(d)²) = Re(Q d²) / denominator
      strains.edges.row(triangle.edges[i]) +=
        part / denominators[t] * (this->Quadratic.row(t) * square).real();
    }
  }
  strains.response = this->Differentials.transpose() * strains.edges;
  return strains;
}

DifferentialSample HolomorphicStrains::Sample(int count) const
{
  const auto triangles = static_cast<Eigen::Index>(this->Areas.size());
  const Eigen::Index stride = std::max<Eigen::Index>(1, triangles / count);
  const Eigen::Index size = (triangles + stride - 1) / stride;
  DifferentialSample sample{ Eigen::MatrixXcd(size, this->Quadratic.cols()),
    Eigen::VectorXd(size) };
  for (Eigen::Index i = 0; i < size; ++i)
  {
    const double area = this->Areas[i * stride];
    sample.areas[i] = static_cast<double>(stride) * area;
    sample.quadratic.row(i) = this->Quadratic.row(i * stride) / area;
  }
  return sample;
}
}
