#include "SplineThrough.h"

#include <Eigen/Sparse>

#include <utility>

namespace crossfield
{
namespace
{
/// Returns the derivatives of the cubic spline through points by the parameter, whose steps are h.
std::vector<Point> SlopesOf(const std::vector<Point>& points, const std::vector<double>& h,
  bool isClosed, const EndTangents& tangents)
{
  const std::size_t count = points.size();
  const std::size_t pieces = h.size();
  const auto chord = [&](std::size_t i)
  { return Point((points[(i + 1) % count] - points[i % count]) / h[i % pieces]); };
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right(static_cast<Eigen::Index>(count), 2);
  const auto add = [&](std::size_t row, std::size_t column, double value)
  {
    entries.emplace_back(
      static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column % count), value);
  };
  const auto set = [&](std::size_t row, const Point& value)
  { right.row(static_cast<Eigen::Index>(row)) = value.transpose(); };
  for (std::size_t i = isClosed ? 0 : 1; i < (isClosed ? count : count - 1); ++i)
  {
    // The second derivative is continuous.
    const std::size_t before = (i + pieces - 1) % pieces;
    add(i, i + count - 1, 1.0 / h[before]);
    add(i, i, 2.0 / h[before] + 2.0 / h[i]);
    add(i, i + 1, 1.0 / h[i]);
    set(i, 3.0 * (chord(before) / h[before] + chord(i) / h[i]));
  }
  const auto setEnd = [&](std::size_t row, std::size_t piece, const std::optional<Point>& tangent)
  {
    if (tangent && tangent->norm() > 0.0)
    {
      add(row, row, 1.0);
      set(row, tangent->normalized());
    }
    else if (count <= 3)
    {
      // A line or a parabola: the second derivative is the same at both ends of the piece.
      add(row, piece, 1.0);
      add(row, piece + 1, 1.0);
      set(row, 2.0 * chord(piece));
    }
    else
    {
      // The third derivative is continuous at the point next to the end.
      const std::size_t i = row == 0 ? 0 : count - 3;
      const double a = 1.0 / (h[i] * h[i]);
      const double b = 1.0 / (h[i + 1] * h[i + 1]);
      add(row, i, a);
      add(row, i + 1, a - b);
      add(row, i + 2, -b);
      set(row, 2.0 * (a * chord(i) - b * chord(i + 1)));
    }
  };
  if (!isClosed)
  {
    setEnd(0, 0, tangents.first);
    setEnd(count - 1, pieces - 1, tangents.last);
  }
  Eigen::SparseMatrix<double> matrix(
    static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(count));
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::MatrixX2d slopes = solver.solve(right);
  std::vector<Point> result;
  for (Eigen::Index i = 0; i < slopes.rows(); ++i)
  {
    result.emplace_back(slopes(i, 0), slopes(i, 1));
  }
  return result;
}
}

PlaneCurve SplineThrough(
  const std::vector<Point>& points, bool isClosed, const EndTangents& tangents)
{
  const std::size_t count = points.size();
  const std::size_t pieces = isClosed ? count : count - 1;
  std::vector<double> h;
  for (std::size_t i = 0; i < pieces; ++i)
  {
    h.push_back((points[(i + 1) % count] - points[i]).norm());
  }
  const std::vector<Point> slopes = SlopesOf(points, h, isClosed, tangents);
  PlaneCurve curve;
  curve.kind = PlaneCurve::Kind::Nurbs;
  curve.degree = 3;
  curve.points.push_back(points[0]);
  curve.knots.assign(4, 0.0);
  double at = 0.0;
  for (std::size_t i = 0; i < pieces; ++i)
  {
    // Bézier points of the piece; every knot is triple.
    const std::size_t next = (i + 1) % count;
    curve.points.push_back(points[i] + h[i] / 3.0 * slopes[i]);
    curve.points.push_back(points[next] - h[i] / 3.0 * slopes[next]);
    curve.points.push_back(points[next]);
    at += h[i];
    curve.knots.insert(curve.knots.end(), 3, at);
  }
  curve.knots.push_back(at);
  curve.weights.assign(curve.points.size(), 1.0);
  return curve;
}
}
