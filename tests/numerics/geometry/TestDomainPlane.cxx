#include "DomainPlane.h"

#include "Error.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{
using crossfield::DomainPlane;
using crossfield::Point;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Returns the points of a grid of 5 × 4 with steps of 0.5 in the plane z = 0.
Matrix3Xd Grid()
{
  Matrix3Xd points(3, 20);
  for (int i = 0; i < 20; ++i)
  {
    points.col(i) << 0.5 * (i % 5) - 1.0, 0.5 * (i / 5), 0.0; // rows of five
  }
  return points;
}

/// Returns the shortest rotation that maps a coordinate axis to a unit vector.
Matrix3d ShortestRotation(const Vector3d& from, const Vector3d& to)
{
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

Matrix3d FrameOf(const DomainPlane& plane)
{
  Matrix3d frame;
  frame.col(0) = plane.DirectionToSpace({ 1.0, 0.0 });
  frame.col(1) = plane.DirectionToSpace({ 0.0, 1.0 });
  frame.col(2) = frame.col(0).cross(frame.col(1));
  return frame;
}

TEST(DomainPlane, CopiesTheBitsOfCoordinatePlanes)
{
  const double numbers[] = { 0.1, -1.0 / 3.0, 1e-300, 12345678.9 };
  const int axes[3][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 0, 2, 1 } }; // first, second, constant
  for (const auto& [first, second, constant] : axes)
  {
    Matrix3Xd points(3, 4);
    for (int i = 0; i < 4; ++i)
    {
      points(first, i) = numbers[i];
      points(second, i) = numbers[3 - i];
      points(constant, i) = 0.7;
    }
    const DomainPlane plane = DomainPlane::Find(points);
    EXPECT_EQ(plane.IsHorizontal(), constant == 2);
    for (int i = 0; i < 4; ++i)
    {
      const Point point = plane.ToPlane(points.col(i));
      EXPECT_EQ(point, Point(numbers[i], numbers[3 - i]));
      EXPECT_EQ(plane.ToSpace(point), points.col(i)) << constant;
    }
    EXPECT_EQ(FrameOf(plane).determinant(), 1.0);
  }
}

TEST(DomainPlane, IsTheNearestCoordinatePlaneAfterTheShortestRotation)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial)
  {
    const Vector3d direction =
      Vector3d(normal(random), normal(random), normal(random)).normalized();
    const Vector3d shift(normal(random), normal(random), normal(random));
    const Matrix3d turn = ShortestRotation(Vector3d::UnitZ(), direction);
    const DomainPlane plane = DomainPlane::Find((turn * Grid()).colwise() + shift);
    const Matrix3d frame = FrameOf(plane);
    EXPECT_LT((frame.transpose() * frame - Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_LT(frame.col(2).cross(direction).norm(), 1e-14);

    Matrix3d base = Matrix3d::Identity();
    int largest = 0;
    direction.cwiseAbs().maxCoeff(&largest);
    if (largest == 0)
    {
      base << 0, 0, 1, 1, 0, 0, 0, 1, 0; // (y, z), normal x
    }
    else if (largest == 1)
    {
      base << 1, 0, 0, 0, 0, -1, 0, 1, 0; // (x, z), normal -y
    }
    EXPECT_GT(base.col(2).dot(frame.col(2)), 0.57) << "the nearest of three";
    EXPECT_LT((frame - ShortestRotation(base.col(2), frame.col(2)) * base).norm(), 1e-13);

    for (int i = 0; i < 20; ++i)
    {
      const Vector3d place = turn * Grid().col(i) + shift;
      EXPECT_LT((plane.ToSpace(plane.ToPlane(place)) - place).norm(), 1e-12);
    }
  }
}

TEST(DomainPlane, RoundingDoesNotDecideTies)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> slope(-0.5, 0.5);
  for (int trial = 0; trial < 50; ++trial)
  {
    const Vector3d direction = Vector3d(slope(random), slope(random), 1.0).normalized();
    const Matrix3Xd points = ShortestRotation(Vector3d::UnitZ(), direction) * Grid();
    const DomainPlane plane = DomainPlane::Find(points);
    for (int i = 0; i < 20; ++i)
    {
      EXPECT_EQ(plane.ToPlane(points.col(i)), Point(Grid().col(i).head<2>()));
    }
  }
}

TEST(DomainPlane, ASlopeOf45DegreesIsNotDecidedByRounding)
{
  for (double noise : { -1e-12, 0.0, 1e-12 })
  {
    Matrix3Xd points = Grid();
    points.row(2) = points.row(0) * (1.0 + noise);
    const Matrix3d frame = FrameOf(DomainPlane::Find(points));
    EXPECT_LT((frame.col(1) - Vector3d::UnitY()).norm(), 1e-10) << "as seen from above";
  }
}

TEST(DomainPlane, DoesNotDependOnTheOrderOfPoints)
{
  const Matrix3Xd points =
    ShortestRotation(Vector3d::UnitZ(), Vector3d(1, -2, 1.5).normalized()) * Grid();
  const DomainPlane plane = DomainPlane::Find(points);
  const DomainPlane reversed = DomainPlane::Find(points.rowwise().reverse());
  EXPECT_LT((FrameOf(plane) - FrameOf(reversed)).norm(), 1e-14);
}

TEST(DomainPlane, RefusesCurvedDataWithItsDeviation)
{
  for (const Vector3d& direction : { Vector3d(0, 0, 1), Vector3d(1, 2, 3) })
  {
    Matrix3Xd points = Grid();
    // A saddle: its least-squares plane is that of the grid, and it deviates from it by 0.15.
    points.row(2) = 0.2 * points.row(0).array() * (points.row(1).array() - 0.75);
    points = ShortestRotation(Vector3d::UnitZ(), direction.normalized()) * points;
    try
    {
      DomainPlane::Find(points);
      FAIL() << "no error";
    }
    catch (const crossfield::Error& error)
    {
      EXPECT_NE(std::string(error.what()).find("not planar"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("0.15 off"), std::string::npos) << error.what();
    }
  }
}

TEST(DomainPlane, FlattensWhatIsSlightlyOffWithAWarning)
{
  // The saddle of above, whose size is about 2.
  for (const auto& [height, isWarned] : { std::pair(1e-7, false), std::pair(1e-4, true) })
  {
    Matrix3Xd points = Grid();
    points.row(2) = height * points.row(0).array() * (points.row(1).array() - 0.75);
    const DomainPlane plane = DomainPlane::Find(
      ShortestRotation(Vector3d::UnitZ(), Vector3d(1, 2, 3).normalized()) * points);
    EXPECT_EQ(plane.FlatteningWarning().find("flattened") != std::string::npos, isWarned)
      << plane.FlatteningWarning();
  }
}

TEST(DomainPlane, AcceptsCoordinatesOfSinglePrecision)
{
  const Matrix3d turn = ShortestRotation(Vector3d::UnitZ(), Vector3d(1, 2, 3).normalized());
  for (double distance : { 0.0, 1e3, 1e5 })
  {
    const Matrix3Xd exact = (turn * Grid()).colwise() + Vector3d(distance, -distance, distance);
    const Matrix3Xd points = exact.cast<float>().cast<double>();
    const DomainPlane plane = DomainPlane::Find(points);
    for (int i = 0; i < 20; ++i)
    {
      EXPECT_LT((plane.ToSpace(plane.ToPlane(exact.col(i))) - exact.col(i)).norm(),
        1e-6 * (1.0 + distance));
    }
  }
}

TEST(DomainPlane, IsHorizontalForPointsThatAreNotFinite)
{
  Matrix3Xd points = Grid();
  points.row(2).setLinSpaced(0.0, 1.0);
  for (double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    points(0, 3) = bad;
    EXPECT_TRUE(DomainPlane::Find(points).IsHorizontal());
  }
  EXPECT_TRUE(DomainPlane::Find(Matrix3Xd(3, 0)).IsHorizontal());
}

TEST(DomainPlane, RefusesPointsOffThePlane)
{
  const Matrix3d turn = ShortestRotation(Vector3d::UnitZ(), Vector3d(1, 2, 3).normalized());
  const DomainPlane plane = DomainPlane::Find(turn * Grid());
  const Vector3d inside(0.25, 0.75, 0.0);
  EXPECT_LT((plane.RequireInPlane(turn * inside, "It") - Point(0.25, 0.75)).norm(), 1e-12);
  // Coordinates typed with four digits.
  const Vector3d typed = ((turn * inside) * 1e4).array().round() / 1e4;
  EXPECT_LT((plane.RequireInPlane(typed, "It") - Point(0.25, 0.75)).norm(), 1e-3);
  try
  {
    plane.RequireInPlane(turn * Vector3d(0.25, 0.75, 0.5), "The point 7");
    FAIL() << "no error";
  }
  catch (const crossfield::Error& error)
  {
    const std::string text = error.what();
    EXPECT_EQ(text.find("The point 7 at ("), 0u) << text;
    EXPECT_NE(text.find("0.5 off the plane"), std::string::npos) << text;
  }
  EXPECT_EQ(DomainPlane::Find(Grid()).RequireInPlane({ 0.25, 0.75, 9.0 }, "It"), Point(0.25, 0.75));
}
}
