#include "OptimizerStart.h"

#include "BoundaryCorners.h"
#include "ConfigurationSymmetry.h"
#include "DomainQueries.h"
#include "Segment.h"

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

BoundaryOffset OffsetFromBoundary(
  const PlanarDomain& domain, const ClearanceFactors& factors, const Point& point)
{
  BoundaryOffset nearest;
  for (std::size_t l = 0; l < domain.loops.size(); ++l)
  {
    const Loop& loop = domain.loops[l];
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const BoundaryOffset offset = {
        OffsetFromSegment(point, loop[i], loop[(i + 1) % loop.size()]), FactorAt(factors, l, i)
      };
      nearest = offset.Distance() < nearest.Distance() ? offset : nearest;
    }
  }
  return nearest;
}

/// Pushes interior singularities away from the boundary and from each other.
class Separation
{
public:
  Separation(
    const PlanarDomain& domain, const ClearanceFactors& factors, const Configuration& configuration)
    : Moved(configuration)
    , Domain(domain)
    , Factors(factors)
    , BoundaryTolerance(BoundaryReach * domain.Diagonal())
  {
    for (std::size_t i = 0; i < configuration.size(); ++i)
    {
      if (configuration[i].position.allFinite() &&
        SignedDistance(configuration[i].position, domain) > this->BoundaryTolerance)
      {
        this->Inside.push_back(i);
      }
    }
    for (const std::size_t i : this->Inside)
    {
      this->MinimumDistance = std::min(this->MinimumDistance,
        OffsetFromBoundary(domain, factors, configuration[i].position).Distance());
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
          [&](std::size_t i)
          { return SignedDistance(this->Moved[i].position, this->Domain) > 0.0; });
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
      const BoundaryOffset offset = OffsetFromBoundary(this->Domain, this->Factors, position);
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
  const PlanarDomain& Domain;
  const ClearanceFactors& Factors;
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
    MatchSymmetry(configuration, FindSymmetries(domain), 1e-9 * domain.Diagonal());
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
