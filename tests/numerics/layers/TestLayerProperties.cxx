// Boundary layers on random sides of random parts: heights, growth, valences and blocks.

#include "BoundaryLayers.h"

#include "LayerChecks.h"
#include "MakePlanarDomain.h"
#include "QuadWorkflow.h"
#include "Segment.h"
#include "SideRequests.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace crossfield::test
{
namespace
{
/// Returns adjacent columns of random heights, at most one higher than the last.
PlanarDomain RandomStairs(Random& random)
{
  Loop loop = { { 0.0, 0.0 } };
  const int columns = random.Integer(1, 3);
  loop.emplace_back(columns, 0.0);
  int height = random.Integer(1, 2);
  for (int c = columns; c-- > 0;)
  {
    loop.emplace_back(c + 1.0, height);
    loop.emplace_back(c, height);
    height = height == 1 ? 2 : 1;
  }
  return MakePlanarDomain({ loop });
}

/// Returns a polygon of three to six corners near a circle.
PlanarDomain RandomPolygon(Random& random)
{
  Loop loop;
  const int count = random.Integer(3, 6);
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * (i + random.Uniform(-0.15, 0.15)) / count;
    loop.push_back(random.Uniform(0.8, 1.2) * Point(std::cos(angle), std::sin(angle)));
  }
  return MakePlanarDomain({ loop });
}

/// Returns a rectangle with one or two circular holes, or a ring.
PlanarDomain RandomHoled(Random& random)
{
  if (random.Integer(0, 2) == 0)
  {
    return MakePlanarDomain({ RegularPolygon(128),
      RegularPolygon(96, random.Uniform(0.2, 0.5), Point(random.Uniform(0.0, 0.2), 0.0)) });
  }
  const double width = random.Uniform(2.0, 3.0);
  std::vector<Loop> loops = { { { 0.0, 0.0 }, { width, 0.0 }, { width, 1.5 }, { 0.0, 1.5 } } };
  const int holes = random.Integer(1, 2);
  for (int i = 0; i < holes; ++i)
  {
    const Point centre(
      (i + 0.5) * width / holes + random.Uniform(-0.1, 0.1), 0.75 + random.Uniform(-0.1, 0.1));
    loops.push_back(RegularPolygon(64, random.Uniform(0.12, 0.22), centre));
  }
  return MakePlanarDomain(loops);
}

PlanarDomain RandomPart(Random& random, int number)
{
  switch (number % 4)
  {
  case 0:
    return RandomSmoothDomain(random);
  case 1:
    return RandomStairs(random);
  case 2:
    return RandomPolygon(random);
  default:
    return RandomHoled(random);
  }
}

/// Returns layers on some of the sides, at least one. Those of one loop, which may share rows, have
/// the same height.
std::vector<SideRequest> RandomLayers(Random& random, const PlanarDomain& domain, double quadSize)
{
  std::vector<SideRequest> layers;
  const BoundarySides sides = NameSides(domain);
  const int forced = random.Integer(0, static_cast<int>(sides.names.size()) - 1);
  const double growth = random.Integer(0, 1) == 0 ? 1.2 : 1.3;
  const double outer = quadSize * std::pow(10.0, random.Uniform(-3.0, -1.0));
  for (std::size_t side = 0; side < sides.names.size(); ++side)
  {
    if (static_cast<int>(side) == forced || random.Integer(0, 2) == 0)
    {
      const std::string& name = sides.names[side];
      const double first =
        name.find("outer") == 0 ? outer : quadSize * std::pow(10.0, random.Uniform(-3.0, -1.0));
      layers.push_back(LayerOf(name, first, growth));
    }
  }
  return layers;
}

/// Counts irregular interior points by quarter index, and quads at boundary points that are not
/// regular.
std::map<int, int> IrregularOf(const QuadMesh& mesh)
{
  std::vector<int> valences(mesh.points.size(), 0);
  for (const std::array<int, 4>& quad : mesh.quads)
  {
    for (const int point : quad)
    {
      ++valences[static_cast<std::size_t>(point)];
    }
  }
  std::map<int, int> found;
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    EXPECT_EQ(valences[p], mesh.points[p].valence);
    const bool isInside = mesh.points[p].curve.loop < 0;
    const int index = (isInside ? 4 : 2) - valences[p];
    if (index != 0)
    {
      ++found[isInside ? index : 100 + index];
    }
  }
  return found;
}

std::map<int, int> RequestedOf(const QuadWorkflowResult& result)
{
  std::map<int, int> requested;
  for (const Singularity& singularity : result.singularities)
  {
    ++requested[singularity.quarterIndex];
  }
  for (const CornerChoice& corner : result.corners)
  {
    if (corner.quarterIndex != 0)
    {
      ++requested[100 + corner.quarterIndex];
    }
  }
  return requested;
}

/// Measures the heights of the first rows independently of LayerReport: distances of the points
/// next to the wall from the edges of its side. Returns the part of them that is within 5 %.
double PartWithin(const QuadWorkflowResult& result, const std::vector<SideRequest>& layers)
{
  const QuadMesh& mesh = result.quads.mesh;
  const auto placeOf = [&](int point)
  { return mesh.points[static_cast<std::size_t>(point)].InPlane(); };
  std::map<std::array<int, 2>, int> sideAt;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      sideAt[{ mesh.quads[q][c], mesh.quads[q][(c + 1) % 4] }] = static_cast<int>(4 * q + c);
    }
  }
  int within = 0;
  int all = 0;
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    const std::string& name = mesh.sideNames[static_cast<std::size_t>(edge.side)];
    const auto layer = std::find_if(layers.begin(), layers.end(),
      [&](const SideRequest& candidate) { return candidate.side == name; });
    if (layer == layers.end())
    {
      continue;
    }
    const int side = sideAt.at(edge.points);
    const int above =
      mesh.quads[static_cast<std::size_t>(side / 4)][static_cast<std::size_t>((side % 4 + 3) % 4)];
    double distance = 1e300;
    for (const QuadBoundaryEdge& other : mesh.boundary)
    {
      distance = other.side != edge.side
        ? distance
        : std::min(distance,
            OffsetFromSegment(placeOf(above), placeOf(other.points[0]), placeOf(other.points[1]))
              .norm());
    }
    ++all;
    within += std::abs(distance / *layer->layer->first - 1.0) <= 0.05 ? 1 : 0;
  }
  return static_cast<double>(within) / all;
}

/// CROSSFIELD_LAYER_CASES sets the number of parts, CROSSFIELD_LAYER_FIRST the first one; with one
/// of them each result is printed.
TEST(LayerProperties, HoldOnRandomParts)
{
  const char* requested = std::getenv("CROSSFIELD_LAYER_CASES");
  const char* from = std::getenv("CROSSFIELD_LAYER_FIRST");
  const int first = from == nullptr ? 0 : std::atoi(from);
  const int cases = requested == nullptr ? 24 : std::atoi(requested);
  int meshes = 0;
  int refused = 0;
  for (int number = first; number < first + cases; ++number)
  {
    SCOPED_TRACE(number);
    Random random(static_cast<std::uint32_t>(32000 + number));
    const PlanarDomain domain = RandomPart(random, number);
    QuadRequest request;
    request.quadSize = std::sqrt(domain.Area() / random.Uniform(1500.0, 4000.0));
    request.sizing = random.Integer(0, 1) == 0 ? Sizing::Conformal : Sizing::Uniform;
    request.sideRequests = RandomLayers(random, domain, request.quadSize);
    try
    {
      const QuadWorkflowResult result = MakeQuadMesh(domain, request);
      ++meshes;
      const QuadMesh& mesh = result.quads.mesh;
      EXPECT_EQ(mesh.EulerCharacteristic(), domain.EulerCharacteristic());
      EXPECT_EQ(IrregularOf(mesh), RequestedOf(result));
      ExpectSoundBlocks(result.quads);
      EXPECT_EQ(result.quads.quality.inverted, 0);
      ASSERT_EQ(result.layers.size(), request.sideRequests.size());
      for (std::size_t i = 0; i < result.layers.size(); ++i)
      {
        const LayerReport& report = result.layers[i];
        EXPECT_EQ(report.name, request.sideRequests[i].side);
        EXPECT_GE(report.partInBounds, 0.95) << report.name;
        // Where bands cross at oblique corners, heights follow the second band.
        EXPECT_LE(report.largestGrowth, request.sideRequests[i].layer->growth * 1.1) << report.name;
        EXPECT_GE(report.rows, report.rowsReplaced) << report.name;
      }
      const double part = PartWithin(result, request.sideRequests);
      EXPECT_GE(part, 0.95);
      if (requested != nullptr || from != nullptr)
      {
        double ratio = 0.0;
        double inBounds = 1.0;
        for (const LayerReport& report : result.layers)
        {
          ratio = std::max(ratio, report.largestRatio);
          inBounds = std::min(inBounds, report.partInBounds);
        }
        std::printf("%d: %zu quads, jacobian %.3f of %.3f, in bounds %.3f %.3f, ratio %.2f\n",
          number, mesh.quads.size(), result.quads.quality.jacobian.min, result.quads.quality.bound,
          inBounds, part, ratio);
      }
    }
    catch (const Error& error)
    {
      // Layers may need more rows than there are, and the message says so.
      ++refused;
      EXPECT_NE(std::string(error.what()).find("are needed"), std::string::npos) << error.what();
      if (requested != nullptr || from != nullptr)
      {
        std::printf("%d: %s\n", number, error.what());
      }
    }
  }
  EXPECT_LE(10 * refused, cases);
  EXPECT_GE(meshes, cases * 9 / 10);
}
}
}
