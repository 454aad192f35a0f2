#include "TMeshFaces.h"

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
  EXPECT_EQ(
    Count(mesh.arcs.size()), 2 * mesh.lineCount + corners + mesh.extraLines - 3 * mesh.headOn);
  EXPECT_LT(mesh.Mismatch(), 1e-12 * std::max(mesh.longest, 1.0));
  double area = 0.0;
  for (const TFace& face : mesh.faces)
  {
    area += mesh.SideLength(face, 0) * mesh.SideLength(face, 1);
  }
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

Configuration Join(Configuration first, const Configuration& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

struct Case
{
  std::string name;
  PlanarDomain domain;
  Configuration configuration;
  int faces;
  int arcs;
};

PlanarDomain LShape()
{
  return MakePlanarDomain(
    { { { 0.0, 0.0 }, { 2.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 1.0 }, { 1.0, 2.0 }, { 0.0, 2.0 } } });
}

PlanarDomain Ring(double edge)
{
  return MakePlanarDomain({ RegularPolygon(static_cast<int>(2.0 * Pi / edge)),
    RegularPolygon(static_cast<int>(0.8 * Pi / edge), 0.4) });
}

PlanarDomain Disk(double edge)
{
  return MakePlanarDomain({ RegularPolygon(static_cast<int>(2.0 * Pi / edge)) });
}

std::vector<Case> ReferenceCases()
{
  return {
    { "five around one", Disk(0.04),
      Join(OnCircle(5, 0.7, 0.1, 1, 0.0), { { { 0.0, 0.0 }, -1 } }), 15, 40 },
    { "six around two", Disk(0.04),
      Join(OnCircle(6, 0.7, 0.1, 1, 0.0), { { { 0.2, 0.0 }, -1 }, { { -0.2, 0.0 }, -1 } }), 21,
      56 },
    { "L-shape with a pair", LShape(), { { { 0.45, 0.55 }, 1 }, { { 1.3, 0.5 }, -1 } }, 9, 26 },
    { "ring with eight", Ring(0.04),
      Join(OnCircle(4, 0.8, 0.1, 1, 0.0), OnCircle(4, 0.55, 0.1, -1, 0.0)), 24, 64 },
    { "hexagon", Builtin("hexagonal"), { { { 0.469, 0.0 }, -1 }, { { -0.469, 0.0 }, -1 } }, 9,
      26 },
    { "L-shape", LShape(), {}, 3, 10 },
    { "ring", Ring(0.04), {}, 1, 3 },
  };
}

TEST(TMesh, OfTheReferenceCases)
{
  for (const Case& reference : ReferenceCases())
  {
    SCOPED_TRACE(reference.name);
    const TMesh mesh = LinesOf(reference.domain, reference.configuration, 0.04);
    std::printf("%s faces %zu arcs %zu lines %d headOn %d extra %d longest %g mismatch %g\n",
      reference.name.c_str(), mesh.faces.size(), mesh.arcs.size(), mesh.lineCount, mesh.headOn,
      mesh.extraLines, mesh.longest, mesh.Mismatch());
    EXPECT_EQ(Count(mesh.faces.size()), reference.faces);
    EXPECT_EQ(Count(mesh.arcs.size()), reference.arcs);
    ExpectSound(mesh, reference.domain.EulerCharacteristic());
  }
}

TEST(TMesh, OfTheDiskConvergesToTheReference)
{
  for (const auto& [radius, s, t] : { std::array<double, 3>{ 0.85, 1.358896, 0.238244 },
         std::array<double, 3>{ 0.6, 1.094482, 0.443977 } })
  {
    for (const double size : { 0.2, 0.1, 0.05, 0.025 })
    {
      const TMesh mesh = LinesOf(Disk(size), OnCircle(4, radius, Pi / 4.0, 1, 0.0), size);
      ExpectSound(mesh, 1);
      std::vector<double> widths;
      for (const TFace& face : mesh.faces)
      {
        widths.push_back(std::min(mesh.SideLength(face, 0), mesh.SideLength(face, 1)));
      }
      std::sort(widths.rbegin(), widths.rend());
      std::printf("h %g faces %zu s %.6f %.6f t %.6f %.6f\n", size, mesh.faces.size(), widths[0], s,
        widths[1], t);
    }
  }
}
}
}
