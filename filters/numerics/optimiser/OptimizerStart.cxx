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
/// The way from the nearest point of the boundary.
Point FromBoundary(const PlanarDomain& domain, const Point& place)
{
  Point nearest = Point::Constant(std::numeric_limits<double>::infinity());
  for (const Loop& loop : domain.loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point apart = WayFromSegment(place, loop[i], loop[(i + 1) % loop.size()]);
      nearest = apart.squaredNorm() < nearest.squaredNorm() ? apart : nearest;
    }
  }
  return nearest;
}

/// Moves singularities inside apart.
class Spreading
{
public:
  Spreading(const PlanarDomain& domain, const Configuration& configuration)
    : Places(configuration)
    , Domain(domain)
    , Reach(BoundaryReach * domain.Diagonal())
  {
    for (std::size_t i = 0; i < configuration.size(); ++i)
    {
      if (configuration[i].position.allFinite() &&
        SignedDistance(configuration[i].position, domain) > this->Reach)
      {
        this->Inside.push_back(i);
      }
    }
    for (const std::size_t i : this->Inside)
    {
      this->Least = std::min(this->Least, FromBoundary(domain, configuration[i].position).norm());
      for (const std::size_t j : this->Inside)
      {
        const double apart = (configuration[i].position - configuration[j].position).norm();
        this->Least = j < i && apart > this->Reach ? std::min(this->Least, apart) : this->Least;
      }
    }
  }

  /// The least distance at the start.
  double GetLeast() const { return this->Least; }

  const Configuration& GetPlaces() const { return this->Places; }

  /// Pushes what is nearer than the clearance until nothing is; whether it succeeded.
  bool To(double clearance)
  {
    constexpr int MostSweeps = 100;
    for (int sweep = 0; sweep < MostSweeps; ++sweep)
    {
      if (!this->Sweep(clearance))
      {
        return std::all_of(this->Inside.begin(), this->Inside.end(),
          [&](std::size_t i)
          { return SignedDistance(this->Places[i].position, this->Domain) > 0.0; });
      }
    }
    return false;
  }

  static constexpr double Enough = 1.2;

private:
  /// Whether anything moved.
  bool Sweep(double clearance)
  {
    constexpr double Target = 1.3; // a little more than enough, so that it ends
    bool moved = false;
    for (const std::size_t i : this->Inside)
    {
      Point& here = this->Places[i].position;
      const Point apart = FromBoundary(this->Domain, here);
      if (apart.norm() < Enough * clearance)
      {
        here += (Target * clearance - apart.norm()) * apart.normalized();
        moved = true;
      }
      for (const std::size_t j : this->Inside)
      {
        const Point between = here - this->Places[j].position;
        if (j < i && between.norm() > this->Reach && between.norm() < Enough * clearance)
        {
          const Point way = 0.5 * (Target * clearance - between.norm()) * between.normalized();
          here += way;
          this->Places[j].position -= way;
          moved = true;
        }
      }
    }
    return moved;
  }

  Configuration Places;
  const PlanarDomain& Domain;
  double Reach;
  std::vector<std::size_t> Inside;
  double Least = std::numeric_limits<double>::infinity();
};

/// ClearStart without regard to symmetries.
double MoveApart(const PlanarDomain& domain, double clearance, Configuration& configuration)
{
  // The clearance grows by so much at a time that a push is smaller than the distances that there are: in a sharp corner one
  // push by all of it would go through the other side.
  constexpr double Growth = 1.2;
  Spreading spreading(domain, configuration);
  const double least = spreading.GetLeast();
  double reached = std::min(clearance, least / Spreading::Enough);
  while (reached < clearance)
  {
    reached = std::min(clearance, Growth * reached);
    if (!spreading.To(reached))
    {
      return std::min(clearance, 0.5 * least);
    }
  }
  configuration = spreading.GetPlaces();
  return clearance;
}
}

double ClearStart(const PlanarDomain& domain, double clearance, Configuration& configuration)
{
  Configuration moved = configuration;
  const double reached = MoveApart(domain, clearance, moved);
  const auto same = [](const Configuration& a, const Configuration& b)
  {
    return std::equal(a.begin(), a.end(), b.begin(),
      [](const Singularity& x, const Singularity& y) { return x.position == y.position; });
  };
  if (same(configuration, moved))
  {
    return reached;
  }
  // They move one after the other, so the symmetric place between is a little nearer.
  constexpr int MostTurns = 5;
  const ConfigurationSymmetry symmetry =
    MatchSymmetry(configuration, FindSymmetries(domain), 1e-9 * domain.Diagonal());
  configuration = moved;
  for (int turn = 0; turn < MostTurns && !symmetry.IsTrivial(); ++turn)
  {
    Configuration symmetric = moved;
    symmetry.Project(symmetric);
    moved = symmetric;
    const double again = MoveApart(domain, clearance, moved);
    if (again == clearance && same(symmetric, moved))
    {
      configuration = symmetric;
      break;
    }
  }
  return reached;
}
}
