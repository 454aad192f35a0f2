#include "SizeTargets.h"

#include "DomainQueries.h"
#include "DrillHoles.h"
#include "Error.h"
#include "GrowthLimit.h"
#include "P1Interpolation.h"
#include "PrescriptionCheck.h"
#include "SegmentSearch.h"
#include "SizeExtension.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <sstream>
#include <utility>

namespace crossfield
{
namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();

/// A set of the domain with its requested size.
struct SizedSet
{
  SizeSet what;
  double size = 0.0;
  std::vector<int> vertices;  ///< Of the mesh.
  std::vector<double> beyond; ///< Distance of each from the set, 0 inside; empty: all are inside.

  /// Returns the size at one of the vertices, with a factor of the size of the set.
  double At(std::size_t vertex, double factor, double growth) const
  {
    return factor * this->size + (this->beyond.empty() ? 0.0 : growth * this->beyond[vertex]);
  }
};

/// Returns the loops that belong to a side entirely.
std::vector<std::size_t> LoopsOf(
  const std::vector<LoopArc>& arcs, const SidesAlong& along, int side)
{
  std::vector<std::size_t> loops;
  for (std::size_t l = 0; l < arcs.size(); ++l)
  {
    const std::vector<LoopSide>& starts = along.On(l);
    if (!starts.empty() &&
      std::all_of(
        starts.begin(), starts.end(), [side](const LoopSide& start) { return start.side == side; }))
    {
      loops.push_back(l);
    }
  }
  return loops;
}

/// The sizes of a request at the vertices of a mesh.
class RequestedSizes
{
public:
  RequestedSizes(const PlanarDomain& domain, const ResolvedRequest& request)
    : Request(request)
    , Growth(std::log(request.growth))
    , Places(this->FindPlaces(domain))
    , Topology(ShareTopology(DrillHoles(domain, {}, this->MeshFor(domain))))
    , Base(this->ComputeBase())
    , Sets(this->FindSets(domain))
  {
  }

  /// Returns the sizes with the size `elsewhere`, or this factor of the prescribed sizes, and with a
  /// factor of all other sizes.
  Eigen::VectorXd For(double elsewhere, double factor) const
  {
    Eigen::VectorXd sizes = elsewhere * this->Base;
    Eigen::VectorXd raised = Eigen::VectorXd::Constant(sizes.size(), Infinite);
    bool isRaised = false;
    for (const SizedSet& set : this->Sets)
    {
      for (std::size_t i = 0; i < set.vertices.size(); ++i)
      {
        const int vertex = set.vertices[i];
        if ((set.beyond.empty() || set.beyond[i] == 0.0) && factor * set.size > sizes[vertex])
        {
          raised[vertex] = std::min(raised[vertex], -factor * set.size);
          isRaised = true;
        }
      }
    }
    if (isRaised)
    {
      sizes = sizes.cwiseMax(-LimitGrowth(*this->Topology, raised, this->Growth));
    }
    for (const SizedSet& set : this->Sets)
    {
      for (std::size_t i = 0; i < set.vertices.size(); ++i)
      {
        double& size = sizes[set.vertices[i]];
        size = std::min(size, set.At(i, factor, this->Growth));
      }
    }
    sizes = LimitGrowth(*this->Topology, sizes, this->Growth);
    if (this->Request.minimumSize > 0.0)
    {
      sizes = sizes.cwiseMax(factor * this->Request.minimumSize);
    }
    if (this->Request.maximumSize > 0.0)
    {
      sizes = sizes.cwiseMin(factor * this->Request.maximumSize);
    }
    return sizes;
  }

  /// Returns the size elsewhere and the factor of all sizes that the request has or that give its
  /// number of quads.
  std::pair<double, double> FindFactors() const
  {
    const ResolvedRequest& request = this->Request;
    if (request.quadSize > 0.0)
    {
      return { request.quadSize, 1.0 };
    }
    if (request.quadCount == 0)
    {
      return { request.sizing == Sizing::Field ? 1.0 : this->SizeFor(DefaultQuads), 1.0 };
    }
    // In each direction other sizes leave at most this factor.
    constexpr double Widest = 64.0;
    const double unit = this->SizeFor(request.quadCount);
    const double size = unit * EquivalentSize(this->Mesh(), this->Base);
    const double elsewhere = this->Bisect(
      unit / Widest, unit * Widest, size, [&](double tried) { return this->For(tried, 1.0); });
    const double reached = EquivalentSize(this->Mesh(), this->For(elsewhere, 1.0));
    if (std::abs(reached / size - 1.0) <= Near)
    {
      return { elsewhere, 1.0 };
    }
    const double factor = this->Bisect(size / reached / Widest, size / reached * Widest, size,
      [&](double tried) { return this->For(tried * elsewhere, tried); });
    return { factor * elsewhere, factor };
  }

  /// Returns a sentence if the prescribed sizes grow faster than permitted where it is noticed,
  /// otherwise nothing. `factor`: that of these sizes.
  std::string DescribeJumps(double factor) const
  {
    constexpr double Noticeable = 1.25;
    constexpr double NoticeablePart = 0.02; // of the places with given sizes
    const P1Interpolation limited(
      this->Mesh(), LimitGrowth(*this->Topology, factor * this->Base, this->Growth));
    std::size_t count = 0;
    double largest = Noticeable;
    const Point* worst = nullptr;
    for (const Point& place : this->Places)
    {
      const double ratio = factor * this->Request.prescribedSizes.length(place) / limited.At(place);
      count += ratio > Noticeable ? 1 : 0;
      if (ratio > largest)
      {
        largest = ratio;
        worst = &place;
      }
    }
    if (worst == nullptr ||
      static_cast<double>(count) <= NoticeablePart * static_cast<double>(this->Places.size()))
    {
      return {};
    }
    return "The prescribed sizes grow so fast that their growth is limited to " +
      FormatNumber(this->Request.growth, 3) + " from quad to quad: near " + Describe(*worst) +
      " the target size is " + FormatNumber(limited.At(*worst), 3) + " instead of " +
      FormatNumber(largest * limited.At(*worst), 3) +
      "; a larger growth (Growth, --growth) permits steeper sizes.";
  }

  const TriangleMesh& Mesh() const { return this->Topology->mesh; }
  const std::vector<SizedSet>& GetSets() const { return this->Sets; }

private:
  /// Relative error of the mean size that is accepted: the number of quads is right to 1 %.
  static constexpr double Near = 0.005;

  /// Returns the factor of the base with which there are as many quads as requested.
  double SizeFor(int count) const
  {
    double area = 0.0;
    for (int t = 0; t < this->Topology->TriangleCount(); ++t)
    {
      area += this->Topology->AreaOf(t);
    }
    return std::sqrt(area / count) / EquivalentSize(this->Mesh(), this->Base);
  }

  template <class Sizes>
  double Bisect(double low, double high, double size, const Sizes& sizesFor) const
  {
    constexpr int Steps = 16; // 2⁻¹⁶ of the logarithm of the range is less than Near
    for (int i = 0; i < Steps; ++i)
    {
      const double middle = std::sqrt(low * high);
      const double reached = EquivalentSize(this->Mesh(), sizesFor(middle));
      if (std::abs(reached / size - 1.0) < 0.5 * Near)
      {
        return middle;
      }
      (reached < size ? low : high) = middle;
    }
    return std::sqrt(low * high);
  }

  /// Returns the options of a mesh that resolves the sizes.
  DrillOptions MeshFor(const PlanarDomain& domain) const
  {
    DrillOptions options;
    options.meshSize = this->Request.meshSize;
    const double usual = ResolveMeshSize(options, domain);
    const auto refine = [&](const Point& place, double size)
    {
      if (size < usual)
      {
        options.refinements.push_back({ place, size });
      }
    };
    const std::vector<LoopArc> arcs(domain.loops.begin(), domain.loops.end());
    const SidesAlong along(this->Request.sides, arcs);
    for (const SidePrescription& one : this->Request.prescribed)
    {
      const double size = one.size > 0.0 ? one.size : one.inside;
      for (std::size_t l = 0; l < arcs.size() && size > 0.0 && size < usual; ++l)
      {
        const auto count = static_cast<int>(std::ceil(arcs[l].Length() / size));
        for (int i = 0; i < count; ++i)
        {
          const double at = arcs[l].Length() * i / count;
          if (along.At(l, at) == one.side)
          {
            refine(arcs[l].At(at), size);
          }
        }
      }
    }
    for (const SizeNear& near : this->Request.sizesNear)
    {
      const auto count = static_cast<int>(near.radius / (2.0 * near.size));
      for (int i = -count; i <= count; ++i)
      {
        for (int j = -count; j <= count; ++j)
        {
          if (i * i + j * j <= count * count)
          {
            refine(near.place + 2.0 * near.size * Point(i, j), near.size);
          }
        }
      }
      const bool isInside = SignedDistance(near.place, domain) > 0.5 * std::min(near.size, usual);
      if (isInside &&
        std::find(options.vertices.begin(), options.vertices.end(), near.place) ==
          options.vertices.end())
      {
        options.vertices.push_back(near.place);
      }
    }
    for (const Point& place : this->Places)
    {
      refine(place, this->Request.prescribedSizes.length(place));
    }
    return options;
  }

  /// Returns where the data have lengths in the domain, which may be a part of theirs.
  std::vector<Point> FindPlaces(const PlanarDomain& domain) const
  {
    std::vector<Point> places;
    if (this->Request.sizing == Sizing::Field)
    {
      const SegmentSearch boundary(domain);
      const double reach = BoundaryReach * domain.Diagonal();
      for (const Point& place : this->Request.prescribedSizes.places)
      {
        if (boundary.SignedDistance(place) >= -reach)
        {
          places.push_back(place);
        }
      }
    }
    return places;
  }

  /// Returns the sizes elsewhere, for the factor 1.
  Eigen::VectorXd ComputeBase() const
  {
    return this->Request.sizing == Sizing::Field
      ? SampleSizes(this->Request.prescribedSizes, *this->Topology)
      : Eigen::VectorXd::Ones(this->Topology->VertexCount());
  }

  std::vector<SizedSet> FindSets(const PlanarDomain& domain) const
  {
    std::vector<SizedSet> sets;
    const std::vector<Loop> loops = this->Topology->AlignedLoops();
    const std::vector<LoopArc> arcs(loops.begin(), loops.end());
    const SidesAlong along(this->Request.sides, arcs);
    for (const SidePrescription& one : this->Request.prescribed)
    {
      if (one.size > 0.0)
      {
        SizedSet set = this->SetAt(one.side, one.size);
        set.vertices = this->VerticesOn(arcs, along, one.side);
        sets.push_back(std::move(set));
      }
      if (one.inside > 0.0)
      {
        sets.push_back(this->InsideOf(arcs, along, one));
      }
    }
    for (const SizeNear& near : this->Request.sizesNear)
    {
      sets.push_back(this->Around(domain, near));
    }
    return sets;
  }

  SizedSet SetAt(int side, double size) const
  {
    SizedSet set;
    set.what.name = this->Request.sides.names[side];
    set.what.side = side;
    set.size = size;
    return set;
  }

  std::vector<int> VerticesOn(
    const std::vector<LoopArc>& arcs, const SidesAlong& along, int side) const
  {
    std::vector<int> vertices;
    for (std::size_t l = 0; l < arcs.size(); ++l)
    {
      const std::vector<int>& loop = this->Topology->alignedVertices[l];
      const auto sideOf = [&](std::size_t segment)
      { return along.At(l, 0.5 * (arcs[l].Start(segment) + arcs[l].Start(segment + 1))); };
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        if (sideOf(i) == side || sideOf((i + loop.size() - 1) % loop.size()) == side)
        {
          vertices.push_back(loop[i]);
        }
      }
    }
    return vertices;
  }

  SizedSet InsideOf(const std::vector<LoopArc>& arcs, const SidesAlong& along,
    const SidePrescription& prescription) const
  {
    SizedSet set = this->SetAt(prescription.side, prescription.inside);
    const std::vector<std::size_t> loops = LoopsOf(arcs, along, prescription.side);
    if (loops.empty())
    {
      throw Error("The side '" + set.what.name +
        "' encloses nothing, because it is no closed curve; give the name of a closed one, or the "
        "size of its edges (Size of a side, --size-at).");
    }
    if (loops[0] == 0)
    {
      set.what.side = -1; // all of the part
      for (int v = 0; v < this->Topology->VertexCount(); ++v)
      {
        set.vertices.push_back(v);
      }
      return set;
    }
    set.vertices = this->VerticesOn(arcs, along, prescription.side);
    return set;
  }

  SizedSet Around(const PlanarDomain& domain, const SizeNear& near) const
  {
    if (SignedDistance(near.place, domain) < -near.radius - BoundaryReach * domain.Diagonal())
    {
      throw Error("The position " + Describe(near.place) +
        " of a size is outside of the domain, by more than its radius; move it inside.");
    }
    std::ostringstream name;
    name << near.place.x() << "," << near.place.y();
    SizedSet set;
    set.what.name = name.str();
    set.what.place = near.place;
    set.what.radius = near.radius;
    set.size = near.size;
    // The vertices inside, and those of triangles that have one inside.
    const auto distanceOf = [&](int vertex)
    { return (this->Topology->PointAt(vertex) - near.place).norm(); };
    int nearest = 0;
    for (int v = 1; v < this->Topology->VertexCount(); ++v)
    {
      nearest = distanceOf(v) < distanceOf(nearest) ? v : nearest;
    }
    const double radius = std::max(near.radius, distanceOf(nearest));
    std::set<int> vertices;
    for (const std::array<int, 3>& triangle : this->Mesh().triangles)
    {
      if (std::any_of(triangle.begin(), triangle.end(),
            [&](int vertex) { return distanceOf(vertex) <= radius; }))
      {
        vertices.insert(triangle.begin(), triangle.end());
      }
    }
    for (const int vertex : vertices)
    {
      set.vertices.push_back(vertex);
      set.beyond.push_back(std::max(0.0, distanceOf(vertex) - near.radius));
    }
    return set;
  }

  const ResolvedRequest& Request;
  const double Growth; ///< Per distance.
  const std::vector<Point> Places;
  const SharedPlanarTopology Topology;
  const Eigen::VectorXd Base;
  const std::vector<SizedSet> Sets;
};
}

ResolvedRequest WithSizeTargets(const PlanarDomain& domain, ResolvedRequest request)
{
  RequireConsistent(
    request.sides, { domain.loops.begin(), domain.loops.end() }, request.prescribed);
  if (request.maximumSize > 0.0 && request.minimumSize > request.maximumSize)
  {
    throw Error("The minimum size of quads exceeds the maximum; exchange them.");
  }
  if (!(request.growth > 1.0) || !std::isfinite(request.growth))
  {
    throw Error("The growth of sizes from quad to quad must be a number above 1, such as 1.25.");
  }
  const bool isSized = std::any_of(request.prescribed.begin(), request.prescribed.end(),
    [](const SidePrescription& one) { return one.size > 0.0 || one.inside > 0.0; });
  if (!isSized && request.sizesNear.empty() && request.minimumSize <= 0.0 &&
    request.maximumSize <= 0.0 && request.sizing != Sizing::Field)
  {
    request.quadCount =
      request.quadSize > 0.0 || request.quadCount > 0 ? request.quadCount : DefaultQuads;
    return request;
  }
  const RequestedSizes sizes(domain, request);
  const auto [elsewhere, factor] = sizes.FindFactors();
  const Eigen::VectorXd atVertices = sizes.For(elsewhere, factor);
  const auto lengths = std::make_shared<const P1Interpolation>(sizes.Mesh(), atVertices);
  SizeTargets targets;
  targets.mean = EquivalentSize(sizes.Mesh(), atVertices);
  targets.length = [lengths](const Point& place) { return lengths->At(place); };
  targets.factor = request.sizing == Sizing::Field ? elsewhere : factor;
  for (const SizedSet& set : sizes.GetSets())
  {
    targets.sets.push_back(set.what);
  }
  if (request.sizing == Sizing::Field)
  {
    targets.warning = sizes.DescribeJumps(elsewhere);
  }
  for (SidePrescription& one : request.prescribed)
  {
    one.size *= factor;
  }
  request.sizing = Sizing::Field;
  request.quadSize = request.quadSize > 0.0 || request.quadCount == 0 ? 1.0 : 0.0;
  request.targets = std::move(targets);
  return request;
}
}
