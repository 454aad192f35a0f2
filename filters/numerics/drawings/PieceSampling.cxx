#include "PieceSampling.h"

#include "Error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace crossfield
{
namespace
{
constexpr std::size_t MostPoints = 1000000;

/// Divides an arc of a circle evenly.
std::vector<double> SampleArc(const DrawingPiece& piece, const SamplingRule& rule)
{
  const double radius = piece.curve.axis.norm();
  const double sweep = piece.end - piece.begin;
  // The sagitta of a segment that turns by a is r (1 − cos a/2).
  const double sagitta = std::min(rule.distance / radius, 1.0);
  const double turn = std::min(rule.turn, 4.0 * std::asin(std::sqrt(0.5 * sagitta)));
  double count = std::min(std::ceil(std::abs(sweep) / turn - 1e-9), double(MostPoints));
  count = piece.first == piece.last ? 8.0 * std::ceil(count / 8.0) : std::max(count, 1.0);
  std::vector<double> parameters;
  for (double i = 0.0; i < count; i += 1.0)
  {
    parameters.push_back(piece.begin + i / count * sweep);
  }
  parameters.push_back(piece.end);
  return parameters;
}

/// Bisects smooth parts of a curve.
class Bisection
{
public:
  Bisection(const DrawingPiece& piece, const SamplingRule& rule)
    : Piece(piece)
    , Rule(rule)
  {
  }

  std::vector<double> Run()
  {
    const std::vector<double> parts = SmoothParts(this->Piece);
    for (std::size_t i = 1; i < parts.size(); ++i)
    {
      this->Parameters.push_back(parts[i - 1]);
      this->Divide(parts[i - 1], parts[i], Deepest);
    }
    this->Parameters.push_back(parts.back());
    return std::move(this->Parameters);
  }

private:
  static constexpr int Deepest = 40;

  void Divide(double begin, double end, int levels)
  {
    if (this->Parameters.size() > MostPoints)
    {
      throw Error("Sampling " + this->Piece.origin +
        " needs more than a million points; simplify this curve in the drawing.");
    }
    if (levels == 0 || this->IsFlat(begin, end))
    {
      return;
    }
    const double middle = 0.5 * (begin + end);
    this->Divide(begin, middle, levels - 1);
    this->Parameters.push_back(middle);
    this->Divide(middle, end, levels - 1);
  }

  bool IsFlat(double begin, double end) const
  {
    constexpr std::size_t Count = 5;
    std::array<Point, Count> points;
    double length = 0.0;
    for (std::size_t i = 0; i < Count; ++i)
    {
      points[i] = PointAt(
        this->Piece, i + 1 == Count ? end : begin + double(i) / (Count - 1) * (end - begin));
      length += i > 0 ? (points[i] - points[i - 1]).norm() : 0.0;
    }
    if (!(length > this->Rule.shortest))
    {
      return true;
    }
    const Point chord = points.back() - points.front();
    double distance = 0.0;
    double turn = 0.0;
    for (std::size_t i = 1; i + 1 < Count; ++i)
    {
      const Point before = points[i] - points[i - 1];
      const Point after = points[i + 1] - points[i];
      distance = std::max(distance, std::abs(Cross(chord, points[i] - points.front())));
      turn +=
        before.norm() > 0.0 && after.norm() > 0.0 ? std::abs(AngleBetween(before, after)) : 0.0;
    }
    // Four chords turn three times; the curve itself turns by another half at each end.
    const bool isBelow = distance <= this->Rule.distance * chord.norm();
    return isBelow && turn * 4.0 / 3.0 <= this->Rule.turn;
  }

  const DrawingPiece& Piece;
  const SamplingRule& Rule;
  std::vector<double> Parameters;
};
}

std::vector<double> SampleParameters(const DrawingPiece& piece, const SamplingRule& rule)
{
  switch (piece.curve.kind)
  {
  case PlaneCurve::Kind::Line:
    return { piece.begin, piece.end };
  case PlaneCurve::Kind::Circle:
    return SampleArc(piece, rule);
  default:
    return Bisection(piece, rule).Run();
  }
}

double ApproximateLength(const DrawingPiece& piece)
{
  constexpr int Segments = 8; // of each smooth part
  const std::vector<double> parts = SmoothParts(piece);
  double length = 0.0;
  Point before = piece.first;
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    for (int k = 1; k <= Segments; ++k)
    {
      const Point here = PointAt(
        piece, k == Segments ? parts[i] : parts[i - 1] + (parts[i] - parts[i - 1]) * k / Segments);
      length += (here - before).norm();
      before = here;
    }
  }
  return length;
}
}
