#include "HField.h"

#include "DrillHoles.h"
#include "PerforatedProblem.h"
#include "Support.h"
#include "UnitNormField.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Five singularities of mixed sign off the centre, of sum 4.
const Configuration Five = { { { 0.31, 0.42 }, 2, 0.0 }, { { -0.52, 0.18 }, 1, 0.0 },
  { { -0.11, -0.61 }, 1, 0.0 }, { { 0.47, -0.33 }, 1, 0.0 }, { { 0.08, 0.05 }, -1, 0.0 } };

/// METHOD §9, with area mean 0: log|z − b| has the mean (|b|² − 1) / 2, the images have 0.
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
  const Complex z(point.x(), point.y());
  Complex u = 1.0;
  for (const Singularity& singularity : configuration)
  {
    const Complex b(singularity.position.x(), singularity.position.y());
    const Complex turn = (z - b) * (1.0 - std::conj(b) * z);
    u *= std::pow(turn / std::abs(turn), singularity.quarterIndex);
  }
  // Aligned at z = 1, where the tangent is vertical.
  Complex atOne = 1.0;
  for (const Singularity& singularity : configuration)
  {
    const Complex b(singularity.position.x(), singularity.position.y());
    const Complex turn = (1.0 - b) * (1.0 - std::conj(b));
    atOne *= std::pow(turn / std::abs(turn), singularity.quarterIndex);
  }
  return u / atOne;
}

TriangleMesh Mesh(const PlanarDomain& domain, double meshSize, const Configuration& holes = {})
{
  DrillOptions options;
  options.meshSize = meshSize;
  return DrillHoles(domain, holes, options);
}

TEST(HField, MatchesTheExactSolutionOnTheDiskUpToTheSingularities)
{
  std::vector<double> sizes;
  std::vector<double> errors;
  std::vector<double> crossErrors;
  for (const double size : { 0.08, 0.056, 0.04, 0.028 })
  {
    const TriangleMesh mesh = Mesh(Builtin("disk", size), size);
    const HField field = SolveHField(mesh, Five);
    double error = 0.0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      error = std::max(error,
        std::abs(field.h[static_cast<Eigen::Index>(v)] - ExactH(Five, mesh.points[v])));
    }
    double crossError = 0.0;
    for (int e = 0; e < field.field.edges.Count(); ++e)
    {
      crossError = std::max(crossError,
        std::abs(field.field.u[e] - ExactCross(Five, Midpoint(mesh, field.field.edges, e))));
    }
    sizes.push_back(size);
    errors.push_back(error);
    crossErrors.push_back(crossError);
    EXPECT_EQ(field.field.unwantedSingularities, 0);
    EXPECT_LT(field.field.residual, 1e-9);
    std::printf("%g %g %g W %.8f\n", size, error, crossError, field.renormalizedEnergy);
    if (size == 0.04)
    {
      EXPECT_LT(error, 1e-3);
    }
  }
  EXPECT_GE(ConvergenceRate(sizes, errors), 1.8);
  EXPECT_GE(ConvergenceRate(sizes, crossErrors), 1.8);
}
}
}
