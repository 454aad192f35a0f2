#include "StripGrading.h"

#include <cmath>
#include <map>

namespace crossfield
{
namespace
{
/// Multiplies the target lengths in the strips of graded boundary edges.
class StripGrading
{
public:
  explicit StripGrading(QuadMesh& mesh)
    : Mesh(mesh)
    , Twins(mesh.Twins())
  {
    for (std::size_t side = 0; side < this->Twins.size(); ++side)
    {
      if (this->Twins[side] < 0)
      {
        this->SideFrom[mesh.quads[side / 4][side % 4]] = static_cast<int>(side);
      }
    }
  }

  /// Grades the strips of some boundary edges.
  void Grade(const std::vector<const QuadBoundaryEdge*>& edges)
  {
    std::map<int, double> factors;
    for (const QuadBoundaryEdge* edge : edges)
    {
      const int side = this->SideFrom.at(edge->points[0]);
      const double length =
        (this->Mesh.points[edge->points[1]].place - this->Mesh.points[edge->points[0]].place)
          .norm();
      factors[side] = length / this->Target(side);
    }
    for (const auto& [side, factor] : factors)
    {
      const std::vector<int> strip = this->StripFrom(side);
      const int last = strip.back() / 4 * 4 + (strip.back() + 2) % 4;
      const auto other = factors.find(last);
      if (other != factors.end() && other->first < side)
      {
        continue; // graded from its other end
      }
      const double atEnd = other != factors.end()  ? other->second
        : this->LoopOf(last) == this->LoopOf(side) ? factor
                                                   : 1.0;
      for (std::size_t i = 0; i < strip.size(); ++i)
      {
        const double part =
          strip.size() > 1 ? static_cast<double>(i) / static_cast<double>(strip.size() - 1) : 0.5;
        this->Target(strip[i]) *= std::pow(factor, 1.0 - part) * std::pow(atEnd, part);
      }
    }
  }

private:
  double& Target(int side) { return this->Mesh.targetLengths[side / 4][side % 2]; }

  /// Returns the loop of a side on the boundary.
  int LoopOf(int side) const
  {
    return this->Mesh.points[this->Mesh.quads[side / 4][side % 4]].curve.loop;
  }

  /// Returns the sides at which a strip enters its quads, from a boundary side on.
  std::vector<int> StripFrom(int side) const
  {
    std::vector<int> strip;
    while (side >= 0)
    {
      strip.push_back(side);
      side = this->Twins[side / 4 * 4 + (side + 2) % 4];
    }
    return strip;
  }

  QuadMesh& Mesh;
  const std::vector<int> Twins;
  std::map<int, int> SideFrom; ///< Boundary side of a quad that starts at a point.
};
}

void GradeStrips(const std::vector<const QuadBoundaryEdge*>& edges, QuadMesh& mesh)
{
  StripGrading(mesh).Grade(edges);
}
}
