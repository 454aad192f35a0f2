#include "PlanarTopology.h"
#include "Support.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"
#include "VertexPotential.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns the largest difference of H and exact values without their means over vertices that are given.
double LargestError(const Eigen::VectorXd& potential, const Eigen::VectorXd& exact,
  const std::vector<bool>& isCompared)
{
  double mean = 0.0;
  double count = 0.0;
  for (Eigen::Index v = 0; v < exact.size(); ++v)
  {
    mean += isCompared[v] ? 0.25 * potential[v] - exact[v] : 0.0;
    count += isCompared[v] ? 1.0 : 0.0;
  }
  double largest = 0.0;
  for (Eigen::Index v = 0; v < exact.size(); ++v)
  {
    if (isCompared[v])
    {
      largest = std::max(largest, std::abs(0.25 * potential[v] - exact[v] - mean / count));
    }
  }
  return largest;
}

TEST(VertexPotential, IsExactAtSecondOrderOnTheSphere)
{
  // With the singularities of a cube, H = ¼ Σ log |x − b| + constant.
  std::vector<double> errors;
  for (const int n : { 8, 16, 32 })
  {
    const SurfaceMesh sphere = CubedSphere(n);
    const auto topology = std::make_shared<const SurfaceTopology>(sphere);
    std::vector<int> quarters(sphere.points.size(), 0);
    std::fill_n(quarters.begin(), 8, 1);
    const VertexPotential::Solution solution = VertexPotential(topology).Solve(quarters);
    EXPECT_TRUE(solution.holonomyDefect.empty());
    Eigen::VectorXd exact(sphere.points.size());
    std::vector<bool> isCompared;
    for (std::size_t v = 0; v < sphere.points.size(); ++v)
    {
      double sum = 0.0;
      double nearest = 2.0;
      for (int b = 0; b < 8; ++b)
      {
        const double distance = (sphere.points[v] - sphere.points[b]).norm();
        sum += std::log(distance);
        nearest = std::min(nearest, distance);
      }
      exact[v] = 0.25 * sum;
      isCompared.push_back(nearest > 0.2);
    }
    errors.push_back(LargestError(solution.potential, exact, isCompared));
  }
  EXPECT_LT(errors[2], 2e-3);
  EXPECT_GT(std::log2(errors[1] / errors[2]), 1.7);
}

TEST(VertexPotential, IsExactAtSecondOrderOnTheTorus)
{
  // Without singularities H = log(R + cos v) + constant, and the crosses along both circles close up.
  constexpr double R = 2.5;
  std::vector<double> errors;
  for (const int n : { 12, 24, 48 })
  {
    const SurfaceMesh torus = Torus(R, 5 * n / 2, n);
    const auto topology = std::make_shared<const SurfaceTopology>(torus);
    const VertexPotential::Solution solution =
      VertexPotential(topology).Solve(std::vector<int>(torus.points.size(), 0));
    Eigen::VectorXd exact(torus.points.size());
    for (std::size_t v = 0; v < torus.points.size(); ++v)
    {
      exact[v] = std::log(torus.points[v].head<2>().norm());
    }
    errors.push_back(
      LargestError(solution.potential, exact, std::vector<bool>(torus.points.size(), true)));
    ASSERT_EQ(solution.holonomyDefect.size(), 2u);
    for (const double defect : solution.holonomyDefect)
    {
      EXPECT_NEAR(defect, 0.0, 1e-2);
    }
  }
  EXPECT_LT(errors[2], 1e-3);
  EXPECT_GT(std::log2(errors[1] / errors[2]), 1.8);
}

TEST(VertexPotential, IsThatOfThePlaneWhenAMeshIsBent)
{
  constexpr int N = 12;
  const TriangleMesh mesh = GridOfSquare(N);
  const auto bent = std::make_shared<const SurfaceTopology>(BentAtRandom(mesh, N, 554));
  std::vector<int> quarters(mesh.points.size(), 0);
  for (const int corner : { 0, N, N * (N + 1), (N + 1) * (N + 1) - 1 })
  {
    quarters[corner] = 1;
  }
  quarters[4 * (N + 1) + 5] = 1;
  quarters[8 * (N + 1) + 7] = -1;
  const auto difference = [](Eigen::VectorXd a, Eigen::VectorXd b)
  { return (a.array() - a.mean() - b.array() + b.mean()).matrix().lpNorm<Eigen::Infinity>(); };
  const Eigen::VectorXd planar = VertexPotential(ShareTopology(mesh)).Solve(quarters).potential;
  EXPECT_LT(difference(planar, VertexPotential(bent).Solve(quarters).potential), 1e-10);
  EXPECT_GT(planar.lpNorm<Eigen::Infinity>(), 0.1);
}

TEST(VertexPotential, RefusesIndicesThatDoNotAddUp)
{
  const SurfaceMesh sphere = CubedSphere(3);
  const VertexPotential potential(std::make_shared<const SurfaceTopology>(sphere));
  EXPECT_TRUE(Refuses([&] { potential.Solve(std::vector<int>(sphere.points.size(), 0)); },
    { "add up to 0", "4χ = 8" }));
}
}
}
