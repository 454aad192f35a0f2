#include "SurfaceSizes.h"

#include "AbsoluteCurvature.h"
#include "Error.h"
#include "GrowthLimit.h"
#include "QuadRequest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace crossfield
{
namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();

/// Throws Error unless a number is positive, or 0.
void RequireNotNegative(double value, const std::string& what)
{
  if (!(value >= 0.0) || !std::isfinite(value))
  {
    throw Error(what + " must be a positive number, or 0 for none.");
  }
}

class SizeResolver
{
public:
  SizeResolver(const MeshTopology& topology, const std::vector<std::array<int, 2>>& twins,
    const std::vector<std::string>& sideNames, const std::vector<SurfaceSideRequest>& sides,
    const SurfaceSizes& sizes)
    : Topology(topology)
    , Twins(twins)
    , Sizes(sizes)
    , Growth(std::log(sizes.growth))
    , Area(topology.Area())
    , Base(Eigen::VectorXd::Ones(topology.VertexCount()))
    , Largest(Eigen::VectorXd::Constant(topology.VertexCount(), Infinite))
  {
    for (int vertex = 0; sizes.length && vertex < topology.VertexCount(); ++vertex)
    {
      this->Base[vertex] = sizes.length(topology.PositionOf(vertex));
    }
    if (sizes.chordError > 0.0)
    {
      // The middle of a quad is this far from a surface with these curvatures.
      this->Largest =
        (8.0 * sizes.chordError / AbsoluteCurvature(topology).array()).sqrt().matrix();
    }
    for (std::size_t entry = 0; entry < sideNames.size(); ++entry)
    {
      for (const SurfaceSideRequest& one : sides)
      {
        const bool isThere = one.size > 0.0 && sideNames[entry] == one.side;
        for (const int vertex : topology.BoundaryAt(static_cast<int>(entry)).vertices)
        {
          double& largest = this->Largest[vertex];
          largest = isThere ? std::min(largest, one.size) : largest;
        }
      }
    }
    for (const SurfaceSizeNear& near : sizes.near)
    {
      // From vertices about the place on, sizes grow along the surface.
      constexpr double About = 2.0;
      Eigen::VectorXd distance(topology.VertexCount());
      for (int vertex = 0; vertex < topology.VertexCount(); ++vertex)
      {
        distance[vertex] = (topology.PositionOf(vertex) - near.place).norm();
      }
      const NearTarget one = { near, std::max(near.radius, About * distance.minCoeff()) };
      for (int vertex = 0; vertex < topology.VertexCount(); ++vertex)
      {
        this->Largest[vertex] =
          std::min(this->Largest[vertex], one.At(distance[vertex], this->Growth));
      }
      this->Near.push_back(one);
    }
  }

  SurfaceTargets Resolve(double quadSize, int quadCount) const
  {
    return { this->For(quadSize > 0.0 ? quadSize : this->Elsewhere(quadCount)), this->Near,
      this->Growth };
  }

private:
  /// Returns the sizes with a factor of the prescribed ones, or a size elsewhere.
  Eigen::VectorXd For(double elsewhere) const
  {
    Eigen::VectorXd sizes = (elsewhere * this->Base).cwiseMin(this->Largest);
    // Each face limits its neighbours. Sizes only fall, so this ends.
    for (bool isLowered = true; isLowered;)
    {
      sizes = LimitGrowth(this->Topology, sizes, this->Growth);
      isLowered = false;
      for (const auto& [one, other] : this->Twins)
      {
        const double lower = std::min(sizes[one], sizes[other]);
        constexpr double Noticeable = 1e-3;
        isLowered = isLowered || std::max(sizes[one], sizes[other]) > (1.0 + Noticeable) * lower;
        sizes[one] = sizes[other] = lower;
      }
    }
    if (this->Sizes.minimum > 0.0)
    {
      sizes = sizes.cwiseMax(this->Sizes.minimum);
    }
    if (this->Sizes.maximum > 0.0)
    {
      sizes = sizes.cwiseMin(this->Sizes.maximum);
    }
    return sizes;
  }

  double CountFor(double elsewhere) const
  {
    SurfaceTargets targets;
    targets.sizes = this->For(elsewhere);
    return targets.CountOn(this->Topology);
  }

  /// Returns the size elsewhere for a number of quads, or the default one.
  double Elsewhere(int count) const
  {
    if (count == 0)
    {
      if (this->Sizes.length)
      {
        return 1.0;
      }
      // Where a surface with a chord error is plane, quads are at most as large as a twenty-fifth of it.
      const double largest = std::sqrt(this->Area / 25.0);
      const bool isCurved = this->Largest.minCoeff() < largest;
      return this->Sizes.chordError > 0.0 && isCurved ? largest
                                                      : std::sqrt(this->Area / DefaultQuads);
    }
    // In each direction other sizes leave at most this factor.
    constexpr double Widest = 64.0;
    constexpr int Steps = 16;
    const double unit = std::sqrt(this->Area / count);
    double low = unit / Widest;
    double high = unit * Widest;
    for (int i = 0; i < Steps; ++i)
    {
      const double middle = std::sqrt(low * high);
      (this->CountFor(middle) > count ? low : high) = middle;
    }
    return std::sqrt(low * high);
  }

  const MeshTopology& Topology;
  const std::vector<std::array<int, 2>>& Twins;
  const SurfaceSizes& Sizes;
  const double Growth;
  const double Area;
  std::vector<NearTarget> Near;
  Eigen::VectorXd Base;
  Eigen::VectorXd Largest; ///< Infinite where nothing limits sizes.
};
}

bool SurfaceSizes::IsEmpty() const
{
  return !this->isUniform && this->chordError == 0.0 && this->near.empty() && !this->length &&
    this->minimum == 0.0 && this->maximum == 0.0;
}

SurfaceTargets ResolveSizes(const MeshTopology& topology,
  const std::vector<std::array<int, 2>>& twins, const std::vector<std::string>& sideNames,
  const std::vector<SurfaceSideRequest>& sides, const SurfaceSizes& sizes, double quadSize,
  int quadCount)
{
  RequireNotNegative(sizes.chordError, "The chord error");
  RequireNotNegative(sizes.minimum, "The smallest size");
  RequireNotNegative(sizes.maximum, "The largest size");
  for (const SurfaceSizeNear& one : sizes.near)
  {
    if (!(one.size > 0.0) || !std::isfinite(one.size))
    {
      throw Error("The size near " + DescribeInSpace(one.place) + " must be a positive number.");
    }
    RequireNotNegative(one.radius, "The radius of the size near " + DescribeInSpace(one.place));
  }
  for (const SurfaceSideRequest& one : sides)
  {
    RequireNotNegative(one.size, "The size at '" + one.side + "'");
  }
  if (!(sizes.growth > 1.0))
  {
    throw Error("The growth of sizes must be above 1.");
  }
  return SizeResolver(topology, twins, sideNames, sides, sizes).Resolve(quadSize, quadCount);
}
}
