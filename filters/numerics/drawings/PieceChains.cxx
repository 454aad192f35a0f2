#include "PieceChains.h"

#include "EndGrid.h"
#include "EndJoints.h"
#include "Error.h"
#include "PieceSampling.h"
#include "Segment.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

/// Returns the indices of the pieces without those that are in the same place as an earlier one,
/// which `hasCopy` marks.
std::vector<std::size_t> WithoutRepeated(const std::vector<DrawingPiece>& pieces, double tolerance,
  std::vector<bool>& hasCopy, std::vector<std::string>& warnings)
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
      const bool isSame =
        IsNear(MiddleOf(pieces[other]), middle, reach) && IsSame(pieces[other], pieces[i], reach);
      hasCopy[other] = hasCopy[other] || isSame;
      isRepeated = isRepeated || isSame;
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

/// Returns whether a line lies on another line, or an arc on an arc or circle.
bool LiesOn(const DrawingPiece& piece, const DrawingPiece& other, double tolerance)
{
  const auto at = [&piece](double part)
  { return PointAt(piece, piece.begin + part * (piece.end - piece.begin)); };
  if (piece.curve.kind != other.curve.kind)
  {
    return false;
  }
  if (piece.curve.kind == PlaneCurve::Kind::Line)
  {
    const auto isOn = [&](const Point& point)
    { return OffsetFromSegment(point, other.first, other.last).norm() <= tolerance; };
    return isOn(piece.first) && isOn(piece.last);
  }
  if (piece.curve.kind != PlaneCurve::Kind::Circle ||
    !IsNear(piece.curve.centre, other.curve.centre, tolerance) ||
    std::abs(piece.curve.axis.norm() - other.curve.axis.norm()) > tolerance)
  {
    return false;
  }
  const double radius = other.curve.axis.norm();
  const auto isOn = [&](const Point& point)
  {
    const Point middle = PointAt(other, 0.5 * (other.begin + other.end));
    const double angle = AngleBetween(middle - other.curve.centre, point - other.curve.centre);
    return std::abs(angle) * radius <= 0.5 * std::abs(other.end - other.begin) * radius + tolerance;
  };
  return std::abs(piece.end - piece.begin) <= std::abs(other.end - other.begin) &&
    isOn(piece.first) && isOn(at(0.5)) && isOn(piece.last);
}

/// Leaves out pieces that lie on longer ones, and ways there and back, at ends that are not joined
/// in pairs, if the others are closed curves.
std::vector<std::size_t> WithoutCovered(const std::vector<DrawingPiece>& pieces,
  const std::vector<std::size_t>& given, const std::vector<bool>& hasCopy, double tolerance,
  std::vector<std::string>& warnings)
{
  // Each candidate is compared with all others, after each piece that is left out: some seconds.
  constexpr std::size_t MostComparisons = 100000000;
  std::size_t comparisons = 0;
  std::vector<std::size_t> used = given;
  std::size_t covered = 0;
  std::string first;
  bool isClosed = false;
  for (bool isChanged = true; isChanged;)
  {
    isChanged = false;
    const EndJoints joints(pieces, used, tolerance);
    isClosed = joints.IsClosed();
    if (isClosed)
    {
      break;
    }
    std::vector<std::size_t> candidates;
    for (const std::size_t piece : used)
    {
      const auto isFree = [&joints, piece](bool isLast) {
        return joints.CountAt({ piece, isLast }) != 2;
      };
      if (isFree(false) || isFree(true))
      {
        candidates.push_back(piece);
      }
    }
    comparisons += (candidates.size() + 1) * used.size();
    if (comparisons > MostComparisons)
    {
      break;
    }
    for (const std::size_t piece : candidates)
    {
      const bool isCovered = hasCopy[piece] ||
        std::any_of(used.begin(), used.end(),
          [&](std::size_t other)
          {
            return other != piece &&
              ApproximateLength(pieces[other]) > ApproximateLength(pieces[piece]) &&
              LiesOn(pieces[piece], pieces[other], tolerance);
          });
      if (isCovered)
      {
        first = covered == 0 ? pieces[piece].origin : first;
        ++covered;
        used.erase(std::find(used.begin(), used.end(), piece));
        isChanged = true;
        break; // others may be joined now
      }
    }
  }
  if (!isClosed || used.empty())
  {
    return given;
  }
  if (covered > 0)
  {
    warnings.push_back(covered == 1
        ? "A piece of the drawing that lies on another one was left out: " + first + "."
        : std::to_string(covered) +
          " pieces of the drawing that lie on others were left out, the first is " + first + ".");
  }
  return used;
}

/// Leaves out chains that a gap closes which is not much shorter than the chain: ways that enclose
/// nothing.
void LeaveOutTiny(const std::vector<DrawingPiece>& pieces, double tolerance, PieceChains& result)
{
  constexpr double MuchLonger = 4.0;
  const auto isTiny = [&](const std::vector<ChainedPiece>& chain)
  {
    double length = 0.0;
    double gap = 0.0;
    for (std::size_t i = 0; i < chain.size(); ++i)
    {
      const DrawingPiece& piece = pieces[chain[i].piece];
      const ChainedPiece& next = chain[(i + 1) % chain.size()];
      const Point& stop = chain[i].isReversed ? piece.first : piece.last;
      const Point& start = next.isReversed ? pieces[next.piece].last : pieces[next.piece].first;
      length += ApproximateLength(piece);
      gap = std::max(gap, (start - stop).norm());
    }
    return gap > 0.0 && length <= MuchLonger * gap && length <= MuchLonger * tolerance;
  };
  const auto end = std::remove_if(result.chains.begin(), result.chains.end(), isTiny);
  const auto count = result.chains.end() - end;
  if (end == result.chains.begin() && count > 0)
  {
    throw Error(
      "All curves of the drawing are about as short as the gaps that the join tolerance " +
      FormatNumber(tolerance) + " closes; set it to less (JoinTolerance, --join-tolerance).");
  }
  result.chains.erase(end, result.chains.end());
  if (count > 0)
  {
    result.warnings.push_back(
      "Curves of the drawing about as short as the gap between their ends were left out: " +
      std::to_string(count) + ".");
  }
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
  std::vector<bool> hasCopy(pieces.size(), false);
  std::vector<std::size_t> used = WithoutRepeated(pieces, tolerance, hasCopy, result.warnings);
  used = WithoutCovered(pieces, std::move(used), hasCopy, tolerance, result.warnings);
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
  LeaveOutTiny(pieces, tolerance, result);
  result.largestGap = joints.LargestGap();
  joints.AddWarnings(result.warnings);
  return result;
}
}
