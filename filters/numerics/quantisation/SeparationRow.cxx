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
/// The spots where a link begins and ends, both of one face.
struct LinkSpots
{
  FaceSpot from;
  FaceSpot to;
};

class Way
{
public:
  Way(const TMesh& mesh, const std::vector<int>& counts)
    : Mesh(mesh)
    , Points(mesh, counts)
    , Developed(mesh)
  {
  }

  /// The displacement along links; `across` gets the axis that a boundary at the ends allows, none for cones.
  /// Nothing where it cannot be followed or the ends ask for different axes.
  std::optional<ArcVector> Walk(
    const std::vector<PointLink>& links, std::optional<std::size_t>& across)
  {
    FaceSpot begin = this->SpotsOf(links.front()).from;
    this->Developed.Begin(begin);
    if (!this->Bound(links.front().from, begin, across))
    {
      return std::nullopt;
    }
    const ArcVector start = this->Developed.StartOf(begin.half);
    FaceSpot here = begin;
    for (const PointLink& link : links)
    {
      const LinkSpots spots = this->SpotsOf(link);
      if (!this->Developed.Turn(here, spots.from))
      {
        return std::nullopt;
      }
      here = spots.to;
    }
    if (!this->Bound(links.back().to, here, across))
    {
      return std::nullopt;
    }
    ArcVector displacement = this->Developed.StartOf(here.half);
    displacement.Subtract(start);
    return displacement;
  }

private:
  bool IsCone(int point) const
  {
    return point < static_cast<int>(this->Mesh.nodes.size()) &&
      this->Mesh.nodes[Index(point)].cone >= 0;
  }

  LinkSpots SpotsOf(const PointLink& link) const
  {
    if (link.arc >= 0)
    {
      const bool inner = this->Mesh.halfEdges[Index(2 * link.arc)].patch >= 0;
      const int half = 2 * link.arc + (inner ? 0 : 1);
      LinkSpots spots = { { half, false }, { this->Developed.Next(half), false } };
      if (this->Mesh.halfEdges[Index(half)].node != link.from)
      {
        std::swap(spots.from, spots.to);
      }
      return spots;
    }
    const TPatch& face = this->Mesh.patches[Index(link.face)];
    const std::size_t one = Index(link.side) + 1;
    const std::size_t other = (one + 2) % 4;
    const LinkSpots forward = { this->SpotOn(face, one, link.from),
      this->SpotOn(face, other, link.to) };
    return forward.from.half >= 0 && forward.to.half >= 0
      ? forward
      : LinkSpots{ this->SpotOn(face, other, link.from), this->SpotOn(face, one, link.to) };
  }

  /// −1 where a point is not on a side.
  FaceSpot SpotOn(const TPatch& face, std::size_t side, int point) const
  {
    for (const int half : face.sides[side])
    {
      if (this->Mesh.halfEdges[Index(half)].node == point)
      {
        return { half, false };
      }
    }
    const int last = face.sides[side].back();
    if (this->Mesh.halfEdges[Index(TMesh::Twin(last))].node == point)
    {
      return { this->Developed.Next(last), false };
    }
    for (const int half : face.sides[side])
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

  /// Turns to the boundary at an end that is no cone, and takes the axis across it.
  bool Bound(int point, FaceSpot& spot, std::optional<std::size_t>& across)
  {
    if (this->IsCone(point))
    {
      return true;
    }
    FaceSpot boundary = spot;
    if (!spot.inside)
    {
      const auto count = static_cast<int>(this->Mesh.halfEdges.size());
      boundary.half = 0;
      while (boundary.half < count &&
        (this->Mesh.halfEdges[Index(boundary.half)].node != point ||
          this->Mesh.halfEdges[Index(boundary.half)].patch < 0 ||
          !this->Mesh.arcs[Index(boundary.half / 2)].onBoundary))
      {
        ++boundary.half;
      }
      if (boundary.half == count || !this->Developed.Turn(spot, boundary))
      {
        return false;
      }
    }
    const std::size_t axis = 1 - this->Developed.AxisOf(boundary.half);
    spot = boundary;
    const bool agrees = !across || *across == axis;
    across = axis;
    return agrees;
  }

  const TMesh& Mesh;
  const ArcPoints Points;
  Unfolding Developed;
};
}

bool ArcRow::Holds(const std::vector<int>& counts) const
{
  int sum = 0;
  for (const auto& [arc, factor] : this->terms)
  {
    sum += factor * counts[Index(arc)];
  }
  return sum >= this->least;
}

ArcRow SeparateEnds(const TMesh& mesh, const std::vector<int>& counts,
  const std::vector<double>& wanted, const std::vector<PointLink>& way)
{
  ArcRow row;
  std::optional<std::size_t> across;
  const std::optional<ArcVector> displacement = Way(mesh, counts).Walk(way, across);
  if (!displacement)
  {
    return row;
  }
  // Coordinates that are 0 by symmetry have no sign: far below the 1e-12 to which opposite sides agree in the map.
  constexpr double NoSign = 1e-9;
  double longest = 0.0;
  for (const double length : wanted)
  {
    longest = std::max(longest, length);
  }
  std::array<int, 2> signs = { 0, 0 };
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double along = displacement->Along(axis, wanted);
    if ((!across || *across == axis) && std::abs(along) > NoSign * longest)
    {
      signs[axis] = along > 0.0 ? 1 : -1;
    }
  }
  for (const auto& [arc, factor] : displacement->GetFactors())
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
