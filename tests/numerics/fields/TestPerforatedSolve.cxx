#include "DegreeConstraint.h"
#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "PerforatedSolve.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
struct Case
{
  std::string name;
  TriangleMesh mesh;
};

/// Returns consistent configurations on domains with curves, corners and inner loops.
std::vector<Case> Cases()
{
  Configuration ring = OnCircle(4, 0.7, 0.0, 1, 0.06);
  const Configuration negative = OnCircle(4, 0.7, 0.25 * Pi, -1, 0.06);
  ring.insert(ring.end(), negative.begin(), negative.end());
  return { { "disk", DrillMesh(Builtin("disk", 0.08), OnCircle(4, 0.6, 0.3, 1, 0.1), 0.08) },
    { "ring", DrillMesh(Builtin("ring", 0.08), ring, 0.08) },
    { "ring without holes", DrillMesh(Builtin("ring", 0.08), {}, 0.08) },
    { "quarter-disk",
      DrillMesh(Builtin("quarter-disk", 0.08), { { { 0.4, 0.4 }, 1, 0.1 } }, 0.08) },
    { "hexagon",
      DrillMesh(MakePlanarDomain({ RegularPolygon(6) }), OnCircle(2, 0.4, 0.2, -1, 0.08), 0.08) },
    { "disk with a square island",
      DrillMesh(MakePlanarDomain({ Builtin("disk", 0.08).loops[0], RegularPolygon(4, 0.2) }),
        OnCircle(4, 0.6, 0.0, 1, 0.1), 0.08) },
    // Holes so close to the boundary that the mesher divides some of their edges.
    { "divided edges", DrillMesh(Builtin("disk", 0.08), OnCircle(4, 0.89, 0.3, 1, 0.1), 0.2) } };
}

TEST(PerforatedSolve, EveryBoundaryEdgeIsAlignedExactly)
{
  for (const auto& [name, mesh] : Cases())
  {
    SCOPED_TRACE(name);
    const SolvedField field = SolvePerforated(ShareTopology(mesh));
    ASSERT_TRUE(field.converged) << field.residual;
    for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
    {
      const auto& [from, to] = mesh.boundary[i].vertices;
      if (mesh.boundary[i].kind != BoundaryKind::Hole)
      {
        EXPECT_EQ(field.u[field.topology->edges.ofBoundary[i]],
          AlignedRepresentation(mesh.points[to] - mesh.points[from]));
      }
    }
  }
}

TEST(PerforatedSolve, OptimalityConditionsHoldOnEveryEdge)
{
  // K u = 0 inside, and K u = −λ_i A_i u on the edges of hole i with C_i(u) = t_i, all computed
  // here from the formulas of docs/method.md §3.
  for (const auto& [name, mesh] : Cases())
  {
    SCOPED_TRACE(name);
    const SolvedField field = SolvePerforated(ShareTopology(mesh));
    const ComplexVector residual = CrouzeixRaviartStiffness(mesh, field.topology->edges) * field.u;
    ComplexVector expected = ComplexVector::Zero(residual.size());
    std::size_t hole = 0;
    for (const BoundaryLoop& loop : FindBoundaryLoops(mesh))
    {
      const auto m = static_cast<int>(loop.edges.size());
      const auto number = [&](int j)
      { return field.topology->edges.ofBoundary[loop.edges[(j + m) % m]]; };
      double sum = 0.0;
      Loop midpoints;
      for (int j = 0; j < m; ++j)
      {
        if (loop.kind != BoundaryKind::Hole)
        {
          expected[number(j)] = residual[number(j)]; // the reaction to the alignment
          continue;
        }
        const Complex difference = field.u[number(j + 1)] - field.u[number(j - 1)];
        sum += 0.5 * (std::conj(field.u[number(j)]) * difference).imag();
        midpoints.push_back(Midpoint(mesh, field.topology->edges, number(j)));
        expected[number(j)] = Complex(0.0, field.multipliers[hole]) * difference;
      }
      if (loop.kind == BoundaryKind::Hole)
      {
        const Point centre = CentreOf(loop, mesh);
        EXPECT_NEAR(sum, DegreeTarget(midpoints, centre, loop.quarterIndex), 1e-8);
        ++hole;
      }
    }
    EXPECT_EQ(hole, field.multipliers.size());
    EXPECT_LE((residual - expected).lpNorm<Eigen::Infinity>(), 1e-8);
    const double energy = 0.5 * field.u.dot(residual).real();
    EXPECT_NEAR(field.energy, energy, 1e-10 * energy + 1e-12);
  }
}

TEST(PerforatedSolve, HolesHaveTheirDegrees)
{
  for (const auto& [name, mesh] : Cases())
  {
    SCOPED_TRACE(name);
    const SolvedField field = SolvePerforated(ShareTopology(mesh));
    std::vector<int> prescribed;
    for (const BoundaryLoop& loop : FindBoundaryLoops(mesh))
    {
      if (loop.kind == BoundaryKind::Hole)
      {
        prescribed.push_back(loop.quarterIndex);
      }
    }
    ASSERT_EQ(field.holes.size(), prescribed.size());
    for (std::size_t i = 0; i < prescribed.size(); ++i)
    {
      EXPECT_EQ(field.holes[i].degree, prescribed[i]);
      EXPECT_TRUE(field.holes[i].Reliable());
    }
    EXPECT_TRUE(field.count.Consistent());
  }
}

/// Compares two runs. Each stops when the relative residual of its conditions is below 1e-10; the
/// violation of the constraints enters the energy multiplied by the Lagrange multipliers.
void ExpectSameField(const SolvedField& moved, const SolvedField& plain)
{
  constexpr double Tolerance = 1e-9;
  EXPECT_NEAR(moved.energy, plain.energy, Tolerance * (1.0 + plain.energy));
  ASSERT_EQ(moved.multipliers.size(), plain.multipliers.size());
  for (std::size_t i = 0; i < plain.multipliers.size(); ++i)
  {
    EXPECT_NEAR(moved.multipliers[i], plain.multipliers[i], 10.0 * Tolerance);
    EXPECT_EQ(moved.holes[i].degree, plain.holes[i].degree);
    EXPECT_NEAR(moved.holes[i].minimumNorm, plain.holes[i].minimumNorm, 100.0 * Tolerance);
    EXPECT_NEAR(moved.holes[i].maximumNorm, plain.holes[i].maximumNorm, 100.0 * Tolerance);
  }
  EXPECT_EQ(moved.unwantedSingularities, plain.unwantedSingularities);
}

TEST(PerforatedSolve, IsEquivariantUnderSimilarities)
{
  Random random(70);
  for (const auto& [name, mesh] : Cases())
  {
    SCOPED_TRACE(name);
    const SolvedField plain = SolvePerforated(ShareTopology(mesh));
    for (const double scale : { 1e-6, 1.0, 1e6 })
    {
      const Similarity move{ random.Uniform(-Pi, Pi), scale, scale * Point(0.3, -0.8) };
      const SolvedField moved = SolvePerforated(ShareTopology(move(mesh)));
      ExpectSameField(moved, plain);
      // The representation turns by four times the angle.
      const ComplexVector turned = std::polar(1.0, 4.0 * move.angle) * plain.u;
      EXPECT_LE((moved.u - turned).lpNorm<Eigen::Infinity>(), 1e-8);
    }
  }
}

TEST(PerforatedSolve, IsIndependentOfTheMeshNumbering)
{
  Random random(71);
  for (const auto& [name, mesh] : Cases())
  {
    SCOPED_TRACE(name);
    ExpectSameField(
      SolvePerforated(ShareTopology(Renumber(mesh, random))), SolvePerforated(ShareTopology(mesh)));
  }
}

TEST(PerforatedSolve, RepeatedRunsAreIdentical)
{
  const TriangleMesh mesh = Cases()[0].mesh;
  EXPECT_EQ(SolvePerforated(ShareTopology(mesh)).u, SolvePerforated(ShareTopology(mesh)).u);
}

TEST(PerforatedSolve, RotationChangesTheEnergyByMeshNoiseOnly)
{
  Random random(72);
  const PlanarDomain disk = Builtin("disk", 0.05);
  const Configuration holes = OnCircle(4, 0.6, 0.25 * Pi, 1, 0.1);
  const auto energy = [](const PlanarDomain& domain, const Configuration& configuration)
  { return SolvePerforated(ShareTopology(DrillMesh(domain, configuration, 0.05))).energy; };
  const double plain = energy(disk, holes);
  for (int trial = 0; trial < 3; ++trial)
  {
    const Similarity turn{ random.Uniform(-Pi, Pi), 1.0, Point::Zero() };
    EXPECT_NEAR(energy(turn(disk), turn(holes)), plain, 0.01 * plain);
    // On the disk, the energy is the same if only the holes are rotated.
    EXPECT_NEAR(energy(disk, turn(holes)), plain, 0.01 * plain);
  }
}

TEST(PerforatedSolve, IsTheHarmonicFieldWithoutHoles)
{
  const SolvedField field = SolvePerforated(ShareTopology(Cases()[2].mesh));
  EXPECT_TRUE(field.converged);
  EXPECT_EQ(field.iterations, 0);
  EXPECT_TRUE(field.multipliers.empty());
  // On a square the field is the constant cross, of energy zero.
  const SolvedField constant =
    SolvePerforated(ShareTopology(DrillMesh(Builtin("square"), {}, 0.08)));
  EXPECT_NEAR(constant.energy, 0.0, 1e-12);
  EXPECT_LE((constant.u - ComplexVector::Ones(constant.u.size())).lpNorm<Eigen::Infinity>(), 1e-10);
}

TEST(PerforatedSolve, PrintsNothing)
{
  // This includes the messages that a BLAS prints for an empty matrix, as without holes.
  for (const auto& [name, mesh] : Cases())
  {
    SCOPED_TRACE(name);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    SolvePerforated(ShareTopology(mesh));
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  }
}

TEST(PerforatedSolve, RightAngledDomainsAreSolved)
{
  // The harmonic field is constant there, so the constraints have no gradient at the start.
  DrillOptions options;
  options.meshSize = 0.04;
  const TriangleMesh mesh = DrillHoles(
    Builtin("square"), { { { 0.3, 0.35 }, 1, 0.06 }, { { 0.7, 0.6 }, -1, 0.06 } }, options);
  const SolvedField field = SolvePerforated(ShareTopology(mesh));
  EXPECT_TRUE(field.converged) << field.residual;
  ASSERT_EQ(field.holes.size(), 2u);
  EXPECT_EQ(field.holes[0].degree, 1);
  EXPECT_EQ(field.holes[1].degree, -1);
}

TEST(PerforatedSolve, HarmonicStartHasTheLowestEnergyAndUnitHolesTheHighest)
{
  for (const auto& [name, mesh] : Cases())
  {
    SCOPED_TRACE(name);
    PerforatedOptions options;
    options.start = PerforatedStart::Harmonic;
    const SolvedField harmonic = SolvePerforated(ShareTopology(mesh), options);
    options.start = PerforatedStart::UnitNorm;
    const SolvedField local = SolvePerforated(ShareTopology(mesh), options);
    options.unitHoles = true;
    const SolvedField unit = SolvePerforated(ShareTopology(mesh), options);
    options.method = PerforatedMethod::UnitNorm;
    const SolvedField everywhere = SolvePerforated(ShareTopology(mesh), options);
    for (const SolvedField* field : { &harmonic, &local, &unit, &everywhere })
    {
      ASSERT_TRUE(field->converged) << field->residual;
    }
    // Each one minimises over fewer fields than the previous one, or only near a point.
    EXPECT_LE(harmonic.energy, local.energy * (1.0 + 1e-9));
    EXPECT_LE(local.energy, unit.energy * (1.0 + 1e-9));
    EXPECT_LE(unit.energy, everywhere.energy * (1.0 + 1e-9));
    for (const HoleReading& hole : unit.holes)
    {
      EXPECT_NEAR(hole.minimumNorm, 1.0, 1e-8);
      EXPECT_NEAR(hole.maximumNorm, 1.0, 1e-8);
    }
    EXPECT_EQ(unit.wrongDegrees, 0);
    EXPECT_EQ(everywhere.wrongDegrees, 0);
  }
}

TEST(PerforatedSolve, RejectsAnInconsistentSumWithBothNumbers)
{
  const auto refused = [](const PlanarDomain& domain, const Configuration& holes,
                         const std::string& given, const std::string& required)
  {
    const TriangleMesh mesh = DrillMesh(domain, holes, 0.08);
    return Refuses([&] { SolvePerforated(ShareTopology(mesh)); },
      { "add up to " + given, "Poincaré-Hopf", "requires " + required }, Error::Kind::Inconsistent);
  };
  EXPECT_TRUE(refused(Builtin("disk"), OnCircle(3, 0.6, 0.0, 1, 0.1), "3", "4"));
  EXPECT_TRUE(refused(Builtin("disk"), {}, "0", "4"));
  EXPECT_TRUE(refused(Builtin("ring"), OnCircle(4, 0.7, 0.0, 1, 0.1), "4", "0"));
  EXPECT_TRUE(refused(Builtin("quarter-disk"), { { { 0.4, 0.4 }, -1, 0.1 } }, "-1", "1"));
}

TEST(PerforatedSolve, RejectsHolesWithTooFewEdges)
{
  DrillOptions options;
  options.minimumHoleEdges = 8;
  options.meshSize = 0.1;
  TriangleMesh mesh = DrillHoles(Builtin("disk"), { { { 0.0, 0.0 }, 1, 0.1 } }, options);
  for (BoundaryEdge& edge : mesh.boundary)
  {
    edge.quarterIndex = edge.kind == BoundaryKind::Hole ? 4 : 0;
  }
  ASSERT_EQ(FindBoundaryLoops(mesh).back().edges.size(), 8u);
  EXPECT_TRUE(
    Refuses([&] { SolvePerforated(ShareTopology(mesh)); }, { "8 edges", "at least 9 edges" }));
}

TEST(PerforatedSolve, ReportsNonConvergenceWithoutThrowing)
{
  PerforatedOptions hurried;
  hurried.reduced.maximumIterations = 1;
  const SolvedField field = SolvePerforated(ShareTopology(Cases()[0].mesh), hurried);
  EXPECT_FALSE(field.converged);
  EXPECT_EQ(field.iterations, 1);
  EXPECT_GT(field.residual, hurried.reduced.tolerance);
}

TEST(PerforatedSolve, ReportsIncreasingProgressAndStopsOnAbort)
{
  const TriangleMesh mesh = Cases()[0].mesh;
  std::vector<double> fractions;
  SolvePerforated(ShareTopology(mesh), {},
    Progress(
      [&](double fraction)
      {
        fractions.push_back(fraction);
        return true;
      }));
  ASSERT_FALSE(fractions.empty());
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1.0);
  // Aborts at every call.
  for (std::size_t last = 0; last < fractions.size(); ++last)
  {
    std::size_t reports = 0;
    const Progress stop([&](double) { return reports++ < last; });
    EXPECT_THROW(SolvePerforated(ShareTopology(mesh), {}, stop), Aborted);
  }
}
}
}
