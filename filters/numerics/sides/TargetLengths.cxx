#include "TargetLengths.h"

namespace crossfield
{
std::vector<double> TargetLengths(const TMesh& mesh, const TargetSizes& sizes)
{
  std::vector<double> lengths;
  lengths.reserve(mesh.arcs.size());
  for (const TArc& arc : mesh.arcs)
  {
    double length = sizes.sizing == Sizing::Conformal ? arc.length : 0.0;
    // Segments are as short as the triangles that they cross, so the midpoint rule is accurate
    // enough.
    for (std::size_t i = 1; sizes.sizing != Sizing::Conformal && i < arc.polyline.size(); ++i)
    {
      const Point from = arc.polyline[i - 1].head<2>();
      const Point to = arc.polyline[i].head<2>();
      length += (to - from).norm() / sizes.At(0.5 * (from + to));
    }
    lengths.push_back(length);
  }
  return lengths;
}

double AreaOf(const TMesh& mesh)
{
  double area = 0.0;
  for (const TPatch& patch : mesh.patches)
  {
    area += mesh.SideLength(patch, 0) * mesh.SideLength(patch, 1);
  }
  return area;
}
}
