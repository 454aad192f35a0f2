#include "SeamlessPoisson.h"

#include "Error.h"
#include "P1Laplacian.h"
#include "Parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace crossfield
{
namespace
{
using Complex = std::complex<double>;

/// Returns values at the corners of a triangle of a function with the target derivative: that at
/// the centre, times (ζ / ζ_c)^{p − 1} near a cone, whose singular part the map then reproduces
/// exactly.
std::array<Complex, 3> LocalPrimitive(
  const std::array<Point, 3>& corners, Complex derivative, const NearCone* cone)
{
  std::array<Complex, 3> values;
  const Point centre = (corners[0] + corners[1] + corners[2]) / 3.0;
  const auto complex = [](const Point& point) { return Complex(point.x(), point.y()); };
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (cone == nullptr)
    {
      values[i] = derivative * complex(corners[i] - corners[0]);
      continue;
    }
    const Complex toCentre = complex(centre - cone->position);
    const Complex ratio = complex(corners[i] - cone->position) / toCentre;
    values[i] =
      ratio == 0.0 ? 0.0 : derivative * toCentre / cone->power * std::pow(ratio, cone->power);
  }
  return values;
}
}

SeamlessPoisson TargetGradients(const MeshTopology& topology, const TriangleFrames& frames)
{
  // Of the logarithm of sizes: the weights, e^{2h}, must be representable, and their products with targets.
  constexpr double LargestLogarithm = 300.0;
  if (std::any_of(frames.h.begin(), frames.h.end(),
        [](double h) { return !(std::abs(h) <= LargestLogarithm); }))
  {
    throw Error("With these positions of the singularities, sizes differ by a factor of more than "
                "e^300 = 1e130",
      "move singularities to where the domain is wider, or nearer to those of opposite sign",
      Error::Kind::CoarseMesh);
  }
  SeamlessPoisson problem;
  problem.weights.resize(topology.mesh.triangles.size());
  problem.target.resize(topology.mesh.triangles.size());
  ForRanges(topology.TriangleCount(),
    [&](int begin, int end)
    {
      auto near = std::lower_bound(frames.near.begin(), frames.near.end(), begin,
        [](const NearCone& cone, int triangle) { return cone.triangle < triangle; });
      for (int t = begin; t < end; ++t)
      {
        const NearCone* cone = nullptr;
        if (near != frames.near.end() && near->triangle == t)
        {
          cone = &*near;
          ++near;
        }
        const std::array<Complex, 3> values = LocalPrimitive(
          topology.ChartOf(t), std::polar(std::exp(-frames.h[t]), -frames.angle[t]), cone);
        for (std::size_t i = 0; i < 3; ++i)
        {
          problem.target[t].row(static_cast<Eigen::Index>(i)) << values[i].real(), values[i].imag();
        }
        problem.weights[t] = std::exp(2.0 * frames.h[t]);
      }
    });
  LimitWeights(problem.weights);
  return problem;
}

void LimitWeights(std::vector<double>& weights)
{
  constexpr double SmallestPart = 1e-8;
  const double minimum = SmallestPart * *std::max_element(weights.begin(), weights.end());
  for (double& weight : weights)
  {
    weight = std::max(weight, minimum);
  }
}

Eigen::Matrix<double, 3, 2> SeamlessPoisson::DeviationIn(
  const SeamlessMap& map, const Eigen::VectorXd& unknowns, std::size_t triangle) const
{
  const auto& corners = map.corners[triangle];
  const Eigen::Matrix<double, 3, 2>& goal = this->target[triangle];
  Eigen::Matrix<double, 3, 2> deviation = Eigen::Matrix<double, 3, 2>::Zero();
  for (int i = 1; i < 3; ++i)
  {
    deviation.row(i) = (goal.row(i) - goal.row(0)) -
      (unknowns.segment<2>(2 * corners[i]) - unknowns.segment<2>(2 * corners[0])).transpose();
  }
  return deviation;
}

Eigen::MatrixX2d SeamlessPoisson::Residual(
  const SeamlessMap& map, const Eigen::VectorXd& unknowns) const
{
  const auto count = static_cast<Eigen::Index>(map.original.size());
  Eigen::MatrixX2d residual = Eigen::MatrixX2d::Zero(count, 2);
  for (std::size_t t = 0; t < this->target.size(); ++t)
  {
    const Eigen::Matrix<double, 3, 2> flux = this->weights[t] *
      (P1ElementStiffness(map.topology->ChartOf(static_cast<int>(t))) *
        this->DeviationIn(map, unknowns, t));
    for (int i = 0; i < 3; ++i)
    {
      residual.row(map.corners[t][i]) += flux.row(i);
    }
  }
  return residual;
}

double SeamlessPoisson::ObjectiveAt(const SeamlessMap& map, const Eigen::VectorXd& unknowns) const
{
  double residual = 0.0;
  for (std::size_t t = 0; t < this->target.size(); ++t)
  {
    const Eigen::Matrix<double, 3, 2> deviation = this->DeviationIn(map, unknowns, t);
    residual += this->weights[t] *
      deviation
        .cwiseProduct(P1ElementStiffness(map.topology->ChartOf(static_cast<int>(t))) * deviation)
        .sum();
  }
  return residual;
}
}
