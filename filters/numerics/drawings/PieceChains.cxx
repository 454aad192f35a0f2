#include "PieceChains.h"

#include "EndGrid.h"
#include "EndJoints.h"
#include "Error.h"
#include "PieceSampling.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
bool IsClosed(const DrawingPiece& piece)
{
  return piece.first == piece.last;
}

/// Returns a point that two equal pieces share, however they are directed.
Point MiddleOf(const DrawingPiece& piece)
{
  return IsClosed(piece) && piece.curve.kind != PlaneCurve::Kind::Nurbs
    ? piece.curve.centre
    : PointAt(piece, 0.5 * (piece.begin + piece.end));
}

bool IsNear(const Point& a, const Point& b, double tolerance)
{
  return (a - b).norm() <= tolerance;
}

/// Returns whether two pieces, whose middles agree, are in the same place.
bool IsSame(const DrawingPiece& a, const DrawingPiece& b, double tolerance)
{
  if (IsClosed(a) && IsClosed(b) && a.curve.kind == PlaneCurve::Kind::Circle)
  {
    return b.curve.kind == PlaneCurve::Kind::Circle &&
      std::abs(a.curve.axis.norm() - b.curve.axis.norm()) <= tolerance;
  }
  const bool isParallel = IsNear(a.first, b.first, tolerance) && IsNear(a.last, b.last, tolerance);
  const bool isOpposite = IsNear(a.first, b.last, tolerance) && IsNear(a.last, b.first, tolerance);
  const auto quarter = [](const DrawingPiece& piece, double part)
  { return PointAt(piece, piece.begin + part * (piece.end - piece.begin)); };
  return (isParallel && IsNear(quarter(a, 0.25), quarter(b, 0.25), tolerance)) ||
    (isOpposite && IsNear(quarter(a, 0.25), quarter(b, 0.75), tolerance));
}

/// Returns the indices of the pieces without those that are in the same place as an earlier one.
std::vector<std::size_t> WithoutRepeated(
  const std::vector<DrawingPiece>& pieces, double tolerance, std::vector<std::string>& warnings)
{
  // Pieces not much longer than the tolerance would all be in the same place.
  constexpr double ShareOfLength = 0.01;
  EndGrid grid(tolerance);
  std::vector<std::size_t> used;
  std::size_t repeated = 0;
  std::string first;
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    const double reach = std::min(tolerance, ShareOfLength * ApproximateLength(pieces[i]));
    const Point middle = MiddleOf(pieces[i]);
    bool isRepeated = false;
    for (const std::size_t other : grid.Near(middle))
    {
      isRepeated = isRepeated ||
        (IsNear(MiddleOf(pieces[other]), middle, reach) && IsSame(pieces[other], pieces[i], reach));
    }
    if (!isRepeated)
    {
      grid.Add(middle, i);
      used.push_back(i);
      continue;
    }
    first = repeated == 0 ? pieces[i].origin : first;
    ++repeated;
  }
  if (repeated > 0)
  {
    warnings.push_back(repeated == 1
        ? "A piece of the drawing was left out because another one is in the same place: " + first +
          "."
        : std::to_string(repeated) +
          " pieces of the drawing were left out because others are in the same place, the first is " +
          first + ".");
  }
  return used;
}
}

double ExtentOf(const std::vector<DrawingPiece>& pieces)
{
  Eigen::AlignedBox2d box;
  for (const DrawingPiece& piece : pieces)
  {
    constexpr int Count = 16;
    for (int i = 0; i <= Count; ++i)
    {
      box.extend(PointAt(
        piece, i == Count ? piece.end : piece.begin + (piece.end - piece.begin) * i / Count));
    }
  }
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

double DefaultJoinTolerance(const std::vector<DrawingPiece>& pieces)
{
  constexpr double ShareOfExtent = 1e-5;
  constexpr double Rounding = 8.0 * std::numeric_limits<double>::epsilon();
  double largest = 0.0;
  for (const DrawingPiece& piece : pieces)
  {
    largest = std::max(
      { largest, piece.first.lpNorm<Eigen::Infinity>(), piece.last.lpNorm<Eigen::Infinity>() });
  }
  return ShareOfExtent * ExtentOf(pieces) + Rounding * largest;
}

PieceChains ChainPieces(const std::vector<DrawingPiece>& pieces, double tolerance)
{
  PieceChains result;
  const std::vector<std::size_t> used = WithoutRepeated(pieces, tolerance, result.warnings);
  const EndJoints joints(pieces, used, tolerance);
  joints.RequireClosed();
  std::vector<bool> visited(pieces.size(), false);
  for (const std::size_t start : used)
  {
    if (visited[start] || !joints.IsUsed(start))
    {
      continue;
    }
    result.chains.emplace_back();
    PieceEnd end = { start, false };
    do
    {
      visited[end.piece] = true;
      result.chains.back().push_back({ end.piece, end.isLast });
      end = joints.PartnerOf({ end.piece, !end.isLast });
    } while (!visited[end.piece]);
  }
  result.largestGap = joints.LargestGap();
  joints.AddWarnings(result.warnings);
  return result;
}
}
