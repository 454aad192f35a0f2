#include "DrillHoles.h"
#include "ExactFields.h"
#include "FieldIndices.h"
#include "Support.h"

#include <cmath>
#include <numeric>

namespace crossfield::test
{
namespace
{
ComplexVector Sample(
  const TriangleMesh& mesh, const EdgeNumbering& edges, const Configuration& singularities)
{
  ComplexVector u(edges.Count());
  for (int e = 0; e < edges.Count(); ++e)
  {
    u[e] = DiskImage{}.CrossAt(singularities, Midpoint(mesh, edges, e));
  }
  return u;
}

int Sum(const std::vector<int>& indices)
{
  return std::accumulate(indices.begin(), indices.end(), 0);
}

/// Sets the values on outer and inner boundaries to aligned ones.
void Align(const TriangleMesh& mesh, const EdgeNumbering& edges, ComplexVector& u)
{
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    const auto& [from, to] = mesh.boundary[i].vertices;
    if (mesh.boundary[i].kind != BoundaryKind::Hole)
    {
      u[edges.ofBoundary[i]] = AlignedRepresentation(mesh.points[to] - mesh.points[from]);
    }
  }
}

std::vector<Configuration> Configurations()
{
  Configuration mixed = OnCircle(6, 0.7, 0.2, 1, 0.0);
  mixed.push_back({ { 0.21, 0.03 }, -1, 0.0 });
  mixed.push_back({ { -0.2, 0.01 }, -1, 0.0 });
  Configuration doubled = OnCircle(3, 0.5, 0.3, 2, 0.0);
  doubled.push_back({ { 0.013, 0.02 }, -2, 0.0 });
  return { OnCircle(4, 0.6, 0.25 * Pi, 1, 0.0), mixed, doubled };
}

TEST(FieldIndices, AreLocatedAtTheSingularitiesOfExactFields)
{
  constexpr double MeshSize = 0.05;
  DrillOptions options;
  options.meshSize = MeshSize;
  const TriangleMesh mesh = DrillHoles(Builtin("disk", MeshSize), {}, options);
  const EdgeNumbering edges = NumberEdges(mesh);
  for (const Configuration& singularities : Configurations())
  {
    const FieldIndices indices =
      ReadIndices(PlanarTopology(mesh), Sample(mesh, edges, singularities));
    EXPECT_EQ(Sum(indices.ofTriangle) + Sum(indices.ofVertex), 4);
    std::vector<int> found(singularities.size(), 0);
    const auto assign = [&](const Point& place, int index)
    {
      for (std::size_t j = 0; index != 0 && j < singularities.size(); ++j)
      {
        if ((place - singularities[j].position).norm() < 1.5 * MeshSize)
        {
          found[j] += index;
          return;
        }
      }
      EXPECT_EQ(index, 0) << "far from all singularities, at " << place.transpose();
    };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      const auto& [a, b, c] = mesh.triangles[t];
      assign((mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0, indices.ofTriangle[t]);
    }
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      assign(mesh.points[v], indices.ofVertex[v]);
    }
    for (std::size_t j = 0; j < singularities.size(); ++j)
    {
      EXPECT_EQ(found[j], singularities[j].quarterIndex) << j;
    }
  }
}

TEST(FieldIndices, CornersHaveTheirQuarterIndices)
{
  // The constant cross aligned with a square: each corner turns by 90° and has k = 1; the reflex
  // corner of an L-shape has k = −1.
  for (const char* name : { "square", "l-shape" })
  {
    const TriangleMesh mesh = DrillHoles(Builtin(name), {});
    const EdgeNumbering edges = NumberEdges(mesh);
    const FieldIndices indices =
      ReadIndices(PlanarTopology(mesh), ComplexVector::Ones(edges.Count()));
    EXPECT_EQ(Sum(indices.ofTriangle), 0);
    EXPECT_EQ(Sum(indices.ofVertex), 4);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      const Point& p = mesh.points[v];
      const auto at = [&](double x, double y) { return p == Point(x, y); };
      const bool isLShape = std::string(name) == "l-shape";
      const bool convex =
        at(0, 0) || at(1, 0) || at(0, 1) || (isLShape ? at(1, 0.5) || at(0.5, 1) : at(1, 1));
      const bool reentrant = isLShape && at(0.5, 0.5);
      EXPECT_EQ(indices.ofVertex[v], (convex ? 1 : 0) - (reentrant ? 1 : 0)) << p.transpose();
    }
  }
}

TEST(FieldIndices, SumIsTopologicalEvenForRandomFields)
{
  Random random(50);
  for (const char* name : { "disk", "ring", "square", "quarter-disk", "l-shape" })
  {
    SCOPED_TRACE(name);
    const PlanarDomain domain = Builtin(name);
    const Point place = std::string(name) == "ring" ? Point(0.6, 0.3) : Point(0.2, 0.25);
    const TriangleMesh mesh =
      DrillHoles(domain, { { place, 1, 0.03 }, { place + Point(0.1, 0.0), 0, 0.02 } });
    const EdgeNumbering edges = NumberEdges(mesh);
    const std::vector<BoundaryLoop> loops = FindBoundaryLoops(mesh);
    for (int trial = 0; trial < 10; ++trial)
    {
      ComplexVector u(edges.Count());
      for (Complex& value : u)
      {
        value = random.UnitComplex() * std::exp(random.Uniform(-5.0, 5.0));
      }
      Align(mesh, edges, u);
      const FieldIndices indices = ReadIndices(PlanarTopology(mesh), u);
      int sum = Sum(indices.ofTriangle) + Sum(indices.ofVertex);
      for (const BoundaryLoop& loop : loops)
      {
        sum += loop.kind == BoundaryKind::Hole ? ReadHole(loop, edges, u).degree : 0;
      }
      EXPECT_EQ(sum, 4 * domain.EulerCharacteristic());
    }
  }
}

TEST(FieldIndices, AreIndependentOfNormAndFrame)
{
  const TriangleMesh mesh = DrillHoles(Builtin("disk"), {});
  const EdgeNumbering edges = NumberEdges(mesh);
  ComplexVector u = Sample(mesh, edges, Configurations()[1]);
  const FieldIndices plain = ReadIndices(PlanarTopology(mesh), u);
  Random random(51);
  for (Complex& value : u)
  {
    value *= random.Uniform(0.01, 10.0);
  }
  // Rotating everything by an angle rotates the representation by four times the angle.
  const Similarity turn{ 0.7, 2.0, Point(1.0, 1.0) };
  const FieldIndices turned =
    ReadIndices(PlanarTopology(turn(mesh)), u * std::polar(1.0, 4.0 * turn.angle));
  EXPECT_EQ(turned.ofTriangle, plain.ofTriangle);
  EXPECT_EQ(turned.ofVertex, plain.ofVertex);
}

TEST(ReadHole, MeasuresDegreeNormAndStep)
{
  DrillOptions options;
  options.minimumHoleEdges = 40;
  const TriangleMesh mesh = DrillHoles(Builtin("disk"), { { { 0.2, -0.1 }, 1, 0.2 } }, options);
  const EdgeNumbering edges = NumberEdges(mesh);
  const BoundaryLoop hole = FindBoundaryLoops(mesh).back();
  const auto m = static_cast<int>(hole.edges.size());
  for (int degree = -15; degree <= 15; ++degree)
  {
    ComplexVector u = ComplexVector::Ones(edges.Count());
    for (int j = 0; j < m; ++j)
    {
      const double norm = j == 3 ? 0.5 : (j == 5 ? 2.0 : 1.0);
      u[edges.ofBoundary[hole.edges[j]]] = std::polar(norm, 2.0 * Pi * degree * j / m);
    }
    const HoleReading reading = ReadHole(hole, edges, u);
    EXPECT_EQ(reading.degree, degree);
    EXPECT_NEAR(reading.largestStep, 2.0 * Pi * std::abs(degree) / m, 1e-12);
    EXPECT_DOUBLE_EQ(reading.minimumNorm, 0.5);
    EXPECT_DOUBLE_EQ(reading.maximumNorm, 2.0);
    if (4 * std::abs(degree) != m) // otherwise the step is π/2 up to rounding
    {
      EXPECT_EQ(reading.Reliable(), 4 * std::abs(degree) < m);
    }
  }
  // A field that nearly vanishes on one edge is unreliable.
  ComplexVector u = ComplexVector::Ones(edges.Count());
  u[edges.ofBoundary[hole.edges[0]]] = 1e-3;
  EXPECT_FALSE(ReadHole(hole, edges, u).Reliable());
  u.setZero();
  EXPECT_FALSE(ReadHole(hole, edges, u).Reliable());
}
}
}
