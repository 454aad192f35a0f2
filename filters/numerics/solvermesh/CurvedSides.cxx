#include "CurvedSides.h"

#include "CellLattice.h"
#include "CurvedLoops.h"
#include "RigidMotion.h"
#include "SidePairs.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>

namespace crossfield
{
namespace
{
/// The boundary side whose image another one is.
struct Master
{
  int side = 0;
  RigidMotion motion; ///< Takes it to its image.
};

/// Returns the motion of a plane that a motion of space is in it.
RigidMotion InPlane(const Eigen::Matrix4d& matrix, const DomainPlane& plane)
{
  const auto image = [&](const Point& point)
  { return plane.ToPlane(Eigen::Affine3d(matrix) * plane.ToSpace(point)); };
  const Point origin = image(Point::Zero());
  const Point along = image(Point::UnitX()) - origin;
  return { std::atan2(along.y(), along.x()), origin };
}

/// Returns the masters of the sides on the second side of a periodic pair.
std::map<int, Master> FindMasters(
  const SolverMesh& quads, const MeshFaces& faces, const DomainPlane& plane)
{
  std::map<int, Master> masters;
  for (const SidePair& pair : quads.pairs)
  {
    const PairMatch match = MatchPair(quads, faces, pair);
    const std::vector<CellFace>& first = faces.OfSide(pair.first);
    for (std::size_t i = 0; i < first.size(); ++i)
    {
      const CellFace& image = faces.OfSide(pair.second)[match.faces[i]];
      masters[static_cast<int>(faces.NumberOf(image))] = {
        static_cast<int>(faces.NumberOf(first[i])), InPlane(pair.motion, plane)
      };
    }
  }
  return masters;
}

/// Returns a side whose nodes are the points of a curve nearest to equal steps from one end to the other.
CurvedSide SideOn(const CurveEvaluator& curve, int side, const Point& from, const Point& to,
  int order, double& sagitta)
{
  const Point along = to - from;
  const SegmentParameters ends = ParametersOf(curve, from, from + along);
  CurvedSide result;
  result.side = side;
  for (int k = 1; k < order; ++k)
  {
    const double fraction = static_cast<double>(k) / order;
    const Point step = from + fraction * along;
    const Point node =
      curve.At(curve.NearestFrom(step, ends.from + fraction * (ends.to - ends.from)));
    result.nodes.push_back(node);
    result.offsets.push_back(AsComplex(node - step) / AsComplex(along));
    sagitta = std::max(sagitta, (node - step).norm());
  }
  return result;
}
}

EdgeOffsets Reversed(const EdgeOffsets& offsets)
{
  EdgeOffsets result;
  for (auto offset = offsets.rbegin(); offset != offsets.rend(); ++offset)
  {
    result.push_back(-*offset);
  }
  return result;
}

std::vector<CurvedSide> FindCurvedSides(const SolverMesh& quads, const MeshFaces& faces,
  const DomainPlane& plane, int order, std::vector<double>& sagittas)
{
  const std::map<int, Master> masters = FindMasters(quads, faces, plane);
  const CellLattice lattice(2, 1);
  std::vector<std::optional<CurveEvaluator>> evaluators; // none for a line
  for (const PlaneCurve& curve : quads.curves)
  {
    evaluators.emplace_back();
    if (curve.kind != PlaneCurve::Kind::Line)
    {
      evaluators.back().emplace(curve);
    }
  }
  sagittas.assign(quads.curves.size(), 0.0);
  std::vector<CurvedSide> result;
  std::map<int, std::size_t> found; // index in the result by number of the side
  for (std::size_t i = 0; i < quads.curve.size(); ++i)
  {
    const CellFace& face = faces.BoundaryFaces()[i];
    const int side = static_cast<int>(faces.NumberOf(face));
    const int curve = quads.curve[i];
    if (masters.count(side) > 0 || curve < 0 || !evaluators[curve])
    {
      continue;
    }
    const std::vector<int> ends = lattice.Face(face.face);
    const auto place = [&](std::size_t end)
    { return plane.ToPlane(quads.points[quads.Cell(face.cell)[ends[end]]]); };
    found[side] = result.size();
    result.push_back(SideOn(*evaluators[curve], side, place(0), place(1), order, sagittas[curve]));
  }
  for (const CellFace& face : faces.BoundaryFaces())
  {
    const int side = static_cast<int>(faces.NumberOf(face));
    const auto master = masters.find(side);
    const auto original = master == masters.end() ? found.end() : found.find(master->second.side);
    if (original == found.end())
    {
      continue;
    }
    const CurvedSide& first = result[original->second];
    CurvedSide image;
    image.side = side;
    std::transform(first.nodes.rbegin(), first.nodes.rend(), std::back_inserter(image.nodes),
      [&](const Point& node) { return master->second.motion(node); });
    image.offsets = Reversed(first.offsets);
    result.push_back(std::move(image));
  }
  return result;
}
}
