#include "QuadSymmetry.h"

#include "BoundarySymmetry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
using Permutation = std::vector<int>;

std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}

/// The points of a mesh in square cells.
class PointGrid
{
public:
  explicit PointGrid(const QuadMesh& mesh)
    : Mesh(mesh)
    , Reach(mesh.points.size(), std::numeric_limits<double>::infinity())
  {
    double longest = 0.0;
    for (const std::array<int, 4>& quad : mesh.quads)
    {
      for (std::size_t c = 0; c < 4; ++c)
      {
        const int from = quad[c];
        const int to = quad[(c + 1) % 4];
        // Nearer than that there is no other point.
        const double reach =
          0.4 * (mesh.points[Index(from)].place - mesh.points[Index(to)].place).norm();
        this->Reach[Index(from)] = std::min(this->Reach[Index(from)], reach);
        this->Reach[Index(to)] = std::min(this->Reach[Index(to)], reach);
      }
    }
    for (const double reach : this->Reach)
    {
      longest = std::max(longest, reach);
    }
    this->Cell = longest;
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      this->Cells.push_back({ this->CellOf(mesh.points[p].place), static_cast<int>(p) });
    }
    std::sort(this->Cells.begin(), this->Cells.end());
  }

  /// The point within the reach of point `p` from a place; −1: none.
  int Find(const Point& place, int p) const
  {
    const std::array<long long, 2> cell = this->CellOf(place);
    int best = -1;
    double least = this->Reach[Index(p)];
    for (long long i = cell[0] - 1; i <= cell[0] + 1; ++i)
    {
      const Entry first = { { i, cell[1] - 1 }, -1 };
      for (auto at = std::lower_bound(this->Cells.begin(), this->Cells.end(), first);
           at != this->Cells.end() && at->first[0] == i && at->first[1] <= cell[1] + 1; ++at)
      {
        const double distance = (this->Mesh.points[Index(at->second)].place - place).norm();
        if (distance < least)
        {
          least = distance;
          best = at->second;
        }
      }
    }
    return best;
  }

  /// Distance of a place from a point in shortest edges there.
  double EdgesBetween(const Point& place, int p) const
  {
    return 0.4 * (this->Mesh.points[Index(p)].place - place).norm() / this->Reach[Index(p)];
  }

private:
  using Entry = std::pair<std::array<long long, 2>, int>;

  std::array<long long, 2> CellOf(const Point& place) const
  {
    return { std::llround(place.x() / this->Cell), std::llround(place.y() / this->Cell) };
  }

  const QuadMesh& Mesh;
  std::vector<double> Reach;
  double Cell = 1.0;
  std::vector<Entry> Cells;
};

class Symmetriser
{
public:
  Symmetriser(QuadMesh& mesh, const BoundaryCurves& curves, double tolerance, bool released)
    : Mesh(mesh)
    , Curves(curves)
    , Tolerance(tolerance)
    , Released(released)
    , Grid(mesh)
    , Quads(this->SortedQuads(nullptr))
  {
  }

  /// What a symmetry does to the points; empty where it is none of the mesh, or images are farther from points than
  /// `worst` edges, which becomes the largest distance.
  Permutation Match(const Isometry& symmetry, double& worst) const
  {
    double farthest = 0.0;
    Permutation images(this->Mesh.points.size(), -1);
    std::vector<bool> taken(images.size(), false);
    // Fixed points first: they decide most cases at once.
    for (const bool fixed : { true, false })
    {
      for (std::size_t p = 0; p < images.size(); ++p)
      {
        const QuadPoint& point = this->Mesh.points[p];
        if (this->IsFixed(point) != fixed)
        {
          continue;
        }
        const Point place = symmetry(point.place);
        const int image = this->Grid.Find(place, static_cast<int>(p));
        if (image < 0 || taken[Index(image)] ||
          !this->Fits(point, this->Mesh.points[Index(image)], place))
        {
          return {};
        }
        farthest = std::max(farthest, this->Grid.EdgesBetween(place, image));
        if (farthest > worst)
        {
          return {};
        }
        taken[Index(image)] = true;
        images[p] = image;
      }
    }
    if (this->SortedQuads(&images) != this->Quads)
    {
      return {};
    }
    worst = farthest;
    return images;
  }

  /// Adds what the inverse of a symmetry makes of the images of all points.
  void Add(const Isometry& inverse, const Permutation& images, std::vector<Point>& sums) const
  {
    for (std::size_t p = 0; p < sums.size(); ++p)
    {
      sums[p] += inverse(this->Mesh.points[Index(images[p])].place);
    }
  }

  void Place(const std::vector<Point>& sums, double count)
  {
    for (std::size_t p = 0; p < sums.size(); ++p)
    {
      QuadPoint& point = this->Mesh.points[p];
      if (this->IsFixed(point))
      {
        continue;
      }
      point.place = sums[p] / count;
      if (point.curve.loop >= 0)
      {
        point.curve = this->Curves.Nearest(point.curve.loop, point.place);
        point.place = this->Curves.At(point.curve);
      }
    }
  }

private:
  bool IsFixed(const QuadPoint& point) const
  {
    return point.fixed && !(this->Released && point.curve.loop < 0);
  }

  bool Fits(const QuadPoint& point, const QuadPoint& image, const Point& place) const
  {
    return point.asked == image.asked && (point.curve.loop < 0) == (image.curve.loop < 0) &&
      this->IsFixed(point) == this->IsFixed(image) &&
      (!this->IsFixed(point) || (image.place - place).norm() <= this->Tolerance);
  }

  std::vector<std::array<int, 4>> SortedQuads(const Permutation* images) const
  {
    std::vector<std::array<int, 4>> quads = this->Mesh.quads;
    for (std::array<int, 4>& quad : quads)
    {
      for (int& point : quad)
      {
        point = images == nullptr ? point : (*images)[Index(point)];
      }
      std::sort(quad.begin(), quad.end());
    }
    std::sort(quads.begin(), quads.end());
    return quads;
  }

  QuadMesh& Mesh;
  const BoundaryCurves& Curves;
  const double Tolerance;
  const bool Released;
  const PointGrid Grid;
  const std::vector<std::array<int, 4>> Quads;
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

/// First `first`, then `second`.
Permutation Chain(const Permutation& first, const Permutation& second)
{
  Permutation both;
  both.reserve(first.size());
  for (const int image : first)
  {
    both.push_back(second[Index(image)]);
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
  constexpr double Tolerance = 1e-9;
  const SymmetryGroup group = FindSymmetries(domain, Tolerance);
  if (group.IsTrivial())
  {
    return 1;
  }
  Symmetriser symmetriser(mesh, curves, Tolerance * domain.Diagonal(), released);
  // Of a polygon of many sides neighbouring symmetries are nearly alike: those of the mesh are nearer than this part
  // of an edge, of reflections the nearest counts, and powers must close.
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
    // images: after i turns.
    const Isometry back = { group.centre, -i * angle, false };
    symmetriser.Add(back, images, sums);
    if (!mirror.empty())
    {
      // Mirrored after i turns; the mirror image of the mirror image is the point itself.
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
  symmetriser.Place(sums, count);
  return count;
}
}
