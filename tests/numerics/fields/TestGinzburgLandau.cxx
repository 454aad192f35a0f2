#include "DrillHoles.h"
#include "FieldSingularities.h"
#include "GinzburgLandau.h"
#include "MakePlanarDomain.h"
#include "PlanarDomain.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace crossfield::test
{
namespace
{
TriangleMesh Mesh(const std::string& name, double meshSize)
{
  return DrillMesh(Builtin(name, meshSize), {}, meshSize);
}

GinzburgLandauField Solve(const TriangleMesh& mesh, double epsilon, GinzburgLandauStart start = {})
{
  GinzburgLandauOptions options;
  options.epsilon = epsilon;
  options.start = start;
  return SolveGinzburgLandau(ShareTopology(mesh), options);
}

/// Checks the properties of every converged run.
void ExpectMinimum(const GinzburgLandauField& field)
{
  EXPECT_TRUE(field.converged) << field.iterations << " iterations, residual " << field.residual;
  EXPECT_LT(field.residual, 1e-10);
  EXPECT_EQ(field.energies.size(), static_cast<std::size_t>(field.iterations) + 1);
  for (std::size_t i = 1; i < field.energies.size(); ++i)
  {
    EXPECT_LE(field.energies[i], field.energies[i - 1] * (1.0 + 1e-12)) << "iteration " << i;
  }
  EXPECT_NEAR(field.energy, field.gradientEnergy + field.penaltyEnergy, 1e-12 * field.energy);
  EXPECT_GT(field.gradientEnergy, 0.0);
  EXPECT_GE(field.penaltyEnergy, 0.0);
  // Any maximum principle would be sufficient; a larger overshoot indicates that the mesh is too
  // coarse.
  EXPECT_LT(field.u.cwiseAbs().maxCoeff(), 1.1);
}

/// Number of singularities of quarter index −1 and of +1; any other index is a failure.
struct Count
{
  int negative = 0;
  int positive = 0;
};

Count CountSingularities(const std::vector<FieldSingularity>& singularities)
{
  Count count;
  for (const FieldSingularity& singularity : singularities)
  {
    EXPECT_EQ(std::abs(singularity.quarterIndex), 1);
    EXPECT_EQ(singularity.place, FieldSingularity::Place::Inside);
    (singularity.quarterIndex > 0 ? count.positive : count.negative) += 1;
  }
  return count;
}

TEST(GinzburgLandau, RingKeepsTheHarmonicFieldAndBreaksTheConstantOne)
{
  // docs/method.md §4: r1/r2 = 0.4, ε = 1/100.
  const TriangleMesh mesh = Mesh("ring", 0.04);
  const GinzburgLandauField radial = Solve(mesh, 0.01, GinzburgLandauStart::Harmonic);
  ExpectMinimum(radial);
  EXPECT_NEAR(radial.energy, 45.9, 0.3);
  EXPECT_TRUE(FindFieldSingularities({ ShareTopology(mesh), radial.u }).empty());
  EXPECT_EQ(radial.unwantedSingularities, 0);
  EXPECT_TRUE(radial.count.Consistent());

  const GinzburgLandauField broken = Solve(mesh, 0.01, GinzburgLandauStart::Constant);
  ExpectMinimum(broken);
  EXPECT_NEAR(broken.energy, 99.8, 4.0);
  EXPECT_GT(broken.convexifiedSteps, 0);
  EXPECT_EQ(broken.unwantedSingularities, 8);
  EXPECT_EQ(broken.count.requiredInteriorQuarters, 0);
  EXPECT_EQ(broken.count.givenInteriorQuarters, 0);
  const auto singularities = FindFieldSingularities({ ShareTopology(mesh), broken.u });
  const Count count = CountSingularities(singularities);
  EXPECT_EQ(count.positive, 4);
  EXPECT_EQ(count.negative, 4);
  for (const FieldSingularity& singularity : singularities)
  {
    // The positive ones are near the outer circle, the negative ones near the inner one.
    const double radius = singularity.position.norm();
    EXPECT_EQ(singularity.quarterIndex, radius > 0.65 ? 1 : -1) << radius;
  }
}

TEST(GinzburgLandau, FourSingularitiesOfTheDiskApproachTheBestRadius)
{
  // docs/method.md §5: the minimum of W is at (3/11)^{1/8}.
  const double best = std::pow(3.0 / 11.0, 0.125);
  double previous = 1.0;
  for (const double size : { 0.2, 0.1, 0.05 })
  {
    const TriangleMesh mesh = Mesh("disk", size);
    const GinzburgLandauField field = Solve(mesh, size);
    ExpectMinimum(field);
    const auto singularities = FindFieldSingularities({ ShareTopology(mesh), field.u });
    const Count count = CountSingularities(singularities);
    ASSERT_EQ(count.positive, 4);
    EXPECT_EQ(count.negative, 0);
    EXPECT_EQ(field.unwantedSingularities, 0);
    EXPECT_EQ(field.count.givenInteriorQuarters, 4);
    double mean = 0.0;
    for (const FieldSingularity& singularity : singularities)
    {
      mean += singularity.position.norm() / 4.0;
    }
    EXPECT_LT(std::abs(mean - best), 0.6 * previous) << "epsilon and h " << size;
    previous = std::abs(mean - best);
  }
  EXPECT_LT(previous, 0.003);
}

TEST(GinzburgLandau, SingularitiesOfAFlatEllipseAreOnALine)
{
  constexpr double Size = 0.08;
  Loop ellipse;
  for (const Point& point : RegularPolygon(200))
  {
    ellipse.emplace_back(3.0 * point.x(), 0.6 * point.y());
  }
  const TriangleMesh mesh = DrillMesh(MakePlanarDomain({ ellipse }), {}, Size);
  const GinzburgLandauField field = Solve(mesh, Size);
  ExpectMinimum(field);
  const auto singularities = FindFieldSingularities({ ShareTopology(mesh), field.u });
  EXPECT_EQ(CountSingularities(singularities).positive, 4);
  EXPECT_EQ(singularities.size(), 4u);
  for (const FieldSingularity& singularity : singularities)
  {
    EXPECT_LT(std::abs(singularity.position.y()), 0.25 * Size);
    EXPECT_GT(std::abs(singularity.position.x()), 2.0);
  }
}

TEST(GinzburgLandau, LeavesASymmetricSaddle)
{
  // u = 1 on the boundary and −1 in the middle, with a ring between them in which gradients are
  // cheap. The iteration stays real and converges to a wall u = 0 in that ring, which is the best
  // real field; among complex fields, the middle can turn until the wall disappears.
  const TriangleMesh mesh = Mesh("square", 0.05);
  const EdgeNumbering edges = NumberEdges(mesh);
  const Point middle(0.5, 0.5);
  GinzburgLandauOptions options;
  options.epsilon = 0.05;
  options.start = GinzburgLandauStart::Given;
  options.given = ComplexVector::Ones(edges.Count());
  for (int e = 0; e < edges.Count(); ++e)
  {
    options.given[e] = (Midpoint(mesh, edges, e) - middle).norm() < 0.25 ? -1.0 : 1.0;
  }
  options.pinning.gradientWeight =
    Eigen::VectorXd::Ones(static_cast<Eigen::Index>(mesh.triangles.size()));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& [a, b, c] = mesh.triangles[t];
    const Point centre = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0;
    const double distance = (centre - middle).norm();
    if (distance > 0.2 && distance < 0.35)
    {
      options.pinning.gradientWeight[static_cast<Eigen::Index>(t)] = 0.1;
    }
  }
  const GinzburgLandauField field = SolveGinzburgLandau(ShareTopology(mesh), options);
  EXPECT_TRUE(field.converged);
  EXPECT_GT(field.saddlesLeft, 0);
  EXPECT_NEAR(field.energy, 0.0, 1e-10);
  for (std::size_t i = 1; i < field.energies.size(); ++i)
  {
    EXPECT_LE(field.energies[i], field.energies[i - 1] * (1.0 + 1e-12)) << "iteration " << i;
  }
}

TEST(GinzburgLandau, KeepsAGivenSolution)
{
  const TriangleMesh mesh = Mesh("disk", 0.14);
  const GinzburgLandauField first = Solve(mesh, 0.14);
  GinzburgLandauOptions options;
  options.epsilon = 0.14;
  options.start = GinzburgLandauStart::Given;
  options.given = first.u;
  const GinzburgLandauField again = SolveGinzburgLandau(ShareTopology(mesh), options);
  ExpectMinimum(again);
  EXPECT_EQ(again.iterations, 0);
  EXPECT_EQ(again.u, first.u);
}

TEST(GinzburgLandau, KeepsTheConstantCrossOfASquare)
{
  const GinzburgLandauField field = Solve(Mesh("square", 0.1), 0.1);
  EXPECT_TRUE(field.converged);
  EXPECT_NEAR(field.energy, 0.0, 1e-12);
  EXPECT_EQ(field.unwantedSingularities, 0);
}

TEST(GinzburgLandau, HandlesASingleTriangle)
{
  TriangleMesh mesh;
  mesh.points = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.3, 0.8 } };
  mesh.triangles = { { 0, 1, 2 } };
  for (const int from : { 0, 1, 2 })
  {
    mesh.boundary.push_back({ { from, (from + 1) % 3 }, BoundaryKind::Outer });
  }
  const GinzburgLandauField field = Solve(mesh, 0.1);
  EXPECT_TRUE(field.converged);
  EXPECT_EQ(field.iterations, 0);
  EXPECT_EQ(field.energies.size(), 1u);
  EXPECT_GT(field.energy, 0.0);
}

TEST(GinzburgLandau, PinningAttractsSingularities)
{
  // Four disks in which the target norm is small, or the gradient has a small weight, at radius
  // 0.5, where the singularities of the unmodified functional would not be.
  const TriangleMesh mesh = Mesh("disk", 0.07);
  const Configuration pinned = OnCircle(4, 0.5, 0.3, 1, 0.15);
  Eigen::VectorXd small = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(mesh.triangles.size()));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& [a, b, c] = mesh.triangles[t];
    const Point centre = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0;
    for (const Singularity& place : pinned)
    {
      if ((centre - place.position).norm() < place.radius)
      {
        small[static_cast<Eigen::Index>(t)] = 0.05;
      }
    }
  }
  for (const bool weight : { false, true })
  {
    GinzburgLandauOptions options;
    options.epsilon = 0.05;
    (weight ? options.pinning.gradientWeight : options.pinning.norm) = small;
    const GinzburgLandauField field = SolveGinzburgLandau(ShareTopology(mesh), options);
    ExpectMinimum(field);
    const auto found = FindFieldSingularities({ ShareTopology(mesh), field.u });
    EXPECT_EQ(CountSingularities(found).positive, 4);
    for (const Singularity& place : pinned)
    {
      EXPECT_TRUE(std::any_of(found.begin(), found.end(),
        [&place](const FieldSingularity& singularity)
        { return (singularity.position - place.position).norm() < place.radius; }))
        << (weight ? "weight " : "norm ") << place.position.transpose();
    }
  }
}

TEST(GinzburgLandau, EpsilonIsALengthWithTheMeanEdgeLengthAsDefault)
{
  const TriangleMesh mesh = Mesh("disk", 0.2);
  const GinzburgLandauField field = SolveGinzburgLandau(ShareTopology(mesh));
  EXPECT_GT(field.epsilon, 0.1);
  EXPECT_LT(field.epsilon, 0.25);
  Similarity scaling;
  scaling.scale = 1e-5;
  const GinzburgLandauField scaled = SolveGinzburgLandau(ShareTopology(scaling(mesh)));
  EXPECT_NEAR(scaled.epsilon, 1e-5 * field.epsilon, 1e-12 * field.epsilon);
  EXPECT_NEAR(scaled.energy, field.energy, 1e-6 * field.energy);
}

TEST(GinzburgLandau, EpsilonIgnoresAFineBoundary)
{
  // Nearly all edges are along the circle: the mean of their lengths is 0.01.
  DrillOptions options;
  options.meshSize = 0.1;
  const SharedPlanarTopology topology =
    ShareTopology(DrillHoles({ { RegularPolygon(2000) } }, {}, options));
  const double epsilon = ResolveEpsilon({}, *topology);
  EXPECT_GT(epsilon, 0.06);
  EXPECT_LT(epsilon, 0.1);
}

TEST(GinzburgLandau, RotatingTheDomainRotatesTheCrosses)
{
  const TriangleMesh mesh = Mesh("ring", 0.1);
  Similarity rotation;
  rotation.angle = 0.37;
  const GinzburgLandauField field = Solve(mesh, 0.1);
  const GinzburgLandauField rotated = Solve(rotation(mesh), 0.1);
  const Complex turn = std::polar(1.0, 4.0 * rotation.angle);
  EXPECT_LT((rotated.u - turn * field.u).norm(), 1e-7 * field.u.norm());
}

TEST(GinzburgLandau, ReportsNonConvergence)
{
  GinzburgLandauOptions options;
  options.epsilon = 0.1;
  options.maximumIterations = 2;
  const GinzburgLandauField field = SolveGinzburgLandau(ShareTopology(Mesh("disk", 0.1)), options);
  EXPECT_FALSE(field.converged);
  EXPECT_EQ(field.iterations, 2);
  EXPECT_GT(field.residual, 1e-10);
  int calls = 0;
  EXPECT_THROW(SolveGinzburgLandau(ShareTopology(Mesh("disk", 0.1)), {},
                 Progress([&calls](double) { return ++calls < 5; })),
    Aborted);
  EXPECT_EQ(calls, 5);
}

TEST(GinzburgLandau, RejectsInvalidOptions)
{
  const TriangleMesh drilled = DrillHoles(Builtin("disk"), OnCircle(4, 0.6, 0.0, 1, 0.1));
  EXPECT_TRUE(Refuses(
    [&] { SolveGinzburgLandau(ShareTopology(drilled)); }, { "has holes", "without holes" }));
  const TriangleMesh mesh = Mesh("disk", 0.2);
  GinzburgLandauOptions options;
  options.start = GinzburgLandauStart::Given;
  options.given = ComplexVector::Ones(3);
  EXPECT_TRUE(Refuses(
    [&] { SolveGinzburgLandau(ShareTopology(mesh), options); }, { "start from", "3 values" }));
  options = {};
  options.epsilon = -0.1;
  EXPECT_TRUE(
    Refuses([&] { SolveGinzburgLandau(ShareTopology(mesh), options); }, { "epsilon", "positive" }));
}
}
}
