#include "DrillHoles.h"
#include "ExactFields.h"
#include "FieldSingularities.h"
#include "PerforatedSolve.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace crossfield::test
{
namespace
{
using Place = FieldSingularity::Place;

/// Disk of a given mesh size.
struct Disk
{
  explicit Disk(double meshSize)
    : size(meshSize)
  {
    DrillOptions options;
    options.meshSize = meshSize;
    this->mesh = DrillHoles(Builtin("disk", meshSize), {}, options);
    this->edges = NumberEdges(this->mesh);
  }

  ComplexVector Sample(const Configuration& singularities) const
  {
    ComplexVector u(this->edges.Count());
    for (int e = 0; e < this->edges.Count(); ++e)
    {
      u[e] = DiskImage{}.CrossAt(singularities, Midpoint(this->mesh, this->edges, e));
    }
    return u;
  }

  /// Sets the values on the boundary to aligned ones.
  ComplexVector Aligned(ComplexVector u) const
  {
    for (std::size_t i = 0; i < this->mesh.boundary.size(); ++i)
    {
      const auto& [from, to] = this->mesh.boundary[i].vertices;
      u[this->edges.ofBoundary[i]] =
        AlignedRepresentation(this->mesh.points[to] - this->mesh.points[from]);
    }
    return u;
  }

  double size;
  TriangleMesh mesh;
  EdgeNumbering edges;
};

/// Returns singularities of quarter indices ±1 and ±2 and sum 4 at positions far from each other
/// and from the boundary.
Configuration RandomSingularities(Random& random, double distance)
{
  Configuration singularities;
  do
  {
    singularities.assign(static_cast<std::size_t>(random.Integer(2, 8)), {});
    for (Singularity& singularity : singularities)
    {
      singularity.quarterIndex = (random.Integer(0, 1) == 0 ? 1 : -1) * random.Integer(1, 2);
    }
  } while (TotalQuarters(singularities) != 4);
  for (std::size_t i = 0; i < singularities.size(); ++i)
  {
    const auto near = [&]
    {
      const Point& here = singularities[i].position;
      return here.norm() > 1.0 - distance ||
        std::any_of(singularities.begin(), singularities.begin() + static_cast<std::ptrdiff_t>(i),
          [&](const Singularity& other) { return (here - other.position).norm() < distance; });
    };
    do
    {
      singularities[i].position = Point(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
    } while (near());
  }
  return singularities;
}

TEST(FieldSingularities, FindsEachSingularityOfExactFieldsOnce)
{
  const std::vector<Disk> disks = { Disk(0.06), Disk(0.05), Disk(0.04), Disk(0.03) };
  Random random(7);
  double largestError = 0.0;
  for (int trial = 0; trial < 200; ++trial)
  {
    const Disk& disk = disks[static_cast<std::size_t>(trial) % disks.size()];
    // The distances are at least five triangles: fine enough to separate the singularities.
    const Configuration exact = RandomSingularities(random, 5.0 * disk.size);
    const auto found = FindFieldSingularities({ ShareTopology(disk.mesh), disk.Sample(exact) });
    ASSERT_EQ(found.size(), exact.size()) << "trial " << trial;
    for (const FieldSingularity& singularity : found)
    {
      EXPECT_EQ(singularity.place, Place::Inside);
      EXPECT_EQ(singularity.id, -1);
      EXPECT_EQ(singularity.radius, 0.0);
    }
    for (const Singularity& expected : exact)
    {
      const auto nearest = std::min_element(found.begin(), found.end(),
        [&expected](const FieldSingularity& a, const FieldSingularity& b) {
          return (a.position - expected.position).norm() < (b.position - expected.position).norm();
        });
      EXPECT_EQ(nearest->quarterIndex, expected.quarterIndex) << "trial " << trial;
      const double error = (nearest->position - expected.position).norm();
      EXPECT_LT(error, disk.size) << "trial " << trial << ", index " << expected.quarterIndex;
      largestError = std::max(largestError, error / disk.size);
    }
  }
  RecordProperty("LargestErrorInMeshSizes", std::to_string(largestError));
}

TEST(FieldSingularities, PositionIsTheZeroOfALocallyLinearField)
{
  const Disk disk(0.1);
  Random random(11);
  for (int trial = 0; trial < 50; ++trial)
  {
    const Complex zero = 0.5 * random.Square();
    for (const bool positive : { true, false })
    {
      ComplexVector u(disk.edges.Count());
      for (int e = 0; e < disk.edges.Count(); ++e)
      {
        const Point place = Midpoint(disk.mesh, disk.edges, e);
        const Complex z = Complex(place.x(), place.y()) - zero;
        u[e] = Complex(1.3, 0.4) * (positive ? z : std::conj(z));
      }
      int inside = 0;
      for (const FieldSingularity& found :
        FindFieldSingularities({ ShareTopology(disk.mesh), disk.Aligned(u) }))
      {
        if (found.place == Place::Inside && found.position.norm() < 0.8)
        {
          ++inside;
          EXPECT_EQ(found.quarterIndex, positive ? 1 : -1);
          EXPECT_LT((found.position - Point(zero.real(), zero.imag())).norm(), 1e-12);
        }
      }
      EXPECT_EQ(inside, 1);
    }
  }
}

TEST(FieldSingularities, OppositeNeighboursCancel)
{
  // Reversing the value on one edge puts +1 and −1 into neighbouring triangles and vertices.
  const Disk disk(0.1);
  const Configuration four = OnCircle(4, 0.6, 0.2, 1, 0.0);
  const ComplexVector plain = disk.Sample(four);
  for (int e = 0; e < disk.edges.Count(); ++e)
  {
    if (Midpoint(disk.mesh, disk.edges, e).norm() < 0.3)
    {
      ComplexVector disturbed = plain;
      disturbed[e] = -disturbed[e];
      const auto found = FindFieldSingularities({ ShareTopology(disk.mesh), disturbed });
      ASSERT_EQ(found.size(), 4u) << e;
      EXPECT_TRUE(std::all_of(found.begin(), found.end(),
        [](const FieldSingularity& one) { return one.quarterIndex == 1; }));
    }
  }
}

TEST(FieldSingularities, BoundaryHasTheIndicesThatTheInteriorLacks)
{
  // The constant cross on a disk: four quarters between the crosses inside and those on the circle.
  const Disk disk(0.1);
  const auto found = FindFieldSingularities(
    { ShareTopology(disk.mesh), disk.Aligned(ComplexVector::Ones(disk.edges.Count())) });
  int sum = 0;
  for (const FieldSingularity& singularity : found)
  {
    EXPECT_TRUE(singularity.place == Place::OuterLoop ? singularity.id == 0
                                                      : singularity.place == Place::Inside);
    EXPECT_GT(singularity.position.norm(), 0.9);
    sum += singularity.quarterIndex;
  }
  EXPECT_EQ(sum, 4);
}

TEST(FieldSingularities, ReportsSingularitiesThatMovedIntoTheBoundary)
{
  const Disk disk(0.1);
  Configuration singularities = OnCircle(3, 0.4, 0.8, 1, 0.0);
  singularities.push_back({ { 1.0, 0.0 }, 1, 0.0 });
  const auto found =
    FindFieldSingularities({ ShareTopology(disk.mesh), disk.Aligned(disk.Sample(singularities)) });
  int atOne = 0;
  for (const FieldSingularity& singularity : found)
  {
    if ((singularity.position - Point(1.0, 0.0)).norm() < 0.15)
    {
      atOne += singularity.quarterIndex;
      EXPECT_EQ(singularity.place, Place::OuterLoop);
      EXPECT_EQ(singularity.id, 0);
      ASSERT_GE(singularity.vertex, 0);
      EXPECT_EQ(
        disk.mesh.points[static_cast<std::size_t>(singularity.vertex)], singularity.position);
    }
    else
    {
      EXPECT_EQ(singularity.quarterIndex, 1);
      EXPECT_EQ(singularity.place, Place::Inside);
      EXPECT_EQ(singularity.vertex, -1);
    }
  }
  EXPECT_EQ(atOne, 1);
}

TEST(FieldSingularities, ReportsCornersOnRequest)
{
  const TriangleMesh mesh = DrillHoles(Builtin("l-shape"), {});
  const EdgeNumbering edges = NumberEdges(mesh);
  const ComplexVector constant = ComplexVector::Ones(edges.Count());
  EXPECT_TRUE(FindFieldSingularities({ ShareTopology(mesh), constant }).empty());
  FieldSingularityOptions options;
  options.corners = true;
  const auto found = FindFieldSingularities({ ShareTopology(mesh), constant }, options);
  ASSERT_EQ(found.size(), 6u);
  EXPECT_EQ(std::count_if(found.begin(), found.end(),
              [](const FieldSingularity& one) { return one.quarterIndex == 1; }),
    5);
  EXPECT_EQ(std::count_if(found.begin(), found.end(),
              [](const FieldSingularity& one) { return one.quarterIndex == -1; }),
    1);
  for (const FieldSingularity& corner : found)
  {
    EXPECT_EQ(corner.place, Place::OuterLoop);
    ASSERT_GE(corner.vertex, 0);
    EXPECT_EQ(mesh.points[static_cast<std::size_t>(corner.vertex)], corner.position);
  }
}

TEST(FieldSingularities, ReportsHolesOnRequest)
{
  const Configuration four = OnCircle(4, 0.6, 0.25 * Pi, 1, 0.1);
  const TriangleMesh mesh = DrillHoles(Builtin("disk"), four);
  const SolvedField field = SolvePerforated(ShareTopology(mesh));
  EXPECT_TRUE(FindFieldSingularities({ ShareTopology(mesh), field.u }).empty());
  FieldSingularityOptions options;
  options.holes = true;
  const auto found = FindFieldSingularities({ ShareTopology(mesh), field.u }, options);
  ASSERT_EQ(found.size(), 4u);
  for (const FieldSingularity& hole : found)
  {
    EXPECT_EQ(hole.place, Place::Hole);
    EXPECT_EQ(hole.quarterIndex, 1);
    EXPECT_NEAR(hole.radius, 0.1, 1e-12);
    const Singularity& row = four[static_cast<std::size_t>(hole.id)];
    EXPECT_LT((hole.position - row.position).norm(), 1e-12);
  }
}

TEST(FieldSingularities, AreIndependentOfTheMeshNumbering)
{
  const Disk disk(0.1);
  Random random(3);
  const Configuration exact = RandomSingularities(random, 0.3);
  const auto expected = FindFieldSingularities({ ShareTopology(disk.mesh), disk.Sample(exact) });
  Disk shuffled = disk;
  shuffled.mesh = Renumber(disk.mesh, random);
  shuffled.edges = NumberEdges(shuffled.mesh);
  const auto found =
    FindFieldSingularities({ ShareTopology(shuffled.mesh), shuffled.Sample(exact) });
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(found[i].quarterIndex, expected[i].quarterIndex);
    EXPECT_LT((found[i].position - expected[i].position).norm(), 1e-12);
  }
}

TEST(FieldSingularities, RejectsInvalidFields)
{
  const Disk disk(0.3);
  EXPECT_TRUE(Refuses(
    [&] {
      FindFieldSingularities({ ShareTopology(disk.mesh), ComplexVector::Ones(2) });
    },
    { "2 values", "edges" }));
  ComplexVector u = ComplexVector::Ones(disk.edges.Count());
  u[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(Refuses(
    [&] {
      FindFieldSingularities({ ShareTopology(disk.mesh), u });
    },
    { "not finite" }));
}
}
}
