#include "HolonomyCheck.h"

#include "ExactFields.h"
#include "HField.h"
#include "MakePlanarDomain.h"
#include "MeshForPoints.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Image of the ring inner ≤ |z| ≤ 1.
struct RingImage : DiskImage
{
  double inner = 0.4;

  /// Returns both circles as polygons with sides of about a given length.
  PlanarDomain Domain(double edgeLength) const
  {
    const auto count = [edgeLength](double radius)
    { return static_cast<int>(std::ceil(2.0 * Pi * radius / edgeLength)); };
    return MakePlanarDomain(
      { this->Polygon(count(1.0)), this->Polygon(count(this->inner), this->inner) });
  }
};

/// Singularities given on the ring, and their positions on its image.
struct RingCase
{
  RingImage image;
  std::vector<Complex> preimages;
  Configuration configuration;

  /// Returns the exact defect.
  ///
  /// On a ring around 0 the defect is wrap(Σ k_j arg b_j). On both circles the tangent is at arg z
  /// + π/2, so alignment is φ = 4 arg z modulo 2π. Let ψ = φ − 4 arg z, and let Ψ = Φ − 4 log|z| be
  /// its single-valued potential: ∂Ψ/∂r = 0 on both circles, where ψ is constant, and ΔΨ = 2π Σ k_j
  /// δ(b_j). The defect is ψ on the inner circle minus ψ on the outer one,
  ///   D = −∫ ∂ψ/∂r dr = ∫ (1/r) ∂Ψ/∂θ dr
  /// along a ray at angle θ. From r ΔΨ = (r Ψ_r)_r + Ψ_θθ / r and Ψ_r = 0 at both ends, dD/dθ = 2π
  /// Σ k_j δ(θ − arg b_j), and D has the mean 0 over θ because Ψ is single-valued. So, with arg b_j
  /// in [0, 2π) and Σ k_j = 0, D = 2π Σ_{arg b_j < θ} k_j + Σ k_j arg b_j.
  ///
  /// An injective map f transports the field: τ increases by arg f′, which is the same for the
  /// field and for the boundary and has no turns where |f′ − 1| < 1, and Φ by the conjugate of 4
  /// arg f′, a multiple of log|f′|, which is single-valued. So the defect is that of the preimages.
  double Defect() const
  {
    double sum = 0.0;
    for (std::size_t j = 0; j < this->preimages.size(); ++j)
    {
      sum += this->configuration[j].quarterIndex * std::arg(this->preimages[j]);
    }
    return sum;
  }
};

/// Returns two to six singularities with sum 0, at least 0.08 apart and away from the circles.
RingCase RandomCase(Random& random, Complex a, int n)
{
  RingCase result;
  result.image = { { a, n }, random.Uniform(0.2, 0.6) };
  const double inner = result.image.inner;
  const auto count = static_cast<std::size_t>(random.Integer(2, 6));
  while (result.preimages.size() < count)
  {
    const Complex z = std::polar(random.Uniform(inner + 0.08, 0.92), random.Uniform(-Pi, Pi));
    if (std::all_of(result.preimages.begin(), result.preimages.end(),
          [&](Complex other) { return std::abs(other - z) > 0.08; }))
    {
      result.preimages.push_back(z);
      const bool last = result.preimages.size() == count;
      result.configuration.push_back({ result.image(z),
        last ? -TotalQuarters(result.configuration) : random.Integer(-2, 2), 0.0 });
    }
  }
  return result;
}

/// Returns 2 count cases, half of them on rings and half on images of rings.
std::vector<RingCase> RandomCases(int count)
{
  Random random(23);
  std::vector<RingCase> cases;
  for (int i = 0; i < count; ++i)
  {
    cases.push_back(RandomCase(random, 0.0, 2));
    const int n = random.Integer(2, 4);
    cases.push_back(RandomCase(random, random.UnitComplex() * (0.5 / n), n));
  }
  return cases;
}

/// Returns the difference of two angles modulo 2π.
double AngularError(double found, double exact)
{
  return std::abs(std::remainder(found - exact, 2.0 * Pi));
}

TEST(HolonomyCheck, MatchesExactDefectOnRingImages)
{
  for (const RingCase& ring : RandomCases(12))
  {
    const std::vector<double> defects =
      HolonomyDefects(ring.image.Domain(0.02), ring.configuration);
    ASSERT_EQ(defects.size(), 1u);
    EXPECT_LE(std::abs(defects[0]), Pi);
    // The bound is the square of the default mesh size, 1/40 of the diagonal, relative to the size
    // of the domain.
    EXPECT_LT(AngularError(defects[0], ring.Defect()), 5e-3);
  }
}

TEST(HolonomyCheck, EqualsFieldAndConvergesAtSecondOrder)
{
  const std::vector<double> sizes = { 0.08, 0.04, 0.02 };
  std::vector<double> errors(sizes.size(), 0.0);
  for (const RingCase& ring : RandomCases(10))
  {
    for (std::size_t i = 0; i < sizes.size(); ++i)
    {
      const PlanarDomain domain = ring.image.Domain(sizes[i]);
      const auto defects = [&](double meshSize)
      {
        const SharedPlanarTopology topology =
          ShareTopology(MeshForPoints(domain, ring.configuration, meshSize));
        return SolveHField(topology, ring.configuration).field.holonomyDefect;
      };
      errors[i] += std::pow(AngularError(defects(sizes[i]).at(0), ring.Defect()), 2);
      if (i == 0)
      {
        EXPECT_EQ(HolonomyDefects(domain, ring.configuration), defects(0.0));
      }
    }
  }
  for (double& error : errors)
  {
    error = std::sqrt(error);
  }
  EXPECT_GE(ConvergenceRate(sizes, errors), 1.8);
}

TEST(HolonomyCheck, IsInvariantUnderScaling)
{
  const RingCase ring = RandomCases(1).back();
  const PlanarDomain domain = ring.image.Domain(0.05);
  const double plain = HolonomyDefects(domain, ring.configuration).at(0);
  for (const int exponent : { -196, -133, 133, 196 }) // scales of about 1e±40 and 1e±59
  {
    const Similarity move{ 0.0, std::ldexp(1.0, exponent), Point::Zero() };
    EXPECT_NEAR(HolonomyDefects(move(domain), move(ring.configuration)).at(0), plain, 1e-9);
  }
}

TEST(HolonomyCheck, EqualsFieldWithSeveralLoops)
{
  EXPECT_TRUE(HolonomyDefects(Builtin("disk"), OnCircle(4, 0.6, 0.3, 1, 0.0)).empty());
  // Two rectangles in a disk; in the second configuration a corner of one has no quarter.
  const PlanarDomain domain = MakePlanarDomain(
    { Builtin("disk", 0.05).loops[0], { { 0.3, -0.1 }, { 0.5, -0.1 }, { 0.5, 0.1 }, { 0.3, 0.1 } },
      { { -0.5, -0.1 }, { -0.3, -0.1 }, { -0.3, 0.15 }, { -0.5, 0.15 } } });
  const Configuration inside = OnCircle(4, 0.8, 0.3, 1, 0.0);
  Configuration atCorner = { { { 0.5, 0.1 }, 0, 0.0 }, { { 0.1, 0.5 }, 1, 0.0 },
    { { -0.6, 0.4 }, 1, 0.0 }, { { 0.2, -0.7 }, 1, 0.0 } };
  for (const Configuration& configuration : { inside, atCorner })
  {
    const SharedPlanarTopology topology = ShareTopology(MeshForPoints(domain, configuration));
    const HField field = SolveHField(topology, configuration);
    ASSERT_EQ(field.field.holonomyDefect.size(), 2u);
    EXPECT_EQ(HolonomyDefects(domain, configuration), field.field.holonomyDefect);
  }
}

TEST(HolonomyCheck, IgnoresRadiiAndRequiresConsistentSum)
{
  const PlanarDomain ring = Builtin("ring");
  const Configuration bare = { { { 0.7, 0.0 }, 1, 0.0 }, { { 0.2, 0.65 }, -1, 0.0 } };
  Configuration holes = bare;
  holes[0].radius = 0.25;
  holes[1].radius = 0.1;
  EXPECT_EQ(HolonomyDefects(ring, holes), HolonomyDefects(ring, bare));
  const Configuration one = { { { 0.7, 0.0 }, 1, 0.0 } };
  EXPECT_TRUE(
    Refuses([&] { HolonomyDefects(ring, one); }, { "requires" }, Error::Kind::Inconsistent));
}
}
}
