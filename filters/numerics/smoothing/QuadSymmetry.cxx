#include "QuadSymmetry.h"

#include "BoundarySymmetry.h"
#include "Index.h"
#include "NodePairs.h"
#include "Parts.h"
#include "PointCorners.h"
#include "PointGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace crossfield
{
namespace
{
/// The image of every point.
using Permutation = std::vector<int>;

/// Returns whether no two points have the same image.
bool IsBijection(const Permutation& images)
{
  std::vector<bool> taken(images.size(), false);
  for (const int image : images)
  {
    if (taken[image])
    {
      return false;
    }
    taken[image] = true;
  }
  return true;
}

class Symmetriser
{
public:
  Symmetriser(QuadMesh& mesh, const BoundaryCurves& curves, double tolerance, bool released)
    : Mesh(mesh)
    , Curves(curves)
    , Reach(tolerance)
    , Released(released)
  {
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      if (this->IsFixed(mesh.points[p]))
      {
        this->Fixed.push_back(p);
      }
    }
  }

  /// Returns the permutation of points by a symmetry. It is empty if the mesh does not have the
  /// symmetry, or images are farther from points than `worst` edges, which receives the largest
  /// distance.
  Permutation Match(const Isometry& symmetry, double& worst)
  {
    if (!this->MatchesFixed(symmetry))
    {
      return {};
    }
    if (!this->Grid)
    {
      this->Grid.emplace(this->Mesh);
    }
    const auto count = static_cast<std::ptrdiff_t>(this->Mesh.points.size());
    Permutation images(this->Mesh.points.size(), -1);
    std::vector<double> farthest(PartCount(count), 0.0);
    ForParts(farthest.size(),
      [&](std::size_t part)
      {
        const auto [begin, end] = PartRange(count, part, farthest.size());
        for (int p = begin; p < end; ++p)
        {
          const QuadPoint& point = this->Mesh.points[p];
          const Point place = symmetry(point.InPlane());
          const int image = this->Grid->Find(place, p);
          const bool fits = image >= 0 && this->Fits(point, this->Mesh.points[image], place);
          const double distance =
            fits ? this->Grid->EdgesBetween(place, image) : std::numeric_limits<double>::infinity();
          farthest[part] = std::max(farthest[part], distance);
          if (farthest[part] > worst)
          {
            return;
          }
          images[p] = image;
        }
      });
    const double distance = *std::max_element(farthest.begin(), farthest.end());
    if (distance > worst || !IsBijection(images) || !this->MapsQuads(images))
    {
      return {};
    }
    worst = distance;
    return images;
  }

  /// Adds the images of all points under a symmetry, mapped back by its inverse, to `sums`.
  void Add(const Isometry& inverse, const Permutation& images, std::vector<Point>& sums) const
  {
    ForRanges(static_cast<std::ptrdiff_t>(sums.size()),
      [&](int begin, int end)
      {
        for (std::size_t p = Index(begin); p < Index(end); ++p)
        {
          sums[p] += inverse(this->Mesh.points[images[p]].InPlane());
        }
      });
  }

  /// Moves all points that are not fixed to the mean sums / count.
  void MovePoints(const std::vector<Point>& sums, double count)
  {
    for (std::size_t p = 0; p < sums.size(); ++p)
    {
      QuadPoint& point = this->Mesh.points[p];
      if (this->IsFixed(point))
      {
        continue;
      }
      point.MoveTo(sums[p] / count);
      if (point.curve.loop >= 0)
      {
        point.curve = this->Curves.Nearest(point.curve.loop, point.InPlane());
        point.MoveTo(this->Curves.At(point.curve));
      }
    }
  }

  /// Returns whether fixed points map to fixed points: a fast test that excludes most symmetries.
  bool MatchesFixed(const Isometry& symmetry) const
  {
    return std::all_of(this->Fixed.begin(), this->Fixed.end(),
      [&](std::size_t p)
      {
        const QuadPoint& point = this->Mesh.points[p];
        const Point place = symmetry(point.InPlane());
        return std::any_of(this->Fixed.begin(), this->Fixed.end(),
          [&](std::size_t q) { return this->Fits(point, this->Mesh.points[q], place); });
      });
  }

private:
  bool IsFixed(const QuadPoint& point) const
  {
    return point.fixed && !point.turns && (point.held || !(this->Released && point.curve.loop < 0));
  }

  bool Fits(const QuadPoint& point, const QuadPoint& image, const Point& place) const
  {
    return point.quarterIndex == image.quarterIndex && point.turns == image.turns &&
      (point.curve.loop < 0) == (image.curve.loop < 0) &&
      this->IsFixed(point) == this->IsFixed(image) &&
      (!this->IsFixed(point) || (image.InPlane() - place).norm() <= this->Reach);
  }

  /// Returns whether the images of the points of every quad are those of a quad.
  bool MapsQuads(const Permutation& images)
  {
    if (!this->Corners)
    {
      this->Corners.emplace(this->Mesh);
    }
    const auto sorted = [](std::array<int, 4> points)
    {
      std::sort(points.begin(), points.end());
      return points;
    };
    const auto isQuad = [&](const std::array<int, 4>& points)
    {
      for (int i = this->Corners->Begin(points[0]); i < this->Corners->Begin(points[0] + 1); ++i)
      {
        if (sorted(this->Mesh.quads[this->Corners->Get(i) / 4]) == points)
        {
          return true;
        }
      }
      return false;
    };
    return SumOfRanges(static_cast<std::ptrdiff_t>(this->Mesh.quads.size()),
             [&](int begin, int end)
             {
               for (std::size_t q = Index(begin); q < Index(end); ++q)
               {
                 std::array<int, 4> points = this->Mesh.quads[q];
                 for (int& point : points)
                 {
                   point = images[point];
                 }
                 if (!isQuad(sorted(points)))
                 {
                   return 1.0;
                 }
               }
               return 0.0;
             }) == 0.0;
  }

  QuadMesh& Mesh;
  const BoundaryCurves& Curves;
  const double Reach;
  const bool Released;
  std::vector<std::size_t> Fixed;
  std::optional<PointGrid> Grid;       ///< Made on demand: few symmetries need it.
  std::optional<PointCorners> Corners; ///< Made on demand.
};

bool IsIdentity(const Permutation& images)
{
  for (std::size_t p = 0; p < images.size(); ++p)
  {
    if (images[p] != static_cast<int>(p))
    {
      return false;
    }
  }
  return true;
}

/// Returns the permutation that applies `first`, then `second`.
Permutation Chain(const Permutation& first, const Permutation& second)
{
  Permutation both;
  both.reserve(first.size());
  for (const int image : first)
  {
    both.push_back(second[image]);
  }
  return both;
}

Permutation Power(const Permutation& images, int exponent)
{
  Permutation power = images;
  for (int i = 1; i < exponent; ++i)
  {
    power = Chain(power, images);
  }
  return power;
}
}

int MakeSymmetric(
  QuadMesh& mesh, const BoundaryCurves& curves, const PlanarDomain& domain, bool released)
{
  const SymmetryGroup group = FindSymmetries(domain);
  if (group.IsTrivial())
  {
    return 1;
  }
  Symmetriser symmetriser(mesh, curves, SymmetryReach * domain.Diagonal(), released);
  // Neighbouring symmetries of a polygon with many sides are nearly equal. A symmetry is accepted
  // only if images match points within this fraction of an edge. Of several reflections the best
  // match is used. A rotation applied `order` times, or a reflection applied twice, must be the
  // identity.
  constexpr double Near = 0.25;
  Permutation turn;
  double angle = 0.0;
  int order = 1;
  for (int steps = 1; steps < group.order && turn.empty(); ++steps)
  {
    if (group.order % steps == 0)
    {
      double worst = Near;
      angle = 2.0 * Pi * steps / group.order;
      order = group.order / steps;
      turn = symmetriser.Match({ group.centre, angle, false }, worst);
      turn = IsIdentity(Power(turn, order)) && !IsIdentity(turn) ? turn : Permutation();
    }
  }
  order = turn.empty() ? 1 : order;
  Permutation mirror;
  Isometry reflection;
  double worst = Near;
  for (const Isometry& element : group.Elements())
  {
    if (element.reflects)
    {
      Permutation images = symmetriser.Match(element, worst);
      if (!images.empty() && IsIdentity(Power(images, 2)))
      {
        reflection = element;
        mirror = std::move(images);
      }
    }
  }
  if (turn.empty() && mirror.empty())
  {
    return 1;
  }
  std::vector<Point> sums(mesh.points.size(), Point::Zero());
  Permutation images(mesh.points.size());
  for (std::size_t p = 0; p < images.size(); ++p)
  {
    images[p] = static_cast<int>(p);
  }
  for (int i = 0; i < order; ++i)
  {
    // `images` are those after i turns.
    const Isometry back = { group.centre, -i * angle, false };
    symmetriser.Add(back, images, sums);
    if (!mirror.empty())
    {
      // Reflected after i turns. A reflection is its own inverse.
      const Permutation mirrored = Chain(images, mirror);
      std::vector<Point> once(sums.size(), Point::Zero());
      symmetriser.Add(reflection.Inverse(), mirrored, once);
      for (std::size_t p = 0; p < sums.size(); ++p)
      {
        sums[p] += back(once[p]);
      }
    }
    if (!turn.empty())
    {
      images = Chain(images, turn);
    }
  }
  const int count = order * (mirror.empty() ? 1 : 2);
  symmetriser.MovePoints(sums, count);
  return count;
}

void MakeSymmetricAndPeriodic(
  QuadMesh& mesh, const BoundaryCurves& curves, const PlanarDomain& domain, SmoothingReport& report)
{
  const std::vector<QuadPoint> start =
    mesh.periodic.empty() ? std::vector<QuadPoint>() : mesh.points;
  report.symmetries = MakeSymmetric(mesh, curves, domain, report.released);
  if (mesh.periodic.empty() || report.symmetries == 1)
  {
    return;
  }
  if (LargestMismatch(mesh) > SymmetryReach * domain.Diagonal())
  {
    mesh.points = start;
    report.symmetries = 1;
    report.isAsymmetric = true;
    return;
  }
  MatchPairs(curves, mesh);
}
}
