// Derivatives of angles and of the directions of loops, against finite differences and identities.

#include "MetricDerivatives.h"

#include "LoopAlignment.h"
#include "MetricCases.h"
#include "Support.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
constexpr double Step = 1e-6;

/// Returns a metric with a different cone at every vertex.
ConeMetric PerturbedMetric(Random& random)
{
  ConeMetric metric = PlaneMetric(*SquareFrame(0.3, 0.3));
  Perturb(random, 0.1, metric);
  return metric;
}

/// Returns the metric moved along a change of the logarithms of lengths.
ConeMetric Moved(ConeMetric metric, const Eigen::VectorXd& change)
{
  std::vector<double> logs = metric.LogLengths();
  for (std::size_t e = 0; e < logs.size(); ++e)
  {
    logs[e] += change[static_cast<Eigen::Index>(e)];
  }
  metric.SetLogLengths(std::move(logs));
  return metric;
}

TEST(MetricDerivatives, AnglesMatchFiniteDifferences)
{
  Random random(51);
  const ConeMetric metric = PerturbedMetric(random);
  const MetricDerivatives derivatives(metric);
  const Eigen::VectorXd change = RandomNumbers(random, metric.LogLengths().size());
  const ConeMetric ahead = Moved(metric, Step * change);
  const ConeMetric behind = Moved(metric, -Step * change);
  for (int t = 0; t < static_cast<int>(metric.Triangles().size()); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      double derivative = 0.0;
      for (const auto& [edge, value] : derivatives.AngleDerivative(t, i))
      {
        derivative += value * change[edge];
      }
      const auto corner = static_cast<std::size_t>(i);
      EXPECT_NEAR(
        (ahead.AnglesOf(t).angle[corner] - behind.AnglesOf(t).angle[corner]) / (2.0 * Step),
        derivative, 1e-7 * (1.0 + std::abs(derivative)));
    }
  }
  const Eigen::VectorXd differences =
    (MetricDerivatives(behind).AngleDefects() - MetricDerivatives(ahead).AngleDefects()) /
    (2.0 * Step);
  EXPECT_LT((derivatives.AngleSumChanges(change) - differences).lpNorm<Eigen::Infinity>(), 1e-6);
}

TEST(MetricDerivatives, ConformalChangesGiveMinusTheLaplacian)
{
  Random random(52);
  const ConeMetric metric = PerturbedMetric(random);
  const MetricDerivatives derivatives(metric);
  const Eigen::SparseMatrix<double> laplacian = derivatives.Laplacian();
  for (int i = 0; i < 5; ++i)
  {
    const Eigen::VectorXd u = RandomNumbers(random, metric.Points().size());
    const Eigen::VectorXd expected = -(laplacian * u);
    EXPECT_LT((derivatives.AngleSumChanges(ConformalChanges(metric, u)) - expected)
                .lpNorm<Eigen::Infinity>(),
      1e-13 * laplacian.norm());
    EXPECT_GT(u.dot(laplacian * u), 0.0);
  }
  // Scaling changes no angle.
  const Eigen::VectorXd ones =
    Eigen::VectorXd::Ones(static_cast<Eigen::Index>(metric.LogLengths().size()));
  EXPECT_LT(derivatives.AngleSumChanges(ones).lpNorm<Eigen::Infinity>(), 1e-12);
}

TEST(MetricDerivatives, PullbacksAreAdjoint)
{
  Random random(53);
  const ConeMetric metric = PerturbedMetric(random);
  const MetricDerivatives derivatives(metric);
  for (int i = 0; i < 5; ++i)
  {
    const Eigen::VectorXd a = RandomNumbers(random, metric.Points().size());
    const Eigen::VectorXd x = RandomNumbers(random, metric.LogLengths().size());
    EXPECT_NEAR(a.dot(derivatives.AngleSumChanges(x)), derivatives.Pullback(a).dot(x),
      1e-12 * a.norm() * x.norm());
    EXPECT_NEAR(x.dot(ConformalChanges(metric, a)), ConformalPullback(metric, x).dot(a),
      1e-13 * a.norm() * x.norm());
  }
}

TEST(LoopAlignment, IsTheAngleByWhichTheHoleIsTurned)
{
  for (const double turn : { -0.7, -0.2, 0.0, 0.3, 0.6 })
  {
    ConeMetric metric = PlaneMetric(*SquareFrame(turn, 0.3));
    const auto defect = [&metric]
    { return MeasureAlignment(MetricDerivatives(metric)).defects[0]; };
    ASSERT_EQ(metric.LoopStarts().size(), 2U);
    EXPECT_NEAR(defect(), turn, 1e-12);
    // All angles are right, so paths and triangulations do not matter.
    EXPECT_LT(MetricDerivatives(metric).AngleDefects().lpNorm<Eigen::Infinity>(), 1e-12);
    Random random(54);
    EXPECT_GT(ChangeAtRandom(random, 200, metric), 40);
    EXPECT_NEAR(defect(), turn, 1e-9);
    // A direction that is turned by a quarter is missed by a quarter less.
    metric.TurnLoop(1, 1);
    EXPECT_NEAR(defect(), WrapAngle(turn - 0.5 * Pi), 1e-9);
    metric.TurnLoop(1, 2);
    EXPECT_NEAR(defect(), WrapAngle(turn - 1.5 * Pi), 1e-9);
    metric.TurnLoop(1, -3);
    EXPECT_NEAR(defect(), turn, 1e-9);
  }
}

TEST(LoopAlignment, RowsMatchFiniteDifferences)
{
  Random random(55);
  const ConeMetric metric = PerturbedMetric(random);
  const LoopAlignment alignment = MeasureAlignment(MetricDerivatives(metric));
  for (int i = 0; i < 5; ++i)
  {
    const Eigen::VectorXd change = RandomNumbers(random, metric.LogLengths().size());
    const auto defectAt = [&](double step)
    { return MeasureAlignment(MetricDerivatives(Moved(metric, step * change))).defects[0]; };
    const double derivative = alignment.Changes(change)[0];
    EXPECT_GT(std::abs(derivative), 1e-3);
    EXPECT_NEAR((defectAt(Step) - defectAt(-Step)) / (2.0 * Step), derivative, 1e-6);
  }
}

/// Returns a metric of a box with holes without jumps, on which derivatives do not depend.
ConeMetric MetricOfHoles(int genus, Random& random)
{
  const SurfaceTopology topology(BoxWithHoles(genus, 1));
  ConeMetric metric(topology, std::vector<std::array<int, 3>>(topology.mesh.triangles.size()), {});
  Perturb(random, 0.1, metric);
  return metric;
}

TEST(LoopAlignment, HasTwoPathsForEachHandle)
{
  Random random(56);
  for (const int genus : { 1, 2 })
  {
    const ConeMetric metric = MetricOfHoles(genus, random);
    const LoopAlignment alignment = MeasureAlignment(MetricDerivatives(metric));
    ASSERT_EQ(alignment.defects.size(), 2 * genus);
    EXPECT_EQ(alignment.innerLoops, 0);
    EXPECT_TRUE(alignment.HasHandles());
    for (int i = 0; i < 5; ++i)
    {
      const Eigen::VectorXd change = RandomNumbers(random, metric.LogLengths().size());
      const auto defectsAt = [&](double step)
      { return MeasureAlignment(MetricDerivatives(Moved(metric, step * change))).defects; };
      const Eigen::VectorXd derivatives = alignment.Changes(change);
      EXPECT_GT(derivatives.lpNorm<Eigen::Infinity>(), 1e-3);
      EXPECT_LT(((defectsAt(Step) - defectsAt(-Step)) / (2.0 * Step) - derivatives)
                  .lpNorm<Eigen::Infinity>(),
        1e-6);
    }
  }
}
}
}
