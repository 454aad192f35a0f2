#include "CrossSamples.h"
#include "DrillHoles.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
using Function = std::function<Complex(const Point&)>;

ComplexVector Sample(const TriangleMesh& mesh, const EdgeNumbering& edges, const Function& f)
{
  ComplexVector u(edges.Count());
  for (int e = 0; e < edges.Count(); ++e)
  {
    u[e] = f(Midpoint(mesh, edges, e));
  }
  return u;
}

Point Centroid(const TriangleMesh& mesh, std::size_t t)
{
  const auto& [a, b, c] = mesh.triangles[t];
  return (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0;
}

/// Returns the largest errors of the samples at triangles and at vertices.
std::pair<double, double> Errors(const TriangleMesh& mesh, const Function& f)
{
  const EdgeNumbering edges = NumberEdges(mesh);
  const CrossSamples samples = SampleField(mesh, edges, Sample(mesh, edges, f));
  std::pair<double, double> errors(0.0, 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    errors.first = std::max(errors.first, std::abs(samples.atTriangles[t] - f(Centroid(mesh, t))));
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    errors.second = std::max(errors.second, std::abs(samples.atVertices[v] - f(mesh.points[v])));
  }
  return errors;
}

TEST(CrossSamples, LinearFieldsAreExactEverywhere)
{
  const TriangleMesh mesh = DrillHoles(Builtin("ring"), { { { 0.7, 0.0 }, 1, 0.05 } });
  const auto [atTriangles, atVertices] = Errors(mesh,
    [](const Point& x) { return Complex(1.0 - 2.0 * x.x() + x.y(), 0.5 + x.x() + 3.0 * x.y()); });
  EXPECT_LT(atTriangles, 1e-13);
  EXPECT_LT(atVertices, 1e-13);
}

TEST(CrossSamples, ConvergesAtSecondOrderUpToTheBoundary)
{
  DrillOptions options;
  options.meshSize = 0.2;
  TriangleMesh mesh = DrillHoles(Builtin("l-shape"), {}, options);
  std::vector<double> sizes;
  std::vector<double> atTriangles;
  std::vector<double> atVertices;
  for (int level = 0; level < 4; ++level)
  {
    const auto errors = Errors(
      mesh, [](const Point& x) { return std::exp(Complex(x.x() - x.y(), 2.0 * x.x() * x.y())); });
    sizes.push_back(std::pow(0.5, level));
    atTriangles.push_back(errors.first);
    atVertices.push_back(errors.second);
    mesh = Refine(mesh);
  }
  EXPECT_GE(ConvergenceRate(sizes, atTriangles), 1.8);
  EXPECT_GE(ConvergenceRate(sizes, atVertices), 1.8);
}

TEST(CrossSamples, VerticesWithoutTrianglesAreZero)
{
  TriangleMesh mesh = DrillHoles(Builtin("square"), {});
  mesh.points.emplace_back(5.0, 5.0);
  const EdgeNumbering edges = NumberEdges(mesh);
  const CrossSamples samples = SampleField(mesh, edges, ComplexVector::Ones(edges.Count()));
  EXPECT_EQ(samples.atVertices[samples.atVertices.size() - 1], Complex(0.0, 0.0));
  EXPECT_NEAR(std::abs(samples.atVertices[0] - 1.0), 0.0, 1e-14);
}

TEST(CrossSamples, BranchIsTheFourthRoot)
{
  Random random(80);
  for (int i = 0; i < 200; ++i)
  {
    const Complex u = random.Uniform(0.01, 10.0) * random.UnitComplex();
    const Point branch = CrossBranch(u);
    EXPECT_NEAR(branch.norm(), 1.0, 1e-15);
    EXPECT_LT(std::abs(AlignedRepresentation(branch) - u / std::abs(u)), 1e-14);
  }
}
}
}
