#include "DrillHoles.h"
#include "FieldIndices.h"
#include "Support.h"
#include "UnitNormField.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
Configuration Joined(Configuration first, const Configuration& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Returns two singularities on a ring that cause a holonomy defect.
Configuration PairOnRing()
{
  return { { { 0.75, 0.05 }, 1, 0.05 }, { { -0.1, 0.65 }, -1, 0.05 } };
}

TEST(UnitNormField, IsUnitAlignedAndHasItsDegrees)
{
  const std::vector<TriangleMesh> meshes = { DrillMesh(Builtin("disk", 0.05),
                                               OnCircle(4, 0.6, 0.3, 1, 0.1), 0.05),
    DrillMesh(Builtin("ring", 0.05), PairOnRing(), 0.05),
    DrillMesh(Builtin("square"), { { { 0.3, 0.35 }, 1, 0.06 }, { { 0.7, 0.6 }, -1, 0.06 } }, 0.04),
    DrillMesh(Builtin("disk", 0.05), { { { 0.2, 0.0 }, 4, 0.1 } }, 0.05) };
  for (const TriangleMesh& mesh : meshes)
  {
    const PotentialProblem problem = ProblemOn(mesh);
    const UnitNormField field = SolveUnitNorm(problem);
    EXPECT_LT(field.residual, 1e-8);
    EXPECT_LE((field.u.cwiseAbs().array() - 1.0).abs().maxCoeff(), 1e-14);
    for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
    {
      const auto& [from, to] = mesh.boundary[i].vertices;
      if (mesh.boundary[i].kind != BoundaryKind::Hole)
      {
        EXPECT_EQ(field.u[problem.Topology().edges.ofBoundary[i]],
          AlignedRepresentation(mesh.points[to] - mesh.points[from]));
      }
    }
    for (const BoundaryLoop& loop : problem.Topology().loops)
    {
      if (loop.kind == BoundaryKind::Hole)
      {
        EXPECT_EQ(ReadHole(loop, problem.Topology().edges, field.u).degree, loop.quarterIndex);
      }
    }
    // No triangle is singular.
    const FieldIndices indices = ReadIndices(PlanarTopology(mesh), field.u);
    EXPECT_EQ(std::count(indices.ofTriangle.begin(), indices.ofTriangle.end(), 0),
      static_cast<std::ptrdiff_t>(mesh.triangles.size()));
  }
}

TEST(UnitNormField, HasTheEnergiesOfReferenceConfigurations)
{
  // docs/method.md §9, from the independent prototype.
  const auto expectEnergy = [](const Configuration& holes, double energy)
  {
    const TriangleMesh mesh = DrillMesh(Builtin("disk", 0.05), holes, 0.05);
    EXPECT_NEAR(SolveUnitNorm(ProblemOn(mesh)).energy, energy, 0.02 * energy);
  };
  expectEnergy(OnCircle(4, 0.6, 0.25 * Pi, 1, 0.1), 30.27);
  expectEnergy(Joined(OnCircle(5, 0.6, 0.0, 1, 0.05), { { { 0.0, 0.0 }, -1, 0.05 } }), 47.16);
  expectEnergy(Joined(OnCircle(6, 0.7, 0.0, 1, 0.05),
                 { { { 0.2, 0.0 }, -1, 0.05 }, { { -0.2, 0.0 }, -1, 0.05 } }),
    54.06);
  expectEnergy(OnCircle(4, 0.6, 0.25 * Pi, 1, 0.01), 59.77);
}

TEST(UnitNormField, ConvergesAtSecondOrderToTheLogarithmOfACentralHole)
{
  // docs/method.md §5: π d² log(1/ρ), and u = z⁴ / |z|⁴.
  constexpr double Radius = 0.3;
  const double exact = 16.0 * Pi * std::log(1.0 / Radius);
  std::vector<double> sizes;
  std::vector<double> energyErrors;
  std::vector<double> valueErrors;
  for (const int sides : { 32, 64, 128 })
  {
    DrillOptions options;
    options.meshSize = 2.0 * Pi * Radius / sides;
    options.minimumHoleEdges = sides;
    const TriangleMesh mesh =
      DrillHoles(Builtin("disk", options.meshSize), { { { 0.0, 0.0 }, 4, Radius } }, options);
    const PotentialProblem problem = ProblemOn(mesh);
    const UnitNormField field = SolveUnitNorm(problem);
    sizes.push_back(options.meshSize);
    energyErrors.push_back(std::abs(field.energy - exact));
    valueErrors.push_back(0.0);
    for (int e = 0; e < problem.Topology().edges.Count(); ++e)
    {
      const Complex aligned = AlignedRepresentation(Midpoint(mesh, problem.Topology().edges, e));
      valueErrors.back() = std::max(valueErrors.back(), std::abs(field.u[e] - aligned));
    }
  }
  EXPECT_LT(energyErrors.back(), 0.01 * exact);
  EXPECT_GE(ConvergenceRate(sizes, energyErrors), 1.7);
  EXPECT_GE(ConvergenceRate(sizes, valueErrors), 1.7);
}

TEST(UnitNormField, IsTheRadialFieldOnARing)
{
  const TriangleMesh mesh = DrillMesh(Builtin("ring", 0.02), {}, 0.02);
  const PotentialProblem problem = ProblemOn(mesh);
  const UnitNormField field = SolveUnitNorm(problem);
  const double exact = 16.0 * Pi * std::log(1.0 / 0.4);
  EXPECT_NEAR(field.energy, exact, 0.005 * exact);
  ASSERT_EQ(field.holonomyDefect.size(), 1u);
  EXPECT_NEAR(field.holonomyDefect[0], 0.0, 1e-6);
}

TEST(UnitNormField, IsInvariantUnderSimilaritiesAndRenumbering)
{
  Random random(120);
  const TriangleMesh mesh = DrillMesh(Builtin("ring", 0.08), PairOnRing(), 0.08);
  const UnitNormField plain = SolveUnitNorm(ProblemOn(mesh));
  ASSERT_EQ(plain.holonomyDefect.size(), 1u);
  EXPECT_GT(std::abs(plain.holonomyDefect[0]), 0.1);
  EXPECT_LT(std::abs(plain.holonomyDefect[0]), Pi - 0.1);
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    const TriangleMesh moved = Renumber(
      Similarity{ random.Uniform(-Pi, Pi), scale, scale * Point(1.0, -2.0) }(mesh), random);
    const UnitNormField field = SolveUnitNorm(ProblemOn(moved));
    EXPECT_NEAR(field.energy, plain.energy, 1e-9 * plain.energy);
    EXPECT_NEAR(field.holonomyDefect[0], plain.holonomyDefect[0], 1e-8);
  }
}

TEST(UnitNormField, MirroringNegatesTheHolonomyDefect)
{
  const TriangleMesh mesh = DrillMesh(Builtin("ring", 0.08), PairOnRing(), 0.08);
  TriangleMesh mirrored = mesh;
  for (Point& point : mirrored.points)
  {
    point.x() = -point.x();
  }
  for (auto& triangle : mirrored.triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  for (BoundaryEdge& edge : mirrored.boundary)
  {
    std::swap(edge.vertices[0], edge.vertices[1]);
  }
  const UnitNormField plain = SolveUnitNorm(ProblemOn(mesh));
  const UnitNormField image = SolveUnitNorm(ProblemOn(mirrored));
  EXPECT_NEAR(image.energy, plain.energy, 1e-9 * plain.energy);
  EXPECT_NEAR(image.holonomyDefect[0], -plain.holonomyDefect[0], 1e-8);
}
}
}
