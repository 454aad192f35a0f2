#include "ArcDerivatives.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
using Complex = std::complex<double>;

Complex AsComplex(const Point& point)
{
  return { point.x(), point.y() };
}

/// Consecutive pieces of a path near a singularity.
struct NearPart
{
  std::size_t begin = 0; ///< First piece.
  std::size_t end = 0;   ///< The piece after the last one.
  Complex step = 0.0;    ///< Sum of the steps.
  Complex from = 0.0;    ///< Start of the part, relative to the singularity.
  Complex to = 0.0;      ///< End of the part, relative to the singularity.
  Complex turn = 0.0;    ///< Sum of the logarithms of quotients: log(to / from) with all turns.
  double nearest = 0.0;  ///< Minimum distance of an end of a piece.
};

/// Returns log((to − b) / (from − b)) of a piece; 0 if it starts or ends at b.
Complex LogQuotient(const ArcPath::Piece& piece, const Point& b)
{
  const Complex from = AsComplex(piece.from - b);
  const Complex to = AsComplex(piece.to - b);
  return std::abs(from) > 0.0 && std::abs(to) > 0.0 ? std::log(to / from) : 0.0;
}

/// Returns the parts of a path that come nearer to a point than `radius`.
std::vector<NearPart> FindNearParts(const ArcPath& path, const Point& b, double radius)
{
  std::vector<NearPart> parts;
  for (std::size_t p = 0; p < path.pieces.size(); ++p)
  {
    const ArcPath::Piece& piece = path.pieces[p];
    const double distance = std::min((piece.from - b).norm(), (piece.to - b).norm());
    if (distance > radius)
    {
      continue;
    }
    if (parts.empty() || parts.back().end != p)
    {
      parts.push_back({ p, p, 0.0, AsComplex(piece.from - b), 0.0, 0.0, distance });
    }
    NearPart& part = parts.back();
    part.end = p + 1;
    part.step += piece.step;
    part.to = AsComplex(piece.to - b);
    part.turn += LogQuotient(piece, b);
    part.nearest = std::min(part.nearest, distance);
  }
  return parts;
}

/// Adds the real and imaginary parts of moves: the contribution is Im(value) for β = 1 and
/// Im(i value) for β = i.
void AddToRow(const Complex& value, Eigen::Index column, Eigen::RowVectorXd& row)
{
  row[column] += value.imag();
  row[column + 1] += value.real();
}

/// Returns ∫ q / (z − b) dw along a path for the m-th singularity, with the motion of the ends of
/// the path that are at b.
///
/// Within a few edges of b the map is inaccurate. There w − w(b) = C (z − b)^(1 − q) replaces it,
/// and the integral is −(1 − q) (w − w(b)) / (z − b) between the ends of the part. The difference of
/// w between its ends and the angle that it sweeps around b determine C.
Complex SingularPart(const PositionResponse& response, std::size_t m, const ArcPath& path)
{
  const double q = 0.25 * response.ConeOf(m).quarterIndex;
  const Point& b = response.PositionOf(m);
  const double radius = response.AccurateDistance(m);
  const int cone = response.GetMoving()[m];
  Complex sum = 0.0;
  std::vector<bool> done(path.pieces.size(), false);
  for (const NearPart& part : FindNearParts(path, b, radius))
  {
    const bool starts = part.begin == 0 && path.firstCone == cone;
    const bool ends = part.end == path.pieces.size() && path.lastCone == cone;
    if (starts || ends)
    {
      sum += starts && ends ? 0.0 : -(1.0 - q) * part.step / (starts ? part.to : part.from);
    }
    else if (part.nearest < 0.5 * radius)
    {
      const Complex quotient = std::exp((1.0 - q) * part.turn);
      const Complex first = part.step / (quotient - 1.0);
      sum += -(1.0 - q) * (first * quotient / part.to - first / part.from);
    }
    else
    {
      continue; // far enough for the map
    }
    std::fill(done.begin() + static_cast<std::ptrdiff_t>(part.begin),
      done.begin() + static_cast<std::ptrdiff_t>(part.end), true);
  }
  for (std::size_t p = 0; p < path.pieces.size(); ++p)
  {
    const ArcPath::Piece& piece = path.pieces[p];
    const Complex step = AsComplex(piece.to - piece.from);
    // Pieces of length 0 are at nodes that coincide.
    if (!done[p] && std::abs(step) > 0.0)
    {
      sum += q * (piece.step / step) * LogQuotient(piece, b);
    }
  }
  return sum;
}
}

Eigen::RowVectorXd DifferentiateArc(const PositionResponse& response, const ArcPath& path)
{
  Eigen::VectorXcd regular = Eigen::VectorXcd::Zero(response.Columns());
  for (const ArcPath::Piece& piece : path.pieces)
  {
    response.AddRegular(piece.triangle, 0.5 * (piece.from + piece.to), -piece.step, regular);
  }
  Eigen::RowVectorXd row = regular.imag().transpose();
  for (std::size_t m = 0; m < response.GetMoving().size(); ++m)
  {
    AddToRow(SingularPart(response, m, path), static_cast<Eigen::Index>(2 * m), row);
  }
  return row;
}
}
