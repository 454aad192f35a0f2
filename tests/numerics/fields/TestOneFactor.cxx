#include "ConfigurationEnergy.h"
#include "FactorisationCount.h"
#include "HField.h"
#include "PerforatedSolve.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
std::shared_ptr<const PotentialSolver> Factor(const TriangleMesh& mesh)
{
  return std::make_shared<const PotentialSolver>(ShareTopology(mesh));
}

TEST(OneFactor, SupportsAllMethodsAndCorners)
{
  // The island provides periods of both kinds.
  DrillOptions options;
  options.meshSize = 0.08;
  const TriangleMesh mesh = DrillHoles(
    Builtin("ring", 0.08), { { { 0.75, 0.05 }, 1, 0.05 }, { { -0.1, 0.65 }, -1, 0.05 } }, options);
  const auto potential = Factor(mesh);
  const long before = FactorisationCount();
  PerforatedOptions constrained;
  PerforatedOptions unitNorm;
  unitNorm.method = PerforatedMethod::UnitNorm;
  PerforatedOptions unitHoles;
  unitHoles.unitHoles = true;
  PerforatedOptions corners = unitNorm;
  const std::vector<int>& outer = potential->GetTopology().alignedVertices[0];
  corners.corners = { { potential->GetTopology().PointAt(outer[0]), 1 },
    { potential->GetTopology().PointAt(outer[5]), -1 } };
  std::vector<SolvedField> fields;
  for (const PerforatedOptions& variant : { constrained, unitNorm, unitHoles, corners, unitNorm })
  {
    fields.push_back(SolvePerforated(potential, variant));
    EXPECT_TRUE(fields.back().converged);
  }
  SolveHField(potential, {});
  EXPECT_EQ(FactorisationCount(), before);
  // Intermediate solves leave no state behind.
  EXPECT_EQ(fields[1].u, fields[4].u);
  // Every solution equals that computed with a factor of its own.
  EXPECT_EQ(SolvePerforated(ShareTopology(mesh), unitHoles).u, fields[2].u);
  EXPECT_EQ(SolvePerforated(ShareTopology(mesh), constrained).u, fields[0].u);
}

TEST(OneFactor, ASolveUsesOneFactor)
{
  // A mesh is factored once.
  DrillOptions options;
  options.meshSize = 0.1;
  const TriangleMesh mesh =
    DrillHoles(Builtin("disk", 0.1), OnCircle(4, 0.6, 0.3, 1, 0.1), options);
  for (const bool unitHoles : { false, true })
  {
    PerforatedOptions variant;
    variant.unitHoles = unitHoles;
    const long before = FactorisationCount();
    SolvePerforated(ShareTopology(mesh), variant);
    EXPECT_EQ(FactorisationCount(), before + 1);
  }
}

TEST(OneFactor, MovedPointsReuseTheFactor)
{
  DrillOptions options;
  options.meshSize = 0.1;
  const auto potential = Factor(DrillHoles(Builtin("disk", 0.1), {}, options));
  // The first energy also factors the Laplacian of the inner vertices.
  double last = SolveHField(potential, OnCircle(4, 0.4, 0.3, 1, 0.0)).renormalizedEnergy;
  const long before = FactorisationCount();
  for (const double radius : { 0.5, 0.6, 0.7 })
  {
    const HField field = SolveHField(potential, OnCircle(4, radius, 0.3, 1, 0.0));
    EXPECT_TRUE(field.field.converged);
    EXPECT_LT(field.renormalizedEnergy, last + 10.0);
    last = field.renormalizedEnergy;
  }
  EXPECT_EQ(FactorisationCount(), before);
}

TEST(OneFactor, EnergiesOfMovedPointsReuseTheFactor)
{
  const FactoredDomain domain(Builtin("disk", 0.1), {}, 0.1);
  CompareRenormalizedEnergies(domain, { OnCircle(4, 0.4, 0.3, 1, 0.0) });
  const long before = FactorisationCount();
  const std::vector<Configuration> configurations = { OnCircle(4, 0.6, 0.3, 1, 0.0),
    OnCircle(3, 0.6, 0.3, 1, 0.0), OnCircle(4, 0.8, 0.3, 1, 0.0) };
  const auto energies = CompareRenormalizedEnergies(domain, configurations);
  EXPECT_EQ(FactorisationCount(), before);
  ASSERT_EQ(energies.size(), 3u);
  EXPECT_EQ(energies[0].configuration, 2);
  EXPECT_EQ(energies[1].configuration, 0);
  EXPECT_FALSE(energies[2].consistent);
  EXPECT_FALSE(energies[0].perforated.has_value());
  EXPECT_EQ(energies[1].renormalized.energy,
    SolveHField(domain.GetPotential(), configurations[0]).renormalizedEnergy);
  EXPECT_TRUE(Refuses(
    [&] {
      CompareRenormalizedEnergies(domain, { { { { 2.0, 0.0 }, 4 } } });
    },
    { "outside the domain" }));
}
}
}
