#include "MeshNumbering.h"

#include "Index.h"

namespace crossfield
{
MeshNumbering NumberNodes(const ExportMesh& mesh, const std::vector<int>& positions, int first)
{
  MeshNumbering result;
  std::vector<bool> isUsed(mesh.points.size(), false);
  for (int cell = 0; cell < mesh.CellCount(); ++cell)
  {
    const int* nodes = mesh.Cell(cell);
    for (const int position : positions)
    {
      isUsed[Index(nodes[position])] = true;
    }
  }
  result.number.resize(mesh.points.size(), -1);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    if (isUsed[i])
    {
      result.number[i] = first + static_cast<int>(result.point.size());
      result.point.push_back(static_cast<int>(i));
    }
  }
  return result;
}
}
