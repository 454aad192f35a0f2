#include "CurveFit.h"

#include "CurveEvaluator.h"
#include "Error.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Weight of fixed ends: they are missed by its inverse square times the residual of the others,
/// 1e-14 of the extent where that is 1e-6.
constexpr double EndWeight = 1e4;
/// Gauss-Newton steps; points near a curve need less than ten.
constexpr int MaximumSteps = 50;

/// The frame in which points are fitted: about their mean, with extent 1.
struct FitFrame
{
  Point centre = Point::Zero();
  double scale = 1.0;
  std::vector<Point> points;
  std::vector<double> weights;
};

FitFrame FrameOf(const std::vector<Point>& points, FitEnds ends)
{
  FitFrame frame;
  for (const Point& point : points)
  {
    frame.centre += point / static_cast<double>(points.size());
  }
  double extent = 0.0;
  for (const Point& point : points)
  {
    extent = std::max(extent, (point - frame.centre).norm());
  }
  frame.scale = extent > 0.0 ? extent : 1.0;
  for (const Point& point : points)
  {
    frame.points.push_back((point - frame.centre) / frame.scale);
  }
  frame.weights.assign(points.size(), 1.0);
  if (ends == FitEnds::Fixed)
  {
    frame.weights.front() = frame.weights.back() = EndWeight;
  }
  return frame;
}

/// Minimises Σ (w r)² by Gauss-Newton with halved steps; `rows(x, r, J)` computes weighted residuals
/// and their derivatives, and returns whether x is valid.
template <class Rows>
Eigen::VectorXd Minimise(Eigen::VectorXd x, std::size_t count, const Rows& rows)
{
  const auto size = static_cast<Eigen::Index>(count);
  Eigen::VectorXd residual(size);
  Eigen::MatrixXd jacobian(size, x.size());
  rows(x, residual, jacobian);
  double value = residual.squaredNorm();
  for (int step = 0; step < MaximumSteps; ++step)
  {
    const Eigen::VectorXd move =
      jacobian.completeOrthogonalDecomposition().solve(residual); // of a circle, no angle matters
    bool isBetter = false;
    for (double length = 1.0; length > 1e-4 && !isBetter; length *= 0.5)
    {
      const Eigen::VectorXd next = x - length * move;
      Eigen::VectorXd nextResidual(size);
      Eigen::MatrixXd nextJacobian(size, x.size());
      if (rows(next, nextResidual, nextJacobian) && nextResidual.squaredNorm() < value)
      {
        isBetter = true;
        x = next;
        residual = nextResidual;
        jacobian = nextJacobian;
      }
    }
    if (!isBetter || move.norm() <= 1e-15 * x.norm())
    {
      break;
    }
    value = residual.squaredNorm();
  }
  return x;
}

[[noreturn]] void RefuseFit(const std::string& kind, const std::string& why)
{
  throw Error("No " + kind + " can be fitted: " + why + ".");
}
}

PlaneCurve FitCircle(const std::vector<Point>& points, FitEnds ends)
{
  if (points.size() < 3)
  {
    RefuseFit(
      "circle", "it needs at least three points, and there are " + std::to_string(points.size()));
  }
  const FitFrame frame = FrameOf(points, ends);
  // Start: |p|² + b·p + c = 0 by linear least squares.
  const auto count = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd matrix(count, 3);
  Eigen::VectorXd right(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const Point& p = frame.points[i];
    matrix.row(i) << p.x(), p.y(), 1.0;
    right[i] = -p.squaredNorm();
  }
  const auto decomposition = matrix.colPivHouseholderQr();
  const auto values = Eigen::VectorXd(decomposition.matrixR().diagonal().cwiseAbs());
  if (values.minCoeff() <= 1e-9 * values.maxCoeff())
  {
    RefuseFit("circle", "the points are on a line");
  }
  const Eigen::Vector3d start = decomposition.solve(right);
  const Point centre = -0.5 * start.head<2>();
  Eigen::VectorXd unknowns(3);
  unknowns << centre, std::sqrt(std::max(0.0, centre.squaredNorm() - start.z()));
  unknowns = Minimise(unknowns, points.size(),
    [&](const Eigen::VectorXd& x, Eigen::VectorXd& residual, Eigen::MatrixXd& jacobian)
    {
      for (Eigen::Index i = 0; i < count; ++i)
      {
        const Point offset = frame.points[i] - Point(x[0], x[1]);
        const double weight = frame.weights[i];
        const double distance = offset.norm();
        residual[i] = weight * (distance - x[2]);
        jacobian.row(i) << -weight * offset.x() / distance, -weight * offset.y() / distance,
          -weight;
      }
      return x[2] > 0.0;
    });
  PlaneCurve curve;
  curve.kind = PlaneCurve::Kind::Circle;
  curve.centre = frame.centre + frame.scale * Point(unknowns[0], unknowns[1]);
  // Parameters start at the first point, so they turn with the points.
  curve.axis = frame.scale * unknowns[2] * (points.front() - curve.centre).normalized();
  return curve;
}

namespace
{
/// An ellipse by its unknowns: centre, angle of the axis, both semi-axes.
PlaneCurve EllipseOf(const Eigen::VectorXd& x)
{
  PlaneCurve curve;
  curve.kind = PlaneCurve::Kind::Ellipse;
  curve.centre = Point(x[0], x[1]);
  curve.axis = x[3] * Point(std::cos(x[2]), std::sin(x[2]));
  curve.ratio = x[4] / x[3];
  return curve;
}

/// Returns the ellipse of the algebraic fit of Halíř and Flusser (1998), empty if there is none.
Eigen::VectorXd StartOfEllipse(const FitFrame& frame)
{
  const auto count = static_cast<Eigen::Index>(frame.points.size());
  Eigen::MatrixXd squares(count, 3);
  Eigen::MatrixXd linear(count, 3);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const Point& p = frame.points[i];
    squares.row(i) << p.x() * p.x(), p.x() * p.y(), p.y() * p.y();
    linear.row(i) << p.x(), p.y(), 1.0;
  }
  const Eigen::Matrix3d s1 = squares.transpose() * squares;
  const Eigen::Matrix3d s2 = squares.transpose() * linear;
  const Eigen::Matrix3d s3 = linear.transpose() * linear;
  const Eigen::Matrix3d t = -s3.ldlt().solve(s2.transpose());
  const Eigen::Matrix3d m = s1 + s2 * t;
  Eigen::Matrix3d reduced;
  reduced << 0.5 * m.row(2), -m.row(1), 0.5 * m.row(0);
  const Eigen::EigenSolver<Eigen::Matrix3d> solver(reduced);
  for (int i = 0; i < 3; ++i)
  {
    const Eigen::Vector3d q = solver.eigenvectors().col(i).real();
    const double discriminant = 4.0 * q[0] * q[2] - q[1] * q[1];
    if (!(discriminant > 1e-12 * q.squaredNorm()))
    {
      continue;
    }
    const Eigen::Vector3d l = t * q;
    Eigen::Matrix2d form;
    form << q[0], 0.5 * q[1], 0.5 * q[1], q[2];
    const Point centre = -0.5 * form.inverse() * Point(l[0], l[1]);
    const double level = centre.dot(form * centre) - l[2];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(form * (level > 0.0 ? 1.0 : -1.0));
    if (!(axes.eigenvalues()[0] > 0.0))
    {
      continue;
    }
    const Point direction = axes.eigenvectors().col(0);
    Eigen::VectorXd x(5);
    x << centre, std::atan2(direction.y(), direction.x()),
      std::sqrt(std::abs(level) / axes.eigenvalues()[0]),
      std::sqrt(std::abs(level) / axes.eigenvalues()[1]);
    return x;
  }
  return {};
}
}

PlaneCurve FitEllipse(const std::vector<Point>& points, FitEnds ends)
{
  if (points.size() < 5)
  {
    RefuseFit(
      "ellipse", "it needs at least five points, and there are " + std::to_string(points.size()));
  }
  const FitFrame frame = FrameOf(points, ends);
  Eigen::VectorXd unknowns = StartOfEllipse(frame);
  if (unknowns.size() == 0 || !unknowns.allFinite())
  {
    RefuseFit("ellipse", "none is near the points");
  }
  unknowns = Minimise(unknowns, points.size(),
    [&](const Eigen::VectorXd& x, Eigen::VectorXd& residual, Eigen::MatrixXd& jacobian)
    {
      // Beyond this the points determine no ellipse.
      if (!(x[3] > 0.0 && x[4] > 0.0 && x[3] < 1e6 && x[4] < 1e6))
      {
        return false;
      }
      const CurveEvaluator ellipse(EllipseOf(x));
      const Point along(std::cos(x[2]), std::sin(x[2]));
      const Point across = TurnedLeft(along);
      for (std::size_t i = 0; i < frame.points.size(); ++i)
      {
        const double t = ellipse.Nearest(frame.points[i]);
        const CurveFrame at = ellipse.FrameAt(t);
        const Point normal = -TurnedLeft(at.first).normalized();
        const double weight = frame.weights[i];
        const auto row = static_cast<Eigen::Index>(i);
        residual[row] = weight * (frame.points[i] - at.place).dot(normal);
        // Minus the movement of the curve along its normal.
        jacobian.row(row) << normal.x(), normal.y(),
          TurnedLeft(at.place - ellipse.Curve().centre).dot(normal),
          std::cos(t) * along.dot(normal), std::sin(t) * across.dot(normal);
        jacobian.row(row) *= -weight;
      }
      return true;
    });
  PlaneCurve curve = EllipseOf(unknowns);
  curve.centre = frame.centre + frame.scale * curve.centre;
  curve.axis *= frame.scale;
  return curve;
}
}
