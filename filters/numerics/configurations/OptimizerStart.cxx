#include "OptimizerStart.h"

#include "BoundaryCorners.h"
#include "ConfigurationSymmetry.h"
#include "DomainQueries.h"
#include "Segment.h"

#include <algorithm>
#include <limits>
#include <sstream>

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

/// ClearStart without regard to symmetries.
double MoveApart(const PlanarDomain& domain, double clearance, Configuration& configuration)
{
  constexpr double Enough = 1.2;
  constexpr double Target = 1.3; // a little more, so that it ends
  constexpr int MostSweeps = 100;
  const double reach = BoundaryReach * domain.Diagonal();
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    if (configuration[i].position.allFinite() &&
      SignedDistance(configuration[i].position, domain) > reach)
    {
      inside.push_back(i);
    }
  }
  Configuration moved = configuration;
  double least = std::numeric_limits<double>::infinity();
  for (int sweep = 0; sweep < MostSweeps; ++sweep)
  {
    bool clear = true;
    for (const std::size_t i : inside)
    {
      Point& here = moved[i].position;
      const Point apart = FromBoundary(domain, here);
      least = sweep == 0 ? std::min(least, apart.norm()) : least;
      if (apart.norm() < Enough * clearance)
      {
        here += (Target * clearance - apart.norm()) * apart.normalized();
        clear = false;
      }
      for (const std::size_t j : inside)
      {
        const Point between = here - moved[j].position;
        if (j < i && between.norm() > reach)
        {
          least = sweep == 0 ? std::min(least, between.norm()) : least;
          if (between.norm() < Enough * clearance)
          {
            const Point way = 0.5 * (Target * clearance - between.norm()) * between.normalized();
            here += way;
            moved[j].position -= way;
            clear = false;
          }
        }
      }
    }
    if (clear)
    {
      const bool allInside = std::all_of(inside.begin(), inside.end(),
        [&](std::size_t i) { return SignedDistance(moved[i].position, domain) > 0.0; });
      if (allInside)
      {
        configuration = moved;
        return clearance;
      }
      break;
    }
  }
  return std::min(clearance, 0.5 * least);
}
}

double ClearStart(const PlanarDomain& domain, double clearance, Configuration& configuration)
{
  Configuration moved = configuration;
  const double reached = MoveApart(domain, clearance, moved);
  const auto differs = [](const Configuration& a, const Configuration& b)
  {
    return !std::equal(a.begin(), a.end(), b.begin(),
      [](const Singularity& x, const Singularity& y) { return x.position == y.position; });
  };
  if (!differs(configuration, moved))
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
    if (again == clearance && !differs(symmetric, moved))
    {
      configuration = symmetric;
      break;
    }
  }
  return reached;
}

std::string Short(double value)
{
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}
}
