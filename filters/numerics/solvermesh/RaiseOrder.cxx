#include "RaiseOrder.h"

#include "CellLattice.h"
#include "CurvedSides.h"
#include "ElementNodes.h"
#include "Error.h"
#include "LagrangeQuad.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <utility>

namespace crossfield
{
namespace
{
/// Part of the minimum of det J in the straight quad that is left at least, if more rows can have
/// curved edges.
constexpr double PartOfStraight = 0.5;

/// The strip of quads that begins at a curved boundary edge.
struct Strip
{
  std::vector<int> sides; ///< One of each quad, in the direction of the first, the boundary edge.
  EdgeOffsets offsets;    ///< Of the boundary edge.
  int rows = 1;           ///< Rows whose edges are curved.

  int Length() const { return static_cast<int>(this->sides.size()); }
};

/// Where a strip passes a quad.
struct Passage
{
  std::size_t strip = 0;
  int row = 0;
};

DomainPlane PlaneOf(const SolverMesh& quads)
{
  const std::vector<int> used = ElementNodes(quads, NodeOrder::Vtk).UsedPoints();
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(used.size()));
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    places.col(static_cast<Eigen::Index>(i)) = quads.points[used[i]];
  }
  return DomainPlane::Find(places);
}

/// Raises the order of quads. Side s of quad q, from corner s to the next, has the number 4 q + s, as in MeshFaces.
class OrderRaiser
{
public:
  OrderRaiser(
    const SolverMesh& quads, int order, OrderQuality& quality, const NodePlacement& surface)
    : Quads(quads)
    , Surface(surface)
    , Faces(quads)
    , Plane(surface ? DomainPlane() : PlaneOf(quads))
    , Element(order)
    , Lattice(2, order)
    , Quality(quality)
    , Passages(quads.region.size())
  {
    this->Result = quads;
    this->Result.order = order;
    this->Result.cells.clear();
    for (const Eigen::Vector3d& point : quads.points)
    {
      this->Places.push_back(surface ? point : InSpace(this->Plane.ToPlane(point)));
    }
    for (int s = 0; s < 4; ++s)
    {
      this->Along[s] = this->Lattice.Face(s);
    }
    this->RequireSimpleEdges();
    if (surface)
    {
      return;
    }
    for (CurvedSide& side :
      FindCurvedSides(quads, this->Faces, this->Plane, order, this->Quality.sagittas))
    {
      this->AddStrip(side);
      this->Exact[side.side] = std::move(side.nodes);
    }
  }

  SolverMesh Raise(const Progress& progress)
  {
    this->FindRows(progress);
    this->AddNodes();
    progress.Report(1.0);
    return std::move(this->Result);
  }

private:
  int CornerOf(int quad, int corner) const
  {
    return this->Quads.Cell(quad)[this->Straight.Corner(corner % 4)];
  }
  int StartOf(int side) const { return this->CornerOf(side / 4, side % 4); }
  int EndOf(int side) const { return this->CornerOf(side / 4, side % 4 + 1); }
  int TwinOf(int side) const { return this->Faces.PartnerOf(Index(side)); }
  /// Returns the corners of the quad of a side, from its start on.
  std::array<int, 4> CornersFrom(int side) const
  {
    std::array<int, 4> corners{};
    for (int i = 0; i < 4; ++i)
    {
      corners[Index(i)] = this->CornerOf(side / 4, side % 4 + i);
    }
    return corners;
  }
  static int Opposite(int side) { return side / 4 * 4 + (side + 2) % 4; }
  /// Returns the number of the edge of a side: the smaller one of its sides.
  std::size_t EdgeOf(int side) const
  {
    const int twin = this->TwinOf(side);
    return Index(twin < 0 ? side : std::min(side, twin));
  }
  int SideCount() const { return static_cast<int>(this->Faces.Count()); }

  void RequireSimpleEdges() const
  {
    for (int side = 0; side < this->SideCount(); ++side)
    {
      const int twin = this->TwinOf(side);
      if (twin >= 0 && (this->TwinOf(twin) != side || this->StartOf(twin) == this->StartOf(side)))
      {
        throw Error("An edge near " + PlaceOf(this->Quads, this->StartOf(side)) +
          " has more than two quads, or quads of different orientation; give a mesh of Quad Mesher.");
      }
    }
  }

  /// Adds the strip that begins at a boundary side.
  void AddStrip(const CurvedSide& start)
  {
    Strip strip;
    strip.offsets = start.offsets;
    for (int side = start.side; side >= 0; side = this->TwinOf(Opposite(side)))
    {
      this->Passages[side / 4].push_back({ this->Strips.size(), strip.Length() });
      strip.sides.push_back(side);
    }
    this->Strips.push_back(std::move(strip));
  }

  /// Adds the offsets of a strip to those of the edges that it passes.
  void AddOffsets(const Strip& strip, std::vector<EdgeOffsets>& ofEdge) const
  {
    for (int row = 0; row < std::min(strip.rows, strip.Length()); ++row)
    {
      const int side = strip.sides[row];
      const double part = 1.0 - static_cast<double>(row) / strip.rows;
      EdgeOffsets& offsets = ofEdge[this->EdgeOf(side)];
      const EdgeOffsets& own = this->IsForward(side) ? strip.offsets : Reversed(strip.offsets);
      offsets.resize(own.size(), 0.0);
      for (std::size_t k = 0; k < own.size(); ++k)
      {
        offsets[k] += part * own[k];
      }
    }
  }

  /// Returns whether a side has the direction of its edge, from the smaller number to the larger one.
  bool IsForward(int side) const { return this->StartOf(side) < this->EndOf(side); }

  std::vector<EdgeOffsets> ComputeOffsets() const
  {
    std::vector<EdgeOffsets> ofEdge(this->Faces.Count());
    for (const Strip& strip : this->Strips)
    {
      this->AddOffsets(strip, ofEdge);
    }
    return ofEdge;
  }

  /// Returns the nodes of a quad: corners, edges, and inside by transfinite interpolation.
  Eigen::Matrix3Xd NodesOf(int quad, const std::vector<EdgeOffsets>* ofEdge) const
  {
    const int p = this->Result.order;
    Eigen::Matrix3Xd nodes(3, (p + 1) * (p + 1));
    for (int s = 0; s < 4; ++s)
    {
      const int side = 4 * quad + s;
      const SpacePoint& from = this->Places[this->StartOf(side)];
      const SpacePoint along = this->Places[this->EndOf(side)] - from;
      EdgeOffsets offsets = ofEdge ? (*ofEdge)[this->EdgeOf(side)] : EdgeOffsets();
      if (!offsets.empty() && !this->IsForward(side))
      {
        offsets = Reversed(offsets);
      }
      nodes.col(this->Along[s][0]) = from;
      for (int k = 1; k < p; ++k)
      {
        SpacePoint node = from + static_cast<double>(k) / p * along;
        if (!offsets.empty())
        {
          const std::complex<double> offset = offsets[k - 1] * AsComplex(along.head<2>());
          node += SpacePoint(offset.real(), offset.imag(), 0.0);
        }
        nodes.col(this->Along[s][k]) = node;
      }
    }
    this->FillInside(nodes);
    return nodes;
  }

  /// Sets the inner nodes from those on the edges, by the formula of Coons.
  void FillInside(Eigen::Matrix3Xd& nodes) const
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
      const std::vector<EdgeOffsets> ofEdge = this->ComputeOffsets();
      std::vector<bool> grows(this->Strips.size(), false);
      for (int q = 0; q < this->Quads.CellCount(); ++q)
      {
        if (this->Passages[q].empty())
        {
          continue;
        }
        const double straight = this->JacobianOf(this->NodesOf(q, nullptr)).min;
        const double curved = this->JacobianOf(this->NodesOf(q, &ofEdge)).min;
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
      this->Quality.curvedRows = std::max(this->Quality.curvedRows, strip.rows);
    }
  }

  int AddPoint(const SpacePoint& place)
  {
    this->Result.points.push_back(this->Plane.PlaceToSpace(place));
    return static_cast<int>(this->Result.points.size()) - 1;
  }

  /// Adds the nodes of all edges and quads, and measures det J.
  void AddNodes()
  {
    const int p = this->Result.order;
    const std::vector<EdgeOffsets> ofEdge = this->ComputeOffsets();
    std::vector<int> firstNode(this->Faces.Count(), -1); // per edge, in its direction
    for (int quad = 0; quad < this->Quads.CellCount(); ++quad)
    {
      Eigen::Matrix3Xd nodes = this->NodesOf(quad, &ofEdge);
      std::vector<int> numbers(static_cast<std::size_t>(nodes.cols()), -1);
      for (int s = 0; s < 4; ++s)
      {
        const int side = 4 * quad + s;
        const std::vector<int>& along = this->Along[s];
        const auto exact = this->Exact.find(side);
        for (int k = 1; k < p && exact != this->Exact.end(); ++k)
        {
          nodes.col(along[k]) = InSpace(exact->second[k - 1]); // on the curve to rounding
        }
        int& first = firstNode[this->EdgeOf(side)];
        const bool isNew = first < 0;
        numbers[along[0]] = this->StartOf(side);
        for (int k = 1; k < p; ++k)
        {
          const int node = along[this->IsForward(side) ? k : p - k];
          if (this->Surface)
          {
            nodes.col(node) = isNew ? this->Surface(nodes.col(node), this->CornersFrom(side),
                                        this->Faces.HasSide(Index(side)))
                                    : this->Result.points[first + k - 1];
          }
          const int number = isNew ? this->AddPoint(nodes.col(node)) : first + k - 1;
          first = k == 1 ? number : first;
          numbers[node] = number;
        }
      }
      this->FillInside(nodes);
      for (std::size_t node = 0; node < numbers.size(); ++node)
      {
        if (numbers[node] < 0)
        {
          auto place = nodes.col(static_cast<Eigen::Index>(node));
          place = this->Surface ? this->Surface(place, this->CornersFrom(4 * quad), false)
                                : SpacePoint(place);
          numbers[node] = this->AddPoint(place);
        }
      }
      this->Measure(nodes);
      this->Result.cells.insert(this->Result.cells.end(), numbers.begin(), numbers.end());
    }
    MeshSources& sources = this->Result.sources;
    for (int point = 0; sources.points.size() < this->Places.size(); ++point)
    {
      sources.points.push_back(point);
    }
    sources.points.resize(this->Result.points.size(), -1);
  }

  /// Measures det J in the plane, on a surface in that of the diagonals.
  LagrangeQuad::Range JacobianOf(const Eigen::Matrix3Xd& nodes) const
  {
    if (!this->Surface)
    {
      return this->Element.MeasureJacobian(nodes.topRows<2>());
    }
    const auto corner = [&](int c) { return nodes.col(this->Lattice.Corner(c)); };
    const SpacePoint diagonal = corner(2) - corner(0);
    const SpacePoint normal = diagonal.cross(corner(3) - corner(1)).normalized();
    Eigen::Matrix<double, 2, 3> axes;
    axes.row(0) = diagonal.normalized();
    axes.row(1) = normal.cross(diagonal.normalized());
    return this->Element.MeasureJacobian(axes * nodes);
  }

  void Measure(const Eigen::Matrix3Xd& nodes)
  {
    const LagrangeQuad::Range range = this->JacobianOf(nodes);
    const double ratio = range.max > 0.0 ? range.min / range.max : -1.0;
    this->Quality.inverted += range.min > 0.0 ? 0 : 1;
    this->Quality.jacobianRatios.push_back(ratio);
    if (ratio < this->Quality.jacobianRatio)
    {
      this->Quality.jacobianRatio = ratio;
      this->Quality.worst = this->Plane.PlaceToSpace(nodes.rowwise().mean());
    }
  }

  const SolverMesh& Quads;
  const NodePlacement& Surface; ///< Empty in the plane.
  const MeshFaces Faces;
  const DomainPlane Plane;
  const LagrangeQuad Element;
  const CellLattice Straight{ 2, 1 };
  const CellLattice Lattice;
  OrderQuality& Quality;
  SolverMesh Result;
  std::vector<SpacePoint>
    Places; ///< Of the points of the quads: plane coordinates, or in space on a surface.
  std::array<std::vector<int>, 4> Along; ///< Positions of the nodes along the sides of a quad.
  std::vector<Strip> Strips;
  std::map<int, std::vector<Point>> Exact;    ///< Inner nodes of boundary sides on curves.
  std::vector<std::vector<Passage>> Passages; ///< Per quad.
};
}

SolverMesh RaiseOrder(const SolverMesh& quads, int order, OrderQuality& quality,
  const Progress& progress, const NodePlacement& surface)
{
  if (order != 2 && order != 3)
  {
    throw Error("Quads of order " + std::to_string(order) + " are not available; give 2 or 3.");
  }
  if (quads.dimension != 2 || quads.order != 1)
  {
    throw Error("The cells are not quads of order 1; give the quads of a Quad Mesher.");
  }
  quality = {};
  return OrderRaiser(quads, order, quality, surface).Raise(progress);
}
}
