#include "SidePlacement.h"

#include "MoveInside.h"
#include "QuadSides.h"
#include "StripGrading.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Divides chains of points at those that are fixed. A closed chain without fixed points is one part.
std::vector<std::vector<int>> PartsBetweenFixed(
  const QuadMesh& mesh, const std::vector<std::vector<int>>& pieces)
{
  const auto isFixed = [&mesh](int point) { return mesh.points[point].fixed; };
  std::vector<std::vector<int>> parts;
  for (std::vector<int> piece : pieces)
  {
    const bool isClosed = piece.front() == piece.back();
    const auto start = std::find_if(piece.begin(), piece.end(), isFixed);
    if (isClosed && start != piece.end())
    {
      piece.pop_back();
      std::rotate(piece.begin(), start, piece.end());
      piece.push_back(piece.front());
    }
    parts.push_back({ piece.front() });
    for (std::size_t i = 1; i < piece.size(); ++i)
    {
      parts.back().push_back(piece[i]);
      if (isFixed(piece[i]) && i + 1 < piece.size())
      {
        parts.push_back({ piece[i] });
      }
    }
  }
  return parts;
}

/// Places the points of one part of a side.
void PlacePart(const BoundaryCurves& curves, const std::vector<int>& part,
  const Progression& progression, QuadMesh& mesh)
{
  const auto count = static_cast<int>(part.size()) - 1;
  const CurvePlace start = mesh.points[part.front()].curve;
  const double loop = curves.Length(start.loop);
  const auto forwards = [loop](double length) { return length - loop * std::floor(length / loop); };
  const bool isClosed = part.front() == part.back();
  const double length = isClosed ? loop : forwards(mesh.points[part.back()].curve.at - start.at);
  const std::vector<double> places = DivideLength(length, count, progression);
  // a closed curve has no end: its points are rotated to where they are on average
  const bool turns = isClosed && !mesh.points[part.front()].fixed;
  double shift = 0.0;
  if (turns)
  {
    for (int i = 1; i < count; ++i)
    {
      shift += (forwards(mesh.points[part[i]].curve.at - start.at) - places[i]) / count;
    }
  }
  for (int i = 0; i < count; ++i)
  {
    QuadPoint& point = mesh.points[part[i]];
    if (!point.fixed)
    {
      point.curve.at = start.at + shift + places[i];
      point.curve.at -= loop * std::floor(point.curve.at / loop);
      point.MoveTo(curves.At(point.curve));
      point.fixed = true;
      point.turns = turns;
    }
  }
}
}

void PlaceOnSides(
  const BoundaryCurves& curves, const SidePrescriptions& prescribed, bool hold, QuadMesh& mesh)
{
  std::vector<const QuadBoundaryEdge*> graded;
  const std::vector<QuadPoint> before = mesh.points;
  bool isMoved = false;
  for (const SidePrescription& one : prescribed)
  {
    if (!one.isGraded && one.size <= 0.0)
    {
      continue;
    }
    const Progression progression = one.isGraded ? one.progression : Progression{};
    for (const std::vector<int>& part : PartsBetweenFixed(mesh, PiecesOf(mesh, one.side)))
    {
      PlacePart(curves, part, progression, mesh);
      isMoved = true;
    }
    for (const QuadBoundaryEdge& edge : mesh.boundary)
    {
      if (one.isGraded && edge.side == one.side)
      {
        graded.push_back(&edge);
      }
    }
  }
  if (isMoved)
  {
    MoveInside(before, hold, mesh);
  }
  if (!graded.empty())
  {
    GradeStrips(graded, mesh);
  }
}
}
