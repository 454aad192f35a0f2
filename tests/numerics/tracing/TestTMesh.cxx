#include "TMeshFaces.h"

#include "DomainQueries.h"
#include "FlatMapSolve.h"
#include "MakePlanarDomain.h"
#include "MeshForPoints.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
TMesh LinesOf(const PlanarDomain& domain, const Configuration& configuration, double meshSize,
  const FlatMapOptions& options = {})
{
  const FlatMap map = SolveFlatMap(
    ShareTopology(MeshOnPoints(domain, configuration, meshSize)), configuration, options);
  return MakeTMesh(map, TraceLines(map));
}

int Count(std::size_t size)
{
  return static_cast<int>(size);
}

double MapArea(const TMesh& mesh)
{
  double area = 0.0;
  for (const TFace& face : mesh.faces)
  {
    area += mesh.SideLength(face, 0) * mesh.SideLength(face, 1);
  }
  return area;
}

/// The counts of docs/method.md §13.3, and opposite sides.
void ExpectSound(const TMesh& mesh, int euler)
{
  int singularities = 0;
  int corners = 0;
  for (const TNode& node : mesh.nodes)
  {
    singularities += node.kind == NodeKind::Singularity ? 1 : 0;
    corners += node.kind == NodeKind::Corner ? 1 : 0;
  }
  EXPECT_EQ(Count(mesh.faces.size()), mesh.lineCount - mesh.headOn - singularities + euler);
  EXPECT_EQ(Count(mesh.arcs.size()),
    2 * mesh.lineCount + corners + mesh.extraLines - 3 * mesh.headOn - mesh.crossings);
  EXPECT_LT(mesh.Mismatch(), 1e-12 * std::sqrt(MapArea(mesh)));
  const double area = MapArea(mesh);
  double domain = 0.0;
  for (const TFace& face : mesh.faces)
  {
    Loop loop;
    for (const auto& side : face.sides)
    {
      for (const int h : side)
      {
        std::vector<Point> way = mesh.arcs[static_cast<std::size_t>(h / 2)].polyline;
        if (h % 2 == 1)
        {
          std::reverse(way.begin(), way.end());
        }
        loop.insert(loop.end(), way.begin(), way.end() - 1);
      }
    }
    domain += SignedArea(loop);
  }
  // The map has the area of the domain, and the faces are all of both.
  EXPECT_NEAR(area, domain, 1e-9 * domain);
}

struct Case
{
  std::string name;
  PlanarDomain domain;
  Configuration configuration;
  int faces;
  int arcs;
};

std::vector<Case> ReferenceCases()
{
  return {
    { "five around one", DiskOfEdges(0.04),
      Join(OnCircle(5, 0.7, 0.1, 1, 0.0), { { { 0.0, 0.0 }, -1 } }), 15, 40 },
    { "six around two", DiskOfEdges(0.04),
      Join(OnCircle(6, 0.7, 0.1, 1, 0.0), { { { 0.2, 0.0 }, -1 }, { { -0.2, 0.0 }, -1 } }), 21,
      56 },
    { "L-shape with a pair", LShape(), { { { 0.45, 0.55 }, 1 }, { { 1.3, 0.5 }, -1 } }, 9, 26 },
    { "ring with eight", RingOfEdges(0.04),
      Join(OnCircle(4, 0.8, 0.1, 1, 0.0), OnCircle(4, 0.55, 0.1, -1, 0.0)), 24, 64 },
    { "hexagon", Builtin("hexagonal"), { { { 0.469, 0.0 }, -1 }, { { -0.469, 0.0 }, -1 } }, 9, 26 },
    { "L-shape", LShape(), {}, 3, 10 },
    { "ring", RingOfEdges(0.04), {}, 1, 3 },
  };
}

TMesh LinesOn(const TriangleMesh& mesh, const Configuration& configuration)
{
  const FlatMap map = SolveFlatMap(ShareTopology(mesh), configuration);
  return MakeTMesh(map, TraceLines(map));
}

TEST(TMesh, OfTheReferenceCases)
{
  for (const Case& reference : ReferenceCases())
  {
    SCOPED_TRACE(reference.name);
    const TMesh mesh = LinesOf(reference.domain, reference.configuration, 0.04);
    EXPECT_EQ(Count(mesh.faces.size()), reference.faces);
    EXPECT_EQ(Count(mesh.arcs.size()), reference.arcs);
    ExpectSound(mesh, reference.domain.EulerCharacteristic());
  }
}

TEST(TMesh, LShapeIsThreeUnitSquares)
{
  const TMesh mesh = LinesOf(LShape(), {}, 0.1);
  for (const TFace& face : mesh.faces)
  {
    EXPECT_NEAR(mesh.SideLength(face, 0), 1.0, 1e-10);
    EXPECT_NEAR(mesh.SideLength(face, 1), 1.0, 1e-10);
  }
}

TEST(TMesh, RingHasSidesInTheRatioOfLogarithms)
{
  const TMesh mesh = LinesOf(RingOfEdges(0.02), {}, 0.02);
  ASSERT_EQ(mesh.faces.size(), 1U);
  EXPECT_EQ(mesh.extraLines, 1);
  const double a = mesh.SideLength(mesh.faces[0], 0);
  const double b = mesh.SideLength(mesh.faces[0], 1);
  EXPECT_NEAR(std::max(a, b) / std::min(a, b), 2.0 * Pi / std::log(2.5), 2e-3);
}

/// docs/method.md §13.4: the exact square s × s and its four strips s × t.
TEST(TMesh, OfTheDiskConvergesAtSecondOrder)
{
  for (const auto& [radius, s, t] : { std::array<double, 3>{ 0.85, 1.358896, 0.238244 },
         std::array<double, 3>{ 0.6, 1.094482, 0.443977 } })
  {
    std::vector<double> sizes;
    std::vector<double> errors;
    for (const double size : { 0.2, 0.1, 0.05, 0.025 })
    {
      const TMesh mesh = LinesOf(DiskOfEdges(size), OnCircle(4, radius, Pi / 4.0, 1, 0.0), size);
      ExpectSound(mesh, 1);
      std::vector<double> widths;
      for (const TFace& face : mesh.faces)
      {
        widths.push_back(std::min(mesh.SideLength(face, 0), mesh.SideLength(face, 1)));
      }
      std::sort(widths.rbegin(), widths.rend());
      sizes.push_back(size);
      errors.push_back(std::abs(widths[0] - s) + std::abs(widths[1] - t));
    }
    EXPECT_GT(ConvergenceRate(sizes, errors), 1.8);
    EXPECT_LT(errors.back(), 4e-4);
  }
}

/// A mesh and its mirror image across x = 0 (y = 0), joined there.
TriangleMesh JoinMirrored(const TriangleMesh& half, Eigen::Index axis)
{
  TriangleMesh mesh = half;
  const auto onAxis = [&half, axis](int v)
  { return std::abs(half.points[static_cast<std::size_t>(v)][axis]) < 1e-12; };
  std::vector<int> image;
  for (int v = 0; v < Count(half.points.size()); ++v)
  {
    Point& point = mesh.points[static_cast<std::size_t>(v)];
    if (onAxis(v))
    {
      point[axis] = 0.0;
      image.push_back(v);
      continue;
    }
    image.push_back(Count(mesh.points.size()));
    Point mirrored = point;
    mirrored[axis] = -mirrored[axis];
    mesh.points.push_back(mirrored);
  }
  const auto at = [&image](int v) { return image[static_cast<std::size_t>(v)]; };
  for (const auto& v : half.triangles)
  {
    mesh.triangles.push_back({ at(v[0]), at(v[2]), at(v[1]) });
  }
  mesh.boundary.clear();
  for (BoundaryEdge edge : half.boundary)
  {
    if (!onAxis(edge.vertices[0]) || !onAxis(edge.vertices[1]))
    {
      mesh.boundary.push_back(edge);
      edge.vertices = { at(edge.vertices[1]), at(edge.vertices[0]) };
      mesh.boundary.push_back(edge);
    }
  }
  return mesh;
}

TEST(TMesh, OfAnExactlySymmetricMeshHasLinesThatMeetHeadOn)
{
  Loop quarter;
  for (int i = 0; i <= 20; ++i)
  {
    const double angle = 0.5 * Pi * i / 20.0;
    quarter.emplace_back(std::cos(angle), std::sin(angle));
  }
  quarter.front().y() = quarter.back().x() = 0.0;
  quarter.emplace_back(0.0, 0.0);
  const Configuration one = OnCircle(1, 0.6, 0.7, 1, 0.0);
  const TriangleMesh mesh =
    JoinMirrored(JoinMirrored(MeshOnPoints(MakePlanarDomain({ quarter }), one, 0.08), 0), 1);
  Configuration four;
  for (const double x : { -1.0, 1.0 })
  {
    for (const double y : { -1.0, 1.0 })
    {
      four.push_back({ { x * one[0].position.x(), y * one[0].position.y() }, 1 });
    }
  }
  const TMesh symmetric = LinesOn(mesh, four);
  EXPECT_EQ(symmetric.headOn, 4);
  EXPECT_EQ(symmetric.faces.size(), 5U);
  EXPECT_EQ(symmetric.arcs.size(), 12U);
  ExpectSound(symmetric, 1);

  Random random(31);
  for (int i = 0; i < 5; ++i)
  {
    TriangleMesh moved = mesh;
    for (Point& point : moved.points)
    {
      point += 1e-9 * Point(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
    }
    ExpectSound(LinesOn(moved, four), 1);
  }
}

/// Two reflex corners that face each other, and a third line through the middle between them.
PlanarDomain Junction(double depth, const std::array<double, 3>& shift)
{
  return MakePlanarDomain(
    { { { -2.0, shift[0] }, { -0.5, shift[0] }, { -0.5, -2.0 }, { 0.5, -2.0 }, { 0.5, shift[1] },
      { 2.0, shift[1] }, { 2.0, depth }, { shift[2], depth }, { shift[2], 1.5 }, { -2.0, 1.5 } } });
}

TEST(TMesh, OfCornersThatFaceEachOther)
{
  const TMesh early = LinesOf(Junction(0.3, { 0.0, 0.0, 0.0 }), {}, 0.15);
  EXPECT_EQ(early.headOn, 0); // the third line comes first
  ExpectSound(early, 1);
  const TMesh late = LinesOf(Junction(0.8, { 0.0, 0.0, 0.0 }), {}, 0.15);
  EXPECT_EQ(late.headOn, 1);
  ExpectSound(late, 1);
  Random random(32);
  for (const double size : { 0.0, 1e-15, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-6 })
  {
    for (int i = 0; i < 5; ++i)
    {
      SCOPED_TRACE(size);
      const auto small = [&] { return size * random.Uniform(-1.0, 1.0); };
      const double depth = 0.5 + small();
      ExpectSound(LinesOf(Junction(depth, { small(), small(), small() }), {}, 0.15), 1);
    }
  }
}

/// Singularities at random places of a random smooth domain, of sum 4.
struct RandomCase
{
  PlanarDomain domain;
  Configuration configuration;
};

RandomCase MakeRandomCase(int number, int pairs, double apart)
{
  Random random(static_cast<std::uint32_t>(9000 + number));
  RandomCase result{ RandomSmoothDomain(random, 140), {} };
  const auto count = static_cast<std::size_t>(4 + 2 * pairs);
  while (result.configuration.size() < count)
  {
    const Point place(random.Uniform(-1.5, 1.5), random.Uniform(-1.5, 1.5));
    bool free = SignedDistance(place, result.domain) > apart;
    for (const Singularity& other : result.configuration)
    {
      free = free && (other.position - place).norm() > apart;
    }
    if (free)
    {
      const bool positive = result.configuration.size() < count - static_cast<std::size_t>(pairs);
      result.configuration.push_back({ place, positive ? 1 : -1 });
    }
  }
  return result;
}

std::vector<double> ArcLengths(const TMesh& mesh, double scale)
{
  std::vector<double> lengths;
  for (const TArc& arc : mesh.arcs)
  {
    lengths.push_back(arc.length / scale);
  }
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

/// 200 of them, in portions that ctest can run side by side.
class RandomTMesh : public testing::TestWithParam<int>
{
};

TEST_P(RandomTMesh, IsSound)
{
  constexpr int PortionSize = 25;
  for (int i = 0; i < PortionSize; ++i)
  {
    const int number = PortionSize * this->GetParam() + i;
    SCOPED_TRACE(number);
    const RandomCase random = MakeRandomCase(number, number % 3, 0.12);
    const TMesh mesh = LinesOf(random.domain, random.configuration, 0.07);
    ExpectSound(mesh, 1);
    EXPECT_LT(mesh.longest, 2.8 * std::sqrt(random.domain.Area()));
  }
}

INSTANTIATE_TEST_SUITE_P(TwoHundred, RandomTMesh, testing::Range(0, 8));

TEST(TMesh, IsTheSameOfAMovedScaledAndMirroredMesh)
{
  for (int number = 0; number < 6; ++number)
  {
    SCOPED_TRACE(number);
    const RandomCase random = MakeRandomCase(number, number % 3, 0.12);
    const TriangleMesh mesh = MeshOnPoints(random.domain, random.configuration, 0.08);
    const std::vector<double> lengths = ArcLengths(LinesOn(mesh, random.configuration), 1.0);
    const auto expectSame = [&lengths](const TMesh& other, double scale)
    {
      const std::vector<double> others = ArcLengths(other, scale);
      ASSERT_EQ(others.size(), lengths.size());
      for (std::size_t i = 0; i < lengths.size(); ++i)
      {
        EXPECT_NEAR(others[i], lengths[i], 1e-8);
      }
    };
    for (const double scale : { 1e-6, 1.0, 1e6 })
    {
      const Similarity move{ 0.7 + number, scale, scale * Point(0.3, -0.2) };
      expectSame(LinesOn(move(mesh), move(random.configuration)), scale);
    }
    TriangleMesh mirrored = mesh;
    Configuration configuration = random.configuration;
    for (Point& point : mirrored.points)
    {
      point.x() = -point.x();
    }
    for (Singularity& singularity : configuration)
    {
      singularity.position.x() = -singularity.position.x();
    }
    for (auto& triangle : mirrored.triangles)
    {
      std::swap(triangle[1], triangle[2]);
    }
    for (BoundaryEdge& edge : mirrored.boundary)
    {
      std::swap(edge.vertices[0], edge.vertices[1]);
    }
    expectSame(LinesOn(mirrored, configuration), 1.0);
  }
}

/// What does not depend on numbering: of every face how many arcs its sides have.
std::vector<std::array<std::size_t, 4>> Signature(const TMesh& mesh)
{
  std::vector<std::array<std::size_t, 4>> signature;
  for (const TFace& face : mesh.faces)
  {
    std::array<std::size_t, 4> counts{};
    for (std::size_t i = 0; i < 4; ++i)
    {
      counts[i] = face.sides[i].size();
    }
    std::array<std::size_t, 4> least = counts;
    for (int turn = 0; turn < 4; ++turn)
    {
      std::rotate(counts.begin(), counts.begin() + 1, counts.end());
      least = std::min(least, counts);
    }
    signature.push_back(least);
  }
  std::sort(signature.begin(), signature.end());
  return signature;
}

TEST(TMesh, DoesNotDependOnTheMesh)
{
  int different = 0;
  constexpr int Cases = 30;
  for (int number = 0; number < Cases; ++number)
  {
    const RandomCase random = MakeRandomCase(number, number % 3, 0.15);
    const TMesh fine = LinesOf(random.domain, random.configuration, 0.03);
    double shortest = fine.longest;
    for (const TArc& arc : fine.arcs)
    {
      shortest = std::min(shortest, arc.length);
    }
    bool same = true;
    for (const double size : { 0.045, 0.06 })
    {
      same =
        same && Signature(LinesOf(random.domain, random.configuration, size)) == Signature(fine);
    }
    different += same ? 0 : 1;
    if (!same)
    {
      std::printf("[   INFO   ] case %d differs, its shortest arc is %g\n", number, shortest);
      EXPECT_LT(shortest, 1e-3); // a near miss below what the mesh resolves
    }
  }
  EXPECT_LE(different, 1);
}

TEST(TMesh, OfManySingularities)
{
  for (const int pairs : { 13, 48 })
  {
    SCOPED_TRACE(pairs);
    const RandomCase random = MakeRandomCase(500 + pairs, pairs, 0.06);
    ExpectSound(LinesOf(random.domain, random.configuration, 0.03), 1);
  }
}
}
}
