#include "BodyQuads.h"

#include "BodyLayout.h"
#include "ConeDescent.h"
#include "Error.h"
#include "Index.h"
#include "LineSides.h"
#include "OptimizerReport.h"
#include "QuadAdvice.h"
#include "Stopwatch.h"
#include "SurfaceChoice.h"
#include "SurfaceQuads.h"
#include "SurfaceTopology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
/// Chooses the singularities of a face, unless they are given, and computes its layout.
Layout LayOutChosen(ConedSurface& face, bool chooses, bool withoutPairs, QuadSeconds& seconds,
  const Progress& progress)
{
  if (chooses)
  {
    Stopwatch clock;
    std::vector<Cone> cones =
      ChooseSurfaceCones(*face.topology, face.cones, withoutPairs, progress.Part(0.0, 0.6));
    face.cones.insert(face.cones.begin(), cones.begin(), cones.end());
    seconds.choose += clock.Lap();
  }
  return LayOutFace(face, seconds, progress.Part(0.6, 1.0));
}

/// Returns the number of pairs of opposite singularities, which have indices 1 and -1.
int CountPairs(const ConedSurface& face)
{
  const auto inside = std::count_if(
    face.cones.begin(), face.cones.end(), [](const Cone& cone) { return !cone.onBoundary; });
  return (static_cast<int>(inside) - std::abs(face.GivenQuarters())) / 2;
}

/// Makes the quads of one part.
class BodyMesher
{
public:
  BodyMesher(FeaturedPart& part, const SurfaceRequest& request, int count, bool joinsAll)
    : Part(part)
    , Names(request.names)
    , Sizes(request.sizes)
    , Sides(request.sides)
    , IsSized(request.HasSizes())
    , Chooses(!request.singularities)
    , JoinsAll(joinsAll)
    , Options({ request.quadSize, count, request.hold, true, request.coarse })
  {
  }

  PartOfQuads Run(const Progress& progress)
  {
    PartOfQuads made = this->MakeAsChosen(progress.Part(0.0, 0.4));
    // Several faces share one mesh, which would have to be made for each of them.
    // With more triangles the moves would take longer than all the rest.
    constexpr int MostTriangles = 20000;
    if (this->Chooses && this->Body.faces.size() == 1 &&
      this->Body.faces.front().topology->TriangleCount() <= MostTriangles)
    {
      const int pairs = CountPairs(this->Body.faces.front());
      this->Improve(made, progress.Part(0.4, 0.6));
      if (pairs > 0)
      {
        this->TryWithoutPairs(pairs, made, progress.Part(0.6, 1.0));
      }
      made.quads.seconds = this->Seconds;
    }
    return made;
  }

private:
  PartOfQuads MakeAsChosen(const Progress& progress)
  {
    const LayoutSet layouts = this->LayOut(progress);
    try
    {
      return this->MakeQuads(layouts, progress.Part(0.7, 1.0));
    }
    catch (const Error& error)
    {
      // A face with pairs may need other numbers of edges on its two loops than the faces beside it have.
      const bool helps = this->Chooses && error.GetKind() == Error::Kind::Inconsistent;
      this->WithoutPairs = this->PairsFail = true;
      const std::optional<PartOfQuads> made = helps ? this->TryAgain() : std::nullopt;
      if (!made)
      {
        throw;
      }
      return *made;
    }
  }

  /// Takes quads with moved singularities if they are better.
  void Improve(PartOfQuads& made, const Progress& progress)
  {
    const auto moved = this->MakeWithMoved(progress);
    if (moved && IsBetter(*moved, made))
    {
      Take(*moved, "Singularities were moved from where smooth crosses have them", made);
    }
  }

  /// Takes quads without pairs of opposite singularities if they are better and each pair has removed less than a part
  /// of the spread of sizes: smooth crosses have such pairs where sizes change.
  void TryWithoutPairs(int pairs, PartOfQuads& made, const Progress& progress)
  {
    constexpr double Removed = 0.15; // as for pairs that are added in a plane (QuadRequest::pairs)
    this->WithoutPairs = true;
    std::optional<PartOfQuads> fewer = this->TryAgain();
    if (!fewer)
    {
      return;
    }
    this->Improve(*fewer, progress);
    const double worth = std::pow(1.0 - Removed, pairs) * fewer->quads.quads.quality.variation;
    if (made.quads.quads.quality.variation > worth && IsBetter(*fewer, made))
    {
      Take(*fewer, "Pairs of opposite singularities were left out", made);
    }
  }

  /// Returns quads with singularities moved from their chosen places, nothing if none moves or there are no quads.
  std::optional<PartOfQuads> MakeWithMoved(const Progress& progress)
  {
    ConedSurface& face = this->Body.faces.front();
    Stopwatch clock;
    try
    {
      std::vector<Cone> moved = MovedCones(face.topology, face.cones, progress.Part(0.0, 0.4));
      this->Seconds.choose += clock.Lap();
      const bool isSame = std::equal(moved.begin(), moved.end(), face.cones.begin(),
        [](const Cone& a, const Cone& b) { return a.vertex == b.vertex; });
      if (isSame)
      {
        return std::nullopt;
      }
      face.cones = std::move(moved);
      std::vector<Layout> layouts;
      layouts.push_back(LayOutFace(face, this->Seconds, progress.Part(0.4, 0.7)));
      return this->MakeQuads(
        JoinBody(this->Body, this->Names, std::move(layouts)), progress.Part(0.7, 1.0));
    }
    catch (const Error&)
    {
      return std::nullopt; // those with the chosen places remain
    }
  }

  /// Returns whether the minimum scaled Jacobian is larger or, where both are nearly equal, the mean; with coarse
  /// blocks only if there are no more of these.
  static bool IsBetter(const PartOfQuads& other, const PartOfQuads& made)
  {
    // The minimum changes by more from one number of quads to the next.
    constexpr double Equal = 0.01;
    const Range& before = made.quads.quads.quality.jacobian;
    const Range& after = other.quads.quads.quality.jacobian;
    const double gain = after.min - before.min;
    const bool isBetter = std::abs(gain) > Equal ? gain > 0.0 : after.mean > before.mean;
    return isBetter && other.quads.blocks.coarse <= made.quads.blocks.coarse;
  }

  /// Replaces quads by others, and adds an event with a reason.
  static void Take(const PartOfQuads& other, const std::string& reason, PartOfQuads& made)
  {
    const Range before = made.quads.quads.quality.jacobian;
    const auto describe = [](const Range& jacobian)
    { return FormatShort(jacobian.min) + ", mean " + FormatShort(jacobian.mean); };
    made = other;
    made.quads.events.push_back(reason + ": the minimum scaled Jacobian is " +
      describe(made.quads.quads.quality.jacobian) + ", instead of " + describe(before) + ".");
  }

  /// Returns quads without pairs of opposite singularities, nothing if there are none.
  std::optional<PartOfQuads> TryAgain()
  {
    try
    {
      const LayoutSet layouts = this->LayOut({});
      return this->MakeQuads(layouts, {});
    }
    catch (const Error&)
    {
      return std::nullopt;
    }
  }

  /// Computes the layouts of all faces. Faces without a map are joined to others until each face has one.
  LayoutSet LayOut(const Progress& progress)
  {
    double done = 0.0;
    while (true)
    {
      this->Body = PlaceCones(this->Part);
      const double end = done + 0.5 * (0.7 - done);
      std::vector<Layout> layouts = this->LayOutFaces(progress.Part(done, end));
      done = end;
      if (layouts.size() == this->Body.faces.size())
      {
        return JoinBody(this->Body, this->Names, std::move(layouts));
      }
      this->Joined += static_cast<int>(this->Body.faces.size() - layouts.size());
      MergeFaces(this->Part.surface, this->Body.faceOf, this->Fails, this->Part.features);
    }
  }

  /// Returns the layouts of the faces that have a map, and marks the others in Fails. Throws Error if these must
  /// not be joined to others.
  std::vector<Layout> LayOutFaces(const Progress& progress)
  {
    std::vector<Layout> layouts;
    double done = 0.0;
    this->Fails.assign(this->Body.faces.size(), false);
    for (std::size_t f = 0; f < this->Body.faces.size(); ++f)
    {
      ConedSurface& face = this->Body.faces[f];
      const double area = face.topology->Area();
      const double end = std::min(1.0, done + area / this->Body.area);
      try
      {
        layouts.push_back(LayOutChosen(
          face, this->Chooses, this->WithoutPairs, this->Seconds, progress.Part(done, end)));
      }
      catch (const Error& error)
      {
        if (this->Body.lines.empty() || !this->Chooses || !this->CanJoin(area))
        {
          throw InFace(this->Body, face, error);
        }
        this->Fails[f] = true;
      }
      done = end;
    }
    return layouts;
  }

  /// Returns whether a face of an area that cannot be laid out may be joined to another: if it is too small for a
  /// few quads, or with smaller triangles cannot be either.
  bool CanJoin(double area) const
  {
    constexpr double Few = 4.0;
    const double size = this->Options.quadSize;
    const int count = this->Options.quadCount > 0 ? this->Options.quadCount : DefaultQuads;
    const double ofQuad = size > 0.0 ? size * size : this->Body.area / count;
    return this->Body.faces.size() > 1 && (this->JoinsAll || area < Few * ofQuad);
  }

  /// Makes quads of requested sizes, which are multiplied by a factor for a requested number. Without one, if centres of
  /// quads are a little farther from the surface than the chord error because numbers of edges are integers, there
  /// are more quads.
  QuadResult MakeSizedQuads(const LayoutSet& layouts, const std::vector<std::string>& sideNames,
    SurfaceQuadOptions options, double& factor, const Progress& progress) const
  {
    constexpr double Accepted = 1.1; // of the chord error
    constexpr double Little = 1.5;   // beyond, it is a place that sizes do not show
    const MeshTopology& topology = *layouts.Single().map.topology;
    options.targets = ResolveSizes(topology, layouts.sides.twins, sideNames, this->Sides,
      this->Sizes, options.quadSize, options.quadCount);
    // Lines between singularities are longer or shorter than others beside them, so the number is searched for.
    const double count = options.targets.CountOn(topology);
    const auto make = [&](double wanted, const Progress& part)
    {
      options.quadSize = 0.0;
      options.quadCount = static_cast<int>(std::max(1.0, std::round(wanted)));
      factor = std::sqrt(count / wanted);
      QuadResult quads = MakeSurfaceQuads(layouts, options, part);
      for (double& target : quads.targets)
      {
        target *= factor;
      }
      return quads;
    };
    const bool isFree = this->Options.quadCount == 0 || this->Options.quadSize > 0.0;
    QuadResult quads = make(isFree ? count : this->Options.quadCount, progress.Part(0.0, 0.5));
    const double error = this->Sizes.chordError;
    const double distance = quads.quality.surface->maximumDistance;
    if (isFree && distance > Accepted * error && distance <= Little * error)
    {
      quads = make(count * distance / error, progress.Part(0.5, 1.0));
    }
    return quads;
  }

  PartOfQuads MakeQuads(const LayoutSet& layouts, const Progress& progress)
  {
    PartOfQuads made;
    QuadWorkflowResult& result = made.quads;
    const Layout& layout = layouts.Single();
    const SurfaceSideNames names = NamesOfSides(
      layouts, SidesOfArcs(layouts.pairs, MeshBoundary(*layout.map.topology), layout.tMesh));
    SurfaceQuadOptions options = this->Options;
    for (const SurfaceSideRequest& one : this->Sides)
    {
      // Other parts may have the other sides.
      if (std::find(names.ofEntries.begin(), names.ofEntries.end(), one.side) !=
        names.ofEntries.end())
      {
        options.sides.push_back(one);
      }
    }
    if (this->IsSized)
    {
      double factor = 1.0;
      result.quads = this->MakeSizedQuads(layouts, names.ofEntries, options, factor, progress);
      result.sizes = this->MeasureSizes(result.quads);
      result.sizes->factor = factor;
    }
    else
    {
      result.quads = MakeSurfaceQuads(layouts, options, progress);
    }
    RequireCover(this->Body, result.quads.mesh);
    this->Seconds.integers += result.quads.counts.seconds;
    this->Seconds.layout += result.quads.layoutSeconds;
    this->Seconds.smooth += result.quads.smoothSeconds;
    result.seconds = this->Seconds;
    result.holonomyDefect = layouts.Single().map.holonomyDefect;
    result.blocks.none = result.quads.separateBlocks;
    if (this->Options.coarse)
    {
      result.blocks.coarse = static_cast<int>(result.quads.blocks.blocks.size());
    }
    this->Describe(result);
    this->AddRegions(result);
    std::set<int> loops;
    for (const QuadBoundaryEdge& edge : result.quads.mesh.boundary)
    {
      if (edge.kind != BoundaryKind::Feature && edge.kind != BoundaryKind::Interface)
      {
        loops.insert(edge.id);
      }
    }
    made.loops = loops.size();
    return made;
  }

  /// Returns how closely sizes are met.
  SizeReport MeasureSizes(const QuadResult& quads) const
  {
    SizeReport report = MeasureTargets(quads.mesh, quads.targets);
    for (const SurfaceSizeNear& near : this->Sizes.near)
    {
      SizeReport::Set& set =
        report.sets.emplace_back(SizeReport::Set{ "near " + DescribeInSpace(near.place), {} });
      std::vector<double> distances; // of centres
      for (const std::array<int, 4>& quad : quads.mesh.quads)
      {
        SpacePoint centre = SpacePoint::Zero();
        for (const int point : quad)
        {
          centre += 0.25 * quads.mesh.points[Index(point)].place;
        }
        distances.push_back((centre - near.place).norm());
      }
      const double reach =
        std::max(near.radius, *std::min_element(distances.begin(), distances.end()));
      for (std::size_t q = 0; q < distances.size(); ++q)
      {
        if (distances[q] <= reach)
        {
          set.ratios.push_back(report.samples[q].Ratio());
        }
      }
    }
    return report;
  }

  /// Adds the regions: one for each face.
  void AddRegions(QuadWorkflowResult& result) const
  {
    if (this->Names.regions.empty())
    {
      return;
    }
    result.materials = this->Names.regions;
    for (std::size_t f = 0; f < this->Body.faces.size(); ++f)
    {
      const ConedSurface& face = this->Body.faces[f];
      result.regions.push_back(
        { this->Body.regionOf[f], face.RequiredQuarters(), face.GivenQuarters(), 0 });
    }
    result.region = result.quads.face;
    std::map<std::array<int, 2>, int> regionAt; // on the left of each side of a quad
    for (std::size_t q = 0; q < result.region.size(); ++q)
    {
      RegionReport& region = result.regions[Index(result.region[q])];
      ++region.quads;
      const std::array<int, 4>& points = result.quads.mesh.quads[q];
      for (std::size_t c = 0; c < 4; ++c)
      {
        regionAt[{ points[c], points[(c + 1) % 4] }] = region.material;
      }
    }
    for (QuadBoundaryEdge& edge : result.quads.mesh.boundary)
    {
      const auto& [from, to] = edge.points;
      const bool isInterface = edge.kind == BoundaryKind::Feature &&
        regionAt.at({ from, to }) != regionAt.at({ to, from });
      edge.kind = isInterface ? BoundaryKind::Interface : edge.kind;
    }
  }

  /// Adds events and warnings.
  void Describe(QuadWorkflowResult& result) const
  {
    const auto counted = [](std::size_t count, const std::string& what)
    { return std::to_string(count) + " " + what + (count == 1 ? "" : "s"); };
    if (!this->Body.lines.empty())
    {
      result.events.push_back("Quads follow the lines between faces of the surface: " +
        counted(this->Body.lines.size(), "line") + " between " +
        counted(this->Body.faces.size(), "face") + ".");
    }
    if (this->PairsFail)
    {
      result.events.emplace_back(
        "Opposite singularities of a face were left out in pairs: with them, no numbers of edges "
        "fit all faces.");
    }
    if (this->Joined > 0)
    {
      result.events.push_back(counted(static_cast<std::size_t>(this->Joined), "face") +
        " could not be meshed and " + (this->Joined == 1 ? "was" : "were") + " joined to others.");
    }
    for (const ConedSurface& face : this->Body.faces)
    {
      result.events.insert(result.events.end(), face.events.begin(), face.events.end());
    }
    if (result.quads.quality.inverted > 0)
    {
      result.warnings.push_back(CountInverted(result.quads.quality) + "; use smaller quads.");
    }
    const std::string missed = result.sizes ? DescribeMissedSizes(*result.sizes) : std::string();
    if (!missed.empty())
    {
      result.warnings.push_back(missed);
    }
    const SurfaceQuality& onSurface = *result.quads.quality.surface;
    if (onSurface.bent > 0)
    {
      result.warnings.push_back("The surface turns by more than 60 degrees within " +
        counted(static_cast<std::size_t>(onSurface.bent), "quad") + ", most near " +
        DescribePlace(onSurface.mostBent) + "; use smaller quads where it is curved.");
    }
  }

  FeaturedPart& Part;
  const SurfaceNames& Names;
  const SurfaceSizes& Sizes;
  const std::vector<SurfaceSideRequest>& Sides;
  const bool IsSized;  ///< SurfaceRequest::HasSizes.
  const bool Chooses;  ///< Whether singularities are chosen.
  const bool JoinsAll; ///< Whether faces of any size may be joined.
  const SurfaceQuadOptions Options;
  SurfaceBody Body;
  std::vector<bool> Fails;   ///< Per face.
  int Joined = 0;            ///< Number of faces joined to others.
  bool WithoutPairs = false; ///< Whether opposite singularities of a face are left out in pairs.
  bool PairsFail = false;    ///< Whether this is because quads with them have failed.
  QuadSeconds Seconds;       ///< In all attempts.
};
}

PartOfQuads MakeQuadsOfBody(FeaturedPart& part, const SurfaceRequest& request, int count,
  bool joinsAll, const Progress& progress)
{
  return BodyMesher(part, request, count, joinsAll).Run(progress);
}
}
