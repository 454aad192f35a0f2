#include "OptimizerStart.h"

#include "BoundaryCorners.h"
#include "ConfigurationSymmetry.h"
#include "CurveSymmetry.h"
#include "DomainQueries.h"
#include "Segment.h"
#include "SegmentSearch.h"

#include <algorithm>
#include <limits>

namespace crossfield
{
namespace
{
/// The vector from the nearest point of the boundary to a point.
struct BoundaryOffset
{
  Point vector = Point::Constant(std::numeric_limits<double>::infinity());
  double factor = 1.0; ///< Of the clearance there.

  /// Returns the distance that counts for the clearance.
  double Distance() const { return this->vector.norm() / this->factor; }
};

/// The sides of a domain with the factors of the clearance.
class FactoredSides
{
public:
  FactoredSides(const PlanarDomain& domain, const ClearanceFactors& factors)
    : Sides(domain)
  {
    for (std::size_t l = 0; l < domain.loops.size(); ++l)
    {
      for (std::size_t i = 0; i < domain.loops[l].size(); ++i)
      {
        this->Factors.push_back(FactorAt(factors, l, i));
      }
    }
    this->LargestFactor = *std::max_element(this->Factors.begin(), this->Factors.end());
  }

  double SignedDistance(const Point& point) const { return this->Sides.SignedDistance(point); }

  /// Returns the offset with the minimum distance, of the first side if there are several.
  BoundaryOffset OffsetOf(const Point& point) const
  {
    const double bound = this->OffsetFrom(this->Sides.Find(point).segment, point).Distance();
    BoundaryOffset nearest;
    this->Sides.ForNear(point, bound * this->LargestFactor,
      [&](std::size_t side)
      {
        const BoundaryOffset offset = this->OffsetFrom(side, point);
        nearest = offset.Distance() < nearest.Distance() ? offset : nearest;
      });
    return nearest;
  }

private:
  BoundaryOffset OffsetFrom(std::size_t side, const Point& point) const
  {
    const auto& [from, to] = this->Sides.At(side);
    return { OffsetFromSegment(point, from, to), this->Factors[side] };
  }

  SegmentSearch Sides;
  std::vector<double> Factors;
  double LargestFactor = 1.0;
};

/// Pushes interior singularities away from the boundary and from each other.
class Separation
{
public:
  Separation(
    const PlanarDomain& domain, const ClearanceFactors& factors, const Configuration& configuration)
    : Moved(configuration)
    , Sides(domain, factors)
    , BoundaryTolerance(BoundaryReach * domain.Diagonal())
  {
    for (std::size_t i = 0; i < configuration.size(); ++i)
    {
      if (configuration[i].position.allFinite() &&
        this->Sides.SignedDistance(configuration[i].position) > this->BoundaryTolerance)
      {
        this->Inside.push_back(i);
      }
    }
    for (const std::size_t i : this->Inside)
    {
      this->MinimumDistance =
        std::min(this->MinimumDistance, this->Sides.OffsetOf(configuration[i].position).Distance());
      for (const std::size_t j : this->Inside)
      {
        const double distance = (configuration[i].position - configuration[j].position).norm();
        this->MinimumDistance = j < i && distance > this->BoundaryTolerance
          ? std::min(this->MinimumDistance, distance)
          : this->MinimumDistance;
      }
    }
  }

  /// Returns the minimum distance at the start.
  double GetMinimumDistance() const { return this->MinimumDistance; }

  const Configuration& GetMoved() const { return this->Moved; }

  /// Pushes singularities until all distances are sufficient for the clearance. Returns whether it
  /// succeeded.
  bool Separate(double clearance)
  {
    constexpr int MaximumSweeps = 100;
    for (int sweep = 0; sweep < MaximumSweeps; ++sweep)
    {
      if (!this->Sweep(clearance))
      {
        return std::all_of(this->Inside.begin(), this->Inside.end(),
          [&](std::size_t i) { return this->Sides.SignedDistance(this->Moved[i].position) > 0.0; });
      }
    }
    return false;
  }

  static constexpr double RequiredFactor = 1.2;

private:
  /// Pushes each singularity once. Returns whether anything moved.
  bool Sweep(double clearance)
  {
    // Slightly larger than RequiredFactor, so that the sweeps end.
    constexpr double TargetFactor = 1.3;
    bool moved = false;
    for (const std::size_t i : this->Inside)
    {
      Point& position = this->Moved[i].position;
      const BoundaryOffset offset = this->Sides.OffsetOf(position);
      if (offset.Distance() < RequiredFactor * clearance)
      {
        position += offset.factor * (TargetFactor * clearance - offset.Distance()) *
          offset.vector.normalized();
        moved = true;
      }
      for (const std::size_t j : this->Inside)
      {
        const Point difference = position - this->Moved[j].position;
        if (j < i && difference.norm() > this->BoundaryTolerance &&
          difference.norm() < RequiredFactor * clearance)
        {
          const Point push =
            0.5 * (TargetFactor * clearance - difference.norm()) * difference.normalized();
          position += push;
          this->Moved[j].position -= push;
          moved = true;
        }
      }
    }
    return moved;
  }

  Configuration Moved;
  FactoredSides Sides;
  double BoundaryTolerance;
  std::vector<std::size_t> Inside;
  double MinimumDistance = std::numeric_limits<double>::infinity();
};

/// Implements EnforceClearance without regard to symmetries.
double MoveApart(const PlanarDomain& domain, double clearance, const ClearanceFactors& factors,
  Configuration& configuration)
{
  // The clearance grows gradually, so that each push is smaller than the present distances: in a
  // sharp corner a single push by the full clearance would cross the opposite side.
  constexpr double Growth = 1.2;
  Separation separation(domain, factors, configuration);
  const double minimumDistance = separation.GetMinimumDistance();
  double reached = std::min(clearance, minimumDistance / Separation::RequiredFactor);
  while (reached < clearance)
  {
    reached = std::min(clearance, Growth * reached);
    if (!separation.Separate(reached))
    {
      return std::min(clearance, 0.5 * minimumDistance);
    }
  }
  configuration = separation.GetMoved();
  return clearance;
}
}

double EnforceClearance(const PlanarDomain& domain, double clearance, Configuration& configuration,
  const ClearanceFactors& factors)
{
  Configuration moved = configuration;
  const double reached = MoveApart(domain, clearance, factors, moved);
  const auto equal = [](const Configuration& a, const Configuration& b)
  {
    return std::equal(a.begin(), a.end(), b.begin(),
      [](const Singularity& x, const Singularity& y) { return x.position == y.position; });
  };
  if (equal(configuration, moved))
  {
    return reached;
  }
  // Singularities are pushed one after the other, so that the symmetrised positions may be slightly
  // too close and have to be separated again.
  constexpr int MaximumRounds = 5;
  const ConfigurationSymmetry symmetry =
    MatchSymmetry(configuration, FindCurveSymmetries(domain), 1e-9 * domain.Diagonal());
  configuration = moved;
  for (int round = 0; round < MaximumRounds && !symmetry.IsTrivial(); ++round)
  {
    Configuration symmetric = moved;
    symmetry.Project(symmetric);
    moved = symmetric;
    const double projected = MoveApart(domain, clearance, factors, moved);
    if (projected == clearance && equal(symmetric, moved))
    {
      configuration = symmetric;
      break;
    }
  }
  return reached;
}
}
