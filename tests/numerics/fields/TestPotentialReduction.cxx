#include "DirectPerforatedSolve.h"
#include "DrillHoles.h"
#include "DualSolve.h"
#include "MakePlanarDomain.h"
#include "PotentialReduction.h"
#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns meshes with and without islands, with equal and unequal holes.
std::vector<TriangleMesh> Meshes()
{
  const Loop disk = Builtin("disk", 0.08).loops[0];
  Configuration unequal = OnCircle(3, 0.6, 0.1, 1, 0.08);
  unequal.push_back({ { 0.05, 0.0 }, 2, 0.15 });
  unequal.push_back({ { 0.2, 0.3 }, -1, 0.04 });
  return { DrillMesh(Builtin("disk", 0.08), OnCircle(4, 0.6, 0.3, 1, 0.1), 0.08),
    DrillMesh(Builtin("disk", 0.08), unequal, 0.08), DrillMesh(Builtin("ring", 0.08), {}, 0.08),
    DrillMesh(
      Builtin("ring", 0.08), { { { 0.75, 0.05 }, 1, 0.05 }, { { -0.1, 0.65 }, -1, 0.05 } }, 0.08),
    DrillMesh(MakePlanarDomain({ disk, RegularPolygon(4, 0.15, Point(0.1, 0.1)),
                RegularPolygon(12, 0.1, Point(-0.3, -0.2)) }),
      { { { 0.6, 0.0 }, -1, 0.08 }, { { -0.6, 0.1 }, 1, 0.05 } }, 0.08) };
}

TEST(PotentialReduction, ReducedFormEqualsTheDirectForm)
{
  int index = 0;
  for (const TriangleMesh& mesh : Meshes())
  {
    SCOPED_TRACE(index++);
    const PotentialProblem problem = ProblemOn(mesh);
    const PotentialReduction solver(problem);
    const MinimiserResult solution = SolveReduced(HoleBases(solver.GetReducedProblem()));
    ASSERT_TRUE(solution.converged);
    const RecoveredField reduced = solver.Recover(solution.x);
    const SolvedField direct = SolvePerforatedDirectly(mesh);
    ASSERT_TRUE(direct.converged);
    EXPECT_NEAR(reduced.energy, direct.energy, 1e-9 * direct.energy);
    EXPECT_LE((reduced.u - direct.u).lpNorm<Eigen::Infinity>(), 1e-7);
    EXPECT_LT(reduced.alignmentResidual, 1e-8);
    for (std::size_t i = 0; i < direct.multipliers.size(); ++i)
    {
      EXPECT_NEAR(solution.multipliers[i], direct.multipliers[i], 1e-7);
    }
  }
}

TEST(PotentialReduction, ValuesOfReproduceTheSolution)
{
  // The values of the recovered field, in the gauge of the reduced problem, are its solution.
  for (const TriangleMesh& mesh : Meshes())
  {
    const PotentialProblem problem = ProblemOn(mesh);
    const PotentialReduction solver(problem);
    const MinimiserResult solution = SolveReduced(HoleBases(solver.GetReducedProblem()));
    const ComplexVector values = solver.ValuesOf(solver.Recover(solution.x).u);
    ASSERT_EQ(values.size(), solution.x.size());
    EXPECT_LE((values - solution.x).norm(), 1e-8 * (1.0 + solution.x.norm()));
  }
}
}
}
