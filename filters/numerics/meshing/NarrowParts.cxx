#include "NarrowParts.h"

#include "BoundaryCorners.h"
#include "LoopTurning.h"
#include "Segment.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace crossfield
{
namespace
{
/// Minimum distance along a loop between opposite points, relative to the distance across. Two
/// sides that meet at an angle α have a ratio of 1/sin(α/2), 3.9 at the corner angle, so the sides
/// of a corner bound a narrow part only where the corner is sharper than about 29°.
constexpr double AlongPerAcross = 4.0;

/// Minimum distance along a loop between opposite points with a single corner between them,
/// relative to the edge length there. Towards a sharp corner the scale of a seamless map decreases
/// as a high power of the distance, so triangles that become smaller with the width would be
/// mapped to areas below rounding. Half of the diagonal with the default edge length.
constexpr double AlongPerEdgeAtCorner = 20.0;

/// A segment of the boundary, with the domain on its left.
struct Side
{
  Point from;
  Point to;
  Point inward; ///< Unit normal that points into the domain.
  std::size_t loop = 0;
  double start = 0.0; ///< Arc length of the loop before the segment.
  int corners = 0;    ///< Number of corners of the loop up to the start of the segment.

  Point At(double along) const { return this->from + along * this->Direction(); }
  Point Direction() const { return Point(this->inward.y(), -this->inward.x()); }
  double Length() const { return (this->to - this->from).norm(); }
};

/// The segments of a boundary in a tree of bounding boxes.
class Boundary
{
public:
  explicit Boundary(const PlanarDomain& domain)
  {
    for (std::size_t l = 0; l < domain.loops.size(); ++l)
    {
      const Loop& loop = domain.loops[l];
      double start = 0.0;
      int corners = 0;
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        const Point& to = loop[(i + 1) % loop.size()];
        const Point along = to - loop[i];
        corners += IsCorner(TurningAt(loop, i)) ? 1 : 0;
        this->Sides.push_back({ loop[i], to, TurnedLeft(along).normalized(), l, start, corners });
        start += along.norm();
      }
      this->Lengths.push_back(start);
      this->Corners.push_back(corners);
    }
    this->Order.resize(this->Sides.size());
    std::iota(this->Order.begin(), this->Order.end(), std::size_t(0));
    this->Boxes.resize(4 * this->Sides.size());
    this->Build(1, 0, this->Order.size());
  }

  const std::vector<Side>& GetSides() const { return this->Sides; }

  /// Returns the local width at a distance `along` a segment, or `bound` if it is not below that.
  /// `size` is the edge length there.
  double WidthAt(const Side& side, double along, double size, double bound) const
  {
    const Query query{ side, side.At(along), side.start + along, size };
    this->Visit(1, 0, this->Order.size(), query, bound);
    return bound;
  }

private:
  struct Query
  {
    const Side& side;
    Point place;
    double at;   ///< Arc length from the start of the loop.
    double size; ///< Edge length.
  };

  std::vector<Side> Sides;
  std::vector<double> Lengths; ///< Length of every loop.
  std::vector<int> Corners;    ///< Number of corners of every loop.
  std::vector<std::size_t> Order;
  std::vector<Eigen::AlignedBox2d> Boxes; ///< Node n has the children 2 n and 2 n + 1.

  void Build(std::size_t node, std::size_t begin, std::size_t end)
  {
    Eigen::AlignedBox2d box;
    for (std::size_t i = begin; i < end; ++i)
    {
      box.extend(this->Sides[this->Order[i]].from);
      box.extend(this->Sides[this->Order[i]].to);
    }
    this->Boxes[node] = box;
    if (end - begin <= 1)
    {
      return;
    }
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t middle = (begin + end) / 2;
    const auto at = [this](std::size_t i)
    { return this->Order.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto key = [&](std::size_t i)
    { return std::make_pair(this->Sides[i].from[axis] + this->Sides[i].to[axis], i); };
    std::nth_element(at(begin), at(middle), at(end),
      [&key](std::size_t a, std::size_t b) { return key(a) < key(b); });
    this->Build(2 * node, begin, middle);
    this->Build(2 * node + 1, middle, end);
  }

  /// Lowers `nearest` to the distance of opposite sides in a part of the tree.
  void Visit(
    std::size_t node, std::size_t begin, std::size_t end, const Query& query, double& nearest) const
  {
    if (this->Boxes[node].exteriorDistance(query.place) >= nearest)
    {
      return;
    }
    if (end - begin == 1)
    {
      nearest =
        std::min(nearest, this->DistanceTo(this->Sides[this->Order[begin]], query, nearest));
      return;
    }
    const std::size_t middle = (begin + end) / 2;
    this->Visit(2 * node, begin, middle, query, nearest);
    this->Visit(2 * node + 1, middle, end, query, nearest);
  }

  /// Returns the distance to the nearest point of a segment, or `bound` if it is not opposite.
  double DistanceTo(const Side& side, const Query& query, double bound) const
  {
    const double along = NearestFraction(query.place, side.from, side.to) * side.Length();
    const Point across = side.At(along) - query.place;
    const double distance = across.norm();
    // Opposite sides face each other, within 60° of the normal where the width is measured.
    if (distance >= bound || across.dot(query.side.inward) <= 0.5 * distance ||
      across.dot(side.inward) > 0.0)
    {
      return bound;
    }
    return side.loop == query.side.loop && this->IsAtSameEnd(side, along, distance, query)
      ? bound
      : distance;
  }

  /// Returns whether two points of a loop are near each other along it: around an end of the domain
  /// or at a sharp corner.
  bool IsAtSameEnd(const Side& side, double along, double distance, const Query& query) const
  {
    double apart = std::abs(side.start + along - query.at);
    int corners = std::abs(side.corners - query.side.corners);
    if (2.0 * apart > this->Lengths[side.loop])
    {
      apart = this->Lengths[side.loop] - apart;
      corners = this->Corners[side.loop] - corners;
    }
    return apart < AlongPerAcross * distance ||
      (corners == 1 && apart < AlongPerEdgeAtCorner * query.size);
  }
};

/// Places sources along segments by bisection.
class Sampling
{
public:
  Sampling(const Boundary& boundary, const SizeField& size, double edgesAcross, double smallest)
    : Sides(boundary)
    , Size(size)
    , EdgesAcross(edgesAcross)
    , Smallest(smallest)
  {
  }

  void Add(const Side& side) { this->Add(side, 0.0, side.Length()); }

  std::vector<SizeSource> TakeSources() { return std::move(this->Sources); }

private:
  void Add(const Side& side, double from, double to)
  {
    const double middle = 0.5 * (from + to);
    const Point place = side.At(middle);
    const double size = this->Size(place);
    // Widths change by at most the distance along the boundary, and so does the size.
    const double half = 0.5 * (to - from);
    const double bound = this->EdgesAcross * (size + half) + half;
    const double width = this->Sides.WidthAt(side, middle, size, bound);
    if (width == bound)
    {
      return;
    }
    const double required = std::max(width / this->EdgesAcross, this->Smallest);
    if (to - from > std::max(width, this->Smallest))
    {
      this->Add(side, from, middle);
      this->Add(side, middle, to);
    }
    else if (required < size)
    {
      this->Sources.push_back({ place, required });
    }
  }

  const Boundary& Sides;
  const SizeField& Size;
  double EdgesAcross;
  double Smallest;
  std::vector<SizeSource> Sources;
};
}

//------------------------------------------------------------------------------
std::vector<SizeSource> FindNarrowParts(
  const PlanarDomain& domain, const SizeField& size, double edgesAcross, double smallest)
{
  const Boundary boundary(domain);
  Sampling sampling(boundary, size, edgesAcross, smallest);
  for (const Side& side : boundary.GetSides())
  {
    sampling.Add(side);
  }
  return sampling.TakeSources();
}
}
