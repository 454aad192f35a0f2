#include "Unfolding.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
namespace
{
std::array<int, 2> Direction(int turns)
{
  constexpr std::array<std::array<int, 2>, 4> Directions = { { { 1, 0 }, { 0, 1 }, { -1, 0 },
    { 0, -1 } } };
  return Directions[turns % 4];
}
}

void ArcVector::Add(int arc, const std::array<int, 2>& factor)
{
  std::array<int, 2>& sum = this->Factors[arc];
  sum = { sum[0] + factor[0], sum[1] + factor[1] };
  if (sum[0] == 0 && sum[1] == 0)
  {
    this->Factors.erase(arc);
  }
}

void ArcVector::Subtract(const ArcVector& other)
{
  for (const auto& [arc, factor] : other.Factors)
  {
    this->Add(arc, { -factor[0], -factor[1] });
  }
}

Unfolding::Unfolding(const TMesh& mesh)
  : Mesh(mesh)
  , Places(mesh.halfEdges.size())
{
  for (const TPatch& patch : mesh.patches)
  {
    for (std::size_t side = 0; side < 4; ++side)
    {
      for (std::size_t i = 0; i < patch.sides[side].size(); ++i)
      {
        Place& place = this->Places[patch.sides[side][i]];
        place.side = side;
        place.index = i;
      }
    }
  }
  for (std::size_t h = 0; h < mesh.halfEdges.size(); ++h)
  {
    if (mesh.halfEdges[h].patch >= 0)
    {
      this->Places[mesh.halfEdges[h].next].previous = static_cast<int>(h);
    }
  }
}

void Unfolding::Begin(const PatchPoint& point)
{
  this->Turns = 0;
  this->Origin = {};
  this->Origin.Subtract(this->StartOf(point.half));
}

ArcVector Unfolding::StartOf(int half) const
{
  const Place& place = this->PlaceOf(half);
  const TPatch& patch = this->Mesh.patches[this->PatchOf(half)];
  ArcVector start = this->Origin;
  const auto walk = [&](std::size_t side, std::size_t count, int turns)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      start.Add(patch.sides[side][i] / 2, Direction(this->Turns + turns));
    }
  };
  if (place.side == 3) // backwards along side 3 from the first corner
  {
    walk(3, patch.sides[3].size(), 1);
    walk(3, place.index, 3);
    return start;
  }
  for (std::size_t side = 0; side <= place.side; ++side)
  {
    walk(side, side < place.side ? patch.sides[side].size() : place.index, static_cast<int>(side));
  }
  return start;
}

void Unfolding::Cross(int half)
{
  const int twin = TMesh::Twin(half);
  ArcVector end = this->StartOf(half);
  const int turns = this->TurnsOf(half) + 2;
  // The twin starts where the half-edge ends.
  end.Add(half / 2, Direction(turns + 2));
  this->Turns = (turns + 4 - static_cast<int>(this->PlaceOf(twin).side)) % 4;
  this->Origin = {};
  const ArcVector local = this->StartOf(twin);
  this->Origin = std::move(end);
  this->Origin.Subtract(local);
}

bool Unfolding::Turn(const PatchPoint& from, const PatchPoint& to)
{
  if (from.inside || to.inside)
  {
    if (from.half / 2 != to.half / 2 || !from.inside || !to.inside)
    {
      return false;
    }
    if (from.half != to.half)
    {
      this->Cross(from.half);
    }
    return true;
  }
  // Visits the half-edges that start at the point: clockwise across the half-edge itself,
  // counter-clockwise across the one before it. If both directions lead to `to` they agree, since
  // the point is not a cone.
  for (const bool clockwise : { true, false })
  {
    std::vector<int> crossed;
    int half = from.half;
    const std::size_t maximum = this->Mesh.halfEdges.size();
    while (half >= 0 && half != to.half && crossed.size() < maximum)
    {
      const int over = clockwise ? half : this->PlaceOf(half).previous;
      crossed.push_back(over);
      const int twin = TMesh::Twin(over);
      half = this->PatchOf(twin) < 0 ? -1 : (clockwise ? this->Next(twin) : twin);
      if (half == from.half)
      {
        half = -1;
      }
    }
    if (half == to.half)
    {
      for (const int over : crossed)
      {
        this->Cross(over);
      }
      return true;
    }
  }
  return false;
}
}
