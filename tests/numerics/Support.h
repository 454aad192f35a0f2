#pragma once

// Shared by the tests of the numerics: random inputs from a fixed seed, similarities, domains, and
// the check that an error message gives its reason.

#include "Alignment.h"
#include "CrouzeixRaviart.h"
#include "DrillHoles.h"
#include "Error.h"
#include "MeshMeasures.h"
#include "PlanarDomain.h"
#include "PointPotential.h"
#include "Singularity.h"
#include "TriangleMesh.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace crossfield::test
{
/// Random numbers that are the same on every platform, unlike those of std::uniform_*_distribution.
class Random
{
public:
  explicit Random(std::uint32_t seed)
    : Engine(seed)
  {
  }
  double Uniform(double lower, double upper);
  /// Returns an integer in [lower, upper].
  int Integer(int lower, int upper);
  /// Returns a complex number with both parts in [−1, 1].
  Complex Square();
  Complex UnitComplex();
  template <typename T>
  void Shuffle(std::vector<T>& items)
  {
    for (std::size_t i = items.size(); i > 1; --i)
    {
      std::swap(items[i - 1], items[static_cast<std::size_t>(this->Integer(0, int(i) - 1))]);
    }
  }

private:
  std::mt19937 Engine;
};

/// Rotation about the origin, followed by scaling and translation.
struct Similarity
{
  double angle = 0.0;
  double scale = 1.0;
  Point shift = Point::Zero();

  Point operator()(const Point& point) const;
  Loop operator()(const Loop& loop) const;
  std::vector<Loop> operator()(const std::vector<Loop>& loops) const;
  PlanarDomain operator()(const PlanarDomain& domain) const;
  Configuration operator()(const Configuration& configuration) const;
  TriangleMesh operator()(const TriangleMesh& mesh) const;
};

/// Returns a matrix with entries in [−1, 1].
Eigen::MatrixXd RandomMatrix(Random& random, Eigen::Index rows, Eigen::Index columns);

/// Returns whether any of the sentences has these words.
bool AnyHas(const std::vector<std::string>& sentences, const std::string& words);

/// Returns a regular polygon, counter-clockwise.
Loop RegularPolygon(int count, double radius = 1.0, const Point& centre = Point::Zero());

/// Returns a smooth star-shaped domain of diameter about two: radius 1 plus a few low harmonics.
PlanarDomain RandomSmoothDomain(Random& random, int pointCount = 128);

/// Returns holes with radii between 0.01 and 0.08 and quarter indices −2 .. 2, at least one radius
/// apart.
Configuration RandomHoles(Random& random, const PlanarDomain& domain, int count);

/// Returns the domain bounded by the polygons of a built-in domain.
PlanarDomain Builtin(const std::string& name, double edgeLength = 0.0);

/// Drills holes with default options except mesh size and mode.
TriangleMesh DrillMesh(const PlanarDomain& domain, const Configuration& configuration,
  double meshSize, DrillMode mode = DrillMode::Perforate);

double DistanceToLoop(const Point& point, const Loop& loop);

/// Returns `count` singularities on a circle around the origin, the first one at `firstAngle`.
Configuration OnCircle(
  int count, double circleRadius, double firstAngle, int quarterIndex, double holeRadius);

/// Concatenates two configurations.
Configuration Join(Configuration first, const Configuration& second);

/// Returns the square of side 2 without the unit square at (1, 1).
PlanarDomain LShape();
/// Returns the unit disk with edges of about this length.
PlanarDomain DiskOfEdges(double edge);
PlanarDomain RingOfEdges(double edge);

/// Returns a singularity on the unit circle.
Singularity OnTheCircle(double angle, int quarterIndex);

/// Position of a singularity of a curve on the polygon that approximates the curve.
enum class Place
{
  Vertex,
  Middle, ///< Middle of a side.
  Anywhere
};

/// Regular polygon that approximates the unit disk, with singularities on the circle and on the
/// polygon. Those beyond the radius 0.999 are on the boundary.
struct OnPolygonOfDisk
{
  PlanarDomain domain;
  Configuration exact;
  Configuration given;
};

/// Places the singularities on a polygon with a vertex at `angle`. Those on the circle move to the
/// nearest point of the given kind.
OnPolygonOfDisk PutOnPolygon(
  int count, double angle, const Configuration& configuration, Place place);

/// Returns the slope of the regression line of log(error) over log(size).
double ConvergenceRate(const std::vector<double>& sizes, const std::vector<double>& errors);

/// Succeeds if `call` throws crossfield::Error of this kind with all parts in its message.
testing::AssertionResult Refuses(const std::function<void()>& call,
  const std::vector<std::string>& parts, Error::Kind kind = Error::Kind::BadInput);

/// Returns the sum of the quarter indices that a domain needs inside.
int Required(const PlanarDomain& domain, const std::vector<CornerChoice>& corners = {});

/// Factors a mesh and aligns its boundary.
PotentialProblem ProblemOn(const TriangleMesh& mesh, const std::vector<CornerChoice>& corners = {});

/// Factors a mesh and aligns its boundary for point singularities with a given sum of quarter
/// indices.
PointPotential PointPotentialOn(
  const TriangleMesh& mesh, const std::vector<CornerChoice>& corners, int pointQuarters);
}
