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
/// Returns the vector from the nearest point of the boundary to a point.
Point OffsetFromBoundary(const PlanarDomain& domain, const Point& point)
{
  Point nearest = Point::Constant(std::numeric_limits<double>::infinity());
  for (const Loop& loop : domain.loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point offset = OffsetFromSegment(point, loop[i], loop[(i + 1) % loop.size()]);
      nearest = offset.squaredNorm() < nearest.squaredNorm() ? offset : nearest;
    }
  }
  return nearest;
}

/// Pushes interior singularities away from the boundary and from each other.
class Separation
{
public:
  Separation(const PlanarDomain& domain, const Configuration& configuration)
    : Moved(configuration)
    , Domain(domain)
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
      this->MinimumDistance = std::min(
        this->MinimumDistance, OffsetFromBoundary(domain, configuration[i].position).norm());
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
      const Point offset = OffsetFromBoundary(this->Domain, position);
      if (offset.norm() < RequiredFactor * clearance)
      {
        position += (TargetFactor * clearance - offset.norm()) * offset.normalized();
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
  double BoundaryTolerance;
  std::vector<std::size_t> Inside;
  double MinimumDistance = std::numeric_limits<double>::infinity();
};

/// Implements EnforceClearance without regard to symmetries.
double MoveApart(const PlanarDomain& domain, double clearance, Configuration& configuration)
{
  // The clearance grows gradually, so that each push is smaller than the present distances: in a
  // sharp corner a single push by the full clearance would cross the opposite side.
  constexpr double Growth = 1.2;
  Separation separation(domain, configuration);
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

double EnforceClearance(const PlanarDomain& domain, double clearance, Configuration& configuration)
{
  Configuration moved = configuration;
  const double reached = MoveApart(domain, clearance, moved);
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
    const double projected = MoveApart(domain, clearance, moved);
    if (projected == clearance && equal(symmetric, moved))
    {
      configuration = symmetric;
      break;
    }
  }
  return reached;
}
}
