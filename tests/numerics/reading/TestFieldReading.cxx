#include "DrillHoles.h"
#include "FieldReading.h"
#include "MakePlanarDomain.h"
#include "Support.h"

#include <cmath>
#include <cstdlib>
#include <limits>

namespace crossfield::test
{
namespace
{
/// Returns the constant cross field along the axes.
CrossField ConstantField(const TriangleMesh& mesh)
{
  const SharedPlanarTopology topology = ShareTopology(mesh);
  return { topology, ComplexVector::Ones(topology->edges.Count()) };
}

FieldRequest MakeRequest(const CrossField& field, const Configuration& points = {})
{
  return { CountMeshQuarters(*field.topology), points, false };
}

FieldReading Read(const CrossField& field, const Configuration& points = {})
{
  return ReadField(field, MakeRequest(field, points));
}

TEST(FieldReading, IndicesOfCornersAreFree)
{
  for (const char* name : { "square", "l-shape" })
  {
    const FieldReading reading =
      Read(ConstantField(DrillHoles(Builtin(name), { { { 0.25, 0.2 }, 0, 0.05 } })));
    EXPECT_EQ(reading.unwantedSingularities, 0) << name;
    ASSERT_EQ(reading.holes.size(), 1u);
    EXPECT_EQ(reading.holes[0].degree, 0);
    EXPECT_TRUE(reading.holes[0].Reliable());
  }
}

/// Returns Π (z − b)^k (1 − conj(b) z)^k, normalised to modulus one; aligned with the unit circle
/// if Σ k = 4.
CrossField ExactField(const Configuration& singularities)
{
  DrillOptions options;
  options.meshSize = 0.04;
  const SharedPlanarTopology topology =
    ShareTopology(DrillHoles(Builtin("disk", 0.04), {}, options));
  CrossField field{ topology, ComplexVector(topology->edges.Count()) };
  for (int e = 0; e < topology->edges.Count(); ++e)
  {
    const Point middle = topology->Midpoint(e);
    const Complex z(middle.x(), middle.y());
    Complex u = 1.0;
    for (const Singularity& singularity : singularities)
    {
      const Complex b(singularity.position.x(), singularity.position.y());
      u *= std::pow((z - b) * (1.0 - std::conj(b) * z), singularity.quarterIndex);
    }
    field.u[e] = u / std::abs(u);
  }
  for (std::size_t i = 0; i < topology->mesh.boundary.size(); ++i)
  {
    const auto& [from, to] = topology->mesh.boundary[i].vertices;
    field.u[topology->edges.ofBoundary[i]] =
      AlignedRepresentation(topology->PointAt(to) - topology->PointAt(from));
  }
  return field;
}

TEST(FieldReading, CountsUnwantedSingularities)
{
  const Configuration all = { { { 0.6, 0.1 }, 1, 0.0 }, { { -0.1, 0.55 }, 2, 0.0 },
    { { -0.5, -0.4 }, 1, 0.0 }, { { 0.3, -0.6 }, 1, 0.0 }, { { 0.05, -0.1 }, -1, 0.0 } };
  const CrossField field = ExactField(all);
  EXPECT_EQ(Read(field, all).unwantedSingularities, 0);
  // The disk leaves four quarters to the interior, and the field has Σ |k| = 6.
  EXPECT_EQ(Read(field).unwantedSingularities, 2);
  for (std::size_t left = 0; left < all.size(); ++left)
  {
    Configuration prescribed = all;
    prescribed.erase(prescribed.begin() + static_cast<std::ptrdiff_t>(left));
    EXPECT_EQ(Read(field, prescribed).unwantedSingularities, std::abs(all[left].quarterIndex))
      << left;
    prescribed = all;
    prescribed[left].quarterIndex += 3;
    EXPECT_EQ(Read(field, prescribed).unwantedSingularities, 3) << left;
    // A singularity prescribed where there is none.
    prescribed = all;
    prescribed[left].position = Point(-0.55, 0.3);
    EXPECT_EQ(Read(field, prescribed).unwantedSingularities, 2 * std::abs(all[left].quarterIndex))
      << left;
  }
}

TEST(FieldReading, InnerLoopsHaveCorners)
{
  const PlanarDomain domain = MakePlanarDomain(
    { { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } }, { { 1, 1 }, { 3, 1 }, { 3, 2 }, { 1, 2 } } });
  const FieldReading reading = Read(ConstantField(DrillHoles(domain, {})));
  EXPECT_EQ(reading.unwantedSingularities, 0);
  EXPECT_EQ(reading.count.requiredInteriorQuarters, 0);
}

TEST(FieldReading, RejectsNonFiniteFields)
{
  CrossField field = ConstantField(DrillHoles(Builtin("square"), {}));
  field.u[field.u.size() / 2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(Refuses([&] { Read(field); }, { "non-finite" }));
}
}
}
