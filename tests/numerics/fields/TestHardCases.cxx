#include "ConjugateField.h"
#include "DirectPerforatedSolve.h"
#include "DualSolve.h"
#include "HardCases.h"
#include "PerforatedSolve.h"
#include "PotentialReduction.h"
#include "Support.h"
#include "UnitNormField.h"

namespace crossfield::test
{
namespace
{
/// Returns ½ ∫ |∇φ|² of the phase in the Crouzeix-Raviart space, from differences of arg u along
/// triangles.
double PhaseEnergy(const TriangleMesh& mesh, const EdgeNumbering& edges, const ComplexVector& u)
{
  // Differences between the edges of a triangle determine its gradient; the branch of φ on each
  // triangle does not matter.
  double energy = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& [e0, e1, e2] = edges.ofTriangle[t];
    const double d1 = std::arg(u[e1] * std::conj(u[e0]));
    const double d2 = std::arg(u[e2] * std::conj(u[e0]));
    const Point m0 = Midpoint(mesh, edges, e0);
    const Point a = Midpoint(mesh, edges, e1) - m0;
    const Point b = Midpoint(mesh, edges, e2) - m0;
    const Point gradient = Point(d1 * b.y() - d2 * a.y(), d2 * a.x() - d1 * b.x()) / Cross(a, b);
    energy += 0.5 * TriangleArea(mesh, t) * gradient.squaredNorm();
  }
  return energy;
}

/// Checks that the field returned to a user has the prescribed degrees, and that its report is
/// correct.
void ExpectSolved(const HardCase& hard)
{
  SCOPED_TRACE(hard.name);
  const SolvedField constrained = SolvePerforated(ShareTopology(hard.mesh));
  EXPECT_TRUE(constrained.converged) << constrained.residual;
  EXPECT_EQ(constrained.wrongDegrees, 0);
  EXPECT_LE(constrained.residual, 1e-10);

  PerforatedOptions options;
  options.method = PerforatedMethod::UnitNorm;
  const SolvedField unitNorm = SolvePerforated(ShareTopology(hard.mesh), options);
  EXPECT_TRUE(unitNorm.converged) << unitNorm.residual;
  EXPECT_EQ(unitNorm.wrongDegrees, 0);
  EXPECT_EQ(unitNorm.unwantedSingularities, 0);
  // The phase of the Crouzeix-Raviart field and the P1 potential have the same energy
  // (docs/method.md §2).
  EXPECT_NEAR(PhaseEnergy(hard.mesh, unitNorm.topology->edges, unitNorm.u), unitNorm.energy,
    1e-10 * unitNorm.energy);
  // Where it exists, the relaxed minimum is below the minimum with |u| = 1 everywhere, because 2 −
  // 2 cos δ ≤ δ² for every step of the phase.
  if (!constrained.unitHoles)
  {
    EXPECT_LT(constrained.energy, unitNorm.energy);
  }
}

/// Checks that the reduced form and the direct form yield the same field and energy.
void ExpectSameAsDirect(const HardCase& hard)
{
  SCOPED_TRACE(hard.name);
  const PotentialProblem problem = ProblemOn(hard.mesh);
  const PotentialReduction solver(problem);
  // Both iterations converge to rounding, so that the comparison does not depend on their stopping
  // criteria.
  MinimiserOptions options;
  options.tolerance = 1e-14;
  const MinimiserResult solution = SolveReduced(HoleBases(solver.GetReducedProblem()), options);
  const RecoveredField reduced = solver.Recover(solution.x);
  const SolvedField direct = SolvePerforatedDirectly(hard.mesh, options);
  if (solution.residual > 1e-10 || direct.residual > 1e-10)
  {
    // The dual has no maximum, and both forms must detect this.
    EXPECT_GT(solution.residual, 1e-10);
    EXPECT_GT(direct.residual, 1e-10);
    return;
  }
  EXPECT_NEAR(reduced.energy, direct.energy, 1e-10 * direct.energy);
  EXPECT_LE((reduced.u - direct.u).norm(), 1e-10 * direct.u.norm());
}

TEST(HardCases, NamedCasesAreSolved)
{
  for (const HardCase& hard : NamedHardCases())
  {
    ExpectSolved(hard);
  }
}

TEST(HardCases, NamedCasesAreEqualInDirectForm)
{
  for (const HardCase& hard : NamedHardCases())
  {
    ExpectSameAsDirect(hard);
  }
}

/// 200 random cases in portions that ctest can run in parallel. Slow builds run only the first few
/// cases of each portion.
class RandomHardCases : public testing::TestWithParam<int>
{
public:
  static constexpr int PortionSize = 25;
  template <typename Function>
  void ForEach(const Function& function)
  {
    for (int i = 0; i < CROSSFIELD_RANDOM_PORTION; ++i)
    {
      function(RandomHardCase(PortionSize * this->GetParam() + i));
    }
  }
};

TEST_P(RandomHardCases, AreSolved)
{
  this->ForEach(ExpectSolved);
}

TEST_P(RandomHardCases, AreEqualInDirectForm)
{
  this->ForEach(ExpectSameAsDirect);
}

INSTANTIATE_TEST_SUITE_P(TwoHundred, RandomHardCases, testing::Range(0, 8));
}
}
