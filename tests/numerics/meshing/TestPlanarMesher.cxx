#include "Index.h"
#include "MakePlanarDomain.h"
#include "PlanarMesher.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace crossfield::test
{
namespace
{
/// Angle bound in degrees: CGAL's criterion sin² < 1/8 means angles below 20.705°.
constexpr double GuaranteedAngle = 20.7;
/// Maximum ratio of an edge to the target size at the centroid of its triangle.
constexpr double LongestRatio = 1.6;

std::vector<BoundaryEdge> PlainMarks(const PlanarDomain& domain)
{
  std::vector<BoundaryEdge> marks;
  for (std::size_t l = 0; l < domain.loops.size(); ++l)
  {
    marks.push_back(
      { { 0, 0 }, l == 0 ? BoundaryKind::Outer : BoundaryKind::Inner, static_cast<int>(l), 0 });
  }
  return marks;
}

SizeField SizeOver(const PlanarDomain& domain, double size, const std::vector<SizeSource>& sources)
{
  Eigen::AlignedBox2d box;
  for (const Point& point : domain.loops[0])
  {
    box.extend(point);
  }
  return SizeField(sources, size, 0.25, box);
}

TriangleMesh Triangulate(const PlanarDomain& domain, const SizeField& size)
{
  return TriangulateDomain(domain, PlainMarks(domain), size);
}

struct NamedDomain
{
  std::string name;
  PlanarDomain domain;
};

/// Returns domains without corners sharper than 60°, for which the angle bound is guaranteed.
std::vector<NamedDomain> BluntDomains()
{
  std::vector<NamedDomain> domains;
  for (const char* name :
    { "disk", "ring", "ellipse", "quarter-disk", "square", "rectangle", "l-shape" })
  {
    domains.push_back({ name, Builtin(name) });
  }
  domains.push_back({ "square with islands",
    MakePlanarDomain({ RegularPolygon(4), RegularPolygon(3, 0.2, Point(0.3, 0.2)),
      RegularPolygon(6, 0.1, Point(-0.4, 0.1)), RegularPolygon(24, 0.15, Point(0.0, -0.5)) }) });
  return domains;
}

TEST(PlanarMesher, NestingDepthsCountTheEnclosingLoops)
{
  const std::vector<Loop> loops = { RegularPolygon(5, 1.0), RegularPolygon(9, 8.0),
    RegularPolygon(4, 2.0), RegularPolygon(6, 4.0), RegularPolygon(3, 0.5, Point(5.0, 0.0)),
    RegularPolygon(7, 1.0, Point(20.0, 0.0)) };
  const std::vector<int> depths = { 3, 0, 2, 1, 1, 0 };
  EXPECT_EQ(NestingDepths(loops), depths);
  const std::vector<Loop> reversed(loops.rbegin(), loops.rend());
  EXPECT_EQ(NestingDepths(reversed), std::vector<int>(depths.rbegin(), depths.rend()));
}

TEST(PlanarMesher, CoversTheDomainExactly)
{
  for (const auto& [name, domain] : BluntDomains())
  {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = Triangulate(domain, SizeOver(domain, domain.Diagonal() / 30.0, {}));
    EXPECT_NEAR(MeshArea(mesh), domain.Area(), 1e-12 * domain.Area());
    EXPECT_EQ(NumberEdges(mesh).EulerCharacteristic(mesh), domain.EulerCharacteristic());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      ASSERT_GT(TriangleArea(mesh, t), 0.0);
    }
  }
}

TEST(PlanarMesher, BoundaryEdgesLieOnTheLoopTheyAreMarkedWith)
{
  for (const auto& [name, domain] : BluntDomains())
  {
    SCOPED_TRACE(name);
    std::vector<BoundaryEdge> marks = PlainMarks(domain);
    for (std::size_t l = 0; l < marks.size(); ++l)
    {
      // Values that can only result from copying.
      marks[l].id = 100 + static_cast<int>(l);
      marks[l].quarterIndex = 7 - static_cast<int>(l);
      marks[l].kind = l % 2 == 0 ? BoundaryKind::Outer : BoundaryKind::Hole;
    }
    const TriangleMesh mesh =
      TriangulateDomain(domain, marks, SizeOver(domain, domain.Diagonal() / 30.0, {}));
    std::vector<double> length(domain.loops.size(), 0.0);
    for (const BoundaryEdge& edge : mesh.boundary)
    {
      const auto l = static_cast<std::size_t>(edge.id - 100);
      ASSERT_LT(l, domain.loops.size());
      EXPECT_EQ(edge.kind, marks[l].kind);
      EXPECT_EQ(edge.quarterIndex, marks[l].quarterIndex);
      const Point& from = mesh.points[edge.vertices[0]];
      const Point& to = mesh.points[edge.vertices[1]];
      length[l] += (to - from).norm();
      for (const Point& point : { from, Point(0.5 * (from + to)), to })
      {
        ASSERT_LT(DistanceToLoop(point, domain.loops[l]), 1e-14 * domain.Diagonal());
      }
    }
    // The edges are on the loop and as long as all of it, so each segment is covered once.
    for (std::size_t l = 0; l < domain.loops.size(); ++l)
    {
      double expected = 0.0;
      for (std::size_t i = 0; i < domain.loops[l].size(); ++i)
      {
        const Point& corner = domain.loops[l][i];
        expected += (domain.loops[l][(i + 1) % domain.loops[l].size()] - corner).norm();
        EXPECT_NE(std::find(mesh.points.begin(), mesh.points.end(), corner), mesh.points.end());
      }
      EXPECT_NEAR(length[l], expected, 1e-12 * expected);
    }
  }
}

TEST(PlanarMesher, RespectsBoundsOfAngleSizeAndCount)
{
  for (const auto& [name, domain] : BluntDomains())
  {
    SCOPED_TRACE(name);
    // Uniform, and graded towards a point of the boundary and one inside the bounding box.
    const double coarse = domain.Diagonal() / 25.0;
    const std::vector<SizeSource> sources = { { domain.loops[0][1], 0.05 * coarse },
      { domain.loops[0][0], 0.3 * coarse } };
    for (const auto& graded : { std::vector<SizeSource>{}, sources })
    {
      const SizeField size = SizeOver(domain, coarse, graded);
      const TriangleMesh mesh = Triangulate(domain, size);
      EXPECT_GE(SmallestAngle(mesh), GuaranteedAngle);
      double ideal = 0.0;
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      {
        const auto& [a, b, c] = mesh.triangles[t];
        const double target = size((mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0);
        for (const double edge : { (mesh.points[a] - mesh.points[b]).norm(),
               (mesh.points[b] - mesh.points[c]).norm(), (mesh.points[c] - mesh.points[a]).norm() })
        {
          ASSERT_LE(edge, LongestRatio * target);
        }
        ideal += TriangleArea(mesh, t) / (0.25 * std::sqrt(3.0) * target * target);
      }
      // `ideal` is the number of equilateral triangles of the target size.
      EXPECT_GE(static_cast<double>(mesh.triangles.size()), 0.8 * ideal);
      EXPECT_LE(static_cast<double>(mesh.triangles.size()), 3.0 * ideal);
    }
  }
}

TEST(PlanarMesher, DomainIsOnTheLeftOfBoundaryEdges)
{
  for (const auto& [name, domain] : BluntDomains())
  {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = Triangulate(domain, SizeOver(domain, domain.Diagonal() / 20.0, {}));
    // Triangles are counter-clockwise, so the one at a boundary edge has the edge in the same
    // direction.
    std::vector<std::array<int, 2>> walked;
    for (const auto& triangle : mesh.triangles)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        walked.push_back({ triangle[i], triangle[(i + 1) % 3] });
      }
    }
    std::sort(walked.begin(), walked.end());
    for (const BoundaryEdge& edge : mesh.boundary)
    {
      EXPECT_TRUE(std::binary_search(walked.begin(), walked.end(), edge.vertices));
    }
  }
}

TEST(PlanarMesher, IsDeterministic)
{
  for (const auto& [name, domain] : BluntDomains())
  {
    const SizeField size =
      SizeOver(domain, domain.Diagonal() / 30.0, { { domain.loops[0][0], 0.002 } });
    EXPECT_TRUE(Identical(Triangulate(domain, size), Triangulate(domain, size))) << name;
  }
}

TEST(PlanarMesher, OnlySharpCornersHaveSmallAngles)
{
  for (const double degrees : { 30.0, 10.0, 3.0 })
  {
    SCOPED_TRACE(degrees);
    const double angle = degrees * Pi / 180.0;
    const PlanarDomain domain =
      MakePlanarDomain({ { { 0.0, 0.0 }, { 1.0, 0.0 }, { std::cos(angle), std::sin(angle) } } });
    const double h = 0.05;
    const TriangleMesh mesh = Triangulate(domain, SizeOver(domain, h, {}));
    EXPECT_NEAR(MeshArea(mesh), domain.Area(), 1e-12 * domain.Area());
    EXPECT_EQ(NumberEdges(mesh).EulerCharacteristic(mesh), 1);
    EXPECT_GE(SmallestAngle(mesh), std::min(degrees, GuaranteedAngle) - 1e-9);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      if (SmallestAngle(mesh, t) < GuaranteedAngle)
      {
        const auto& [a, b, c] = mesh.triangles[t];
        const double distance =
          std::min({ mesh.points[a].norm(), mesh.points[b].norm(), mesh.points[c].norm() });
        EXPECT_LT(distance, h) << SmallestAngle(mesh, t) << " " << distance;
      }
    }
  }
}

TEST(PlanarMesher, ReportsIncreasingProgressAndAborts)
{
  const PlanarDomain domain = Builtin("disk");
  const SizeField size = SizeOver(domain, 0.02, {});
  std::vector<double> fractions;
  const Progress record(
    [&](double fraction)
    {
      fractions.push_back(fraction);
      return true;
    });
  TriangulateDomain(domain, PlainMarks(domain), size, record);
  ASSERT_FALSE(fractions.empty());
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GE(fractions.front(), 0.0);
  EXPECT_EQ(fractions.back(), 1.0);
  const Progress stop([](double) { return false; });
  EXPECT_THROW(TriangulateDomain(domain, PlainMarks(domain), size, stop), Aborted);
}

TEST(PlanarMesher, IsDelaunayAroundTheCoreOfTheLatticeAsWell)
{
  for (const auto& [name, domain] : BluntDomains())
  {
    SCOPED_TRACE(name);
    const double h = domain.Diagonal() / 90.0;
    const TriangleMesh mesh =
      Triangulate(domain, SizeOver(domain, h, { { domain.loops[0][0], 0.1 * h } }));
    EXPECT_NEAR(MeshArea(mesh), domain.Area(), 1e-12 * domain.Area());
    std::map<std::array<int, 2>, double> opposite; // the angle opposite each directed edge
    std::size_t equilateral = 0;
    for (const auto& triangle : mesh.triangles)
    {
      double longest = 0.0;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const Point& apex = mesh.points[Index(triangle[i])];
        const Point from = mesh.points[Index(triangle[(i + 1) % 3])] - apex;
        const Point to = mesh.points[Index(triangle[(i + 2) % 3])] - apex;
        const double angle = std::atan2(Cross(from, to), from.dot(to));
        longest = std::max(longest, std::abs(angle - Pi / 3.0));
        const bool isNew =
          opposite.insert({ { triangle[(i + 1) % 3], triangle[(i + 2) % 3] }, angle }).second;
        ASSERT_TRUE(isNew) << "a directed edge has one triangle";
      }
      equilateral += longest < 1e-9 ? 1 : 0;
    }
    std::size_t border = 0;
    for (const auto& [edge, angle] : opposite)
    {
      const auto other = opposite.find({ edge[1], edge[0] });
      border += other == opposite.end() ? 1 : 0;
      EXPECT_LE(other == opposite.end() ? 0.0 : angle + other->second, Pi + 1e-9);
    }
    EXPECT_EQ(border, mesh.boundary.size());
    EXPECT_GT(2 * equilateral, mesh.triangles.size());
  }
}

TEST(PlanarMesher, OrdersTrianglesAlongACurve)
{
  const double h = 0.02;
  const PlanarDomain domain = Builtin("ring");
  const TriangleMesh mesh = Triangulate(domain, SizeOver(domain, h, {}));
  const auto centroid = [&mesh](std::size_t t) -> Point
  {
    const auto& [a, b, c] = mesh.triangles[t];
    return (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0;
  };
  double way = 0.0;
  int unused = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    way += t > 0 ? (centroid(t) - centroid(t - 1)).norm() : 0.0;
    for (int vertex : mesh.triangles[t])
    {
      EXPECT_LE(vertex, unused) << "points are numbered as triangles use them first";
      unused = std::max(unused, vertex + 1);
    }
  }
  // In random order this would be the mean distance of two points, about 1.
  EXPECT_LT(way / static_cast<double>(mesh.triangles.size()), 1.5 * h);
}

TEST(PlanarMesher, RefusesGapsThatWouldTakeMillionsOfTriangles)
{
  const auto withGap = [](double gap)
  {
    const PlanarDomain domain = MakePlanarDomain({ { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } },
      { { -0.5, -1.0 + gap }, { 0.5, -1.0 + gap }, { 0.5, 0.0 }, { -0.5, 0.0 } } });
    return Triangulate(domain, SizeOver(domain, 0.1, {}));
  };
  // A gap of length 1 takes one row of triangles about as wide as the gap.
  const std::size_t triangles = withGap(1e-4).triangles.size();
  EXPECT_GT(triangles, 10000u);
  EXPECT_LT(triangles, 40000u);
  EXPECT_TRUE(Refuses([&] { withGap(1e-9); }, { "within 1e-09 of itself", "widen the gap" }));
  // Small triangles are accepted if the size field requires them.
  const PlanarDomain strip = MakePlanarDomain({ { { 0, 0 }, { 400, 0 }, { 400, 1 }, { 0, 1 } } });
  EXPECT_GT(Triangulate(strip, SizeOver(strip, 0.05, {})).triangles.size(), 300000u);
}
}
}
