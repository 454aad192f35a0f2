#include "CrossField.h"
#include "Support.h"

#include <cmath>
#include <numeric>

namespace crossfield::test
{
namespace
{
/// Returns a field of random directions, with indices of all kinds.
CrossField RandomField(const char* domain, std::uint32_t seed)
{
  const SharedPlanarTopology topology = ShareTopology(DrillMesh(Builtin(domain, 0.15), {}, 0.15));
  Random random(seed);
  CrossField field{ topology, ComplexVector(topology->edges.Count()) };
  for (Complex& value : field.u)
  {
    value = random.UnitComplex() * random.Uniform(0.1, 2.0);
  }
  return field;
}

TEST(UnwrapPhase, EqualsTheArgumentUpToFullTurns)
{
  for (const char* domain : { "disk", "ring" })
  {
    const CrossField field = RandomField(domain, 7);
    const UnwrappedPhase phase = UnwrapPhase(field);
    for (Eigen::Index e = 0; e < field.u.size(); ++e)
    {
      const double turns = (phase.atEdges[e] - std::arg(field.u[e])) / (2.0 * Pi);
      EXPECT_NEAR(turns, std::round(turns), 1e-9);
    }
  }
}

TEST(UnwrapPhase, MatchingAddsUpToMinusTheIndex)
{
  const CrossField field = RandomField("ring", 8);
  const UnwrappedPhase phase = UnwrapPhase(field);
  int singular = 0;
  int onTree = 0;
  for (std::size_t t = 0; t < field.topology->mesh.triangles.size(); ++t)
  {
    const auto& sides = field.topology->edges.ofTriangle[t];
    double around = 0.0;
    int sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Complex from = field.u[sides[i]];
      const Complex to = field.u[sides[(i + 1) % 3]];
      const double step = std::arg(std::conj(from) * to);
      around += step;
      sum += phase.matching[t][i];
      onTree += phase.matching[t][i] == 0 ? 1 : 0;
      EXPECT_NEAR(phase.atEdges[sides[(i + 1) % 3]] - phase.atEdges[sides[i]],
        step + 2.0 * Pi * phase.matching[t][i], 1e-9);
    }
    const int index = static_cast<int>(std::lround(around / (2.0 * Pi)));
    singular += index != 0 ? 1 : 0;
    EXPECT_EQ(sum, -index);
  }
  EXPECT_GT(singular, 10);
  // A spanning tree of the edges has one step fewer than there are edges.
  EXPECT_GE(onTree, field.topology->edges.Count() - 1);
}

TEST(UnwrapPhase, MatchingVanishesForSmoothFields)
{
  // u = e^{4iθ} for a smooth θ without singularities on a simply connected domain.
  CrossField field = RandomField("disk", 9);
  for (int e = 0; e < field.topology->edges.Count(); ++e)
  {
    const Point place = field.topology->Midpoint(e);
    field.u[e] = std::polar(1.0, 4.0 * (3.0 * place.x() - 2.0 * place.y() * place.y()));
  }
  const UnwrappedPhase phase = UnwrapPhase(field);
  for (const auto& turns : phase.matching)
  {
    EXPECT_EQ(turns, (std::array<int, 3>{ 0, 0, 0 }));
  }
  const Point first = field.topology->Midpoint(0);
  for (int e = 0; e < field.topology->edges.Count(); ++e)
  {
    const Point place = field.topology->Midpoint(e);
    EXPECT_NEAR(phase.atEdges[e] - phase.atEdges[0],
      4.0 * (3.0 * (place.x() - first.x()) - 2.0 * (place.y() * place.y() - first.y() * first.y())),
      1e-9);
  }
}

TEST(UnwrapPhase, RefusesAFieldThatVanishes)
{
  CrossField field = RandomField("disk", 10);
  field.u[3] = 0.0;
  EXPECT_TRUE(Refuses([&] { UnwrapPhase(field); }, { "zero or not finite", "unit-norm" }));
}
}
}
