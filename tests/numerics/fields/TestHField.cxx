#include "HField.h"

#include "Alignment.h"
#include "DrillHoles.h"
#include "ExactFields.h"
#include "Support.h"
#include "UnitNormField.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns the gradients on a triangle of 4H, from its vertices, and of the phase of u, from its
/// midpoints.
std::array<Point, 2> Gradients(const TriangleMesh& mesh, const HField& field, std::size_t t)
{
  const auto& v = mesh.triangles[t];
  const auto& e = field.field.topology->edges.ofTriangle[t];
  const Point a =
    mesh.points[static_cast<std::size_t>(v[1])] - mesh.points[static_cast<std::size_t>(v[0])];
  const Point b =
    mesh.points[static_cast<std::size_t>(v[2])] - mesh.points[static_cast<std::size_t>(v[0])];
  // Gradient of the linear function that increases by da along a and by db along b.
  const auto slope = [&](double da, double db)
  { return Point(Point(da * b.y() - db * a.y(), db * a.x() - da * b.x()) / Cross(a, b)); };
  const auto step = [&](int from, int to)
  { return std::arg(field.field.u[to] / field.field.u[from]); };
  // The midpoints of p0p1, p1p2, p2p0 are b / 2 and −a / 2 apart.
  return { slope(4.0 * (field.h[v[1]] - field.h[v[0]]), 4.0 * (field.h[v[2]] - field.h[v[0]])),
    slope(-2.0 * step(e[1], e[2]), 2.0 * step(e[0], e[1])) };
}

TEST(HField, MatchesTheUnitNormFieldOnDrilledMeshes)
{
  const std::vector<TriangleMesh> meshes = {
    DrillMesh(Builtin("disk", 0.05), OnCircle(4, 0.6, 0.3, 1, 0.1), 0.05),
    DrillMesh(
      Builtin("ring", 0.05), { { { 0.75, 0.05 }, 1, 0.05 }, { { -0.1, 0.65 }, -1, 0.05 } }, 0.05),
    DrillMesh(Builtin("l-shape"), { { { 0.2, 0.3 }, 1, 0.05 }, { { 0.7, 0.2 }, -1, 0.05 } }, 0.04)
  };
  for (const TriangleMesh& mesh : meshes)
  {
    const HField field = SolveHField(ShareTopology(mesh), {});
    const PotentialProblem problem = ProblemOn(mesh);
    const UnitNormField unit = SolveUnitNorm(problem);
    EXPECT_LT((field.field.u - unit.u).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_EQ(field.field.energy, unit.energy);
    EXPECT_EQ(field.field.holonomyDefect, unit.holonomyDefect);
    // H is constant on every hole.
    for (const BoundaryLoop& loop : problem.Topology().loops)
    {
      if (loop.kind == BoundaryKind::Hole)
      {
        double minimum = 1e300;
        double maximum = -1e300;
        for (int vertex : WalkedVertices(mesh, loop))
        {
          minimum = std::min(minimum, field.h[vertex]);
          maximum = std::max(maximum, field.h[vertex]);
        }
        EXPECT_LT(maximum - minimum, 1e-9);
      }
    }
  }
}

TEST(HField, ConjugateEnergiesAgree)
{
  // docs/method.md §2: compares the phase energy from CR values with the potential energy from P1
  // values.
  const TriangleMesh mesh = DrillMesh(Builtin("disk", 0.05), OnCircle(4, 0.6, 0.3, 1, 0.1), 0.05);
  const HField field = SolveHField(ShareTopology(mesh), {});
  double phaseEnergy = 0.0;
  double potentialEnergy = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto [potential, phase] = Gradients(mesh, field, t);
    potentialEnergy += 0.5 * TriangleArea(mesh, t) * potential.squaredNorm();
    phaseEnergy += 0.5 * TriangleArea(mesh, t) * phase.squaredNorm();
  }
  EXPECT_NEAR(phaseEnergy, potentialEnergy, 1e-10 * potentialEnergy);
  EXPECT_NEAR(field.field.energy, potentialEnergy, 1e-10 * potentialEnergy);
}

TEST(HField, IsTheLogarithmOnARing)
{
  const TriangleMesh mesh = DrillMesh(Builtin("ring", 0.03), {}, 0.03);
  const HField field = SolveHField(ShareTopology(mesh), {});
  // Mean of log r over the ring.
  const auto primitive = [](double r) { return r * r * (0.5 * std::log(r) - 0.25); };
  const double mean = 2.0 * (primitive(1.0) - primitive(0.4)) / (1.0 - 0.16);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    EXPECT_NEAR(
      field.h[static_cast<Eigen::Index>(v)], std::log(mesh.points[v].norm()) - mean, 2e-3);
  }
  ASSERT_EQ(field.field.holonomyDefect.size(), 1u);
  EXPECT_NEAR(field.field.holonomyDefect[0], 0.0, 1e-4);
  EXPECT_NEAR(field.periods[0], 0.0, 1e-4);
}

TEST(HField, AppliesGivenIndicesAtCorners)
{
  // At a corner of angle α with index k, H behaves like c log r, c = −(turning − kπ/2)/α.
  const PlanarDomain square = Builtin("square");
  const TriangleMesh mesh = DrillMesh(square, {}, 0.03);
  const Configuration given = { { { 0.0, 0.0 }, 0, 0.0 }, { { 0.7, 0.6 }, 1, 0.0 } };
  const HField field = SolveHField(ShareTopology(mesh), given);
  EXPECT_EQ(field.field.unwantedSingularities, 0);
  int chosen = 0;
  for (const CountedCorner& corner : field.field.count.corners)
  {
    if (corner.position.norm() < 1e-9)
    {
      EXPECT_EQ(corner.quarterIndex, 0);
      chosen += corner.chosen ? 1 : 0;
    }
  }
  EXPECT_EQ(chosen, 1);
  // H + log r tends to a constant at the corner: (π/2)/(π/2) = 1.
  std::vector<double> remainders;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    const double r = mesh.points[v].norm();
    if (r > 1e-9 && r < 0.1)
    {
      remainders.push_back(field.h[static_cast<Eigen::Index>(v)] + std::log(r));
    }
  }
  const auto [minimum, maximum] = std::minmax_element(remainders.begin(), remainders.end());
  EXPECT_GT(remainders.size(), 5u);
  EXPECT_LT(*maximum - *minimum, 0.1);
}

TEST(HField, IsolinesMeetStraightSidesAtRightAnglesAndCrossesAreRotatedGradients)
{
  const Configuration pair = { { { 0.25, 0.3 }, 1, 0.0 }, { { 0.7, 0.22 }, -1, 0.0 } };
  for (const double size : { 0.03, 0.015 })
  {
    const TriangleMesh mesh = DrillMesh(Builtin("l-shape"), {}, size);
    const HField field = SolveHField(ShareTopology(mesh), pair);
    const auto away = [&](const Point& point)
    {
      return (point - pair[0].position).norm() > 0.12 && (point - pair[1].position).norm() > 0.12 &&
        (point - Point(0.5, 0.5)).norm() > 0.12;
    };
    double largestTurn = 0.0;
    double largestFlux = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      const auto [potential, phase] = Gradients(mesh, field, t);
      if (away(mesh.points[static_cast<std::size_t>(mesh.triangles[t][0])]))
      {
        largestTurn = std::max(largestTurn, (phase - Point(-potential.y(), potential.x())).norm());
      }
    }
    for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
    {
      const auto& ends = mesh.boundary[i].vertices;
      const Point from = mesh.points[static_cast<std::size_t>(ends[0])];
      const Point along = (mesh.points[static_cast<std::size_t>(ends[1])] - from).normalized();
      const int edge = field.field.topology->edges.ofBoundary[i];
      const auto triangle = static_cast<std::size_t>(
        field.field.topology->edges.triangles[static_cast<std::size_t>(edge)][0]);
      if (away(from))
      {
        const Point slope = Gradients(mesh, field, triangle)[0];
        largestFlux = std::max(largestFlux, std::abs(Cross(along, slope)));
      }
    }
    // Both converge to zero with the mesh size; the gradients themselves are up to 10.
    EXPECT_LT(largestTurn, 40.0 * size);
    EXPECT_LT(largestFlux, 60.0 * size);
  }
}

TEST(HField, IsInvariantUnderSimilaritiesAndRenumbering)
{
  Random random(7);
  const TriangleMesh mesh = DrillMesh(Builtin("disk", 0.08), {}, 0.08);
  const HField plain = SolveHField(ShareTopology(mesh), FiveInDisk);
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    const Similarity move{ random.Uniform(-Pi, Pi), scale, scale * Point(1.0, -2.0) };
    const HField field = SolveHField(ShareTopology(move(mesh)), move(FiveInDisk));
    EXPECT_LT((field.h - plain.h).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_EQ(field.field.unwantedSingularities, 0);
    // W changes by the logarithm of the scale.
    EXPECT_NEAR(
      field.renormalizedEnergy, plain.renormalizedEnergy + Pi * 8.0 * std::log(scale), 1e-6);
  }
  const HField renumbered = SolveHField(ShareTopology(Renumber(mesh, random)), FiveInDisk);
  EXPECT_NEAR(renumbered.renormalizedEnergy, plain.renormalizedEnergy, 1e-8);
}

TEST(HField, IsScaleInvariantOverManyOrdersOfMagnitude)
{
  struct Case
  {
    const char* name;
    Configuration configuration;
    /// Change of W per unit of the logarithm of the scale.
    double shift;
  };
  // FiveInDisk pairs on a ring: ten logarithms contribute to each value.
  Configuration pairs = OnCircle(5, 0.6, 0.3, 1, 0.0);
  for (const Singularity& singularity : OnCircle(5, 0.8, 0.5, -1, 0.0))
  {
    pairs.push_back(singularity);
  }
  const std::vector<Case> cases = { { "disk", FiveInDisk, Pi * 8.0 },
    { "ring", pairs, Pi * 10.0 } };
  for (const auto& [name, configuration, shift] : cases)
  {
    const TriangleMesh mesh = DrillMesh(Builtin(name, 0.1), {}, 0.1);
    const HField plain = SolveHField(ShareTopology(mesh), configuration);
    for (const double scale : { 1e-59, 1e-40, 1e-20, 1e20, 1e40, 1e59 })
    {
      SCOPED_TRACE(std::string(name) + " times " + std::to_string(std::log10(scale)));
      const Similarity move{ 0.0, scale, Point::Zero() };
      const HField field = SolveHField(ShareTopology(move(mesh)), move(configuration));
      EXPECT_LT((field.h - plain.h).cwiseAbs().maxCoeff(), 1e-9);
      EXPECT_LT((field.field.u - plain.field.u).cwiseAbs().maxCoeff(), 1e-9);
      EXPECT_EQ(field.field.unwantedSingularities, 0);
      EXPECT_NEAR(field.renormalizedEnergy, plain.renormalizedEnergy + shift * std::log(scale),
        1e-9 * std::abs(plain.renormalizedEnergy));
      ASSERT_EQ(field.periods.size(), plain.periods.size());
      for (std::size_t k = 0; k < plain.periods.size(); ++k)
      {
        EXPECT_NEAR(field.field.holonomyDefect[k], plain.field.holonomyDefect[k], 1e-9);
        EXPECT_NEAR(field.periods[k], plain.periods[k], 1e-9);
      }
    }
  }
}

TEST(HField, IsFiniteForSingularitiesAtVerticesAndMidpoints)
{
  const TriangleMesh mesh = DrillMesh(Builtin("disk", 0.1), {}, 0.1);
  const EdgeNumbering edges = NumberEdges(mesh);
  int vertex = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    vertex = mesh.points[v].norm() < mesh.points[static_cast<std::size_t>(vertex)].norm()
      ? static_cast<int>(v)
      : vertex;
  }
  int edge = 0;
  for (int e = 0; e < edges.Count(); ++e)
  {
    const Point target(0.5, 0.3);
    edge =
      (Midpoint(mesh, edges, e) - target).norm() < (Midpoint(mesh, edges, edge) - target).norm()
      ? e
      : edge;
  }
  const Configuration on = { { mesh.points[static_cast<std::size_t>(vertex)], 1, 0.0 },
    { Midpoint(mesh, edges, edge), 1, 0.0 }, { { -0.5, 0.4 }, 1, 0.0 },
    { { -0.2, -0.5 }, 1, 0.0 } };
  const HField field = SolveHField(ShareTopology(mesh), on);
  EXPECT_TRUE(field.h.allFinite());
  EXPECT_TRUE(field.field.u.allFinite());
  EXPECT_EQ(field.field.unwantedSingularities, 0);
}

TEST(HField, RejectsConfigurationsWithoutSolution)
{
  const TriangleMesh mesh = DrillMesh(Builtin("disk", 0.1), {}, 0.1);
  EXPECT_TRUE(Refuses(
    [&] {
      SolveHField(ShareTopology(mesh), { { { 0.1, 0.2 }, 3, 0.0 } });
    },
    { "add up to 3", "requires 4" }, Error::Kind::Inconsistent));
  EXPECT_TRUE(Refuses(
    [&] {
      SolveHField(ShareTopology(mesh), { { { 1.3, 0.2 }, 4, 0.0 } });
    },
    { "singularity 1", "outside the domain" }));
  EXPECT_TRUE(Refuses(
    [&] {
      SolveHField(ShareTopology(mesh), { { { std::nan(""), 0.2 }, 4, 0.0 } });
    },
    { "Row 1", "not a finite number" }));
  EXPECT_TRUE(Refuses(
    [&] {
      SolveHField(ShareTopology(mesh), { { { 0.1, 0.2 }, 2, 0.0 }, { { 0.1, 0.2 }, 2, 0.0 } });
    },
    { "Singularities 1 and 2", "same place", "(0.1, 0.2)" }));
  const Configuration holes = OnCircle(4, 0.6, 0.3, 1, 0.1);
  const TriangleMesh drilled = DrillMesh(Builtin("disk", 0.1), holes, 0.1);
  EXPECT_NO_THROW(SolveHField(ShareTopology(drilled), holes));
  EXPECT_TRUE(Refuses(
    [&] {
      SolveHField(ShareTopology(drilled), { { { 0.0, 0.0 }, 1, 0.0 } });
    },
    { "has holes", "(0, 0)" }));
}
}
}
