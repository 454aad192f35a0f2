#include "HField.h"

#include "Alignment.h"
#include "BoundarySingularities.h"
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
/// Five singularities of mixed sign off the centre, of sum 4.
const Configuration Five = { { { 0.31, 0.42 }, 2, 0.0 }, { { -0.52, 0.18 }, 1, 0.0 },
  { { -0.11, -0.61 }, 1, 0.0 }, { { 0.47, -0.33 }, 1, 0.0 }, { { 0.08, 0.05 }, -1, 0.0 } };

/// docs/method.md §9, with area mean 0: log|z − b| has the mean (|b|² − 1) / 2, the images have 0.
double ExactH(const Configuration& configuration, const Point& point)
{
  const Complex z(point.x(), point.y());
  double value = 0.0;
  for (const Singularity& singularity : configuration)
  {
    const Complex b(singularity.position.x(), singularity.position.y());
    value += 0.25 * singularity.quarterIndex *
      (std::log(std::abs(z - b)) + std::log(std::abs(1.0 - std::conj(b) * z)) -
        0.5 * (std::norm(b) - 1.0));
  }
  return value;
}

Complex ExactCross(const Configuration& configuration, const Point& point)
{
  return DiskImage{}.CrossAt(configuration, point);
}

TriangleMesh Mesh(const PlanarDomain& domain, double meshSize, const Configuration& holes = {})
{
  DrillOptions options;
  options.meshSize = meshSize;
  return DrillHoles(domain, holes, options);
}

/// Slopes on a triangle of 4H, from its vertices, and of the phase of u, from its midpoints.
std::array<Point, 2> Slopes(const TriangleMesh& mesh, const HField& field, std::size_t t)
{
  const auto& v = mesh.triangles[t];
  const auto& e = field.field.topology->edges.ofTriangle[t];
  const Point a =
    mesh.points[static_cast<std::size_t>(v[1])] - mesh.points[static_cast<std::size_t>(v[0])];
  const Point b =
    mesh.points[static_cast<std::size_t>(v[2])] - mesh.points[static_cast<std::size_t>(v[0])];
  // Of the linear function that grows by da along a and by db along b.
  const auto slope = [&](double da, double db)
  { return Point(Point(da * b.y() - db * a.y(), db * a.x() - da * b.x()) / Cross(a, b)); };
  const auto step = [&](int from, int to)
  { return std::arg(field.field.u[to] / field.field.u[from]); };
  // The midpoints of p0p1, p1p2, p2p0 are b / 2 and −a / 2 apart.
  return { slope(4.0 * (field.h[v[1]] - field.h[v[0]]), 4.0 * (field.h[v[2]] - field.h[v[0]])),
    slope(-2.0 * step(e[1], e[2]), 2.0 * step(e[0], e[1])) };
}

TEST(HField, MatchesTheExactSolutionOnTheDiskUpToTheSingularities)
{
  std::vector<double> sizes;
  std::vector<double> errors;
  std::vector<double> awayErrors;
  std::vector<double> crossErrors;
  for (const double size : { 0.08, 0.056, 0.04, 0.028 })
  {
    const TriangleMesh mesh = Mesh(Builtin("disk", size), size);
    const HField field = SolveHField(ShareTopology(mesh), Five);
    double error = 0.0;
    double awayError = 0.0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      const Point& point = mesh.points[v];
      const double here = std::abs(field.h[static_cast<Eigen::Index>(v)] - ExactH(Five, point));
      error = std::max(error, here);
      const bool away = std::all_of(Five.begin(), Five.end(),
        [&](const Singularity& s) { return (s.position - point).norm() > 0.1; });
      awayError = std::max(awayError, away ? here : 0.0);
    }
    double crossError = 0.0;
    for (int e = 0; e < field.field.topology->edges.Count(); ++e)
    {
      // The boundary's edges have the directions of the polygon, not of the circle.
      if (field.field.topology->edges.triangles[static_cast<std::size_t>(e)][1] >= 0)
      {
        crossError = std::max(crossError,
          std::abs(
            field.field.u[e] - ExactCross(Five, Midpoint(mesh, field.field.topology->edges, e))));
      }
    }
    sizes.push_back(size);
    errors.push_back(error);
    awayErrors.push_back(awayError);
    crossErrors.push_back(crossError);
    EXPECT_EQ(field.field.unwantedSingularities, 0);
    EXPECT_LT(field.field.residual, 1e-9);
    if (size == 0.04)
    {
      EXPECT_LT(error, 1e-3);
    }
  }
  EXPECT_GE(ConvergenceRate(sizes, errors), 1.8);
  EXPECT_GE(ConvergenceRate(sizes, awayErrors), 1.8);
  EXPECT_GE(ConvergenceRate(sizes, crossErrors), 1.8);
}

TEST(HField, OnARingIsThatOfThetaFunctions)
{
  const auto at = [](double radius, double angle, int quarter) {
    return Singularity{ radius * Point(std::cos(angle), std::sin(angle)), quarter, 0.0 };
  };
  const ExactRing ring;
  for (const Configuration& configuration : { Configuration{ at(0.8, 0.3, 1), at(0.55, 0.3, -1) },
         Configuration{ at(0.8, 2.0, 2), at(0.6, 1.5, -1), at(0.6, 2.5, -1) } })
  {
    ASSERT_NEAR(ring.Defect(configuration), 0.0, 1e-12);
    std::vector<double> sizes;
    std::vector<double> errors;
    std::vector<double> crossErrors;
    for (const double size : { 0.08, 0.04, 0.02 })
    {
      const TriangleMesh mesh = Mesh(Builtin("ring", size), size);
      const HField field = SolveHField(ShareTopology(mesh), configuration);
      Eigen::ArrayXd off = field.h;
      for (Eigen::Index v = 0; v < off.size(); ++v)
      {
        off[v] -= 0.25 * ring.PhiAt(configuration, mesh.points[static_cast<std::size_t>(v)]);
      }
      const EdgeNumbering& edges = field.field.topology->edges;
      double crossError = 0.0;
      int count = 0;
      for (int e = 0; e < edges.Count(); ++e)
      {
        const Point middle = Midpoint(mesh, edges, e);
        const bool away = std::all_of(configuration.begin(), configuration.end(),
          [&](const Singularity& s) { return (s.position - middle).norm() > 0.1; });
        if (away && edges.triangles[static_cast<std::size_t>(e)][1] >= 0)
        {
          crossError += std::norm(field.field.u[e] - ring.CrossAt(configuration, middle));
          ++count;
        }
      }
      sizes.push_back(size);
      errors.push_back(std::sqrt((off - off.mean()).square().mean()));
      crossErrors.push_back(std::sqrt(crossError / count));
    }
    EXPECT_LT(errors.back(), 2e-4);
    EXPECT_LT(crossErrors.back(), 1e-3);
    EXPECT_GE(ConvergenceRate(sizes, errors), 1.8);
    EXPECT_GE(ConvergenceRate(sizes, crossErrors), 1.8);
  }
}

TEST(HField, OfSingularitiesOnACircleIsExactToSecondOrderUpToThem)
{
  // k (log|z − b| + log|1 − b̄z|) of docs/method.md §11.2 is 2k log|z − b| at a point b of the circle,
  // which has the flux k through the circle like the others, and the jump 2πk of the phase at b.
  const Configuration mixed = { OnTheCircle(0.3, 1), OnTheCircle(1.6, -1), OnTheCircle(2.5, 1),
    OnTheCircle(4.4, 2), { { 0.1, 0.5 }, 2, 0.0 }, { { -0.4, -0.2 }, -1, 0.0 } };
  for (const Place place : { Place::Vertex, Place::Middle, Place::Anywhere })
  {
    SCOPED_TRACE(static_cast<int>(place));
    std::vector<double> sizes;
    std::vector<double> errors;
    std::vector<double> crossErrors;
    for (const int count : { 80, 160, 320 })
    {
      const double size = 2.0 * Pi / count;
      const OnPolygonOfDisk at = PutOnPolygon(count, 0.0, mixed, place);
      const TriangleMesh mesh = Mesh(InsertBoundarySingularities(at.domain, at.given), size);
      const HField field = SolveHField(ShareTopology(mesh), at.given);
      const auto away = [&](const Point& point, double distance)
      {
        return std::all_of(at.exact.begin(), at.exact.end(),
          [&](const Singularity& s) { return (s.position - point).norm() > distance; });
      };
      double error = 0.0;
      for (std::size_t v = 0; v < mesh.points.size(); ++v)
      {
        // At a singularity H is infinite, and the field has a mean.
        if (away(mesh.points[v], 0.1 * size))
        {
          error = std::max(error,
            std::abs(field.h[static_cast<Eigen::Index>(v)] - ExactH(at.exact, mesh.points[v])));
        }
      }
      const EdgeNumbering& edges = field.field.topology->edges;
      double crossError = 0.0;
      for (int e = 0; e < edges.Count(); ++e)
      {
        const Point middle = Midpoint(mesh, edges, e);
        if (edges.triangles[static_cast<std::size_t>(e)][1] >= 0 && away(middle, 0.1))
        {
          crossError =
            std::max(crossError, std::abs(field.field.u[e] - ExactCross(at.exact, middle)));
        }
      }
      sizes.push_back(size);
      errors.push_back(error);
      crossErrors.push_back(crossError);
      EXPECT_EQ(field.field.unwantedSingularities, 0);
      EXPECT_LT(field.field.residual, 1e-9);
    }
    EXPECT_LT(errors.back(), 1e-3);
    EXPECT_GE(ConvergenceRate(sizes, errors), 1.8);
    EXPECT_GE(ConvergenceRate(sizes, crossErrors), 1.8);
  }
}

TEST(HField, OnADrilledMeshTheCrossIsThatOfTheUnitNormField)
{
  const std::vector<TriangleMesh> meshes = { Mesh(Builtin("disk", 0.05), 0.05,
                                               OnCircle(4, 0.6, 0.3, 1, 0.1)),
    Mesh(
      Builtin("ring", 0.05), 0.05, { { { 0.75, 0.05 }, 1, 0.05 }, { { -0.1, 0.65 }, -1, 0.05 } }),
    Mesh(Builtin("l-shape"), 0.04, { { { 0.2, 0.3 }, 1, 0.05 }, { { 0.7, 0.2 }, -1, 0.05 } }) };
  for (const TriangleMesh& mesh : meshes)
  {
    const HField field = SolveHField(ShareTopology(mesh), {});
    const PotentialProblem problem = ProblemOn(mesh);
    const UnitNormField unit = SolveUnitNorm(problem);
    EXPECT_LT((field.field.u - unit.u).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_EQ(field.field.energy, unit.energy);
    EXPECT_EQ(field.field.holonomyDefect, unit.holonomyDefect);
    // H is one constant on every hole.
    for (const BoundaryLoop& loop : problem.Topology().loops)
    {
      if (loop.kind == BoundaryKind::Hole)
      {
        double least = 1e300;
        double most = -1e300;
        for (int vertex : WalkedVertices(mesh, loop))
        {
          least = std::min(least, field.h[vertex]);
          most = std::max(most, field.h[vertex]);
        }
        EXPECT_LT(most - least, 1e-9);
      }
    }
  }
}

TEST(HField, ConjugateEnergiesAgree)
{
  // docs/method.md §2: the phase energy from CR values against the potential energy from P1 values.
  const TriangleMesh mesh = Mesh(Builtin("disk", 0.05), 0.05, OnCircle(4, 0.6, 0.3, 1, 0.1));
  const HField field = SolveHField(ShareTopology(mesh), {});
  double phaseEnergy = 0.0;
  double potentialEnergy = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto [potential, phase] = Slopes(mesh, field, t);
    potentialEnergy += 0.5 * TriangleArea(mesh, t) * potential.squaredNorm();
    phaseEnergy += 0.5 * TriangleArea(mesh, t) * phase.squaredNorm();
  }
  EXPECT_NEAR(phaseEnergy, potentialEnergy, 1e-10 * potentialEnergy);
  EXPECT_NEAR(field.field.energy, potentialEnergy, 1e-10 * potentialEnergy);
}

TEST(HField, OnARingItIsTheLogarithm)
{
  const TriangleMesh mesh = Mesh(Builtin("ring", 0.03), 0.03);
  const HField field = SolveHField(ShareTopology(mesh), {});
  // ∫ log r over the ring by its area.
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

TEST(HField, CornersCarryIndicesLikePointsInside)
{
  // The quarter of a disk around a corner of angle α with k has H = c log r, c = −(turning − kπ/2)/α.
  const PlanarDomain square = Builtin("square");
  const TriangleMesh mesh = Mesh(square, 0.03);
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
  const auto [least, most] = std::minmax_element(remainders.begin(), remainders.end());
  EXPECT_GT(remainders.size(), 5u);
  EXPECT_LT(*most - *least, 0.1);
}

TEST(HField, IsolinesMeetStraightSidesAtRightAnglesAndCrossesAreRotatedGradients)
{
  const Configuration pair = { { { 0.25, 0.3 }, 1, 0.0 }, { { 0.7, 0.22 }, -1, 0.0 } };
  for (const double size : { 0.03, 0.015 })
  {
    const TriangleMesh mesh = Mesh(Builtin("l-shape"), size);
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
      const auto [potential, phase] = Slopes(mesh, field, t);
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
        const Point slope = Slopes(mesh, field, triangle)[0];
        largestFlux = std::max(largestFlux, std::abs(Cross(along, slope)));
      }
    }
    // Both vanish with the size; the slopes themselves are up to 10 there.
    EXPECT_LT(largestTurn, 40.0 * size);
    EXPECT_LT(largestFlux, 60.0 * size);
  }
}

TEST(HField, TurningScalingAndRenumberingChangeNothing)
{
  Random random(7);
  const TriangleMesh mesh = Mesh(Builtin("disk", 0.08), 0.08);
  const HField plain = SolveHField(ShareTopology(mesh), Five);
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    const Similarity move{ random.Uniform(-Pi, Pi), scale, scale * Point(1.0, -2.0) };
    const HField field = SolveHField(ShareTopology(move(mesh)), move(Five));
    EXPECT_LT((field.h - plain.h).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_EQ(field.field.unwantedSingularities, 0);
    // W changes by the logarithm of the scale.
    EXPECT_NEAR(
      field.renormalizedEnergy, plain.renormalizedEnergy + Pi * 8.0 * std::log(scale), 1e-6);
  }
  const HField renumbered = SolveHField(ShareTopology(Renumber(mesh, random)), Five);
  EXPECT_NEAR(renumbered.renormalizedEnergy, plain.renormalizedEnergy, 1e-8);
}

TEST(HField, IsTheSameAtAllExtents)
{
  struct Case
  {
    const char* name;
    Configuration configuration;
    /// Of W, by the logarithm of the scale.
    double shift;
  };
  // 5 pairs on a ring: one point has ten logarithms.
  Configuration pairs = OnCircle(5, 0.6, 0.3, 1, 0.0);
  for (const Singularity& singularity : OnCircle(5, 0.8, 0.5, -1, 0.0))
  {
    pairs.push_back(singularity);
  }
  const std::vector<Case> cases = { { "disk", Five, Pi * 8.0 }, { "ring", pairs, Pi * 10.0 } };
  for (const auto& [name, configuration, shift] : cases)
  {
    const TriangleMesh mesh = Mesh(Builtin(name, 0.1), 0.1);
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

TEST(HField, IsFiniteWhereASingularityIsAVertexOrAMidpoint)
{
  const TriangleMesh mesh = Mesh(Builtin("disk", 0.1), 0.1);
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

TEST(HField, RefusesWhatHasNoSolution)
{
  const TriangleMesh mesh = Mesh(Builtin("disk", 0.1), 0.1);
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
  const TriangleMesh drilled = Mesh(Builtin("disk", 0.1), 0.1, holes);
  EXPECT_NO_THROW(SolveHField(ShareTopology(drilled), holes));
  EXPECT_TRUE(Refuses(
    [&] {
      SolveHField(ShareTopology(drilled), { { { 0.0, 0.0 }, 1, 0.0 } });
    },
    { "has holes", "(0, 0)" }));
}
}
}
