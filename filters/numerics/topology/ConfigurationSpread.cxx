#include "ConfigurationSpread.h"

#include "CanonicalFrame.h"
#include "DomainQueries.h"
#include "Error.h"
#include "HoleRadii.h"
#include "PoincareHopf.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <limits>

namespace crossfield
{
namespace
{
/// Candidate positions inside the domain, with their distances to the boundary.
struct Candidates
{
  std::vector<Point> places;
  std::vector<double> clearances;

  explicit Candidates(const PlanarDomain& domain)
  {
    const CanonicalFrame frame(domain.loops);
    Eigen::AlignedBox2d box;
    for (const Point& point : domain.loops[0])
    {
      box.extend(frame.ToFrame(point));
    }
    constexpr int Count = 64;
    const double step = box.sizes().maxCoeff() / Count;
    const Point half = 0.5 * box.sizes();
    const int columns = static_cast<int>(half.x() / step);
    const int rows = static_cast<int>(half.y() / step);
    for (int row = -rows; row <= rows; ++row)
    {
      for (int column = -columns; column <= columns; ++column)
      {
        const Point place = frame.FromFrame(box.center() + step * Point(column, row));
        const double clearance = SignedDistance(place, domain);
        if (clearance > 0.0)
        {
          this->places.push_back(place);
          this->clearances.push_back(clearance);
        }
      }
    }
  }
};

/// Free disks of the candidates: the largest disks around them inside the domain that do not overlap
/// equal disks around singularities. The two nearest singularities of every candidate are stored, so
/// that a move of a singularity changes few of them.
class FreeDisks
{
public:
  FreeDisks(const Candidates& candidates, const Configuration& singularities)
    : Places(candidates)
    , Nearest(candidates.places.size())
  {
    for (const Singularity& singularity : singularities)
    {
      this->Add(singularity.position);
    }
  }

  void Add(const Point& position)
  {
    this->Positions.push_back(position);
    for (std::size_t c = 0; c < this->Nearest.size(); ++c)
    {
      this->Insert(c, this->Positions.size() - 1);
    }
  }

  void Move(std::size_t singularity, const Point& position)
  {
    this->Positions[singularity] = position;
    for (std::size_t c = 0; c < this->Nearest.size(); ++c)
    {
      Two& two = this->Nearest[c];
      if (two[0].singularity != singularity && two[1].singularity != singularity)
      {
        this->Insert(c, singularity);
        continue;
      }
      two = {};
      for (std::size_t i = 0; i < this->Positions.size(); ++i)
      {
        this->Insert(c, i);
      }
    }
  }

  /// Returns the radius of the free disk of a candidate, without regard to one singularity.
  double Radius(std::size_t candidate, std::size_t except) const
  {
    const Two& two = this->Nearest[candidate];
    const Neighbour& nearest = two[0].singularity == except ? two[1] : two[0];
    return std::min(this->Places.clearances[candidate], 0.5 * nearest.distance);
  }

  /// Returns the candidate with the largest free disk, without regard to one singularity.
  std::size_t Best(std::size_t except) const
  {
    std::size_t best = 0;
    double largest = -1.0;
    for (std::size_t c = 0; c < this->Nearest.size(); ++c)
    {
      const double radius = this->Radius(c, except);
      // The margin above rounding prevents rounding from deciding on symmetric domains.
      if (radius > largest * (1.0 + 1e-9))
      {
        best = c;
        largest = radius;
      }
    }
    return best;
  }

private:
  static constexpr std::size_t None = std::numeric_limits<std::size_t>::max();
  struct Neighbour
  {
    double distance = std::numeric_limits<double>::infinity();
    std::size_t singularity = None;
  };
  using Two = std::array<Neighbour, 2>;

  /// Stores a singularity among the two nearest ones of a candidate if it is.
  void Insert(std::size_t candidate, std::size_t singularity)
  {
    Two& two = this->Nearest[candidate];
    const double distance = (this->Positions[singularity] - this->Places.places[candidate]).norm();
    if (distance < two[0].distance)
    {
      two[1] = two[0];
      two[0] = { distance, singularity };
    }
    else if (distance < two[1].distance)
    {
      two[1] = { distance, singularity };
    }
  }

  const Candidates& Places;
  std::vector<Point> Positions;
  std::vector<Two> Nearest; ///< Of every candidate.
};

/// Returns the corners of a loop, starting after one that is not cancelled, so that no pair is
/// split.
std::vector<Corner> CornersOfLoop(const std::vector<Corner>& corners, int loop)
{
  std::vector<Corner> own;
  std::copy_if(corners.begin(), corners.end(), std::back_inserter(own),
    [loop](const Corner& corner) { return corner.loop == loop; });
  const auto sharp = std::find_if(
    own.begin(), own.end(), [](const Corner& corner) { return !corner.Cancellable(); });
  std::rotate(own.begin(), sharp, own.end());
  return own;
}

/// Returns one +1 for every two consecutive corners in [3π/4, π) on a loop, or for a single one.
Configuration CancelFlatCorners(const PlanarDomain& domain, const std::vector<Corner>& corners)
{
  Configuration added;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    if (!corners[i].Cancellable())
    {
      continue;
    }
    Point from = corners[i].position;
    Point inward = corners[i].inward;
    double reach = std::numeric_limits<double>::infinity();
    if (i + 1 < corners.size() && corners[i + 1].Cancellable())
    {
      const Point along = corners[i + 1].position - corners[i].position;
      from = 0.5 * (corners[i].position + corners[i + 1].position);
      inward = (corners[i].inward + corners[i + 1].inward).normalized();
      reach = 0.5 * along.norm();
      ++i;
    }
    Singularity singularity;
    const double distance = DistanceAlongRay(domain, from, inward);
    singularity.position = from + std::min(reach, 0.25 * distance) * inward;
    if (SignedDistance(singularity.position, domain) <= 0.0)
    {
      // The segment between two corners on a curve may leave the domain; the inward ray of the
      // first corner does not.
      const double own = DistanceAlongRay(domain, corners[i].position, corners[i].inward);
      singularity.position = corners[i].position + 0.25 * own * corners[i].inward;
    }
    added.push_back(singularity);
  }
  return added;
}
}

Configuration SpreadConfiguration(
  const PlanarDomain& domain, const SpreadOptions& options, const Progress& progress)
{
  for (const Singularity& singularity : options.given)
  {
    if (!(SignedDistance(singularity.position, domain) > 0.0))
    {
      throw Error("A given singularity lies outside the domain; move it inside.");
    }
  }
  Configuration result = options.given;
  const std::size_t given = result.size();
  if (options.cancelFlatCorners)
  {
    const std::vector<Corner> corners = FindCorners(domain.loops, options.cornerAngle);
    for (std::size_t loop = 0; loop < domain.loops.size(); ++loop)
    {
      const Configuration added =
        CancelFlatCorners(domain, CornersOfLoop(corners, static_cast<int>(loop)));
      result.insert(result.end(), added.begin(), added.end());
    }
  }
  const std::size_t fixed = result.size();
  const int missing =
    CountQuarters(domain.loops, TotalQuarters(result), options.cornerAngle, options.corners)
      .requiredInteriorQuarters -
    TotalQuarters(result);

  // 1. Add singularities one by one at the position with the largest free disk.
  const Candidates candidates(domain);
  progress.Report(0.5);
  if (candidates.places.empty() && missing != 0)
  {
    throw Error("The domain is too thin to place singularities in it; give them yourself.");
  }
  FreeDisks disks(candidates, result);
  std::vector<std::size_t> chosen;
  for (int i = 0; i < std::abs(missing); ++i)
  {
    Singularity singularity;
    chosen.push_back(disks.Best(result.size()));
    singularity.position = candidates.places[chosen.back()];
    disks.Add(singularity.position);
    singularity.quarterIndex = missing > 0 ? 1 : -1;
    result.push_back(singularity);
  }

  // 2. Move singularities in turn until none can be improved. Every move enlarges the free disk of
  // one of them, but moves may repeat in a cycle.
  constexpr int MostSweeps = 50;
  bool moved = true;
  for (int sweep = 0; sweep < MostSweeps && moved; ++sweep)
  {
    progress.Report(0.5 + 0.5 * sweep / MostSweeps);
    moved = false;
    for (std::size_t i = fixed; i < result.size(); ++i)
    {
      const std::size_t best = disks.Best(i);
      const std::size_t here = chosen[i - fixed];
      if (disks.Radius(best, i) > disks.Radius(here, i) * (1.0 + 1e-9))
      {
        chosen[i - fixed] = best;
        result[i].position = candidates.places[best];
        disks.Move(i, result[i].position);
        moved = true;
      }
    }
  }
  AssignRadii(domain, result, given);
  return result;
}

std::optional<Point> FindFreePlace(const PlanarDomain& domain, const Configuration& others)
{
  const Candidates candidates(domain);
  if (candidates.places.empty())
  {
    return std::nullopt;
  }
  return candidates.places[FreeDisks(candidates, others).Best(others.size())];
}

void AssignRadii(const PlanarDomain& domain, Configuration& configuration, std::size_t first)
{
  for (std::size_t i = first; i < configuration.size(); ++i)
  {
    configuration[i].radius = DefaultRadius(domain, configuration, i, domain.Diagonal() / 40.0);
  }
}
}
