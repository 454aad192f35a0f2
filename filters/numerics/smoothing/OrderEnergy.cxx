#include "OrderEnergy.h"

#include "BoundaryOrder.h"
#include "Index.h"

#include <algorithm>
#include <limits>

namespace crossfield
{
namespace
{
/// Part of a loop up to which an edge is not penalised: that of eight equal edges.
constexpr double Free = 0.125;
}

OrderEnergy::OrderEnergy(const QuadMesh& mesh, const BoundaryCurves& curves,
  const std::vector<bool>& isFixed, const std::vector<bool>& isImage)
{
  const std::vector<int> twins = mesh.Twins();
  for (int side = 0; side < static_cast<int>(twins.size()); ++side)
  {
    const std::size_t q = Index(side / 4);
    const int from = mesh.quads[q][side % 4];
    const int to = mesh.quads[q][(side + 1) % 4];
    const CurvePlace& start = mesh.points[from].curve;
    const CurvePlace& end = mesh.points[to].curve;
    if (twins[side] >= 0 || start.loop < 0 || start.loop != end.loop || isImage[from] ||
      isImage[to]) // in order if the other side is
    {
      continue;
    }
    const double loop = curves.Length(start.loop);
    const double length = LengthAlong(start, end, loop);
    if (!(length > 0.0))
    {
      this->Terms.clear();
      return;
    }
    // The unknowns of fixed points are not lengths.
    const double moving = (isFixed[to] ? 0.0 : end.at) - (isFixed[from] ? 0.0 : start.at);
    this->Terms.push_back({ isFixed[from] ? -1 : FirstUnknown(from),
      isFixed[to] ? -1 : FirstUnknown(to), length - moving, 1.0 / mesh.targetLengths[q][side % 2],
      length < LongestPartOfLoop * loop ? 1.0 / loop : 0.0 });
  }
}

double OrderEnergy::Value(const Eigen::VectorXd& unknowns, Eigen::VectorXd* gradient) const
{
  const auto at = [&unknowns](Eigen::Index unknown)
  { return unknown < 0 ? 0.0 : unknowns[unknown]; };
  double energy = 0.0;
  for (const Term& term : this->Terms)
  {
    const double along = at(term.to) - at(term.from) + term.offset;
    const double length = term.inverse * along;
    const double excess =
      std::max(0.0, (term.inverseLoop * along - Free) / (LongestPartOfLoop - Free));
    if (!(length > 0.0) || !(excess < 1.0))
    {
      return std::numeric_limits<double>::infinity();
    }
    energy += length + 1.0 / length + excess * excess * excess / (1.0 - excess);
    if (gradient != nullptr)
    {
      const double slope = term.inverse * (1.0 - 1.0 / (length * length)) +
        term.inverseLoop / (LongestPartOfLoop - Free) * excess * excess * (3.0 - 2.0 * excess) /
          ((1.0 - excess) * (1.0 - excess));
      if (term.to >= 0)
      {
        (*gradient)[term.to] += slope;
      }
      if (term.from >= 0)
      {
        (*gradient)[term.from] -= slope;
      }
    }
  }
  return energy;
}
}
