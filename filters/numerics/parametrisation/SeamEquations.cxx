#include "SeamEquations.h"

#include "Elimination.h"
#include "Index.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// The order in which unknowns are eliminated where there is a choice: further copies of a vertex,
/// then vertices, then translations, last cones, because the cones' coordinates in terms of
/// translations would have halves as coefficients.
enum Rank
{
  Copies,
  Vertices,
  Translations,
  Cones
};

/// Returns the coordinate (0: x, 1: y) that is the given part (0: real, 1: imaginary) of i^quarters
/// (x + iy), and its sign there.
std::pair<int, double> PartOfTurned(int part, int quarters)
{
  const Point real = TurnByQuarters(Point(1.0, 0.0), quarters);
  const Point imaginary = TurnByQuarters(Point(0.0, 1.0), quarters);
  return real[part] != 0.0 ? std::make_pair(0, real[part]) : std::make_pair(1, imaginary[part]);
}

/// Assembles the equations and eliminates them one by one.
class Equations
{
public:
  Equations(const MeshTopology& topology, const CutGraph& cut, const std::vector<Cone>& cones)
    : Topology(topology)
    , Cut(cut)
    , System(Ranks(topology, cut, cones))
  {
  }

  /// Imposes w' = i^rotation w + T at both ends of every edge of a chain.
  void ImposeSeam(std::size_t chain, int rotation)
  {
    const auto& [vertices, edges] = this->Cut.chains[chain];
    const auto translation = static_cast<int>(this->Cut.original.size() + chain);
    for (std::size_t j = 0; j < edges.size(); ++j)
    {
      const int left = TriangleLeftOf(this->Topology, edges[j], vertices[j]);
      const int right = TriangleLeftOf(this->Topology, edges[j], vertices[j + 1]);
      for (const int vertex : { vertices[j], vertices[j + 1] })
      {
        const int from = this->Copy(left, vertex);
        const int to = this->Copy(right, vertex);
        for (int part = 0; part < 2; ++part)
        {
          const auto [other, sign] = PartOfTurned(part, rotation);
          if (from == to && other == part && sign == 1.0)
          {
            this->System.Impose({ { 2 * translation + part, 1.0 } });
            continue;
          }
          this->System.Impose({ { 2 * to + part, 1.0 }, { 2 * from + other, -sign },
            { 2 * translation + part, -1.0 } });
        }
      }
    }
  }

  /// Imposes that the coordinate across a boundary edge is the same at both its ends.
  void ImposeSide(int position, int direction)
  {
    const int edge = this->Topology.EdgeOfBoundary(position);
    const int triangle = this->Topology.edges.triangles[edge][0];
    const auto& [from, to] = this->Topology.BoundaryAt(position).vertices;
    const int part = direction % 2 == 0 ? 1 : 0;
    this->System.Impose({ { 2 * this->Copy(triangle, to) + part, 1.0 },
      { 2 * this->Copy(triangle, from) + part, -1.0 } });
  }

  Eigen::SparseMatrix<double, Eigen::RowMajor> Prolongation()
  {
    return this->System.Prolongation();
  }

private:
  static std::vector<int> Ranks(
    const MeshTopology& topology, const CutGraph& cut, const std::vector<Cone>& cones)
  {
    const std::size_t vertices = cut.original.size();
    std::vector<int> ranks(2 * (vertices + cut.chains.size()), Vertices);
    std::fill(
      ranks.begin() + static_cast<std::ptrdiff_t>(2 * topology.VertexCount()), ranks.end(), Copies);
    std::fill(ranks.begin() + static_cast<std::ptrdiff_t>(2 * vertices), ranks.end(), Translations);
    for (const Cone& cone : cones)
    {
      ranks[2 * Index(cone.vertex)] = ranks[2 * Index(cone.vertex) + 1] = Cones;
    }
    return ranks;
  }

  /// Returns the vertex of the cut mesh at the corner of a triangle where `vertex` is.
  int Copy(int triangle, int vertex) const
  {
    const auto& v = this->Topology.mesh.triangles[triangle];
    return this->Cut.corners[triangle][std::find(v.begin(), v.end(), vertex) - v.begin()];
  }

  const MeshTopology& Topology;
  const CutGraph& Cut;
  Elimination System;
};
}

int TriangleLeftOf(const MeshTopology& topology, int edge, int from)
{
  for (const int t : topology.edges.triangles[edge])
  {
    if (t < 0)
    {
      continue;
    }
    const auto& sides = topology.edges.ofTriangle[t];
    const auto i = std::find(sides.begin(), sides.end(), edge) - sides.begin();
    if (topology.mesh.triangles[t][i] == from)
    {
      return t;
    }
  }
  return -1;
}

Eigen::SparseMatrix<double, Eigen::RowMajor> EliminateSeams(const MeshTopology& topology,
  const CutGraph& cut, const std::vector<SeamTransition>& seams, const std::vector<int>& directions,
  const std::vector<Cone>& cones)
{
  Equations equations(topology, cut, cones);
  for (std::size_t chain = 0; chain < cut.chains.size(); ++chain)
  {
    equations.ImposeSeam(chain, seams[chain].rotation);
  }
  for (int position = 0; position < static_cast<int>(directions.size()); ++position)
  {
    equations.ImposeSide(position, directions[position]);
  }
  return equations.Prolongation();
}
}
