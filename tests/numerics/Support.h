#pragma once

// What the tests of the numerics share: random inputs from a fixed seed, similarities, measures of
// a mesh, and the check that a refusal says why.

#include "Alignment.h"
#include "CrouzeixRaviart.h"
#include "DrillHoles.h"
#include "Error.h"
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
/// Numbers that are the same on every platform, which those of std::uniform_*_distribution are not.
class Random
{
public:
  explicit Random(std::uint32_t seed)
    : Engine(seed)
  {
  }
  double Uniform(double lower, double upper);
  /// An integer in [lower, upper].
  int Integer(int lower, int upper);
  /// Both parts in [−1, 1].
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

/// Rotation about the origin, then scaling, then translation.
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

/// Regular polygon, counter-clockwise.
Loop RegularPolygon(int count, double radius = 1.0, const Point& centre = Point::Zero());

/// A smooth star-shaped domain of diameter about two: radius 1 + a few low harmonics.
PlanarDomain RandomSmoothDomain(Random& random, int pointCount = 128);

/// Holes with radii between 0.01 and 0.08 and quarter indices −2 .. 2, one radius apart at least.
Configuration RandomHoles(Random& random, const PlanarDomain& domain, int count);

/// The domain bounded by polygons of a built-in domain.
PlanarDomain Builtin(const std::string& name, double edgeLength = 0.0);

/// What DrillHoles makes of them with all other options as they are.
TriangleMesh DrillMesh(const PlanarDomain& domain, const Configuration& configuration,
  double meshSize, DrillMode mode = DrillMode::Perforate);

double DistanceToLoop(const Point& point, const Loop& loop);

/// `count` singularities on a circle around the origin, the first one at an angle.
Configuration OnCircle(
  int count, double circleRadius, double firstAngle, int quarterIndex, double holeRadius);

/// Those of both, in order.
Configuration Join(Configuration first, const Configuration& second);

/// The square of side 2 without the unit square at (1, 1).
PlanarDomain LShape();
/// The unit disk, and with an island of radius 0.4, of edges of about this length.
PlanarDomain DiskOfEdges(double edge);
PlanarDomain RingOfEdges(double edge);

/// On the unit circle.
Singularity OnTheCircle(double angle, int quarterIndex);

/// Where on the polygon of a curve a singularity of the curve lies.
enum class Place
{
  Vertex,
  Middle, ///< Of a side.
  Anywhere
};

/// A regular polygon of the unit disk, and singularities of which those outside of the radius 0.999 lie
/// on the circle, and where a user of the polygon puts them.
struct OnPolygonOfDisk
{
  PlanarDomain domain;
  Configuration exact;
  Configuration given;
};

/// The polygon has a vertex at `angle`. Those on the circle go to the nearest place of this kind.
OnPolygonOfDisk PutOnPolygon(
  int count, double angle, const Configuration& configuration, Place place);

double MeshArea(const TriangleMesh& mesh);
double TriangleArea(const TriangleMesh& mesh, std::size_t triangle);
/// Smallest angle of one triangle, in degrees.
double SmallestAngle(const TriangleMesh& mesh, std::size_t triangle);
double SmallestAngle(const TriangleMesh& mesh);
Point Midpoint(const TriangleMesh& mesh, const EdgeNumbering& edges, int edge);
bool Identical(const TriangleMesh& a, const TriangleMesh& b);

/// Vertices of a boundary loop in the order in which the loop is walked.
std::vector<int> WalkedVertices(const TriangleMesh& mesh, const BoundaryLoop& loop);
Loop WalkedPoints(const TriangleMesh& mesh, const BoundaryLoop& loop);

/// Every triangle in four; the marks of boundary edges go to both halves.
TriangleMesh Refine(const TriangleMesh& mesh);

/// The same mesh with its points, triangles and boundary edges in a random order, and every
/// triangle starting at a random corner.
TriangleMesh Renumber(const TriangleMesh& mesh, Random& random);

/// Slope of the regression line of log(error) over log(size).
double ConvergenceRate(const std::vector<double>& sizes, const std::vector<double>& errors);

/// Succeeds when `call` throws crossfield::Error of this kind, with all the parts in its sentence.
testing::AssertionResult Refuses(const std::function<void()>& call,
  const std::vector<std::string>& parts, Error::Kind kind = Error::Kind::BadInput);

/// The mesh with its factor, and its boundary aligned.
PotentialProblem ProblemOn(const TriangleMesh& mesh, const std::vector<CornerChoice>& corners = {});

/// The same for singularities that are points, of a given sum of quarter indices.
PointPotential PointPotentialOn(
  const TriangleMesh& mesh, const std::vector<CornerChoice>& corners, int pointQuarters);
}
