// The flat cone metric of crosses, laid out: exact lengths on the disk where the plain map is right
// as well, and invariance under similarities where it is not.

#include "FlatMetric.h"

#include "InjectivityCheck.h"
#include "LoopAlignment.h"
#include "MeshForPoints.h"
#include "MetricCases.h"
#include "MetricRemeshing.h"
#include "PhaseSteps.h"
#include "RandomConfigurations.h"
#include "SeamlessMapChecks.h"
#include "TMeshChecks.h"
#include "TargetSolve.h"
#include "TriangleArea.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns the frames of singularities inside a domain.
TriangleFrames FramesOf(const SharedPlanarTopology& topology, const Configuration& configuration)
{
  const PointPotential potential =
    PointPotentialOn(topology->mesh, {}, TotalQuarters(configuration));
  TriangleFrames frames =
    FrameTriangles(*topology, StepsOf(potential, potential.Solve(configuration)));
  frames.h.array() -= frames.h.mean();
  return frames;
}

std::vector<double> SortedArcs(const TMesh& mesh)
{
  std::vector<double> arcs;
  for (const TPatch& face : mesh.patches)
  {
    for (const int side : { 0, 1 })
    {
      arcs.push_back(mesh.SideLength(face, side));
    }
  }
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

/// Returns the side of the square (docs/method.md §13.4) that four +1 on the disk make.
double SideOfSquare(const SeamlessMap& map)
{
  const TMesh mesh = MakeTMesh(map, TraceSeparatrices(map));
  ExpectSound(mesh, 1);
  double widest = 0.0;
  for (const TPatch& face : mesh.patches)
  {
    widest = std::max(widest, std::min(mesh.SideLength(face, 0), mesh.SideLength(face, 1)));
  }
  return widest;
}

/// Errors of that side in the nearest map and in the layout of the flat metric.
struct Errors
{
  double nearest = 0.0;
  double flat = 0.0;
};

/// Returns the errors, after checking the flat metric and its layout.
Errors ErrorsOnTheDisk(double radius, double exact, double firstAngle, double size)
{
  const Configuration four = OnCircle(4, radius, firstAngle, 1, 0.0);
  const SharedPlanarTopology topology =
    ShareTopology(MeshThroughPoints(DiskOfEdges(size), four, size));
  const SeamlessMap nearest = SolveSeamlessMap(topology, four);
  FlattenedTargets flat = FlattenFrames(*topology, FramesOf(topology, four), nearest.cones);
  EXPECT_TRUE(flat.report.converged);
  EXPECT_LE(flat.report.iterations, 6);
  EXPECT_LT(flat.report.angleDefect, 1e-9);
  EXPECT_EQ(flat.report.alignmentDefect, 0.0);
  EXPECT_EQ(flat.report.predictedStrain, 0.0);
  const SeamlessMap map = SolveTargets(std::move(flat.targets), nearest.cones);
  EXPECT_EQ(CountReversed(map), 0);
  EXPECT_LT(AngleSumDefect(map), 1e-9);
  EXPECT_EQ(SeamDefect(map), 0.0);
  EXPECT_FALSE(FindFault(map));
  return { SideOfSquare(nearest) - exact, SideOfSquare(map) - exact };
}

/// The errors differ from mesh to mesh, so they are root mean squares over directions of the
/// configuration.
TEST(FlattenFrames, ConvergesToExactLengthsOnTheDisk)
{
  constexpr int Directions = 6;
  for (const auto& [radius, exact] : { std::pair(0.85, 1.358896), std::pair(0.6, 1.094482) })
  {
    std::vector<double> sizes;
    std::vector<double> nearest;
    std::vector<double> flat;
    for (const double size : { 0.2, 0.08, 0.03, 0.015 })
    {
      Errors squares;
      for (int i = 0; i < Directions; ++i)
      {
        const Errors errors = ErrorsOnTheDisk(radius, exact, 0.3 + 0.17 * i, size);
        squares.nearest += errors.nearest * errors.nearest;
        squares.flat += errors.flat * errors.flat;
      }
      sizes.push_back(size);
      nearest.push_back(std::sqrt(squares.nearest / Directions));
      flat.push_back(std::sqrt(squares.flat / Directions));
      EXPECT_LT(flat.back(), 2.0 * nearest.back());
    }
    EXPECT_GT(ConvergenceRate(sizes, flat), 1.7);
    EXPECT_LT(flat.back(), 4e-5);
  }
}

/// From the metric of the plane, without H: the flat metric in its conformal class.
TEST(FlattenMetric, FindsTheConformalFlatMetric)
{
  const Configuration four = OnCircle(4, 0.6, Pi / 4.0, 1, 0.0);
  const SharedPlanarTopology topology =
    ShareTopology(MeshThroughPoints(DiskOfEdges(0.1), four, 0.1));
  const std::vector<Cone> cones = SolveSeamlessMap(topology, four).cones;
  ConeMetric metric(*topology, FramesOf(topology, four).jump, cones);
  SplitNarrowFans(metric);
  const FlatteningReport report = FlattenMetric(metric, 0.3);
  ASSERT_TRUE(report.converged);
  EXPECT_TRUE(report.loopDefects.empty());
  EXPECT_LT(MetricDerivatives(metric).AngleDefects().lpNorm<Eigen::Infinity>(), 1e-9);
  EXPECT_TRUE(metric.IsValid());
  for (int t = 0; t < static_cast<int>(metric.Triangles().size()); ++t)
  {
    EXPECT_GT(crossfield::TriangleArea(
                metric.Triangulation(), metric.Triangles()[static_cast<std::size_t>(t)].vertices),
      0.0);
    EXPECT_GT(metric.AreaOf(t), 0.0);
  }
}

/// A square hole turned against a square has to be turned back, and by a quarter less where that is
/// nearer.
TEST(FlattenMetric, TurnsAHole)
{
  for (const double turn : { 0.0, 0.1, -0.4, 0.6 })
  {
    ConeMetric metric = PlaneMetric(*SquareFrame(turn, 0.1));
    const FlatteningReport report = FlattenMetric(metric, 0.3);
    ASSERT_TRUE(report.converged) << turn;
    const MetricDerivatives derivatives(metric);
    EXPECT_LT(derivatives.AngleDefects().lpNorm<Eigen::Infinity>(), 1e-9);
    EXPECT_LT(MeasureAlignment(derivatives).defects.lpNorm<Eigen::Infinity>(), 1e-9);
    EXPECT_TRUE(metric.IsValid());
    if (turn == 0.0)
    {
      EXPECT_EQ(report.iterations, 0);
      continue;
    }
    ASSERT_EQ(report.loopDefects.size(), 1U);
    EXPECT_NEAR(report.loopDefects[0], turn, 1e-9);
    EXPECT_GT(report.predictedStrain, 0.0);
    // A quarter turn of the directions keeps them parallel to the sides.
    ConeMetric turned = PlaneMetric(*SquareFrame(turn, 0.1));
    turned.TurnLoop(1, 1);
    const FlatteningReport same = FlattenMetric(turned, 0.3);
    ASSERT_TRUE(same.converged);
    EXPECT_NEAR(same.loopDefects[0], turn, 1e-9);
    EXPECT_EQ(same.iterations, report.iterations);
  }
}

/// Flips and splits depend on angles alone, so a similar mesh gets the same ones.
TEST(FlattenFrames, DoesNotDependOnPlaceSizeAndDirection)
{
  int tested = 0;
  for (std::uint32_t seed = 1000; tested < 3; ++seed)
  {
    SCOPED_TRACE(seed);
    const RandomCase ring = RandomRing(seed);
    const TriangleMesh mesh = MeshThroughPoints(ring.domain, ring.singularities, 0.0);
    const SeamlessMap map = SolveSeamlessMap(ShareTopology(mesh), ring.singularities);
    if (!map.flattening)
    {
      continue;
    }
    ++tested;
    const std::vector<double> arcs = SortedArcs(MakeTMesh(map, TraceSeparatrices(map)));
    for (const Similarity& similarity :
      { Similarity{ 0.7, 1.0, { 0.0, 0.0 } }, Similarity{ 0.0, 1000.0, { 0.0, 0.0 } },
        Similarity{ 0.0, 1.0, { 20.0, -3.0 } }, Similarity{ 2.5, 1e-3, { 0.01, 0.02 } } })
    {
      const Configuration moved = similarity(ring.singularities);
      const SeamlessMap other = SolveSeamlessMap(ShareTopology(similarity(mesh)), moved);
      ASSERT_TRUE(other.flattening);
      EXPECT_EQ(other.flattening->iterations, map.flattening->iterations);
      EXPECT_EQ(other.flattening->flips, map.flattening->flips);
      EXPECT_EQ(other.flattening->splits, map.flattening->splits);
      ASSERT_EQ(other.flattening->loopDefects.size(), 1U);
      EXPECT_NEAR(other.flattening->predictedStrain, map.flattening->predictedStrain, 1e-8);
      EXPECT_NEAR(other.flattening->loopDefects[0], map.flattening->loopDefects[0], 1e-8);
      const std::vector<double> same = SortedArcs(MakeTMesh(other, TraceSeparatrices(other)));
      ASSERT_EQ(same.size(), arcs.size());
      for (std::size_t i = 0; i < arcs.size(); ++i)
      {
        EXPECT_NEAR(same[i] / similarity.scale, arcs[i], 1e-8);
      }
    }
  }
}
}
}
