#pragma once

#include "TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// The function that is linear on every triangle of a mesh and has given values at its vertices.
///
/// Triangles are found by a uniform grid of buckets, about one bucket per triangle.
class P1Interpolation
{
public:
  /// Stores the points, triangles and values: the mesh need not outlive this object.
  P1Interpolation(const TriangleMesh& mesh, Eigen::VectorXd values);

  /// Returns the value at a point; outside of the mesh, that at the nearest point of the mesh.
  double At(const Point& place) const;

private:
  struct Nearest
  {
    double squaredDistance;
    double value;
  };
  Nearest InTriangle(int triangle, const Point& place) const;
  int Column(double x) const;
  int Row(double y) const;

  std::vector<Point> Points;
  std::vector<std::array<int, 3>> Triangles;
  Eigen::VectorXd Values;
  Point Corner = Point::Zero(); ///< Lower left corner of the grid.
  double Width = 1.0;           ///< Side of a bucket.
  int Columns = 1;
  int Rows = 1;
  /// Triangles whose bounding box meets the bucket, row by row.
  std::vector<std::vector<int>> Buckets;
};
}
