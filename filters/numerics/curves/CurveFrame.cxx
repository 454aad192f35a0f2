#include "CurveFrame.h"

#include "Index.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace crossfield
{
namespace
{
CurveFrame ConicFrame(const PlaneCurve& curve, double parameter)
{
  const Point other = curve.ratio * TurnedLeft(curve.axis);
  const double c = std::cos(parameter);
  const double s = std::sin(parameter);
  const Point offset = c * curve.axis + s * other;
  return { curve.centre + offset, c * other - s * curve.axis, -offset };
}

CurveFrame NurbsFrame(const PlaneCurve& curve, double parameter)
{
  const std::vector<double>& knots = curve.knots;
  const auto degree = Index(curve.degree);
  const std::size_t count = curve.points.size();
  const double t = std::clamp(parameter, knots[degree], knots[count]);
  // The span [knots[k], knots[k + 1]) of the parameter, the last one that is not empty at the end.
  const auto after = std::upper_bound(knots.begin() + static_cast<std::ptrdiff_t>(degree),
    knots.begin() + static_cast<std::ptrdiff_t>(count), t);
  std::size_t k = static_cast<std::size_t>(after - knots.begin()) - 1;
  while (knots[k] == knots[k + 1])
  {
    --k;
  }
  // De Boor's algorithm in homogeneous coordinates, relative to the first control point, so that
  // large coordinates lose no digits. The last two rounds also give the derivatives.
  const Point& origin = curve.points.front();
  std::array<Eigen::Vector3d, MaximumDegree + 1> d;
  for (std::size_t j = 0; j <= degree; ++j)
  {
    const std::size_t i = k - degree + j;
    const Point offset = curve.weights[i] * (curve.points[i] - origin);
    d[j] = { offset.x(), offset.y(), curve.weights[i] };
  }
  const double span = knots[k + 1] - knots[k];
  const auto p = static_cast<double>(degree);
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Vector3d second = Eigen::Vector3d::Zero();
  for (std::size_t round = 1; round <= degree; ++round)
  {
    if (round + 1 == degree)
    {
      const double left = knots[k + 1] - knots[k - 1];
      const double right = knots[k + 2] - knots[k];
      second = p * (p - 1.0) / span *
        ((d[degree] - d[degree - 1]) / right - (d[degree - 1] - d[degree - 2]) / left);
    }
    if (round == degree)
    {
      first = p / span * (d[degree] - d[degree - 1]);
    }
    for (std::size_t j = degree; j >= round; --j)
    {
      const std::size_t i = k - degree + j;
      const double width = knots[i + degree - round + 1] - knots[i];
      const double part = (t - knots[i]) / width;
      d[j] = (1.0 - part) * d[j - 1] + part * d[j];
    }
  }
  const Eigen::Vector3d& h = d[degree];
  const Point offset = h.head<2>() / h.z();
  CurveFrame frame;
  frame.place = origin + offset;
  frame.first = (first.head<2>() - first.z() * offset) / h.z();
  frame.second = (second.head<2>() - 2.0 * first.z() * frame.first - second.z() * offset) / h.z();
  return frame;
}
}

CurveFrame FrameOf(const PlaneCurve& curve, double parameter)
{
  return curve.kind == PlaneCurve::Kind::Nurbs ? NurbsFrame(curve, parameter)
                                               : ConicFrame(curve, parameter);
}
}
