#include "SurfaceDesign.h"

#include "BodyLayout.h"
#include "ConeDescent.h"
#include "Error.h"
#include "Stopwatch.h"
#include "SurfaceChoice.h"
#include "SurfaceParts.h"
#include "SurfaceRefinement.h"
#include "SurfaceSimplification.h"
#include "SurfaceTopology.h"
#include "TriangleDivision.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// A step with this number takes 35 ms (docs/speed.md), which leaves most of a tenth of a second for drawing.
constexpr int CoarseTriangles = 4000;

/// Returns a part with singularities on it.
FeaturedPart With(FeaturedPart part, const std::vector<SurfaceSingularity>& singularities)
{
  part.singularities = singularities;
  part.rows.resize(singularities.size());
  std::iota(part.rows.begin(), part.rows.end(), 0);
  return part;
}

LayoutDesign DesignOn(const FeaturedPart& part, const SurfaceNames& names,
  const std::optional<SurfaceQuadOptions>& quads, const std::vector<PatchColour>& earlier,
  const Progress& progress)
{
  Stopwatch stopwatch;
  LayoutDesign design;
  const SurfaceBody body = PlaceCones(part);
  QuadSeconds seconds;
  std::vector<Layout> layouts;
  const double share = (quads ? 0.7 : 1.0) / static_cast<double>(body.faces.size());
  for (const ConedSurface& face : body.faces)
  {
    const double done = share * static_cast<double>(layouts.size());
    try
    {
      layouts.push_back(LayOutFace(face, seconds, progress.Part(done, done + share)));
    }
    catch (const Error& error)
    {
      throw InFace(body, face, error);
    }
  }
  design.layouts = JoinBody(body, names, std::move(layouts));
  const Layout& layout = design.layouts.Single();
  design.energy.energy = std::numeric_limits<double>::quiet_NaN();
  design.reason = DescribeHolonomy(layout.map.holonomyDefect);
  design.onSurface = part.singularities;
  if (quads)
  {
    design.quads = MakeSurfaceQuads(design.layouts, *quads, progress.Part(0.7, 1.0));
    RequireCover(body, design.quads->mesh);
    std::vector<SpacePoint> places;
    for (const SurfaceSingularity& one : design.onSurface)
    {
      places.push_back(one.place);
    }
    NodePlaces nodes = FindNodePlaces(layout.map, design.quads->mesh, places, places);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      design.onSurface[i].place = nodes.places[i];
    }
    design.nodes.moved = nodes.moved;
    design.nodes.events = std::move(nodes.events);
  }
  design.shortestArc = ShortestArc(layout.tMesh);
  design.colours = ColourPatches(layout.tMesh, earlier);
  design.seconds = stopwatch.Lap();
  progress.Report(1.0);
  return design;
}
}

DesignSurface::DesignSurface(SurfaceMesh surface, SurfaceNames names, double featureAngle)
  : Names(std::move(names))
  , FeatureAngle(featureAngle)
{
  FeaturedParts found = FindFeaturedParts(std::move(surface), {}, featureAngle);
  if (found.parts.size() != 1)
  {
    throw Error("The surface has " + std::to_string(found.parts.size()) +
      " parts that are not connected, and a layout is designed on one; give one of them, for example from the filter Connectivity.");
  }
  this->Part = std::move(found.parts.front());
  this->SurfaceArea = AreaOf(this->Part.surface);
  // Triangles of sides up to a length are between one and three times as many as equilateral ones (TriangleDivision).
  const double length = std::sqrt(3.0 * this->SurfaceArea / (0.43 * CoarseTriangles));
  const SurfaceMesh even = Refined(this->Part.surface, length);
  SimplifiedSurface coarse =
    Simplified(even, FindFeatureEdges(even, featureAngle), CoarseTriangles);
  this->CoarsePart.surface = std::move(coarse.surface);
  this->CoarsePart.features = std::move(coarse.features);
}

int DesignSurface::RequiredSum() const
{
  const SurfaceBody body = PlaceCones(this->Part);
  return std::accumulate(body.faces.begin(), body.faces.end(), 0,
    [](int sum, const ConedSurface& face) { return sum + face.RequiredQuarters(); });
}

std::vector<SurfaceSingularity> DesignSurface::Choose(
  double quadSize, const Progress& progress) const
{
  TriangleDivision division(this->Part, quadSize, this->FeatureAngle);
  return division.Run([](const FeaturedPart& part, bool, const Progress& steps)
    { return ChooseSurfaceSingularities(part, steps); },
    progress);
}

std::vector<SurfaceSingularity> DesignSurface::Move(
  std::vector<SurfaceSingularity> singularities, const Progress& progress) const
{
  constexpr std::size_t MostTriangles = 20000; // as for chosen ones (BodyQuads.cxx)
  const bool isSmall = this->Part.surface.triangles.size() <= MostTriangles;
  const SurfaceBody body = PlaceCones(With(isSmall ? this->Part : this->CoarsePart, singularities));
  const double share = 1.0 / static_cast<double>(body.faces.size());
  double done = 0.0;
  for (const ConedSurface& face : body.faces)
  {
    for (const Cone& cone :
      MovedCones(face.topology, face.cones, progress.Part(done, done + share)))
    {
      if (cone.row >= 0) // corners have none
      {
        singularities[static_cast<std::size_t>(cone.row)].place =
          face.topology->PositionOf(cone.vertex);
      }
    }
    done += share;
  }
  return singularities;
}

LayoutDesign DesignSurface::DesignCoarse(const std::vector<SurfaceSingularity>& singularities,
  const std::vector<PatchColour>& earlier, const Progress& progress) const
{
  return DesignOn(With(this->CoarsePart, singularities), {}, std::nullopt, earlier, progress);
}

LayoutDesign DesignSurface::Design(const std::vector<SurfaceSingularity>& singularities,
  double quadSize, const std::optional<SurfaceQuadOptions>& quads,
  const std::vector<PatchColour>& earlier, const Progress& progress) const
{
  TriangleDivision division(With(this->Part, singularities), quadSize, this->FeatureAngle);
  return division.Run([&](const FeaturedPart& part, bool, const Progress& steps)
    { return DesignOn(part, this->Names, quads, earlier, steps); },
    progress);
}
}
