#include "CoarseQuads.h"
#include "FreePoints.h"
#include "Layouts.h"
#include "MeshBoundary.h"
#include "MeshForPoints.h"
#include "QuadEnergy.h"
#include "QuadMesher.h"
#include "SeamlessMapSolve.h"
#include "Support.h"

#include <cmath>
#include <random>

namespace crossfield::test
{
namespace
{
SeamlessMap MapOfSix()
{
  const Configuration configuration =
    Join(OnCircle(6, 0.7, 0.1, 1, 0.0), { { { 0.2, 0.0 }, -1 }, { { -0.2, 0.0 }, -1 } });
  return SolveSeamlessMap(
    ShareTopology(MeshThroughPoints(DiskOfEdges(0.04), configuration, 0.04)), configuration);
}

QuadResult QuadsOf(const SeamlessMap& map, int count, Sizing sizing = Sizing::Conformal)
{
  QuadOptions options;
  options.quadCount = count;
  options.sizes.sizing = sizing;
  return MakeQuads(LayoutOf(map), options);
}

Eigen::VectorXd RandomVector(Eigen::Index size, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return Eigen::VectorXd::NullaryExpr(size, [&] { return uniform(random); });
}

TEST(QuadEnergy, GradientMatchesFiniteDifferences)
{
  const SeamlessMap map = MapOfSix();
  const QuadResult result = QuadsOf(map, 300);
  const MeshBoundary curves(*RequirePlanar(map.topology));
  std::vector<double> weights(result.mesh.quads.size());
  for (std::size_t q = 0; q < weights.size(); ++q)
  {
    weights[q] = 1.0 + static_cast<double>(q % 3);
  }
  for (const double epsilon : { 0.0, 0.5 })
  {
    QuadEnergy energy(result.mesh, curves, AllButFixed(result.mesh), 0.3, weights);
    const Eigen::VectorXd at = energy.Unknowns();
    energy.Tilt(RandomVector(at.size(), 1), at);
    const Eigen::VectorXd direction = energy.Masked(RandomVector(at.size(), 2));
    Eigen::VectorXd gradient;
    energy.Value(at, epsilon, &gradient);
    // Far below the size of quads and of boundary edges.
    const double step = 1e-7;
    const double difference = (energy.Value(at + step * direction, epsilon, nullptr) -
                                energy.Value(at - step * direction, epsilon, nullptr)) /
      (2.0 * step);
    EXPECT_NEAR(gradient.dot(direction), difference, 1e-5 * gradient.norm() * direction.norm())
      << epsilon;
    EXPECT_EQ(energy.Masked(gradient), gradient);
  }
}

TEST(QuadEnergy, IsIdealForTargetRectangles)
{
  const SeamlessMap map = MapOfSix();
  QuadMesh mesh = QuadsOf(map, 300).mesh;
  const MeshBoundary curves(*RequirePlanar(map.topology));
  const std::vector<double> weights(mesh.quads.size(), 1.0);
  // Distorted quads have a higher energy.
  QuadEnergy energy(mesh, curves, AllButFixed(mesh), 0.2, weights);
  EXPECT_GT(energy.Value(energy.Unknowns(), 0.0, nullptr), energy.IdealValue());
  // A single target rectangle has exactly the ideal value.
  QuadMesh square;
  square.points.resize(4);
  square.points[1].MoveTo({ 0.0, 2.0 });
  square.points[2].MoveTo({ -3.0, 2.0 });
  square.points[3].MoveTo({ -3.0, 0.0 });
  square.quads = { { 0, 1, 2, 3 } };
  square.targetLengths = { { 2.0, 3.0 } };
  QuadEnergy one(square, curves, AllButFixed(square), 0.2, { 1.0 });
  EXPECT_NEAR(one.Value(one.Unknowns(), 0.0, nullptr), 8.0, 1e-14);
  EXPECT_NEAR(one.MinimumDeterminant(one.Unknowns()), 1.0, 1e-15);
}

TEST(CoarseQuads, KeepsTheSameLinesFromBothEnds)
{
  for (int count = 1; count < 200; ++count)
  {
    const std::vector<int> kept = KeptLines(count);
    EXPECT_EQ(kept.front(), 0);
    EXPECT_EQ(kept.back(), count);
    for (std::size_t k = 0; k < kept.size(); ++k)
    {
      EXPECT_EQ(kept[k], count - kept[kept.size() - 1 - k]) << count;
      EXPECT_TRUE(k == 0 || (kept[k] > kept[k - 1] && kept[k] <= kept[k - 1] + 3)) << count;
    }
    EXPECT_TRUE(count < 8 || 2 * static_cast<int>(kept.size()) <= count + 3) << count;
  }
}

TEST(CoarseQuads, RestrictionIsTheTransposeOfProlongation)
{
  const SeamlessMap map = MapOfSix();
  const QuadResult result = QuadsOf(map, 3000);
  const MeshBoundary curves(*RequirePlanar(map.topology));
  const std::vector<QuadLattice> lattices = LatticesOf(result.mesh, result.blocks);
  const CoarseQuads coarse(result.mesh, lattices);
  EXPECT_TRUE(coarse.IsSmaller());
  EXPECT_EQ(coarse.mesh.EulerCharacteristic(), result.mesh.EulerCharacteristic());
  double sum = 0.0;
  for (const double weight : coarse.weights)
  {
    sum += weight;
  }
  EXPECT_EQ(sum, static_cast<double>(result.mesh.quads.size()));
  const auto fineSize = 2 * static_cast<Eigen::Index>(result.mesh.points.size());
  const auto coarseSize = 2 * static_cast<Eigen::Index>(coarse.mesh.points.size());
  Eigen::VectorXd moves = RandomVector(coarseSize, 3);
  Eigen::VectorXd gradient = RandomVector(fineSize, 4);
  const auto clearUnused = [](const QuadMesh& mesh, Eigen::VectorXd& vector)
  {
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      const auto second = 2 * static_cast<Eigen::Index>(p) + 1;
      vector[second] = mesh.points[p].curve.loop < 0 ? vector[second] : 0.0;
    }
  };
  clearUnused(coarse.mesh, moves);
  clearUnused(result.mesh, gradient);
  const TangentFrames fine(result.mesh, nullptr);
  const TangentFrames frames(coarse.mesh, nullptr);
  EXPECT_NEAR(coarse.Prolong(curves, fine, frames, moves).dot(gradient),
    moves.dot(coarse.Restrict(curves, fine, frames, gradient)),
    1e-12 * moves.norm() * gradient.norm());
  // If all points move along the boundary by the same length, so do the points between them.
  Eigen::VectorXd along = Eigen::VectorXd::Zero(coarseSize);
  for (std::size_t p = 0; p < coarse.mesh.points.size(); ++p)
  {
    along[2 * static_cast<Eigen::Index>(p)] = coarse.mesh.points[p].curve.loop < 0 ? 0.0 : 0.01;
  }
  const Eigen::VectorXd prolonged = coarse.Prolong(curves, fine, frames, along);
  for (std::size_t p = 0; p < result.mesh.points.size(); ++p)
  {
    if (result.mesh.points[p].curve.loop >= 0)
    {
      EXPECT_NEAR(prolonged[2 * static_cast<Eigen::Index>(p)], 0.01, 1e-15);
    }
  }
}

TEST(QuadMesh, FindsTheTwinOfEverySide)
{
  const SeamlessMap map = MapOfSix();
  const QuadMesh mesh = QuadsOf(map, 1000).mesh;
  const std::vector<int> twins = mesh.Twins();
  const auto pointAt = [&mesh](int side)
  { return mesh.quads[static_cast<std::size_t>(side / 4)][static_cast<std::size_t>(side % 4)]; };
  const auto endOf = [&](int side) { return pointAt(side / 4 * 4 + (side + 1) % 4); };
  std::size_t onBoundary = 0;
  for (int side = 0; side < static_cast<int>(twins.size()); ++side)
  {
    const int twin = twins[static_cast<std::size_t>(side)];
    onBoundary += twin < 0 ? 1 : 0;
    if (twin >= 0)
    {
      EXPECT_EQ(twins[static_cast<std::size_t>(twin)], side);
      EXPECT_EQ(pointAt(side), endOf(twin));
      EXPECT_EQ(endOf(side), pointAt(twin));
    }
  }
  EXPECT_EQ(onBoundary, mesh.boundary.size());
}

/// With coarser meshes the number of steps does not grow with the number of quads, and quality does
/// not suffer.
TEST(QuadSmoothing, TakesFewStepsForManyQuads)
{
  const SeamlessMap map = MapOfSix();
  const QuadResult few = QuadsOf(map, 4500);
  for (const int count : { 12000, 48000 })
  {
    const QuadResult many = QuadsOf(map, count);
    EXPECT_LE(many.smoothing.iterations, 10);
    EXPECT_GT(many.quality.jacobian.min, few.quality.jacobian.min - 0.01) << count;
    EXPECT_GT(many.quality.jacobian.mean, few.quality.jacobian.mean) << count;
    EXPECT_EQ(many.quality.inverted, 0);
  }
}

TEST(QuadSmoothing, KeepsUniformSizesUniformForManyQuads)
{
  const SeamlessMap map = MapOfSix();
  const QuadQuality few = QuadsOf(map, 2000, Sizing::Uniform).quality;
  // With these numbers separatrices that nearly meet are one quad apart: quads of the map are
  // sheared there.
  for (const int count : { 16000, 20000, 24000 })
  {
    SCOPED_TRACE(count);
    const QuadResult many = QuadsOf(map, count, Sizing::Uniform);
    EXPECT_LE(many.smoothing.iterations, 10);
    EXPECT_LT(many.quality.variation, few.variation + 0.01);
    EXPECT_GE(many.quality.jacobian.min, few.jacobian.min - 0.1);
  }
}
}
}
