#include "CoarseQuads.h"

#include "Index.h"
#include "NodePairs.h"
#include "QuadEnergy.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// Returns the index of a point or cell of a lattice with `row` of them per row.
std::size_t At(int i, int j, int row)
{
  return Index(j) * Index(row) + Index(i);
}

/// Position of a grid line of the finer mesh between two lines of the coarser one: the index of the
/// coarse line before it, and the fraction of the distance to the next one.
struct LinePlace
{
  int before;
  double fraction;
};

std::vector<LinePlace> PlacesBetween(const std::vector<int>& kept)
{
  std::vector<LinePlace> places;
  for (std::size_t k = 1; k < kept.size(); ++k)
  {
    for (int line = kept[k - 1]; line < kept[k]; ++line)
    {
      places.push_back({ static_cast<int>(k) - 1,
        static_cast<double>(line - kept[k - 1]) / (kept[k] - kept[k - 1]) });
    }
  }
  places.push_back({ static_cast<int>(kept.size()) - 2, 1.0 });
  return places;
}
}

std::vector<int> KeptLines(int count)
{
  // Coarser blocks would not resolve the curvature of their sides.
  constexpr int Few = 8;
  std::vector<int> kept;
  if (count < Few)
  {
    for (int line = 0; line <= count; ++line)
    {
      kept.push_back(line);
    }
    return kept;
  }
  // Steps of two from both ends; the step in the middle is 1, 2 or 3.
  for (int line = 0; 2 * line <= count; line += 2)
  {
    kept.push_back(line);
  }
  for (std::size_t k = kept.size(); k-- > 0;)
  {
    if (count - kept[k] > kept.back())
    {
      kept.push_back(count - kept[k]);
    }
  }
  return kept;
}

std::vector<QuadLattice> LatticesOf(const QuadMesh& mesh, const QuadBlocks& blocks)
{
  std::vector<QuadLattice> lattices;
  lattices.reserve(blocks.blocks.size());
  for (const QuadBlock& block : blocks.blocks)
  {
    const std::size_t cells = Index(block.width) * Index(block.height);
    lattices.push_back({ block.width, block.height, block.points,
      std::vector<std::array<double, 2>>(cells), std::vector<double>(cells, 1.0) });
  }
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    QuadLattice& lattice = lattices[blocks.block[q]];
    const int i = blocks.i[q];
    const int j = blocks.j[q];
    const int corner = lattice.points[At(i, j, lattice.width + 1)];
    const auto& points = mesh.quads[q];
    const auto side =
      static_cast<std::size_t>(std::find(points.begin(), points.end(), corner) - points.begin());
    lattice.targetLengths[At(i, j, lattice.width)] = { mesh.targetLengths[q][side % 2],
      mesh.targetLengths[q][(side + 1) % 2] };
  }
  return lattices;
}

CoarseQuads::CoarseQuads(const QuadMesh& fineMesh, const std::vector<QuadLattice>& fineLattices)
  : Fine(fineMesh)
  , FineLattices(fineLattices)
{
  std::vector<int> number(fineMesh.points.size(), -1);
  for (const QuadLattice& from : fineLattices)
  {
    const std::vector<int> columns = KeptLines(from.width);
    const std::vector<int> rows = KeptLines(from.height);
    QuadLattice to;
    to.width = static_cast<int>(columns.size()) - 1;
    to.height = static_cast<int>(rows.size()) - 1;
    for (const int j : rows)
    {
      for (const int i : columns)
      {
        const int point = from.points[At(i, j, from.width + 1)];
        int& mine = number[point];
        if (mine < 0)
        {
          mine = static_cast<int>(this->mesh.points.size());
          this->mesh.points.push_back(fineMesh.points[point]);
        }
        to.points.push_back(mine);
      }
    }
    for (std::size_t j = 1; j < rows.size(); ++j)
    {
      for (std::size_t i = 1; i < columns.size(); ++i)
      {
        // Lengths along i: the mean over the rows of the sum along each row. Along j: the same for
        // columns.
        std::array<double, 2> lengths{};
        double weight = 0.0;
        for (int y = rows[j - 1]; y < rows[j]; ++y)
        {
          for (int x = columns[i - 1]; x < columns[i]; ++x)
          {
            const std::array<double, 2>& cell = from.targetLengths[At(x, y, from.width)];
            weight += from.weights[At(x, y, from.width)];
            lengths[0] += cell[0] / (rows[j] - rows[j - 1]);
            lengths[1] += cell[1] / (columns[i] - columns[i - 1]);
          }
        }
        to.targetLengths.push_back(lengths);
        to.weights.push_back(weight);
        const auto point = [&](std::size_t k, std::size_t l)
        { return to.points[l * columns.size() + k]; };
        this->mesh.quads.push_back(
          { point(i - 1, j - 1), point(i, j - 1), point(i, j), point(i - 1, j) });
        this->mesh.targetLengths.push_back(lengths);
        this->weights.push_back(weight);
      }
    }
    this->lattices.push_back(std::move(to));
  }
  // Blocks beside two periodic sides may keep different points of them.
  for (const int single : CopyPairs(fineMesh, number, this->mesh))
  {
    this->mesh.points[single].fixed = true;
  }
}

template <typename Function>
void CoarseQuads::ForEachLink(const Function& function) const
{
  std::vector<bool> done(this->Fine.points.size(), false);
  for (std::size_t b = 0; b < this->FineLattices.size(); ++b)
  {
    const QuadLattice& to = this->FineLattices[b];
    const QuadLattice& from = this->lattices[b];
    const std::vector<LinePlace> columns = PlacesBetween(KeptLines(to.width));
    const std::vector<LinePlace> rows = PlacesBetween(KeptLines(to.height));
    for (int j = 0; j <= to.height; ++j)
    {
      for (int i = 0; i <= to.width; ++i)
      {
        const int point = to.points[At(i, j, to.width + 1)];
        if (done[point])
        {
          continue;
        }
        done[point] = true;
        const LinePlace& x = columns[i];
        const LinePlace& y = rows[j];
        const std::size_t corner = At(x.before, y.before, from.width + 1);
        const std::size_t above = corner + Index(from.width + 1);
        function(Link{ point,
          { from.points[corner], from.points[corner + 1], from.points[above],
            from.points[above + 1] },
          { (1.0 - x.fraction) * (1.0 - y.fraction), x.fraction * (1.0 - y.fraction),
            (1.0 - x.fraction) * y.fraction, x.fraction * y.fraction } });
      }
    }
  }
}

std::vector<SpacePoint> CoarseQuads::Tangents(const BoundaryCurves& curves) const
{
  std::vector<SpacePoint> tangents(this->mesh.points.size(), SpacePoint::Zero());
  for (std::size_t p = 0; p < tangents.size(); ++p)
  {
    const CurvePlace& curve = this->mesh.points[p].curve;
    if (curve.loop >= 0)
    {
      tangents[p] = curves.DirectionAt(curve);
    }
  }
  return tangents;
}

Eigen::VectorXd CoarseQuads::Prolong(const BoundaryCurves& curves, const TangentFrames& fineFrames,
  const TangentFrames& frames, const Eigen::VectorXd& moves) const
{
  const std::vector<SpacePoint> tangents = this->Tangents(curves);
  Eigen::VectorXd result =
    Eigen::VectorXd::Zero(FirstUnknown(static_cast<int>(this->Fine.points.size())));
  this->ForEachLink(
    [&](const Link& link)
    {
      auto sum = result.segment<2>(FirstUnknown(link.fine));
      const bool inside = this->Fine.points[link.fine].curve.loop < 0;
      SpacePoint inSpace = SpacePoint::Zero();
      for (std::size_t k = 0; k < 4; ++k)
      {
        const int p = link.coarse[k];
        const Point move = moves.segment<2>(FirstUnknown(p));
        if (!inside)
        {
          sum += link.parts[k] * move;
        }
        else if (this->mesh.points[p].curve.loop >= 0)
        {
          inSpace += link.parts[k] * (move.x() * tangents[p]);
        }
        else
        {
          inSpace += link.parts[k] * frames.VectorOf(p, move);
        }
      }
      if (inside)
      {
        sum = fineFrames.ComponentsOf(link.fine, inSpace);
      }
    });
  return result;
}

Eigen::VectorXd CoarseQuads::Interpolate(const BoundaryCurves& curves,
  const TangentFrames& fineFrames, const TangentFrames& frames, const Eigen::VectorXd& moves) const
{
  Eigen::VectorXd result = this->Prolong(curves, fineFrames, frames, moves);
  this->ForEachLink(
    [&](const Link& link)
    {
      const QuadPoint& point = this->Fine.points[link.fine];
      if (point.curve.loop >= 0)
      {
        return;
      }
      SpacePoint displacement = -point.place;
      for (std::size_t k = 0; k < 4; ++k)
      {
        displacement += link.parts[k] * this->mesh.points[link.coarse[k]].place;
      }
      result.segment<2>(FirstUnknown(link.fine)) = fineFrames.ComponentsOf(link.fine, displacement);
    });
  return result;
}

Eigen::VectorXd CoarseQuads::Restrict(const BoundaryCurves& curves, const TangentFrames& fineFrames,
  const TangentFrames& frames, const Eigen::VectorXd& gradient) const
{
  const std::vector<SpacePoint> tangents = this->Tangents(curves);
  Eigen::VectorXd result =
    Eigen::VectorXd::Zero(FirstUnknown(static_cast<int>(this->mesh.points.size())));
  this->ForEachLink(
    [&](const Link& link)
    {
      const bool inside = this->Fine.points[link.fine].curve.loop < 0;
      const Point part = gradient.segment<2>(FirstUnknown(link.fine));
      const SpacePoint inSpace = fineFrames.VectorOf(link.fine, part);
      for (std::size_t k = 0; k < 4; ++k)
      {
        const int p = link.coarse[k];
        const bool onBoundary = this->mesh.points[p].curve.loop >= 0;
        result.segment<2>(FirstUnknown(p)) += link.parts[k] *
          (!inside         ? part
              : onBoundary ? Point(inSpace.dot(tangents[p]), 0.0)
                           : frames.ComponentsOf(p, inSpace));
      }
    });
  return result;
}
}
