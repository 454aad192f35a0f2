#include "ThroughPoints.h"

#include <Eigen/Core>

namespace crossfield
{
namespace
{
/// Cyclic or open tridiagonal system for the slopes at the points, solved by elimination without
/// pivoting, since it is diagonally dominant.
class SlopeSystem
{
public:
  explicit SlopeSystem(std::size_t count)
    : Below(count, 0.0)
    , Middle(count, 1.0)
    , Above(count, 0.0)
    , Right(count, Point::Zero())
  {
  }

  void SetRow(std::size_t row, double below, double middle, double above, const Point& right)
  {
    this->Below[row] = below;
    this->Middle[row] = middle;
    this->Above[row] = above;
    this->Right[row] = right;
  }

  std::vector<Point> Solve() const { return this->SolveFor(this->Right); }

  /// Solves the cyclic system, whose first row refers to the last unknown and vice versa, by the
  /// formula of Sherman and Morrison.
  std::vector<Point> SolveCyclic() const
  {
    const std::size_t last = this->Middle.size() - 1;
    const double shift = -this->Middle[0];
    const double low = this->Below[0];
    const double high = this->Above[last];
    SlopeSystem open = *this;
    open.Middle[0] -= shift;
    open.Middle[last] -= low * high / shift;
    std::vector<Point> column(last + 1, Point::Zero());
    column[0] = Point(shift, 0.0);
    column[last] = Point(high, 0.0);
    const std::vector<Point> one = open.SolveFor(this->Right);
    const std::vector<Point> two = open.SolveFor(column);
    const double scale = 1.0 + two[0].x() + low / shift * two[last].x();
    const Point factor = (one[0] + low / shift * one[last]) / scale;
    std::vector<Point> slopes = one;
    for (std::size_t i = 0; i <= last; ++i)
    {
      slopes[i] -= two[i].x() * factor;
    }
    return slopes;
  }

private:
  std::vector<Point> SolveFor(std::vector<Point> right) const
  {
    std::vector<double> middle = this->Middle;
    for (std::size_t i = 1; i < right.size(); ++i)
    {
      const double factor = this->Below[i] / middle[i - 1];
      middle[i] -= factor * this->Above[i - 1];
      right[i] -= factor * right[i - 1];
    }
    for (std::size_t i = right.size(); i-- > 0;)
    {
      right[i] = (right[i] -
                   (i + 1 < right.size() ? this->Above[i] : 0.0) *
                     (i + 1 < right.size() ? right[i + 1] : Point(Point::Zero()))) /
        middle[i];
    }
    return right;
  }

  std::vector<double> Below;
  std::vector<double> Middle;
  std::vector<double> Above;
  std::vector<Point> Right;
};

/// Returns the derivatives at the points; a periodic spline has one point fewer than it passes.
std::vector<Point> Slopes(const std::vector<Point>& points, const std::vector<double>& lengths,
  const EndTangents& tangents, bool isPeriodic)
{
  const std::size_t spans = lengths.size();
  const auto secant = [&points, &lengths](std::size_t i)
  { return Point((points[i + 1] - points[i]) / lengths[i]); };
  SlopeSystem system(isPeriodic ? spans : spans + 1);
  for (std::size_t i = isPeriodic ? 0 : 1; i < spans; ++i)
  {
    const std::size_t before = (i + spans - 1) % spans;
    system.SetRow(i, lengths[i], 2.0 * (lengths[before] + lengths[i]), lengths[before],
      3.0 * (lengths[i] * secant(before) + lengths[before] * secant(i)));
  }
  if (isPeriodic)
  {
    std::vector<Point> slopes = system.SolveCyclic();
    slopes.push_back(slopes.front());
    return slopes;
  }
  if (tangents.first.has_value() && tangents.first->norm() > 0.0)
  {
    system.SetRow(0, 0.0, 1.0, 0.0, tangents.first->normalized());
  }
  else
  {
    system.SetRow(0, 0.0, 2.0, 1.0, 3.0 * secant(0));
  }
  if (tangents.last.has_value() && tangents.last->norm() > 0.0)
  {
    system.SetRow(spans, 0.0, 1.0, 0.0, tangents.last->normalized());
  }
  else
  {
    system.SetRow(spans, 1.0, 2.0, 0.0, 3.0 * secant(spans - 1));
  }
  return system.Solve();
}
}

DrawingPiece ThroughPoints(
  const std::vector<Point>& points, bool isPeriodic, const EndTangents& tangents)
{
  std::vector<Point> places;
  std::vector<double> lengths;
  for (const Point& point : points)
  {
    if (places.empty() || point != places.back())
    {
      if (!places.empty())
      {
        lengths.push_back((point - places.back()).norm());
      }
      places.push_back(point);
    }
  }
  if (places.size() < 3)
  {
    return LinePiece(places.front(), places.back());
  }
  const std::vector<Point> slopes =
    Slopes(places, lengths, tangents, isPeriodic && places.size() > 3);

  PlaneCurve curve;
  curve.kind = PlaneCurve::Kind::Nurbs;
  curve.knots = { 0.0 };
  curve.points = { places.front() };
  double at = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    curve.knots.insert(curve.knots.end(), 3, at);
    at += lengths[i];
    curve.points.emplace_back(places[i] + lengths[i] / 3.0 * slopes[i]);
    curve.points.emplace_back(places[i + 1] - lengths[i] / 3.0 * slopes[i + 1]);
    curve.points.push_back(places[i + 1]);
  }
  curve.knots.insert(curve.knots.end(), 4, at);
  curve.weights.assign(curve.points.size(), 1.0);
  DrawingPiece piece = CurvePiece(curve, 0.0, at);
  piece.first = places.front();
  piece.last = places.back();
  return piece;
}
}
