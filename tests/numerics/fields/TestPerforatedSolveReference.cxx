// The perforated solve compared with numbers that do not come from this library: the independent
// prototype of docs/method.md §9, and closed forms on annuli.
#include "DrillHoles.h"
#include "PerforatedSolve.h"
#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
SolvedField SolveOnDisk(const Configuration& holes)
{
  DrillOptions options;
  options.meshSize = 0.05;
  return SolvePerforated(ShareTopology(DrillHoles(Builtin("disk", 0.05), holes, options)));
}

Configuration Joined(Configuration first, const Configuration& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

TEST(PerforatedSolveReference, FourHolesOnTheDisk)
{
  const SolvedField field = SolveOnDisk(OnCircle(4, 0.6, 0.25 * Pi, 1, 0.1));
  EXPECT_TRUE(field.converged);
  EXPECT_NEAR(field.energy, 20.71, 0.02 * 20.71);
  EXPECT_LE(field.iterations, 13);
  EXPECT_LT(field.residual, 1e-8);
  EXPECT_EQ(field.unwantedSingularities, 0);
  ASSERT_EQ(field.holes.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(field.holes[i].degree, 1);
    EXPECT_NEAR(field.multipliers[i], -0.41, 0.02);
    EXPECT_GT(field.holes[i].minimumNorm, 0.80);
    EXPECT_LT(field.holes[i].maximumNorm, 1.22);
  }
}

TEST(PerforatedSolveReference, OtherConfigurationsOnTheDisk)
{
  const auto expectEnergy = [](const Configuration& holes, double energy)
  {
    const SolvedField field = SolveOnDisk(holes);
    EXPECT_TRUE(field.converged);
    EXPECT_NEAR(field.energy, energy, 0.02 * energy);
    for (std::size_t i = 0; i < holes.size(); ++i)
    {
      EXPECT_EQ(field.holes[i].degree, holes[i].quarterIndex);
    }
  };
  expectEnergy(Joined(OnCircle(5, 0.6, 0.0, 1, 0.05), { { { 0.0, 0.0 }, -1, 0.05 } }), 28.05);
  expectEnergy(Joined(OnCircle(6, 0.7, 0.0, 1, 0.05),
                 { { { 0.2, 0.0 }, -1, 0.05 }, { { -0.2, 0.0 }, -1, 0.05 } }),
    32.04);
  expectEnergy(OnCircle(4, 0.6, 0.25 * Pi, 1, 0.01), 24.35);
}

/// One hole of radius ρ in the centre, k = 4: u = f(r) e^{4iθ} with f = a r⁴ + b r⁻⁴, f = 1 on both
/// circles, has the energy 8π (1 − q)/(1 + q), q = ρ⁴. Every other Fourier mode increases it, so
/// this is the minimum.
TEST(PerforatedSolveReference, CentralHoleConvergesAtSecondOrder)
{
  constexpr double Radius = 0.5;
  const double q = std::pow(Radius, 4.0);
  const double exact = 8.0 * Pi * (1.0 - q) / (1.0 + q);
  std::vector<double> sizes;
  std::vector<double> errors;
  for (const int sides : { 32, 64, 128 })
  {
    DrillOptions options;
    options.meshSize = 2.0 * Pi * Radius / sides;
    options.minimumHoleEdges = sides;
    const TriangleMesh mesh =
      DrillHoles(Builtin("disk", options.meshSize), { { { 0.0, 0.0 }, 4, Radius } }, options);
    const SolvedField field = SolvePerforated(ShareTopology(mesh));
    ASSERT_TRUE(field.converged);
    ASSERT_EQ(field.holes.size(), 1u);
    EXPECT_EQ(field.holes[0].degree, 4);
    sizes.push_back(options.meshSize);
    errors.push_back(std::abs(field.energy - exact));
    if (sides == 128)
    {
      EXPECT_NEAR(field.energy, exact, 0.01 * exact);
      // λ = −½ (1 − q)/(1 + q) in the scaling where C tends to 2π k |f|².
      EXPECT_NEAR(field.multipliers[0], -0.5 * (1.0 - q) / (1.0 + q), 0.01);
      EXPECT_NEAR(field.holes[0].minimumNorm, 1.0, 0.01);
      EXPECT_NEAR(field.holes[0].maximumNorm, 1.0, 0.01);
    }
  }
  EXPECT_GE(ConvergenceRate(sizes, errors), 1.7);
}

/// A ring without holes: the harmonic field is f(r) e^{4iθ} with f = (r⁴ + r₁⁴ r⁻⁴)/(1 + r₁⁴), of
/// energy 8π (1 − r₁⁴)/(1 + r₁⁴).
TEST(PerforatedSolveReference, RingWithoutHolesConvergesAtSecondOrder)
{
  const double q = std::pow(0.4, 4.0);
  const double exact = 8.0 * Pi * (1.0 - q) / (1.0 + q);
  std::vector<double> sizes;
  std::vector<double> errors;
  for (const double size : { 0.08, 0.04, 0.02 })
  {
    DrillOptions options;
    options.meshSize = size;
    const SolvedField field =
      SolvePerforated(ShareTopology(DrillHoles(Builtin("ring", size), {}, options)));
    sizes.push_back(size);
    errors.push_back(std::abs(field.energy - exact));
  }
  EXPECT_LT(errors.back(), 0.01 * exact);
  EXPECT_GE(ConvergenceRate(sizes, errors), 1.7);
}

TEST(PerforatedSolveReference, RingWithFourPairs)
{
  // The field has the eightfold symmetry: all positive holes are equivalent, and all negative ones.
  DrillOptions options;
  options.meshSize = 0.04;
  const Configuration holes =
    Joined(OnCircle(4, 0.7, 0.0, 1, 0.05), OnCircle(4, 0.7, 0.25 * Pi, -1, 0.05));
  const SolvedField field =
    SolvePerforated(ShareTopology(DrillHoles(Builtin("ring", 0.04), holes, options)));
  ASSERT_TRUE(field.converged);
  EXPECT_EQ(field.count.requiredInteriorQuarters, 0);
  for (std::size_t i = 0; i < holes.size(); ++i)
  {
    EXPECT_EQ(field.holes[i].degree, holes[i].quarterIndex);
    EXPECT_NEAR(field.multipliers[i], field.multipliers[i < 4 ? 0 : 4], 0.01);
  }
  // The holes and their degrees increase the energy above that of the field without them.
  const double q = std::pow(0.4, 4.0);
  EXPECT_GT(field.energy, 8.0 * Pi * (1.0 - q) / (1.0 + q));
}
}
}
