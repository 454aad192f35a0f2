#include "PrescribedSides.h"

#include "Error.h"
#include "Index.h"
#include "QuadSides.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>
#include <utility>

namespace crossfield
{
namespace
{
std::string Quoted(const std::string& name)
{
  return "'" + name + "'";
}

std::string Number(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

void RequireInRange(const std::string& name, const SidePrescription& prescribed)
{
  const Progression& progression = prescribed.progression;
  const auto isPositive = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (prescribed.count < 0)
  {
    throw Error("The number of edges of side " + Quoted(name) + " is " +
      std::to_string(prescribed.count) + "; give a positive number.");
  }
  if (prescribed.size != 0.0 && !isPositive(prescribed.size))
  {
    throw Error("The size at side " + Quoted(name) + " is not a positive number; correct it.");
  }
  if (!prescribed.isGraded)
  {
    return;
  }
  if (!isPositive(progression.ratio) || progression.first < 0.0 || progression.last < 0.0 ||
    (progression.first > 0.0) != (progression.last > 0.0) || !std::isfinite(progression.first) ||
    !std::isfinite(progression.last))
  {
    throw Error("The progression of side " + Quoted(name) +
      " is not positive; give a positive ratio of the last edge to the first, or both lengths.");
  }
}

/// Chains of boundary arcs on one side.
class SideArcs
{
public:
  SideArcs(const SeamlessMap& map, const BoundaryCurves& curves, const BoundarySides& sides,
    const TMesh& mesh)
    : Mesh(mesh)
  {
    const SidesAlong along(sides, curves.GetArcs());
    for (int arc = 0; arc < static_cast<int>(mesh.arcs.size()); ++arc)
    {
      if (mesh.arcs[Index(arc)].onBoundary)
      {
        const CurvePlace middle = Middle(map, curves, mesh.arcs[Index(arc)]);
        this->SideOf[arc] = along.At(Index(middle.loop), middle.at);
        this->From[mesh.halfEdges[Index(2 * arc)].node] = arc;
      }
    }
  }

  /// Returns the arcs of a side.
  std::vector<int> Of(int side) const
  {
    std::vector<int> arcs;
    for (const auto& [arc, its] : this->SideOf)
    {
      if (its == side)
      {
        arcs.push_back(arc);
      }
    }
    return arcs;
  }

  /// Returns the arcs of a side in parts between corners or ends; a closed curve without them is one
  /// part.
  std::vector<std::vector<int>> PartsOf(int side) const
  {
    std::vector<std::vector<int>> parts;
    std::vector<int> remaining = this->Of(side);
    for (const bool distinct : { true, false })
    {
      for (const int first : this->Of(side))
      {
        const int start = this->Mesh.halfEdges[Index(2 * first)].node;
        const bool isLeft = std::find(remaining.begin(), remaining.end(), first) != remaining.end();
        if (isLeft && (!distinct || this->Mesh.nodes[Index(start)].IsDistinct()))
        {
          parts.push_back(this->Follow(first, remaining));
        }
      }
    }
    return parts;
  }

  double LengthOf(const std::vector<int>& arcs) const
  {
    double length = 0.0;
    for (const int arc : arcs)
    {
      const std::vector<Point>& line = this->Mesh.arcs[Index(arc)].polyline;
      for (std::size_t i = 1; i < line.size(); ++i)
      {
        length += (line[i] - line[i - 1]).norm();
      }
    }
    return length;
  }

private:
  static CurvePlace Middle(const SeamlessMap& map, const BoundaryCurves& curves, const TArc& arc)
  {
    double remaining = 0.5 * arc.length;
    const ChartPiece* at = &arc.pieces.front();
    for (const ChartPiece& piece : arc.pieces)
    {
      at = &piece;
      const double length = (piece.to - piece.from).norm();
      if (remaining <= length)
      {
        break;
      }
      remaining -= length;
    }
    const MeshTopology& topology = *map.topology;
    const auto& sides = topology.edges.ofTriangle[Index(at->triangle)];
    const auto side = static_cast<int>(
      std::find(sides.begin(), sides.end(), topology.EdgeOfBoundary(at->position)) - sides.begin());
    const Point& from = map.At(at->triangle, side);
    const double length = (map.At(at->triangle, (side + 1) % 3) - from).norm();
    const double fraction = (0.5 * (at->from + at->to) - from).norm() / length;
    return curves.Place(at->position, std::clamp(fraction, 0.0, 1.0));
  }

  /// Removes arcs from `remaining`, from a first one up to the next distinct node, and returns them.
  std::vector<int> Follow(int arc, std::vector<int>& remaining) const
  {
    std::vector<int> part;
    auto found = std::find(remaining.begin(), remaining.end(), arc);
    while (found != remaining.end())
    {
      remaining.erase(found);
      part.push_back(arc);
      const int end = this->Mesh.halfEdges[Index(2 * arc + 1)].node;
      if (this->Mesh.nodes[Index(end)].IsDistinct())
      {
        break;
      }
      arc = this->From.at(end);
      found = std::find(remaining.begin(), remaining.end(), arc);
    }
    return part;
  }

  const TMesh& Mesh;
  std::map<int, int> SideOf; ///< Per arc on the boundary.
  std::map<int, int> From;   ///< Boundary arc that starts at a node.
};

/// Throws Error unless a first and a last edge fit on a part of a side.
void RequireRoom(const std::string& name, const Progression& progression, double length)
{
  const double available = progression.both ? 0.5 * length : length;
  if (progression.first + progression.last > available)
  {
    throw Error("Edges of lengths " + Number(progression.first) + " and " +
      Number(progression.last) + " do not fit on side " + Quoted(name) +
      ", which has a part of length " + Number(length) +
      (progression.both ? " for both ends" : "") + "; give smaller lengths.");
  }
}

/// Returns the range of counts with which all edges of a part have a size within the tolerance.
std::pair<int, int> RangeFor(double length, double size)
{
  const auto least = static_cast<int>(std::ceil(length / ((1.0 + SizeTolerance) * size)));
  const auto most = static_cast<int>(std::floor(length / ((1.0 - SizeTolerance) * size)));
  const int nearest = std::max(1, static_cast<int>(std::lround(length / size)));
  return least <= most && most > 0 ? std::pair(std::max(1, least), most)
                                   : std::pair(nearest, nearest);
}

/// Returns the sum of the counts of arcs, within bounds.
CountSum SumOf(const std::vector<int>& arcs, int minimum, int maximum, std::string name)
{
  CountSum sum;
  for (const int arc : arcs)
  {
    sum.terms.emplace_back(arc, 1);
  }
  sum.minimum = minimum;
  sum.maximum = maximum;
  sum.name = std::move(name);
  return sum;
}

/// Divides chains of points at those that are fixed. A closed chain without fixed points is one part.
std::vector<std::vector<int>> PartsBetweenFixed(
  const QuadMesh& mesh, const std::vector<std::vector<int>>& pieces)
{
  const auto isFixed = [&mesh](int point) { return mesh.points[Index(point)].fixed; };
  std::vector<std::vector<int>> parts;
  for (std::vector<int> piece : pieces)
  {
    const bool isClosed = piece.front() == piece.back();
    const auto start = std::find_if(piece.begin(), piece.end(), isFixed);
    if (isClosed && start != piece.end())
    {
      piece.pop_back();
      std::rotate(piece.begin(), start, piece.end());
      piece.push_back(piece.front());
    }
    parts.push_back({ piece.front() });
    for (std::size_t i = 1; i < piece.size(); ++i)
    {
      parts.back().push_back(piece[i]);
      if (isFixed(piece[i]) && i + 1 < piece.size())
      {
        parts.push_back({ piece[i] });
      }
    }
  }
  return parts;
}

/// Places the points of one part of a side.
void PlacePart(const BoundaryCurves& curves, const std::vector<int>& part,
  const Progression& progression, QuadMesh& mesh)
{
  const auto count = static_cast<int>(part.size()) - 1;
  const CurvePlace start = mesh.points[Index(part.front())].curve;
  const double loop = curves.Length(start.loop);
  const auto forwards = [loop](double length) { return length - loop * std::floor(length / loop); };
  const bool isClosed = part.front() == part.back();
  const double length =
    isClosed ? loop : forwards(mesh.points[Index(part.back())].curve.at - start.at);
  const std::vector<double> places = DivideLength(length, count, progression);
  // a closed curve has no end: its points are rotated to where they are on average
  double shift = 0.0;
  if (isClosed && !mesh.points[Index(part.front())].fixed)
  {
    for (int i = 1; i < count; ++i)
    {
      shift +=
        (forwards(mesh.points[Index(part[Index(i)])].curve.at - start.at) - places[Index(i)]) /
        count;
    }
  }
  for (int i = 0; i < count; ++i)
  {
    QuadPoint& point = mesh.points[Index(part[Index(i)])];
    if (!point.fixed)
    {
      point.curve.at = start.at + shift + places[Index(i)];
      point.curve.at -= loop * std::floor(point.curve.at / loop);
      point.place = curves.At(point.curve);
      point.fixed = true;
    }
  }
}

/// Moves the points inside along with points of the boundary that were moved: displacements are
/// harmonic on the graph of edges, so that quads stay positive where they can.
void MoveInside(const std::vector<QuadPoint>& before, QuadMesh& mesh)
{
  const std::size_t count = mesh.points.size();
  std::vector<Eigen::Index> unknown(count, -1);
  Eigen::Index unknowns = 0;
  for (std::size_t p = 0; p < count; ++p)
  {
    if (mesh.points[p].curve.loop < 0)
    {
      unknown[p] = unknowns++;
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(unknowns, 2);
  for (const std::array<int, 4>& quad : mesh.quads)
  {
    for (std::size_t side = 0; side < 4; ++side)
    {
      // every inner edge has two quads, which add one half-edge each
      for (const auto& [from, to] : { std::pair(quad[side], quad[(side + 1) % 4]),
             std::pair(quad[(side + 1) % 4], quad[side]) })
      {
        const Eigen::Index row = unknown[Index(from)];
        if (row < 0)
        {
          continue;
        }
        entries.emplace_back(row, row, 1.0);
        if (unknown[Index(to)] >= 0)
        {
          entries.emplace_back(row, unknown[Index(to)], -1.0);
        }
        else
        {
          right.row(row) += (mesh.points[Index(to)].place - before[Index(to)].place).transpose();
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(matrix);
  solver.setTolerance(1e-4); // only a start for the smoothing
  const Eigen::MatrixX2d moves = solver.solve(right);
  for (std::size_t p = 0; p < count; ++p)
  {
    if (unknown[p] >= 0)
    {
      mesh.points[p].place += moves.row(unknown[p]).transpose();
    }
  }
}

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
      const double length = (this->Mesh.points[Index(edge->points[1])].place -
        this->Mesh.points[Index(edge->points[0])].place)
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
  double& Target(int side) { return this->Mesh.targetLengths[Index(side / 4)][Index(side % 2)]; }

  /// Returns the loop of a side on the boundary.
  int LoopOf(int side) const
  {
    return this->Mesh.points[Index(this->Mesh.quads[Index(side / 4)][Index(side % 4)])].curve.loop;
  }

  /// Returns the sides at which a strip enters its quads, from a boundary side on.
  std::vector<int> StripFrom(int side) const
  {
    std::vector<int> strip;
    while (side >= 0)
    {
      strip.push_back(side);
      side = this->Twins[Index(side / 4 * 4 + (side + 2) % 4)];
    }
    return strip;
  }

  QuadMesh& Mesh;
  const std::vector<int> Twins;
  std::map<int, int> SideFrom; ///< Boundary side of a quad that starts at a point.
};
}

void RequireConsistent(const BoundarySides& sides, const std::vector<LoopArc>& loops,
  const SidePrescriptions& prescribed)
{
  const SidesAlong along(sides, loops);
  for (const SidePrescription& one : prescribed)
  {
    const std::string& name = sides.names[Index(one.side)];
    RequireInRange(name, one);
    const bool hasLengths = one.isGraded && one.progression.HasLengths();
    if ((one.count > 0 ? 1 : 0) + (hasLengths ? 1 : 0) + (one.size > 0.0 ? 1 : 0) > 1 ||
      (one.isGraded && one.size > 0.0))
    {
      throw Error("Side " + Quoted(name) + " has more than one of a size, a number of edges and " +
        "lengths of edges, or a size and a progression; leave all but one out.");
    }
    for (std::size_t loop = 0; one.isGraded && loop < loops.size(); ++loop)
    {
      const std::vector<LoopSide>& starts = along.On(loop);
      if (starts.size() == 1 && starts[0].side == one.side &&
        loops[loop].Corners(DefaultCornerAngle).empty())
      {
        throw Error("Side " + Quoted(name) +
          " is a closed curve without a first and a last edge for a progression; divide it into "
          "sides with different names.");
      }
    }
  }
}

std::vector<CountSum> PrescribedSums(const SeamlessMap& map, const BoundaryCurves& curves,
  const BoundarySides& sides, const SidePrescriptions& prescribed, const TMesh& mesh)
{
  std::vector<CountSum> sums;
  if (prescribed.empty())
  {
    return sums;
  }
  const SideArcs arcs(map, curves, sides, mesh);
  for (const SidePrescription& one : prescribed)
  {
    const std::string& name = sides.names[Index(one.side)];
    if (one.count > 0)
    {
      sums.push_back(
        SumOf(arcs.Of(one.side), one.count, one.count, name + ":" + std::to_string(one.count)));
    }
    const bool hasLengths = one.isGraded && one.progression.HasLengths();
    if (one.size <= 0.0 && !hasLengths)
    {
      continue;
    }
    for (const std::vector<int>& part : arcs.PartsOf(one.side))
    {
      const double length = arcs.LengthOf(part);
      if (hasLengths)
      {
        RequireRoom(name, one.progression, length);
        const int count = CountForLengths(length, one.progression);
        sums.push_back(SumOf(part, count, count,
          "the lengths " + Number(one.progression.first) + "," + Number(one.progression.last) +
            " on " + name));
      }
      else
      {
        const auto [minimum, maximum] = RangeFor(length, one.size);
        sums.push_back(
          SumOf(part, minimum, maximum, "the size " + Number(one.size) + " at " + name));
      }
    }
  }
  return sums;
}

GradedArcs::GradedArcs(const SeamlessMap& map, const BoundaryCurves& curves,
  const BoundarySides& sides, const SidePrescriptions& prescribed, const TMesh& mesh)
  : Prescribed(prescribed)
{
  for (std::size_t i = 0; i < prescribed.size(); ++i)
  {
    if (!prescribed[i].isGraded)
    {
      continue;
    }
    const SideArcs arcs(map, curves, sides, mesh);
    for (std::vector<int>& part : arcs.PartsOf(prescribed[i].side))
    {
      this->Parts.push_back({ {}, { 0.0 }, i });
      for (const int arc : part)
      {
        std::vector<double>& ends = this->Parts.back().ends;
        ends.push_back(ends.back() + arcs.LengthOf({ arc }));
      }
      this->Parts.back().arcs = std::move(part);
    }
  }
}

void GradedArcs::SetTargets(std::vector<double>& targets) const
{
  const auto sumOf = [&targets](const Part& part)
  {
    return std::accumulate(part.arcs.begin(), part.arcs.end(), 0.0,
      [&targets](double sum, int arc) { return sum + targets[Index(arc)]; });
  };
  std::vector<double> ofSide(this->Prescribed.size(), 0.0);
  for (const Part& part : this->Parts)
  {
    ofSide[part.side] += sumOf(part);
  }
  for (const Part& part : this->Parts)
  {
    const SidePrescription& one = this->Prescribed[part.side];
    double count = sumOf(part);
    count *= one.count > 0 ? one.count / ofSide[part.side] : 1.0;
    if (one.progression.HasLengths())
    {
      count = CountForLengths(part.ends.back(), one.progression);
    }
    for (std::size_t i = 0; i < part.arcs.size(); ++i)
    {
      const auto within = [&](double length)
      { return EdgesWithin(length, part.ends.back(), count, one.progression); };
      targets[Index(part.arcs[i])] = within(part.ends[i + 1]) - within(part.ends[i]);
    }
  }
}

void GradedArcs::SetWeights(QuantisationProblem& problem) const
{
  // Arcs across the domain, whose targets are those of the size field, give way to these.
  constexpr double Preference = 100.0;
  for (const Part& part : this->Parts)
  {
    for (const int arc : part.arcs)
    {
      problem.weight[Index(arc)] *= Preference;
    }
  }
}

void PlaceOnSides(const BoundaryCurves& curves, const SidePrescriptions& prescribed, QuadMesh& mesh)
{
  std::vector<const QuadBoundaryEdge*> graded;
  const std::vector<QuadPoint> before = mesh.points;
  bool isMoved = false;
  for (const SidePrescription& one : prescribed)
  {
    if (!one.isGraded && one.size <= 0.0)
    {
      continue;
    }
    const Progression progression = one.isGraded ? one.progression : Progression{};
    for (const std::vector<int>& part : PartsBetweenFixed(mesh, PiecesOf(mesh, one.side)))
    {
      PlacePart(curves, part, progression, mesh);
      isMoved = true;
    }
    for (const QuadBoundaryEdge& edge : mesh.boundary)
    {
      if (one.isGraded && edge.side == one.side)
      {
        graded.push_back(&edge);
      }
    }
  }
  if (isMoved)
  {
    MoveInside(before, mesh);
  }
  if (!graded.empty())
  {
    StripGrading(mesh).Grade(graded);
  }
}
}
