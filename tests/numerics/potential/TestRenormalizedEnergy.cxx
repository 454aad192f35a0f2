#include "MakePlanarDomain.h"
#include "RenormalizedEnergy.h"

#include "BoundarySingularities.h"
#include "ConfigurationPlacement.h"
#include "CornerEnergy.h"
#include "DrillHoles.h"
#include "ExactFields.h"
#include "PerforatedEnergy.h"
#include "Support.h"
#include "UnitNormField.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
RenormalizedEnergyValue Evaluate(
  const PointPotential& potential, const Configuration& configuration)
{
  return EvaluateRenormalizedEnergy(potential, potential.Solve(configuration));
}

/// Returns a disk of radius 1 with a square and a rectangle cut out.
PlanarDomain TwoIslands(double edgeLength)
{
  return MakePlanarDomain({ Builtin("disk", edgeLength).loops[0],
    { { 0.3, -0.1 }, { 0.5, -0.1 }, { 0.5, 0.1 }, { 0.3, 0.1 } },
    { { -0.5, -0.1 }, { -0.3, -0.1 }, { -0.3, 0.15 }, { -0.5, 0.15 } } });
}

TEST(RenormalizedEnergy, ConvergesToExactValuesOnTheDisk)
{
  const double optimum = std::pow(3.0 / 11.0, 0.125);
  EXPECT_NEAR(ExactEnergyOnDisk(OnCircle(4, 0.6, 0.3, 1, 0.0)), 2.0498, 1e-4);
  EXPECT_NEAR(ExactEnergyOnDisk(OnCircle(4, optimum, 0.3, 1, 0.0)), -7.2962, 1e-4);
  const std::vector<Configuration> cases = { OnCircle(4, 0.6, 0.3, 1, 0.0),
    OnCircle(4, optimum, 0.3, 1, 0.0),
    { { { 0.31, 0.42 }, 2, 0.0 }, { { -0.52, 0.18 }, 1, 0.0 }, { { -0.11, -0.61 }, 1, 0.0 },
      { { 0.47, -0.33 }, 1, 0.0 }, { { 0.08, 0.05 }, -1, 0.0 } },
    { { { 0.2, -0.4 }, 4, 0.0 } } };
  for (const Configuration& configuration : cases)
  {
    std::vector<double> sizes;
    std::vector<double> errors;
    for (const double size : { 0.1, 0.05, 0.025, 0.0125 })
    {
      const TriangleMesh mesh = DrillMesh(Builtin("disk", size), {}, size);
      const PointPotential potential = PointPotentialOn(mesh, {}, 4);
      sizes.push_back(size);
      errors.push_back(
        std::abs(Evaluate(potential, configuration).energy - ExactEnergyOnDisk(configuration)));
    }
    EXPECT_LT(errors.back(), 1e-3);
    EXPECT_GE(ConvergenceRate(sizes, errors), 1.5);
  }
}

const std::vector<Configuration> WithBoundary = { { OnTheCircle(0.3, 1), { { 0.1, 0.5 }, 1, 0.0 },
                                                    { { -0.5, -0.1 }, 1, 0.0 },
                                                    { { 0.3, -0.5 }, 1, 0.0 } },
  { OnTheCircle(0.3, 1), OnTheCircle(1.6, -1), OnTheCircle(2.5, 1), OnTheCircle(4.4, 2),
    { { 0.1, 0.5 }, 2, 0.0 }, { { -0.4, -0.2 }, -1, 0.0 } },
  { OnTheCircle(0.3, 1), OnTheCircle(2.2, 1), OnTheCircle(3.6, 1), OnTheCircle(5.3, 1) },
  { OnTheCircle(0.3, 4) }, { OnTheCircle(0.3, -2), { { 0.1, -0.2 }, 6, 0.0 } } };

/// Evaluates W and the coefficient of the logarithm on a polygon of a disk.
RenormalizedEnergyValue OnPolygon(const OnPolygonOfDisk& at, double size)
{
  const TriangleMesh mesh = DrillMesh(InsertBoundarySingularities(at.domain, at.given), {}, size);
  const auto potential = std::make_shared<const PotentialSolver>(ShareTopology(mesh));
  const PlanarTopology& topology = potential->GetTopology();
  const PlacedConfiguration placed = PlaceConfiguration(topology, at.given, {});
  return Evaluate(
    { potential, AlignWithBoundary(topology, placed.corners, TotalQuarters(placed.interior)) },
    placed.interior);
}

TEST(RenormalizedEnergy, ConvergesAtSecondOrderForSingularitiesOnTheBoundary)
{
  for (std::size_t c = 0; c < WithBoundary.size(); ++c)
  {
    SCOPED_TRACE(c);
    double coefficient = 0.0;
    for (const Singularity& singularity : WithBoundary[c])
    {
      const double square = singularity.quarterIndex * singularity.quarterIndex;
      coefficient += singularity.position.norm() < 0.999 ? Pi * square : 2.0 * Pi * square;
    }
    std::vector<double> sizes;
    std::vector<double> errors;
    for (const int count : { 80, 160, 320 })
    {
      // At vertices, in the middle of sides and anywhere along them, on polygons turned by some
      // angle.
      const double size = 2.0 * Pi / count;
      std::vector<double> of;
      for (const Place place : { Place::Vertex, Place::Middle, Place::Anywhere })
      {
        for (const double angle : { 0.0, 4.7 })
        {
          const OnPolygonOfDisk at = PutOnPolygon(count, angle, WithBoundary[c], place);
          const RenormalizedEnergyValue value = OnPolygon(at, size);
          EXPECT_NEAR(value.logarithmCoefficient, coefficient, 1e-12 * coefficient);
          of.push_back(value.energy - ExactEnergyOnDisk(at.exact));
        }
      }
      sizes.push_back(size);
      errors.push_back(Eigen::Map<Eigen::VectorXd>(of.data(), static_cast<Eigen::Index>(of.size()))
                         .lpNorm<Eigen::Infinity>());
    }
    EXPECT_LT(errors.back(), 2e-3);
    EXPECT_GE(ConvergenceRate(sizes, errors), 1.8);
  }
}

TEST(RenormalizedEnergy, AgreesWithThetaFunctionsOnRings)
{
  const ExactRing ring;
  EXPECT_NEAR(ring.Energy({}), 16.0 * Pi * std::log(1.0 / ring.inner), 1e-12);
  const std::vector<Configuration> cases = { { { { 0.75, 0.05 }, 1, 0.0 },
                                               { { -0.1, 0.65 }, -1, 0.0 } },
    { { { 0.0, 0.8 }, 2, 0.0 }, { { 0.55, 0.1 }, -1, 0.0 }, { { -0.5, -0.2 }, -1, 0.0 } },
    { { { -0.6, 0.4 }, 3, 0.0 }, { { 0.1, -0.55 }, -2, 0.0 }, { { 0.7, 0.3 }, 1, 0.0 },
      { { -0.8, -0.3 }, -2, 0.0 } } };
  const std::vector<double> sizes = { 0.1, 0.05, 0.025 };
  std::vector<double> errors(sizes.size(), 0.0);
  for (std::size_t c = 0; c < cases.size(); ++c)
  {
    double squares = 4.0; // for the energy of the circles alone
    for (const Singularity& singularity : cases[c])
    {
      squares += singularity.quarterIndex * singularity.quarterIndex;
    }
    for (std::size_t i = 0; i < sizes.size(); ++i)
    {
      SCOPED_TRACE(std::to_string(c) + ", " + std::to_string(sizes[i]));
      const double square = sizes[i] * sizes[i];
      const TriangleMesh mesh = DrillMesh(Builtin("ring", sizes[i]), {}, sizes[i]);
      const RenormalizedEnergyValue value = Evaluate(PointPotentialOn(mesh, {}, 0), cases[c]);
      const double tolerance = 6.0 * squares * square;
      EXPECT_NEAR(value.energy, ring.Energy(cases[c]), tolerance);
      EXPECT_NEAR(value.singleValuedEnergy, ring.SingleValuedEnergy(cases[c]), tolerance);
      EXPECT_NEAR(
        std::remainder(value.holonomyDefect.at(0) - ring.Defect(cases[c]), 2.0 * Pi), 0.0, square);
      errors[i] += std::abs(value.energy - ring.Energy(cases[c]));
    }
  }
  EXPECT_GE(ConvergenceRate(sizes, errors), 1.8);
}

struct GradientCase
{
  const char* name;
  PlanarDomain domain;
  Configuration configuration;
  std::vector<CornerChoice> corners;
};

TEST(RenormalizedEnergy, GradientIsTheDerivative)
{
  const std::vector<GradientCase> cases = { { "disk", Builtin("disk", 0.1),
                                              OnCircle(4, 0.6, 0.3, 1, 0.0), {} },
    { "l-shape", Builtin("l-shape"), { { { 0.3, 0.3 }, 1, 0.0 }, { { 0.2, 0.2 }, -1, 0.0 } }, {} },
    { "l-shape with a chosen corner", Builtin("l-shape"), { { { 0.3, 0.3 }, 1, 0.0 } },
      { { { 1.0, 0.5 }, 0 } } },
    { "ring", Builtin("ring", 0.1), { { { 0.75, 0.05 }, 1, 0.0 }, { { -0.1, 0.65 }, -1, 0.0 } },
      {} },
    { "two islands", TwoIslands(0.1), OnCircle(4, 0.8, 0.3, 1, 0.0), {} } };
  for (const GradientCase& test : cases)
  {
    SCOPED_TRACE(test.name);
    const TriangleMesh mesh = DrillMesh(test.domain, {}, 0.1);
    const PointPotential potential =
      PointPotentialOn(mesh, test.corners, TotalQuarters(test.configuration));
    const RenormalizedEnergyValue value = Evaluate(potential, test.configuration);
    const double step = 1e-5;
    for (std::size_t j = 0; j < test.configuration.size(); ++j)
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        Configuration moved = test.configuration;
        moved[j].position[axis] += step;
        const RenormalizedEnergyValue above = Evaluate(potential, moved);
        moved[j].position[axis] -= 2.0 * step;
        const RenormalizedEnergyValue below = Evaluate(potential, moved);
        const auto column = static_cast<Eigen::Index>(j);
        const double tolerance = 1e-7 * (1.0 + value.gradient.norm());
        EXPECT_NEAR(
          (above.energy - below.energy) / (2.0 * step), value.gradient(axis, column), tolerance);
        EXPECT_NEAR((above.singleValuedEnergy - below.singleValuedEnergy) / (2.0 * step),
          value.singleValuedGradient(axis, column), tolerance);
        for (std::size_t k = 0; k < value.holonomyDefect.size(); ++k)
        {
          EXPECT_NEAR((above.holonomyDefect[k] - below.holonomyDefect[k]) / (2.0 * step),
            value.defectGradient[k](axis, column), tolerance);
        }
      }
    }
  }
}

TEST(RenormalizedEnergy, EnergyOfADefectIsBetterThanItsLowerBound)
{
  // The exact energy is ½ δ² 2π / log(1 / a) in a ring of inner radius a. With long triangles
  // around a small polygon, P1 functions alone are not accurate enough.
  const double inner = 0.02;
  const PlanarDomain ring =
    MakePlanarDomain({ RegularPolygon(256, 1.0), RegularPolygon(24, inner) });
  const Configuration pair = { { { 0.75, 0.05 }, 1, 0.0 }, { { -0.1, 0.65 }, -1, 0.0 } };
  const PointPotential potential = PointPotentialOn(DrillMesh(ring, {}, 0.2), {}, 0);
  const PointPotential::Solution solution = potential.Solve(pair);
  const RenormalizedEnergyValue value = EvaluateRenormalizedEnergy(potential, solution);
  const double offset = solution.offsets[0];
  ASSERT_GT(std::abs(offset), 0.5);
  // Outside of it, a regular polygon acts like a circle whose radius is its capacity, Γ(1/n) /
  // (2^(1 + 2/n) π^½ Γ(½ + 1/n)) times a side. The outer polygon equals the unit circle within
  // 1e-4.
  const double part = 1.0 / 24.0;
  const double radius = inner * 2.0 * std::sin(Pi * part) * std::tgamma(part) /
    (std::pow(2.0, 1.0 + 2.0 * part) * std::sqrt(Pi) * std::tgamma(0.5 + part));
  const double exact = Pi * offset * offset / std::log(1.0 / radius);
  const double ofMean = value.energy - value.singleValuedEnergy;
  const double ofVertices = 0.5 * offset * solution.periods[0];
  EXPECT_LT(ofVertices, 0.995 * exact);
  EXPECT_LT(std::abs(ofMean - exact), 0.2 * (exact - ofVertices));
}

TEST(RenormalizedEnergy, IsTheLimitOfTheEnergyWithHoles)
{
  // The disk, and a ring with a holonomy defect, whose harmonic field is part of both energies.
  struct Case
  {
    PlanarDomain domain;
    Configuration configuration;
  };
  const double size = 0.03;
  const std::vector<Case> cases = { { Builtin("disk", size), OnCircle(4, 0.6, 0.3, 1, 0.0) },
    { Builtin("ring", size), { { { 0.75, 0.05 }, 1, 0.0 }, { { -0.1, 0.65 }, -1, 0.0 } } } };
  for (const Case& test : cases)
  {
    const TriangleMesh mesh = DrillMesh(test.domain, {}, size);
    const PointPotential potential = PointPotentialOn(mesh, {}, TotalQuarters(test.configuration));
    const RenormalizedEnergyValue value = Evaluate(potential, test.configuration);
    std::vector<double> differences;
    for (const double radius : { 0.08, 0.04, 0.02 })
    {
      Configuration holes = test.configuration;
      for (Singularity& hole : holes)
      {
        hole.radius = radius;
      }
      DrillOptions options;
      options.meshSize = size;
      options.minimumHoleEdges = 64;
      const TriangleMesh drilled = DrillHoles(test.domain, holes, options);
      const PerforatedEnergy bounds = ComputePerforatedEnergy(ShareTopology(drilled));
      const double energy = 0.5 * (bounds.alignedLower + bounds.alignedUpper);
      differences.push_back(
        std::abs(energy - value.logarithmCoefficient * std::log(1.0 / radius) - value.energy));
    }
    EXPECT_LT(differences[1], 0.5 * differences[0]);
    EXPECT_LT(differences[2], 0.15); // energies are about 50
  }
}

TEST(RenormalizedEnergy, CornerEnergyGrowsWithItsCoefficient)
{
  // A wedge of angle α carrying k: the energy ½ ∫ |∇φ|² of the discrete field grows by
  // 16 e(α, k) log 2 when the triangles at the corner are halved.
  for (const double angle : { 0.3 * Pi, 0.5 * Pi, 0.8 * Pi, 1.2 * Pi, 1.5 * Pi, 1.8 * Pi })
  {
    for (const int index : { -2, -1, 0, 1, 2 })
    {
      SCOPED_TRACE(std::to_string(angle / Pi) + " pi, k = " + std::to_string(index));
      // A sector with the corner at its centre; its other corners are right angles with k = 1.
      Loop sector = { { 0.0, 0.0 } };
      const int steps = static_cast<int>(std::ceil(angle / 0.05));
      for (int i = 0; i <= steps; ++i)
      {
        sector.emplace_back(std::cos(angle * i / steps), std::sin(angle * i / steps));
      }
      const PlanarDomain domain = MakePlanarDomain({ sector });
      const int interior = 4 - 2 - index;
      const std::vector<CornerChoice> corners = { { { 0.0, 0.0 }, index } };
      const double middle = 0.5 * angle;
      const Configuration inside = { { 0.6 * Point(std::cos(middle), std::sin(middle)), interior,
        interior == 0 ? 0.05 : 0.1 } };
      DrillOptions options;
      options.meshSize = 0.08;
      options.minimumHoleEdges = 16;
      TriangleMesh mesh = DrillHoles(domain, inside, options);
      std::vector<double> energies;
      for (int level = 0; level < 4; ++level)
      {
        energies.push_back(SolveUnitNorm(ProblemOn(mesh, corners)).energy);
        mesh = Refine(mesh);
      }
      // Refine also halves the edges of the arc, whose vertices are corners that turn by a small
      // angle; they contribute to the slope.
      double coefficient = 16.0 * CornerEnergy(angle, index);
      const double turn = angle / steps;
      coefficient += (steps - 1) * 16.0 * CornerEnergy(Pi - turn, 0);
      // The angle at the ends of the arc differs from a right angle.
      coefficient += 2.0 * 16.0 * CornerEnergy(0.5 * (Pi - turn), 1);
      const double slope = (energies[3] - energies[2]) / std::log(2.0);
      EXPECT_NEAR(slope, coefficient, 0.02 * coefficient + 0.06);
    }
  }
}

TEST(RenormalizedEnergy, OnlyCornersWithAJumpHaveALogarithm)
{
  const auto corners =
    [](const PlanarDomain& domain, const std::vector<CornerChoice>& choices, int quarters)
  {
    const TriangleMesh mesh = DrillMesh(domain, {}, 0.1);
    return PointPotentialOn(mesh, choices, quarters).GetBoundaryLogs();
  };
  EXPECT_TRUE(corners(Builtin("l-shape"), {}, 0).empty());
  const std::vector<LogSource> chosen = corners(Builtin("l-shape"), { { { 0.5, 0.5 }, 0 } }, -1);
  ASSERT_EQ(chosen.size(), 1u);
  EXPECT_NEAR(chosen[0].angle, 1.5 * Pi, 1e-12);
  EXPECT_NEAR(0.5 * chosen[0].angle * chosen[0].strength * chosen[0].strength,
    16.0 * CornerEnergy(1.5 * Pi, 0), 1e-12);
  // Between a straight side and a curve the jump of the polygon is that of the curve.
  for (const LogSource& corner : corners(Builtin("quarter-disk", 0.05), {}, 1))
  {
    EXPECT_LT(std::abs(corner.strength), 1e-12);
  }
}

TEST(RenormalizedEnergy, VanishesOnAQuarterDiskWithIndexTwoAtItsCentre)
{
  // With index 2 at the centre, Φ = c log r with c = −(4 π/2 − 4 π)/(π/2) = 4. Φ is zero on the arc
  // and below zero by O(h²) on its chords.
  for (const double size : { 0.1, 0.03 })
  {
    const TriangleMesh mesh = DrillMesh(Builtin("quarter-disk", size), {}, size);
    const PointPotential potential = PointPotentialOn(mesh, { { { 0.0, 0.0 }, 2 } }, 0);
    const RenormalizedEnergyValue value = Evaluate(potential, {});
    EXPECT_NEAR(value.logarithmCoefficient, 4.0 * Pi, 1e-9);
    EXPECT_NEAR(value.energy, 0.0, size * size);
  }
}

TEST(RenormalizedEnergy, EnergyOfHolesGrowsWithPiTimesTheSquareOfTheIndex)
{
  for (const int index : { -2, -1, 1, 2, 3 })
  {
    Configuration configuration = { { { 0.1, 0.05 }, index, 0.0 },
      { { -0.6, -0.3 }, 4 - index, 0.15 } };
    std::vector<double> energies;
    for (const double radius : { 0.008, 0.004 })
    {
      configuration[0].radius = radius;
      DrillOptions options;
      options.meshSize = 0.05;
      options.minimumHoleEdges = 64;
      const TriangleMesh mesh = DrillHoles(Builtin("disk", 0.05), configuration, options);
      energies.push_back(SolveUnitNorm(ProblemOn(mesh)).energy);
    }
    const double slope = (energies[1] - energies[0]) / std::log(2.0);
    EXPECT_NEAR(slope, Pi * index * index, 0.02 * Pi * index * index);
  }
}

TEST(RenormalizedEnergy, PairThatClosesUpHasMoreEnergyThanNone)
{
  // On a square, W = 0 without singularities. W of a pair at distance d is 2π log d + O(1), and so is
  // its energy at a core radius larger than d.
  const PlanarDomain square = Builtin("square", 0.02);
  const double radius = 0.05;
  const auto topology = ShareTopology(DrillHoles(square, {}, DrillOptions{}));
  const PointPotential potential(
    std::make_shared<const PotentialSolver>(topology), AlignWithBoundary(*topology, {}, 0));
  double previous = 0.0;
  for (const double distance : { 0.02, 0.01, 0.005 })
  {
    const Configuration pair = { { { 0.5, 0.5 }, 1, 0.0 }, { { 0.5 + distance, 0.5 }, -1, 0.0 } };
    const RenormalizedEnergyValue value =
      EvaluateRenormalizedEnergy(potential, potential.Solve(pair));
    const double atRadius = value.energy - value.logarithmCoefficient * std::log(radius);
    const double overlap = CoreOverlapEnergy(pair, radius);
    EXPECT_NEAR(overlap, 2.0 * Pi * std::log(radius / (0.5 * distance)), 1e-12);
    EXPECT_LT(atRadius, 0.0);
    EXPECT_GT(atRadius + overlap, 0.0);
    EXPECT_TRUE(previous == 0.0 || std::abs(atRadius + overlap - previous) < 0.05);
    previous = atRadius + overlap;
  }
  const Configuration apart = { { { 0.2, 0.5 }, 1, 0.0 }, { { 0.8, 0.5 }, -1, 0.0 } };
  EXPECT_EQ(CoreOverlapEnergy(apart, radius), 0.0);
}
}
}
