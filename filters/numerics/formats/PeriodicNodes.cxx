#include "PeriodicNodes.h"

#include "CellLattice.h"
#include "Error.h"
#include "Index.h"
#include "SideFaces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <set>

namespace crossfield
{
namespace
{
/// Images of periodic points in files with 12 digits or more are within this part of the extent.
constexpr double Tolerance = 1e-9;

std::vector<int> PointsOf(const ExportMesh& mesh, const std::vector<SideFace>& faces)
{
  const CellLattice lattice(mesh.dimension, mesh.order);
  std::set<int> points;
  for (const SideFace& face : faces)
  {
    for (const int position : lattice.Face(face.face))
    {
      points.insert(mesh.Cell(face.cell)[position]);
    }
  }
  return { points.begin(), points.end() };
}

/// Points sorted along a direction, so that a search compares few of them.
class SortedPoints
{
public:
  SortedPoints(const ExportMesh& mesh, const std::vector<int>& points)
    : Mesh(mesh)
  {
    for (const int point : points)
    {
      this->Sorted.emplace_back(KeyOf(mesh.points[Index(point)]), point);
    }
    std::sort(this->Sorted.begin(), this->Sorted.end());
  }

  /// Returns the nearest point within a distance, −1 if there is none.
  int Find(const Eigen::Vector3d& place, double reach) const
  {
    int nearest = -1;
    double distance = reach;
    const double key = KeyOf(place);
    for (auto at =
           std::lower_bound(this->Sorted.begin(), this->Sorted.end(), std::pair(key - reach, -1));
         at != this->Sorted.end() && at->first <= key + reach; ++at)
    {
      const double next = (this->Mesh.points[Index(at->second)] - place).norm();
      if (next <= distance)
      {
        distance = next;
        nearest = at->second;
      }
    }
    return nearest;
  }

private:
  /// Coordinate along a unit vector that is not parallel to the lines of usual meshes.
  static double KeyOf(const Eigen::Vector3d& place)
  {
    return place.dot(Eigen::Vector3d(0.6113, 0.5527, 0.5666).normalized());
  }

  const ExportMesh& Mesh;
  std::vector<std::pair<double, int>> Sorted;
};
}

std::vector<std::array<int, 2>> PeriodicNodes(const ExportMesh& mesh, const PeriodicPair& pair)
{
  const SideFaces faces = FindSideFaces(mesh);
  const std::vector<int> from = PointsOf(mesh, faces.ofSide[Index(pair.first)]);
  const std::vector<int> to = PointsOf(mesh, faces.ofSide[Index(pair.second)]);
  Eigen::Vector3d low = mesh.points.front();
  Eigen::Vector3d high = low;
  for (const Eigen::Vector3d& point : mesh.points)
  {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double reach = Tolerance * (high - low).norm();
  const SortedPoints sorted(mesh, to);
  const Eigen::Affine3d motion(pair.motion);
  std::vector<std::array<int, 2>> nodes;
  std::set<int> images;
  for (const int point : from)
  {
    const int image = sorted.Find(motion * mesh.points[Index(point)], reach);
    if (image >= 0)
    {
      nodes.push_back({ point, image });
      images.insert(image);
    }
  }
  if (nodes.size() != from.size() || images.size() != to.size())
  {
    throw Error("The periodic sides '" + mesh.sideNames[Index(pair.first)] + "' and '" +
      mesh.sideNames[Index(pair.second)] + "' have " + std::to_string(from.size()) + " and " +
      std::to_string(to.size()) + " nodes, and " + std::to_string(images.size()) +
      " of them match; make the mesh again, or remove the field data PeriodicSides.");
  }
  return nodes;
}
}
