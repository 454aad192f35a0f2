#include "HigherOrder.h"

#include "CurvedLoops.h"
#include "Error.h"
#include "Index.h"
#include "LagrangeQuad.h"
#include "PeriodicEdges.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <utility>

namespace crossfield
{
namespace
{
/// Part of the minimum of det J in the straight quad that is left at least, if more rows can have
/// curved edges.
constexpr double PartOfStraight = 0.5;

/// Offsets of the inner nodes of an edge from equal steps along it, relative to the edge as a complex
/// number: independent of position, direction and size.
using Offsets = std::vector<std::complex<double>>;

/// Returns the offsets of the same edge in the other direction.
Offsets Reversed(const Offsets& offsets)
{
  Offsets result;
  for (auto offset = offsets.rbegin(); offset != offsets.rend(); ++offset)
  {
    result.push_back(-*offset);
  }
  return result;
}

/// The strip of quads that begins at a curved boundary edge.
struct Strip
{
  std::vector<int> sides; ///< One of each quad, in the direction of the first, the boundary edge.
  Offsets offsets;        ///< Of the boundary edge.
  int rows = 1;           ///< Rows whose edges are curved.

  int Length() const { return static_cast<int>(this->sides.size()); }
};

/// Where a strip passes a quad.
struct Passage
{
  std::size_t strip = 0;
  int row = 0;
};

class OrderRaiser
{
public:
  OrderRaiser(const StraightQuads& straight, int order)
    : Straight(straight)
    , Element(order)
    , Passages(straight.quads.size())
  {
    this->Result.order = order;
    this->Result.points = straight.points;
    this->Result.sagittas.assign(straight.curves.size(), 0.0);
    this->NumberEdges();
    for (const PlaneCurve& curve : straight.curves)
    {
      if (curve.kind == PlaneCurve::Kind::Line)
      {
        this->Evaluators.emplace_back();
      }
      else
      {
        this->Evaluators.push_back({ CurveEvaluator(curve) });
      }
    }
    const std::vector<int> masters = MatchEdges(straight);
    for (const bool isImage : { false, true })
    {
      for (std::size_t e = 0; e < straight.edges.size(); ++e)
      {
        if ((masters[e] >= 0) == isImage)
        {
          this->AddStrip(straight.edges[e], isImage ? &straight.edges[Index(masters[e])] : nullptr);
        }
      }
    }
  }

  CurvedQuads Raise(const Progress& progress)
  {
    this->FindRows(progress);
    this->AddNodes();
    progress.Report(1.0);
    return std::move(this->Result);
  }

private:
  int Inner() const { return this->Result.order - 1; }
  int StartOf(int side) const { return this->Straight.quads[Index(side / 4)][Index(side % 4)]; }
  int EndOf(int side) const { return this->Straight.quads[Index(side / 4)][Index((side + 1) % 4)]; }
  static int Opposite(int side) { return side / 4 * 4 + (side + 2) % 4; }

  /// Numbers edges, and finds for each side of a quad the other side of its edge.
  void NumberEdges()
  {
    std::map<std::array<int, 2>, int> first;
    const auto sides = static_cast<int>(4 * this->Straight.quads.size());
    this->Twins.assign(Index(sides), -1);
    this->EdgeOf.assign(Index(sides), -1);
    for (int side = 0; side < sides; ++side)
    {
      const auto [low, high] = std::minmax({ this->StartOf(side), this->EndOf(side) });
      const auto [found, isNew] = first.emplace(std::array<int, 2>{ low, high }, side);
      if (isNew)
      {
        this->EdgeOf[Index(side)] = this->EdgeCount++;
        continue;
      }
      const int other = found->second;
      if (this->Twins[Index(other)] >= 0 || this->StartOf(other) == this->StartOf(side))
      {
        throw Error("An edge near " + Describe(this->Straight.points[Index(low)]) +
          " has more than two quads, or quads of different orientation; give a mesh of Quad Mesher.");
      }
      this->EdgeOf[Index(side)] = this->EdgeOf[Index(other)];
      this->Twins[Index(side)] = other;
      this->Twins[Index(other)] = side;
    }
    for (int side = 0; side < sides; ++side)
    {
      if (this->Twins[Index(side)] < 0)
      {
        this->OnBoundary[{ this->StartOf(side), this->EndOf(side) }] = side;
      }
    }
  }

  int BoundarySideOf(const StraightEdge& edge) const
  {
    const auto found = this->OnBoundary.find({ edge.points[0], edge.points[1] });
    if (found == this->OnBoundary.end())
    {
      throw Error("The boundary edge near " +
        Describe(this->Straight.points[Index(edge.points[0])]) +
        " belongs to no quad; give quads and boundary of the same mesh.");
    }
    return found->second;
  }

  static std::complex<double> AsComplex(const Point& point) { return { point.x(), point.y() }; }

  /// Returns the offsets of the nodes of a boundary edge, which are the points of the curve nearest
  /// to equal steps along the edge.
  Offsets OffsetsOn(const StraightEdge& edge)
  {
    const CurveEvaluator& curve = this->Evaluators[Index(edge.curve)].front();
    const Point& from = this->Straight.points[Index(edge.points[0])];
    const Point along = this->Straight.points[Index(edge.points[1])] - from;
    const SegmentParameters ends = ParametersOf(curve, from, from + along);
    Offsets offsets;
    for (int k = 1; k < this->Result.order; ++k)
    {
      const double fraction = static_cast<double>(k) / this->Result.order;
      const Point step = from + fraction * along;
      const Point node =
        curve.At(curve.NearestFrom(step, ends.from + fraction * (ends.to - ends.from)));
      offsets.push_back(AsComplex(node - step) / AsComplex(along));
      double& sagitta = this->Result.sagittas[Index(edge.curve)];
      sagitta = std::max(sagitta, (node - step).norm());
      this->Exact[{ edge.points[0], edge.points[1] }].push_back(node);
    }
    return offsets;
  }

  /// Returns the offsets of an edge that is the image of another one, whose nodes are known: they are
  /// independent of position and direction.
  Offsets OffsetsOfImage(const StraightEdge& edge, const StraightEdge& master)
  {
    const auto found = std::find_if(this->Straight.periodic.begin(), this->Straight.periodic.end(),
      [&](const PairedSides& pair) { return pair.second == edge.side; });
    const std::vector<Point> nodes = this->Exact.at({ master.points[0], master.points[1] });
    std::vector<Point>& images = this->Exact[{ edge.points[0], edge.points[1] }];
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
    {
      images.push_back(found->motion(*node));
    }
    return Reversed(this->OfEdge.at({ master.points[0], master.points[1] }));
  }

  /// Adds the strip of an edge; `master` is the edge whose image it is, or null.
  void AddStrip(const StraightEdge& edge, const StraightEdge* master)
  {
    const int start = this->BoundarySideOf(edge);
    const int curve = master == nullptr ? edge.curve : master->curve;
    if (curve < 0 || this->Evaluators[Index(curve)].empty())
    {
      return;
    }
    Strip strip;
    strip.offsets = master == nullptr ? this->OffsetsOn(edge) : this->OffsetsOfImage(edge, *master);
    this->OfEdge[{ edge.points[0], edge.points[1] }] = strip.offsets;
    for (int side = start; side >= 0; side = this->Twins[Index(Opposite(side))])
    {
      this->Passages[Index(side / 4)].push_back({ this->Strips.size(), strip.Length() });
      strip.sides.push_back(side);
    }
    this->Strips.push_back(std::move(strip));
  }

  /// Adds the offsets of a strip to those of the edges that it passes.
  void AddOffsets(const Strip& strip, std::vector<Offsets>& ofEdge) const
  {
    for (int row = 0; row < std::min(strip.rows, strip.Length()); ++row)
    {
      const int side = strip.sides[Index(row)];
      const double part = 1.0 - static_cast<double>(row) / strip.rows;
      Offsets& offsets = ofEdge[Index(this->EdgeOf[Index(side)])];
      const Offsets& own = this->IsForward(side) ? strip.offsets : Reversed(strip.offsets);
      offsets.resize(own.size(), 0.0);
      for (std::size_t k = 0; k < own.size(); ++k)
      {
        offsets[k] += part * own[k];
      }
    }
  }

  /// Returns whether a side has the direction of its edge, from the smaller number to the larger one.
  bool IsForward(int side) const { return this->StartOf(side) < this->EndOf(side); }

  std::vector<Offsets> ComputeOffsets() const
  {
    std::vector<Offsets> ofEdge(Index(this->EdgeCount));
    for (const Strip& strip : this->Strips)
    {
      this->AddOffsets(strip, ofEdge);
    }
    return ofEdge;
  }

  /// Returns the nodes of a quad: corners, edges, and inside by transfinite interpolation.
  Eigen::Matrix2Xd NodesOf(std::size_t q, const std::vector<Offsets>* ofEdge) const
  {
    const int p = this->Result.order;
    const auto at = [p](int i, int j) { return static_cast<Eigen::Index>(j * (p + 1) + i); };
    std::array<Point, 4> c;
    for (std::size_t k = 0; k < 4; ++k)
    {
      c[k] = this->Straight.points[Index(this->Straight.quads[q][k])];
    }
    Eigen::Matrix2Xd nodes(2, (p + 1) * (p + 1));
    nodes.col(at(0, 0)) = c[0];
    nodes.col(at(p, 0)) = c[1];
    nodes.col(at(p, p)) = c[2];
    nodes.col(at(0, p)) = c[3];
    for (int s = 0; s < 4; ++s)
    {
      const int side = static_cast<int>(4 * q) + s;
      const Point along = c[Index((s + 1) % 4)] - c[Index(s)];
      Offsets offsets = ofEdge ? (*ofEdge)[Index(this->EdgeOf[Index(side)])] : Offsets();
      if (!offsets.empty() && !this->IsForward(side))
      {
        offsets = Reversed(offsets);
      }
      for (int k = 1; k < p; ++k)
      {
        Point node = c[Index(s)] + static_cast<double>(k) / p * along;
        if (!offsets.empty())
        {
          const std::complex<double> offset = offsets[Index(k - 1)] * AsComplex(along);
          node += Point(offset.real(), offset.imag());
        }
        nodes.col(s == 0 ? at(k, 0)
            : s == 1     ? at(p, k)
            : s == 2     ? at(p - k, p)
                         : at(0, p - k)) = node;
      }
    }
    this->FillInside(nodes);
    return nodes;
  }

  /// Sets the inner nodes from those on the edges, by the formula of Coons.
  void FillInside(Eigen::Matrix2Xd& nodes) const
  {
    const int p = this->Result.order;
    const auto at = [p](int i, int j) { return static_cast<Eigen::Index>(j * (p + 1) + i); };
    for (int j = 1; j < p; ++j)
    {
      for (int i = 1; i < p; ++i)
      {
        const double x = static_cast<double>(i) / p;
        const double y = static_cast<double>(j) / p;
        nodes.col(at(i, j)) = (1.0 - y) * nodes.col(at(i, 0)) + y * nodes.col(at(i, p)) +
          (1.0 - x) * nodes.col(at(0, j)) + x * nodes.col(at(p, j)) -
          (1.0 - x) * (1.0 - y) * nodes.col(at(0, 0)) - x * (1.0 - y) * nodes.col(at(p, 0)) -
          x * y * nodes.col(at(p, p)) - (1.0 - x) * y * nodes.col(at(0, p));
      }
    }
  }

  /// Curves the edges of more rows until all quads are good, or no more rows help.
  void FindRows(const Progress& progress)
  {
    for (bool isChanged = true; isChanged;)
    {
      progress.Report(0.5);
      isChanged = false;
      const std::vector<Offsets> ofEdge = this->ComputeOffsets();
      std::vector<bool> grows(this->Strips.size(), false);
      for (std::size_t q = 0; q < this->Straight.quads.size(); ++q)
      {
        if (this->Passages[q].empty())
        {
          continue;
        }
        const double straight = this->Element.MeasureJacobian(this->NodesOf(q, nullptr)).min;
        const double curved = this->Element.MeasureJacobian(this->NodesOf(q, &ofEdge)).min;
        if (curved >= PartOfStraight * straight && curved > 0.0)
        {
          continue;
        }
        for (const Passage& passage : this->Passages[q])
        {
          const Strip& strip = this->Strips[passage.strip];
          grows[passage.strip] =
            grows[passage.strip] || (passage.row < strip.rows && strip.rows < strip.Length());
        }
      }
      for (std::size_t s = 0; s < grows.size(); ++s)
      {
        if (grows[s])
        {
          Strip& strip = this->Strips[s];
          strip.rows = std::min(2 * strip.rows, strip.Length());
          isChanged = true;
        }
      }
    }
    for (const Strip& strip : this->Strips)
    {
      this->Result.curvedRows = std::max(this->Result.curvedRows, strip.rows);
    }
  }

  /// Adds the nodes of all edges and quads, and measures det J.
  void AddNodes()
  {
    const int p = this->Result.order;
    const std::vector<Offsets> ofEdge = this->ComputeOffsets();
    std::vector<int> firstNode(Index(this->EdgeCount), -1); // in the direction of the edge
    for (std::size_t q = 0; q < this->Straight.quads.size(); ++q)
    {
      Eigen::Matrix2Xd nodes = this->NodesOf(q, &ofEdge);
      std::vector<int> numbers(static_cast<std::size_t>(nodes.cols()), -1);
      const auto at = [p](int i, int j) { return Index(j * (p + 1) + i); };
      const std::array<int, 4>& quad = this->Straight.quads[q];
      numbers[at(0, 0)] = quad[0];
      numbers[at(p, 0)] = quad[1];
      numbers[at(p, p)] = quad[2];
      numbers[at(0, p)] = quad[3];
      for (int s = 0; s < 4; ++s)
      {
        const int side = static_cast<int>(4 * q) + s;
        int& first = firstNode[Index(this->EdgeOf[Index(side)])];
        const bool isNew = first < 0;
        first = isNew ? static_cast<int>(this->Result.points.size()) : first;
        const auto exact = this->Exact.find({ this->StartOf(side), this->EndOf(side) });
        for (int k = 1; k < p; ++k)
        {
          const std::size_t node = s == 0 ? at(k, 0)
            : s == 1                      ? at(p, k)
            : s == 2                      ? at(p - k, p)
                                          : at(0, p - k);
          numbers[node] = first + (this->IsForward(side) ? k - 1 : p - 1 - k);
          if (exact != this->Exact.end())
          {
            // On the curve to rounding.
            nodes.col(static_cast<Eigen::Index>(node)) = exact->second[Index(k - 1)];
          }
        }
        for (int k = 1; isNew && k < p; ++k)
        {
          const int along = this->IsForward(side) ? k : p - k;
          const std::size_t node = s == 0 ? at(along, 0)
            : s == 1                      ? at(p, along)
            : s == 2                      ? at(p - along, p)
                                          : at(0, p - along);
          this->Result.points.emplace_back(nodes.col(static_cast<Eigen::Index>(node)));
        }
      }
      this->FillInside(nodes);
      for (int j = 1; j < p; ++j)
      {
        for (int i = 1; i < p; ++i)
        {
          numbers[at(i, j)] = static_cast<int>(this->Result.points.size());
          this->Result.points.emplace_back(nodes.col(static_cast<Eigen::Index>(at(i, j))));
        }
      }
      this->Measure(nodes);
      this->Result.quads.push_back(std::move(numbers));
    }
    this->AddEdges(firstNode);
  }

  void Measure(const Eigen::Matrix2Xd& nodes)
  {
    const LagrangeQuad::Range range = this->Element.MeasureJacobian(nodes);
    const double ratio = range.max > 0.0 ? range.min / range.max : -1.0;
    this->Result.inverted += range.min > 0.0 ? 0 : 1;
    this->Result.jacobianRatios.push_back(ratio);
    if (ratio < this->Result.jacobianRatio)
    {
      this->Result.jacobianRatio = ratio;
      this->Result.worst = nodes.rowwise().mean();
    }
  }

  void AddEdges(const std::vector<int>& firstNode)
  {
    for (const StraightEdge& edge : this->Straight.edges)
    {
      const int side = this->BoundarySideOf(edge);
      const int first = firstNode[Index(this->EdgeOf[Index(side)])];
      std::vector<int> nodes = { edge.points[0] };
      for (int k = 1; k < this->Result.order; ++k)
      {
        nodes.push_back(first + (this->IsForward(side) ? k - 1 : this->Inner() - k));
      }
      nodes.push_back(edge.points[1]);
      this->Result.edges.push_back(std::move(nodes));
    }
  }

  const StraightQuads& Straight;
  const LagrangeQuad Element;
  CurvedQuads Result;
  std::vector<int> Twins;  ///< As QuadMesh::Twins.
  std::vector<int> EdgeOf; ///< Per side of a quad.
  int EdgeCount = 0;
  std::map<std::array<int, 2>, int> OnBoundary;        ///< Sides on the boundary by their points.
  std::vector<std::vector<CurveEvaluator>> Evaluators; ///< Per curve; none for a line.
  std::vector<Strip> Strips;
  std::map<std::array<int, 2>, Offsets> OfEdge; ///< Of boundary edges on curves, by their ends.
  std::vector<std::vector<Passage>> Passages;   ///< Per quad.
  std::map<std::array<int, 2>, std::vector<Point>> Exact; ///< Nodes on curves, by the edge's ends.
};
}

CurvedQuads RaiseOrder(const StraightQuads& straight, int order, const Progress& progress)
{
  if (order != 2 && order != 3)
  {
    throw Error("Quads of order " + std::to_string(order) + " are not available; give 2 or 3.");
  }
  return OrderRaiser(straight, order).Raise(progress);
}
}
