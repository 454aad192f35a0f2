#include "SideSizes.h"

#include "Error.h"
#include "MeshForPoints.h"
#include "P1Interpolation.h"
#include "PrescriptionCheck.h"
#include "Segment.h"
#include "SizeExtension.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace crossfield
{
namespace
{
/// A side with a prescribed size.
struct SizedSide
{
  double size = 0.0;
  std::vector<std::array<Point, 2>> segments;

  double DistanceTo(const Point& place) const
  {
    double distance = std::numeric_limits<double>::infinity();
    for (const auto& [from, to] : this->segments)
    {
      distance = std::min(distance, OffsetFromSegment(place, from, to).norm());
    }
    return distance;
  }
};

std::vector<SizedSide> FindSizedSides(const PlanarDomain& domain, const ResolvedRequest& request)
{
  const std::vector<LoopArc> arcs(domain.loops.begin(), domain.loops.end());
  const SidesAlong along(request.sides, arcs);
  std::vector<SizedSide> sized;
  for (const SidePrescription& one : request.prescribed)
  {
    if (one.size <= 0.0)
    {
      continue;
    }
    SizedSide side;
    side.size = one.size;
    for (std::size_t l = 0; l < arcs.size(); ++l)
    {
      const Loop& loop = domain.loops[l];
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        if (along.At(l, 0.5 * (arcs[l].Start(i) + arcs[l].Start(i + 1))) == one.side)
        {
          side.segments.push_back({ loop[i], loop[(i + 1) % loop.size()] });
        }
      }
    }
    sized.push_back(std::move(side));
  }
  return sized;
}

/// Sizes at the vertices of a mesh.
class SideSizes
{
public:
  SideSizes(const PlanarDomain& domain, const ResolvedRequest& request)
    : Request(request)
    , Sides(FindSizedSides(domain, request))
    , Topology(ShareTopology(MeshThroughPoints(domain, {}, request.meshSize)))
    , Base(this->ComputeBase())
  {
    for (const BoundaryEdge& edge : this->Topology->mesh.boundary)
    {
      std::vector<std::array<double, 2>> near;
      for (const SizedSide& side : this->Sides)
      {
        near.push_back({ side.size, side.DistanceTo(this->Topology->PointAt(edge.vertices[0])) });
      }
      this->Distances.push_back(std::move(near));
    }
  }

  /// Returns the sizes for a factor of the base sizes.
  Eigen::VectorXd For(double factor) const
  {
    const Eigen::VectorXd base = factor * this->Base;
    Eigen::VectorXd sizes = base;
    if (!this->Sides.empty())
    {
      Eigen::VectorXd ratios = Eigen::VectorXd::Ones(base.size());
      for (std::size_t i = 0; i < this->Distances.size(); ++i)
      {
        const int vertex = this->Topology->mesh.boundary[i].vertices[0];
        ratios[vertex] = this->NearSides(base[vertex], this->Distances[i]) / base[vertex];
      }
      sizes = base.cwiseProduct(ExtendSizes(*this->Topology, ratios));
    }
    if (this->Request.minimumSize > 0.0)
    {
      sizes = sizes.cwiseMax(this->Request.minimumSize);
    }
    if (this->Request.maximumSize > 0.0)
    {
      sizes = sizes.cwiseMin(this->Request.maximumSize);
    }
    return sizes;
  }

  /// Returns the factor that gives a number of quads, or the nearest one within the bounds.
  double FactorFor(int count) const
  {
    const TriangleMesh& mesh = this->Topology->mesh;
    const double size = std::sqrt(this->Area() / count);
    const double unit = size / EquivalentSize(mesh, this->Base);
    // In each direction sizes of sides leave at most this factor; twelve halvings of its logarithm
    // leave less than 0.2 % of the size.
    constexpr double Widest = 64.0;
    double low = std::log(unit / Widest);
    double high = std::log(unit * Widest);
    for (int i = 0; i < 12; ++i)
    {
      const double middle = 0.5 * (low + high);
      (EquivalentSize(mesh, this->For(std::exp(middle))) < size ? low : high) = middle;
    }
    return std::exp(0.5 * (low + high));
  }

  const TriangleMesh& Mesh() const { return this->Topology->mesh; }

private:
  double Area() const
  {
    double area = 0.0;
    for (const auto& [a, b, c] : this->Topology->mesh.triangles)
    {
      area += 0.5 *
        Cross(this->Topology->PointAt(b) - this->Topology->PointAt(a),
          this->Topology->PointAt(c) - this->Topology->PointAt(a));
    }
    return area;
  }

  /// Returns the sizes without sides and bounds, for the factor 1.
  Eigen::VectorXd ComputeBase() const
  {
    const auto count = static_cast<Eigen::Index>(this->Topology->mesh.points.size());
    Eigen::VectorXd sizes = Eigen::VectorXd::Ones(count);
    if (this->Request.sizing != Sizing::Field)
    {
      return sizes;
    }
    const PrescribedSizes& given = this->Request.prescribedSizes;
    if (given.isOnBoundaryOnly)
    {
      for (const BoundaryEdge& edge : this->Topology->mesh.boundary)
      {
        sizes[edge.vertices[0]] = given.length(this->Topology->PointAt(edge.vertices[0]));
      }
      return ExtendSizes(*this->Topology, sizes);
    }
    for (Eigen::Index v = 0; v < count; ++v)
    {
      sizes[v] = given.length(this->Topology->PointAt(static_cast<int>(v)));
    }
    return sizes;
  }

  /// Returns the size at given distances from sides of given sizes.
  static double NearSides(double base, const std::vector<std::array<double, 2>>& near)
  {
    double size = base;
    for (const auto& [ofSide, distance] : near)
    {
      size = ofSide < base ? std::min(size, ofSide + SizeGrowth * distance)
                           : std::max(size, ofSide - SizeGrowth * distance);
    }
    for (const auto& [ofSide, distance] : near)
    {
      if (distance == 0.0)
      {
        return ofSide;
      }
    }
    return size;
  }

  const ResolvedRequest& Request;
  const std::vector<SizedSide> Sides;
  const SharedPlanarTopology Topology;
  const Eigen::VectorXd Base;
  std::vector<std::vector<std::array<double, 2>>>
    Distances; ///< Per entry of mesh.boundary and side: its size and distance.
};
}

ResolvedRequest WithSideSizes(const PlanarDomain& domain, ResolvedRequest request)
{
  RequireConsistent(
    request.sides, { domain.loops.begin(), domain.loops.end() }, request.prescribed);
  const bool isSized = std::any_of(request.prescribed.begin(), request.prescribed.end(),
    [](const SidePrescription& one) { return one.size > 0.0; });
  if (request.maximumSize > 0.0 && request.minimumSize > request.maximumSize)
  {
    throw Error("The minimum size of quads exceeds the maximum; exchange them.");
  }
  if (!isSized && request.minimumSize <= 0.0 && request.maximumSize <= 0.0)
  {
    return request;
  }
  const SideSizes sizes(domain, request);
  const double factor =
    request.quadSize > 0.0 ? request.quadSize : sizes.FactorFor(request.quadCount);
  const auto lengths = std::make_shared<const P1Interpolation>(sizes.Mesh(), sizes.For(factor));
  request.prescribedSizes = { [lengths](const Point& place) { return lengths->At(place); }, false };
  request.sizing = Sizing::Field;
  request.quadSize = 1.0;
  return request;
}
}
