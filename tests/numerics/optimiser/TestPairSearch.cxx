// Pairs for uniform sizes: the prediction for a pair is exact on its mesh, and the optimiser adds
// the pairs that improve sizes.

#include "PairSearch.h"

#include "DomainQueries.h"
#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "SingularityOptimizer.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns a channel that becomes twice as wide: no singularity is needed, and sizes differ by a
/// factor of 2.
PlanarDomain Ramp()
{
  return MakePlanarDomain(
    { { { 0.0, 0.0 }, { 6.0, 0.0 }, { 6.0, 2.0 }, { 4.0, 2.0 }, { 2.0, 1.0 }, { 0.0, 1.0 } } });
}

double LargestDefect(const std::vector<double>& defects)
{
  double largest = 0.0;
  for (const double defect : defects)
  {
    largest = std::max(largest, std::abs(defect));
  }
  return largest;
}

TEST(PairSearch, PredictionIsExactOnMesh)
{
  const PlanarDomain domain = MakePlanarDomain({ RegularPolygon(5, 1.0),
    RegularPolygon(4, 0.15, { 0.3, -0.1 }), RegularPolygon(30, 0.15, { -0.3, 0.15 }) });
  DrillOptions drill;
  drill.meshSize = 0.1;
  const PointPotential potential = PointPotentialOn(DrillHoles(domain, {}, drill), {}, -5);
  const Configuration around = { { { 0.55, 0.2 }, -1, 0.0 }, { { 0.05, 0.4 }, -2, 0.0 },
    { { -0.5, -0.2 }, -2, 0.0 } };
  const SizeUniformity uniformity(potential);
  PairSearchOptions options;
  options.clearance = 0.05;
  options.positions = 12;
  options.count = 200;
  const std::vector<SingularityPair> pairs = FindPairs(potential, uniformity, around, options);
  ASSERT_GT(pairs.size(), 20U);
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    const SingularityPair& pair = pairs[i];
    const Configuration extended =
      Join(around, { { pair.positive, 1, 0.0 }, { pair.negative, -1, 0.0 } });
    const PointPotential::Solution solution = potential.Solve(extended);
    const double energy = uniformity.Evaluate(potential, solution).energy;
    EXPECT_NEAR(pair.energy, energy, 1e-10 * energy);
    EXPECT_NEAR(pair.largestDefect, LargestDefect(solution.holonomyDefect), 1e-9);
    double score = energy;
    for (const double defect : solution.holonomyDefect)
    {
      score += 0.25 * defect * defect;
    }
    EXPECT_NEAR(pair.score, score, 1e-9 * score);
    EXPECT_TRUE(i == 0 || pairs[i - 1].score <= pair.score);
    EXPECT_GT(SignedDistance(pair.positive, domain), options.clearance);
    EXPECT_GT(SignedDistance(pair.negative, domain), options.clearance);
  }
}

TEST(PairSearch, BestPairsDiffer)
{
  DrillOptions drill;
  drill.meshSize = 0.2;
  const PointPotential potential = PointPotentialOn(DrillHoles(Ramp(), {}, drill), {}, 0);
  PairSearchOptions options;
  options.clearance = 0.1;
  options.count = 3;
  const std::vector<SingularityPair> pairs =
    FindPairs(potential, SizeUniformity(potential), {}, options);
  ASSERT_EQ(pairs.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      EXPECT_GT(std::max((pairs[i].positive - pairs[j].positive).norm(),
                  (pairs[i].negative - pairs[j].negative).norm()),
        0.2);
    }
  }
  // Rows of quads end where the channel is narrow and begin where it is wide, where sizes would be
  // larger.
  EXPECT_LT(pairs[0].energy,
    0.5 * SizeUniformity(potential).Evaluate(potential, potential.Solve({})).energy);
}

TEST(SingularityOptimizer, PairsMakeSizesOfRampUniform)
{
  OptimizerOptions options;
  options.pairs = 2;
  const OptimizerResult result = OptimizeSingularities(Ramp(), {}, options);
  ASSERT_GE(result.front.size(), 3U);
  // Without singularities, the minimum of W and uniform sizes are the same.
  EXPECT_EQ(result.front[0].singularities, 0);
  EXPECT_NEAR(result.front[1].sizeSpread, result.front[0].sizeSpread, 1e-12);
  EXPECT_EQ(result.front[2].singularities, 2);
  EXPECT_LT(result.front[2].sizeSpread, 0.4 * result.front[1].sizeSpread);
  ASSERT_TRUE(result.sizeSpreads);
  EXPECT_EQ(result.sizeSpreads->after, result.front.back().sizeSpread);
  EXPECT_EQ(static_cast<int>(result.configuration.size()), result.front.back().singularities);
  EXPECT_EQ(TotalQuarters(result.configuration), 0);
  EXPECT_TRUE(result.converged) << result.reason;
}

TEST(SingularityOptimizer, AddsNoPairWithoutImprovement)
{
  OptimizerOptions options;
  options.pairs = 3;
  const OptimizerResult uniform = OptimizeSingularities(LShape(), {}, options);
  EXPECT_TRUE(uniform.configuration.empty());
  EXPECT_EQ(uniform.front.size(), 2U);
}
}
}
