#include "RigidMotion.h"

#include <Eigen/LU>

#include <numeric>

namespace crossfield
{
namespace
{
Point MeanOf(const std::vector<Point>& points)
{
  return std::accumulate(points.begin(), points.end(), Point(Point::Zero())) /
    static_cast<double>(points.size());
}
}

Eigen::Matrix2d RigidMotion::Rotation() const
{
  Eigen::Matrix2d rotation = Eigen::Matrix2d::Identity();
  if (this->angle != 0.0)
  {
    const double cosine = std::cos(this->angle);
    const double sine = std::sin(this->angle);
    rotation << cosine, -sine, sine, cosine;
  }
  return rotation;
}

RigidMotion RigidMotion::Inverse() const
{
  return { -this->angle, -this->Rotation().transpose() * this->shift };
}

Point RigidMotion::Centre() const
{
  return (Eigen::Matrix2d::Identity() - this->Rotation()).inverse() * this->shift;
}

RigidMotion FitMotion(const std::vector<Point>& from, const std::vector<Point>& to)
{
  const Point start = MeanOf(from);
  const Point end = MeanOf(to);
  double cosine = 0.0;
  double sine = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    cosine += (from[i] - start).dot(to[i] - end);
    sine += Cross(from[i] - start, to[i] - end);
  }
  RigidMotion motion;
  motion.angle = std::atan2(sine, cosine);
  motion.shift = end - motion.Rotation() * start;
  return motion;
}
}
