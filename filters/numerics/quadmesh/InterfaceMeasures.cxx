#include "InterfaceMeasures.h"

#include "Index.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace crossfield
{
std::vector<InterfaceMeasure> MeasureInterfaces(const QuadMesh& mesh)
{
  std::map<std::pair<int, int>, int> sideOf;
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    if (edge.kind == BoundaryKind::Interface)
    {
      sideOf[std::minmax(edge.points[0], edge.points[1])] = edge.side;
    }
  }
  if (sideOf.empty())
  {
    return {};
  }
  const auto areaOf = [&mesh](int quad)
  {
    const auto at = [&](std::size_t corner) -> const SpacePoint&
    { return mesh.points[Index(mesh.quads[Index(quad)][corner])].place; };
    return 0.5 * (at(2) - at(0)).cross(at(3) - at(1)).norm();
  };
  std::map<int, std::vector<double>> ratios;
  const std::vector<int> twins = mesh.Twins();
  for (int side = 0; side < static_cast<int>(twins.size()); ++side)
  {
    const int twin = twins[Index(side)];
    const std::array<int, 4>& quad = mesh.quads[Index(side / 4)];
    const auto found = sideOf.find(std::minmax(quad[Index(side % 4)], quad[Index((side + 1) % 4)]));
    if (side < twin && found != sideOf.end())
    {
      const double one = areaOf(side / 4);
      const double two = areaOf(twin / 4);
      ratios[found->second].push_back(std::max(one, two) / std::min(one, two));
    }
  }
  std::vector<InterfaceMeasure> measures;
  for (auto& [side, all] : ratios)
  {
    std::sort(all.begin(), all.end());
    const double median = 0.5 * (all[(all.size() - 1) / 2] + all[all.size() / 2]);
    measures.push_back({ side < 0 ? std::string() : mesh.sideNames[Index(side)],
      static_cast<int>(all.size()), all.back(), median });
  }
  return measures;
}
}
