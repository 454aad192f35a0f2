#include "MonotoneCurve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace crossfield
{
namespace
{
/// Returns the derivative at an inner point between two slopes: their weighted harmonic mean, 0 if
/// their signs differ.
double InnerSlope(double h0, double h1, double d0, double d1)
{
  if (d0 * d1 <= 0.0)
  {
    return 0.0;
  }
  const double w0 = 2.0 * h1 + h0;
  const double w1 = h1 + 2.0 * h0;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

/// Returns the derivative at an end: that of the parabola through three points, limited so that the
/// first piece is monotone.
double EndSlope(double h0, double h1, double d0, double d1)
{
  const double slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0.0)
  {
    return 0.0;
  }
  return d0 * d1 <= 0.0 && std::abs(slope) > 3.0 * std::abs(d0) ? 3.0 * d0 : slope;
}

/// Returns the derivative of the parabola through three points at the one between them.
double ParabolaSlope(double h0, double h1, double d0, double d1)
{
  return (h1 * d0 + h0 * d1) / (h0 + h1);
}

/// Returns the derivatives of one coordinate at all points; without `monotone` those of parabolas
/// through three points each.
std::vector<double> SlopesOf(
  const std::vector<double>& chords, const std::vector<double>& values, bool monotone)
{
  const std::size_t pieces = chords.size();
  std::vector<double> secants;
  for (std::size_t i = 0; i < pieces; ++i)
  {
    secants.push_back((values[i + 1] - values[i]) / chords[i]);
  }
  if (pieces == 1)
  {
    return { secants[0], secants[0] };
  }
  const auto atEnd = [&](std::size_t end, std::size_t next)
  {
    const double h0 = chords[end];
    const double h1 = chords[next];
    return monotone ? EndSlope(h0, h1, secants[end], secants[next])
                    : ((2.0 * h0 + h1) * secants[end] - h0 * secants[next]) / (h0 + h1);
  };
  std::vector<double> slopes = { atEnd(0, 1) };
  for (std::size_t i = 1; i < pieces; ++i)
  {
    slopes.push_back((monotone ? InnerSlope : ParabolaSlope)(
      chords[i - 1], chords[i], secants[i - 1], secants[i]));
  }
  slopes.push_back(atEnd(pieces - 1, pieces - 2));
  return slopes;
}
}

MonotoneCurve::MonotoneCurve(const std::vector<Point>& points, const std::optional<Point>& start)
  : Points(points)
{
  const Point along = (points.back() - points.front()).normalized();
  std::array<std::vector<double>, 2> coordinates;
  for (const Point& point : points)
  {
    coordinates[0].push_back(along.dot(point - points.front()));
    coordinates[1].push_back(Cross(along, point - points.front()));
  }
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    this->Chords.push_back((points[i + 1] - points[i]).norm());
  }
  const std::array<std::vector<double>, 2> slopes = { SlopesOf(this->Chords, coordinates[0], true),
    SlopesOf(this->Chords, coordinates[1], false) };
  const Point across(-along.y(), along.x());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    this->Slopes.push_back(slopes[0][i] * along + slopes[1][i] * across);
  }
  if (start)
  {
    this->Slopes.front() = *start;
  }
  this->Lengths = { 0.0 };
  for (std::size_t i = 0; i < this->Chords.size(); ++i)
  {
    this->Lengths.push_back(this->Lengths.back() + this->LengthOn(i, 1.0));
  }
}

Point MonotoneCurve::PlaceOn(std::size_t piece, double fraction) const
{
  const double t = fraction;
  const double h = this->Chords[piece];
  const Point secant = this->Points[piece + 1] - this->Points[piece];
  return this->Points[piece] + t * t * (3.0 - 2.0 * t) * secant +
    h * t * (1.0 - t) * ((1.0 - t) * this->Slopes[piece] - t * this->Slopes[piece + 1]);
}

Point MonotoneCurve::DerivativeOn(std::size_t piece, double fraction) const
{
  const double t = fraction;
  const double h = this->Chords[piece];
  const Point secant = this->Points[piece + 1] - this->Points[piece];
  return 6.0 * t * (1.0 - t) * secant + h * (1.0 - t) * (1.0 - 3.0 * t) * this->Slopes[piece] +
    h * t * (3.0 * t - 2.0) * this->Slopes[piece + 1];
}

double MonotoneCurve::LengthOn(std::size_t piece, double fraction) const
{
  // Gauss's rule with five points: the speed varies little on a piece.
  constexpr std::array<double, 5> Nodes = { 0.04691007703066802, 0.23076534494715845, 0.5,
    0.76923465505284155, 0.95308992296933198 };
  constexpr std::array<double, 5> Weights = { 0.11846344252809454, 0.23931433524968324,
    0.28444444444444444, 0.23931433524968324, 0.11846344252809454 };
  double sum = 0.0;
  for (std::size_t i = 0; i < Nodes.size(); ++i)
  {
    sum += Weights[i] * this->DerivativeOn(piece, fraction * Nodes[i]).norm();
  }
  return fraction * sum;
}

Point MonotoneCurve::At(double length) const
{
  const auto next = std::upper_bound(this->Lengths.begin() + 1, this->Lengths.end() - 1, length);
  const auto piece = static_cast<std::size_t>(next - this->Lengths.begin()) - 1;
  const double wanted = length - this->Lengths[piece];
  // Newton's method, within bounds that it narrows.
  double low = 0.0;
  double high = 1.0;
  double t = std::clamp(wanted / (this->Lengths[piece + 1] - this->Lengths[piece]), 0.0, 1.0);
  for (int i = 0; i < 60 && high - low > 1e-15; ++i)
  {
    const double error = this->LengthOn(piece, t) - wanted;
    (error > 0.0 ? high : low) = t;
    if (std::abs(error) <= 1e-14 * this->Length())
    {
      break;
    }
    const double speed = this->DerivativeOn(piece, t).norm();
    const double step = speed > 0.0 ? t - error / speed : -1.0;
    t = step > low && step < high ? step : 0.5 * (low + high);
  }
  return this->PlaceOn(piece, t);
}

Point MonotoneCurve::StartTangent() const
{
  const Point& slope = this->Slopes.front();
  return slope.norm() > 0.0 ? slope.normalized()
                            : Point((this->Points[1] - this->Points[0]).normalized());
}
}
