#include "ArcRecognition.h"

#include "BoundaryCorners.h"
#include "CurveFit.h"
#include "Error.h"
#include "LoopTurning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace crossfield
{
namespace
{
constexpr std::size_t FewestPoints = 5;
/// Distance of points from their circle, relative to the diagonal of the loop, because coordinates
/// in single precision have errors of 6e-8. The domain may be much larger than a profile in it.
constexpr double LargestResidual = 1e-7;
/// The same, relative to the smallest sagitta: other smooth curves deviate more from their circles
/// of curvature, because their curvature changes.
constexpr double LargestPart = 0.01;
constexpr double SmallestTurn = Pi / 6.0;

class ArcFinder
{
public:
  ArcFinder(const Loop& loop, double cornerAngle)
    : Vertices(loop)
    , Extent(BoundingDiagonal({ loop }))
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      this->Corners.push_back(IsCorner(TurningAt(loop, i), cornerAngle));
    }
  }

  std::vector<RecognisedArc> Find() const
  {
    const std::size_t count = this->Vertices.size();
    if (count < FewestPoints)
    {
      return {};
    }
    if (std::none_of(this->Corners.begin(), this->Corners.end(), [](bool is) { return is; }))
    {
      if (const std::optional<PlaneCurve> circle = this->Fit(0, count))
      {
        return { { 0, count, *circle } };
      }
    }
    // Arcs are extended forwards only, so the first vertex must not be inside one.
    const std::size_t start = this->FirstOutside();
    std::vector<RecognisedArc> arcs;
    for (std::size_t step = 0; step + FewestPoints - 1 <= count;)
    {
      const std::size_t first = (start + step) % count;
      const std::size_t segments = this->Longest(first, count - step);
      std::optional<PlaneCurve> circle;
      if (segments > 0)
      {
        circle = this->Fit(first, segments);
      }
      if (circle && this->TurnOf(first, segments, *circle) >= SmallestTurn - AngleRounding)
      {
        arcs.push_back({ first, segments, *circle });
        step += segments;
      }
      else
      {
        ++step;
      }
    }
    return arcs;
  }

private:
  const Point& At(std::size_t vertex) const
  {
    return this->Vertices[vertex % this->Vertices.size()];
  }

  /// Returns a vertex that is a corner, or inside no five points on a circle; 0 if there is none.
  std::size_t FirstOutside() const
  {
    const std::size_t count = this->Vertices.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      bool isInside = false;
      for (std::size_t before = 1; before < FewestPoints - 1; ++before)
      {
        isInside = isInside || this->Fit((i + count - before) % count, FewestPoints - 1);
      }
      if (this->Corners[i] || !isInside)
      {
        return i;
      }
    }
    return 0;
  }

  /// Returns the circle of consecutive segments if they satisfy the conditions but that of the
  /// turn.
  std::optional<PlaneCurve> Fit(std::size_t first, std::size_t segments) const
  {
    const bool isLoop = segments == this->Vertices.size();
    std::vector<Point> points;
    for (std::size_t i = 0; i < segments + (isLoop ? 0 : 1); ++i)
    {
      points.push_back(this->At(first + i));
    }
    for (std::size_t i = 1; i < segments; ++i)
    {
      if (this->Corners[(first + i) % this->Vertices.size()])
      {
        return std::nullopt;
      }
    }
    PlaneCurve circle;
    try
    {
      circle = FitCircle(points);
    }
    catch (const Error&)
    {
      return std::nullopt; // on a line
    }
    const double radius = circle.axis.norm();
    double sagitta = std::numeric_limits<double>::infinity();
    double turn = 0.0;
    for (std::size_t i = 0; i < segments; ++i)
    {
      const Point a = this->At(first + i) - circle.centre;
      const Point b = this->At(first + i + 1) - circle.centre;
      const double angle = AngleBetween(a, b);
      if (i > 0 && angle * turn <= 0.0)
      {
        return std::nullopt; // turns back
      }
      turn += angle;
      sagitta = std::min(sagitta, 2.0 * radius * std::pow(std::sin(0.25 * angle), 2.0));
    }
    if (std::abs(turn) > 2.0 * Pi + AngleRounding)
    {
      return std::nullopt;
    }
    const double allowed = std::min(LargestResidual * this->Extent, LargestPart * sagitta);
    const bool isNear = std::all_of(points.begin(), points.end(),
      [&](const Point& point)
      { return std::abs((point - circle.centre).norm() - radius) <= allowed; });
    return isNear ? std::make_optional(circle) : std::nullopt;
  }

  /// Returns the largest number of segments from a vertex on that are on one circle, 0 if the first
  /// five points are on none.
  std::size_t Longest(std::size_t first, std::size_t available) const
  {
    std::size_t fits = FewestPoints - 1;
    if (available < fits || !this->Fit(first, fits))
    {
      return 0;
    }
    std::size_t fails = available + 1;
    for (std::size_t tried = 2 * fits; fails - fits > 1;)
    {
      tried = std::min(tried, fails - 1);
      (this->Fit(first, tried) ? fits : fails) = tried;
      tried = fails <= available ? fits + (fails - fits + 1) / 2 : 2 * fits;
      tried = std::max(tried, fits + 1);
    }
    return fits;
  }

  double TurnOf(std::size_t first, std::size_t segments, const PlaneCurve& circle) const
  {
    double turn = 0.0;
    for (std::size_t i = 0; i < segments; ++i)
    {
      turn +=
        AngleBetween(this->At(first + i) - circle.centre, this->At(first + i + 1) - circle.centre);
    }
    return std::abs(turn);
  }

  const Loop& Vertices;
  const double Extent;
  std::vector<bool> Corners;
};
}

std::vector<RecognisedArc> FindArcs(const Loop& loop, double cornerAngle)
{
  return ArcFinder(loop, cornerAngle).Find();
}
}
