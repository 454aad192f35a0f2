#include "SeparationRow.h"

#include "Index.h"
#include "Unfolding.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace crossfield
{
namespace
{
/// The ends of a link, both on the outline of one patch.
struct LinkEnds
{
  PatchPoint from;
  PatchPoint to;
};

/// Follows a path of links in the unfolded patches.
class PathUnfolder
{
public:
  PathUnfolder(const TMesh& mesh, const std::vector<int>& counts)
    : Mesh(mesh)
    , Points(mesh, counts)
    , Unfolded(mesh)
  {
  }

  /// Returns the displacement along links. `across` receives the axis across the boundary if an end
  /// is on one. Returns nothing if the path cannot be unfolded, or the boundaries at its ends are
  /// not parallel.
  std::optional<ArcVector> Displacement(
    const std::vector<PointLink>& links, std::optional<std::size_t>& across)
  {
    PatchPoint begin = this->EndsOf(links.front()).from;
    this->Unfolded.Begin(begin);
    if (!this->TurnToBoundary(links.front().from, begin, across))
    {
      return std::nullopt;
    }
    const ArcVector start = this->Unfolded.StartOf(begin.half);
    std::optional<PatchPoint> here = this->Follow(links, begin);
    if (!here || !this->TurnToBoundary(links.back().to, *here, across))
    {
      return std::nullopt;
    }
    ArcVector displacement = this->Unfolded.StartOf(here->half);
    displacement.Subtract(start);
    return displacement;
  }

  /// Returns the displacement along a closed path of links, nothing if it cannot be unfolded.
  std::optional<ArcVector> DisplacementAround(const std::vector<PointLink>& links)
  {
    const PatchPoint begin = this->EndsOf(links.front()).from;
    this->Unfolded.Begin(begin);
    const ArcVector start = this->Unfolded.StartOf(begin.half);
    const std::optional<PatchPoint> here = this->Follow(links, begin);
    if (!here || !this->Unfolded.Turn(*here, begin))
    {
      return std::nullopt;
    }
    ArcVector displacement = this->Unfolded.StartOf(begin.half);
    displacement.Subtract(start);
    return displacement;
  }

private:
  /// Follows links from a position in the present patch. Returns where they end, nothing if they cannot be
  /// unfolded.
  std::optional<PatchPoint> Follow(const std::vector<PointLink>& links, PatchPoint here)
  {
    for (const PointLink& link : links)
    {
      const LinkEnds ends = this->EndsOf(link);
      if (!this->Unfolded.Turn(here, ends.from))
      {
        return std::nullopt;
      }
      here = ends.to;
    }
    return here;
  }

  bool IsDistinct(int point) const
  {
    return point < static_cast<int>(this->Mesh.nodes.size()) &&
      this->Mesh.nodes[point].IsDistinct();
  }

  LinkEnds EndsOf(const PointLink& link) const
  {
    if (link.arc >= 0)
    {
      const bool inner = this->Mesh.halfEdges[2 * link.arc].patch >= 0;
      const int half = 2 * link.arc + (inner ? 0 : 1);
      LinkEnds ends = { { half, false }, { this->Unfolded.Next(half), false } };
      if (this->Mesh.halfEdges[half].node != link.from)
      {
        std::swap(ends.from, ends.to);
      }
      return ends;
    }
    const TPatch& patch = this->Mesh.patches[link.patch];
    const std::size_t one = Index(link.side) + 1;
    const std::size_t other = (one + 2) % 4;
    const LinkEnds forward = { this->PointOnSide(patch, one, link.from),
      this->PointOnSide(patch, other, link.to) };
    return forward.from.half >= 0 && forward.to.half >= 0
      ? forward
      : LinkEnds{ this->PointOnSide(patch, other, link.from),
          this->PointOnSide(patch, one, link.to) };
  }

  /// Returns the position of a point on a side; its half-edge is −1 if the point is not there.
  PatchPoint PointOnSide(const TPatch& patch, std::size_t side, int point) const
  {
    for (const int half : patch.sides[side])
    {
      if (this->Mesh.halfEdges[half].node == point)
      {
        return { half, false };
      }
    }
    const int last = patch.sides[side].back();
    if (this->Mesh.halfEdges[TMesh::Twin(last)].node == point)
    {
      return { this->Unfolded.Next(last), false };
    }
    for (const int half : patch.sides[side])
    {
      for (int j = 1; j < this->Points.CountOf(half); ++j)
      {
        if (this->Points.At(half, j) == point)
        {
          return { half, true };
        }
      }
    }
    return {};
  }

  /// Turns to the boundary at an end that is not distinct, and stores the axis across it. Returns
  /// false if there is none, or another one was stored before.
  bool TurnToBoundary(int point, PatchPoint& position, std::optional<std::size_t>& across)
  {
    if (this->IsDistinct(point))
    {
      return true;
    }
    PatchPoint boundary = position;
    if (!position.inside)
    {
      const auto count = static_cast<int>(this->Mesh.halfEdges.size());
      boundary.half = 0;
      while (boundary.half < count &&
        (this->Mesh.halfEdges[boundary.half].node != point ||
          this->Mesh.halfEdges[boundary.half].patch < 0 ||
          !this->Mesh.arcs[boundary.half / 2].onBoundary))
      {
        ++boundary.half;
      }
      if (boundary.half == count || !this->Unfolded.Turn(position, boundary))
      {
        return false;
      }
    }
    const std::size_t axis = 1 - this->Unfolded.AxisOf(boundary.half);
    position = boundary;
    const bool agrees = !across || *across == axis;
    across = axis;
    return agrees;
  }

  const TMesh& Mesh;
  const ArcPoints Points;
  Unfolding Unfolded;
};

/// Returns the signs of a displacement for the target counts, 0 for a component that is none.
std::array<int, 2> SignsOf(const ArcVector& displacement, const std::vector<double>& target)
{
  // Coordinates that are 0 by symmetry have no sign. Opposite sides agree to 1e-12 in the map.
  constexpr double NoSign = 1e-9;
  double longest = 0.0;
  for (const double length : target)
  {
    longest = std::max(longest, length);
  }
  std::array<int, 2> signs = { 0, 0 };
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double along = displacement.Along(axis, target);
    if (std::abs(along) > NoSign * longest)
    {
      signs[axis] = along > 0.0 ? 1 : -1;
    }
  }
  return signs;
}

/// Returns the row Σ sign · component ≥ minimum.
SeparationRow RowOf(const ArcVector& displacement, const std::array<int, 2>& signs, int minimum)
{
  SeparationRow row;
  row.minimum = minimum;
  for (const auto& [arc, factor] : displacement.GetFactors())
  {
    const int sum = signs[0] * factor[0] + signs[1] * factor[1];
    if (sum != 0)
    {
      row.terms.emplace_back(arc, sum);
    }
  }
  return row;
}
}

bool SeparationRow::Holds(const std::vector<int>& counts) const
{
  int sum = 0;
  for (const auto& [arc, factor] : this->terms)
  {
    sum += factor * counts[arc];
  }
  return sum >= this->minimum;
}

SeparationRow SeparateEnds(const TMesh& mesh, const std::vector<int>& counts,
  const std::vector<double>& target, const std::vector<PointLink>& path)
{
  std::optional<std::size_t> across;
  const std::optional<ArcVector> displacement =
    PathUnfolder(mesh, counts).Displacement(path, across);
  if (!displacement)
  {
    return {};
  }
  std::array<int, 2> signs = SignsOf(*displacement, target);
  if (across)
  {
    signs[1 - *across] = 0;
  }
  return RowOf(*displacement, signs, 1);
}

SeparationRow OpenCycle(const TMesh& mesh, const std::vector<int>& counts,
  const std::vector<double>& target, const std::vector<PointLink>& path)
{
  const std::optional<ArcVector> displacement = PathUnfolder(mesh, counts).DisplacementAround(path);
  if (!displacement)
  {
    return {};
  }
  constexpr int ShortestLine = 3;
  const std::array<int, 2> signs = SignsOf(*displacement, target);
  return RowOf(*displacement, signs, signs[0] == 0 || signs[1] == 0 ? ShortestLine : 1);
}
}
