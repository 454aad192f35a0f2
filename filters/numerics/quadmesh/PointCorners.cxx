#include "PointCorners.h"

#include "Index.h"

#include <numeric>

namespace crossfield
{
PointCorners::PointCorners(const QuadMesh& mesh)
  : First(mesh.points.size() + 1, 0)
  , Corners(4 * mesh.quads.size())
{
  for (const std::array<int, 4>& quad : mesh.quads)
  {
    for (const int p : quad)
    {
      ++this->First[Index(p) + 1];
    }
  }
  std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
  std::vector<int> next(this->First.begin(), this->First.end() - 1);
  for (int corner = 0; corner < static_cast<int>(this->Corners.size()); ++corner)
  {
    const int p = mesh.quads[corner / 4][corner % 4];
    this->Corners[next[p]++] = corner;
  }
}
}
