// Convergence of H and its cross field to exact solutions.

#include "BoundarySingularities.h"
#include "DrillHoles.h"
#include "ExactFields.h"
#include "HField.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns the exact H of docs/method.md §9 with area mean 0: log|z − b| has the mean (|b|² − 1) /
/// 2, and the images have mean 0.
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

TEST(HField, ConvergesAtSecondOrderOnTheDisk)
{
  std::vector<double> sizes;
  std::vector<double> errors;
  std::vector<double> awayErrors;
  std::vector<double> crossErrors;
  for (const double size : { 0.08, 0.056, 0.04, 0.028 })
  {
    const TriangleMesh mesh = DrillMesh(Builtin("disk", size), {}, size);
    const HField field = SolveHField(ShareTopology(mesh), FiveInDisk);
    double error = 0.0;
    double awayError = 0.0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      const Point& point = mesh.points[v];
      const double here =
        std::abs(field.h[static_cast<Eigen::Index>(v)] - ExactH(FiveInDisk, point));
      error = std::max(error, here);
      const bool away = std::all_of(FiveInDisk.begin(), FiveInDisk.end(),
        [&](const Singularity& s) { return (s.position - point).norm() > 0.1; });
      awayError = std::max(awayError, away ? here : 0.0);
    }
    double crossError = 0.0;
    for (int e = 0; e < field.field.topology->edges.Count(); ++e)
    {
      // Boundary edges have the direction of the polygon, not of the circle.
      if (field.field.topology->edges.triangles[static_cast<std::size_t>(e)][1] >= 0)
      {
        crossError = std::max(crossError,
          std::abs(field.field.u[e] -
            ExactCross(FiveInDisk, Midpoint(mesh, field.field.topology->edges, e))));
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

TEST(HField, ConvergesAtSecondOrderOnARing)
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
      const TriangleMesh mesh = DrillMesh(Builtin("ring", size), {}, size);
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

TEST(HField, ConvergesAtSecondOrderForSingularitiesOnTheBoundary)
{
  // At a point b of the circle, k (log|z − b| + log|1 − b̄z|) of docs/method.md §11.2 is
  // 2k log|z − b|, which has the flux k through the circle like the others, and the phase jumps by
  // 2πk at b.
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
      const TriangleMesh mesh =
        DrillMesh(InsertBoundarySingularities(at.domain, at.given), {}, size);
      const HField field = SolveHField(ShareTopology(mesh), at.given);
      const auto away = [&](const Point& point, double distance)
      {
        return std::all_of(at.exact.begin(), at.exact.end(),
          [&](const Singularity& s) { return (s.position - point).norm() > distance; });
      };
      double error = 0.0;
      for (std::size_t v = 0; v < mesh.points.size(); ++v)
      {
        // At a singularity H is infinite, and the computed value is a mean.
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
    // The maximum is next to a singularity, where it depends on the triangles there.
    EXPECT_GE(ConvergenceRate(sizes, errors), 1.7);
    EXPECT_GE(ConvergenceRate(sizes, crossErrors), 1.8);
  }
}
}
}
