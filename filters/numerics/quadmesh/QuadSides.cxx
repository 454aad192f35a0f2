#include "QuadSides.h"

#include "Index.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace crossfield
{
namespace
{
/// Sorts boundary edges so that each follows the one that ends where it starts, loop after loop, in
/// the order of the first edges.
void Chain(std::vector<QuadBoundaryEdge>& edges)
{
  std::map<int, std::size_t> startingAt;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    startingAt[edges[i].points[0]] = i;
  }
  std::vector<QuadBoundaryEdge> sorted;
  std::vector<bool> done(edges.size(), false);
  for (std::size_t first = 0; first < edges.size(); ++first)
  {
    for (std::size_t i = first; !done[i]; i = startingAt.at(edges[i].points[1]))
    {
      done[i] = true;
      sorted.push_back(edges[i]);
    }
  }
  edges = std::move(sorted);
}
}

void NameBoundary(const BoundarySides& sides, const BoundaryCurves& curves, QuadMesh& mesh)
{
  if (!sides.names.empty())
  {
    Chain(mesh.boundary);
  }
  mesh.sideNames = sides.names;
  const SidesAlong along(sides, curves.GetArcs());
  for (QuadBoundaryEdge& edge : mesh.boundary)
  {
    const CurvePlace& from = mesh.points[edge.points[0]].curve;
    const CurvePlace& to = mesh.points[edge.points[1]].curve;
    const double loop = curves.Length(from.loop);
    const double length = to.at - from.at - loop * std::floor((to.at - from.at) / loop);
    const CurvePlace middle = { from.loop, from.at + 0.5 * length };
    edge.side = along.At(Index(middle.loop), middle.at);
    edge.curve = curves.CurveAt(middle);
  }
}

std::vector<std::vector<int>> PiecesOf(const QuadMesh& mesh, int side)
{
  std::vector<std::vector<int>> pieces;
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    if (edge.side != side)
    {
      continue;
    }
    if (pieces.empty() || pieces.back().back() != edge.points[0])
    {
      pieces.push_back({ edge.points[0] });
    }
    pieces.back().push_back(edge.points[1]);
  }
  // a piece may contain the point where the edges of its loop begin
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    for (std::size_t j = 0; j < pieces.size(); ++j)
    {
      if (i != j && pieces[j].back() == pieces[i].front())
      {
        pieces[j].insert(pieces[j].end(), pieces[i].begin() + 1, pieces[i].end());
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i));
        --i;
        break;
      }
    }
  }
  return pieces;
}

std::vector<SideMeasure> MeasureSides(const QuadMesh& mesh)
{
  std::vector<SideMeasure> measures(mesh.sideNames.size());
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    if (edge.side >= 0)
    {
      SideMeasure& measure = measures[edge.side];
      ++measure.edges;
      measure.length +=
        (mesh.points[edge.points[1]].place - mesh.points[edge.points[0]].place).norm();
    }
  }
  return measures;
}

std::vector<std::array<std::vector<int>, 4>> SidesOfBlocks(
  const QuadMesh& mesh, const std::vector<QuadBlock>& blocks)
{
  std::map<std::array<int, 2>, int> sideOf;
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    sideOf[{ std::min(edge.points[0], edge.points[1]), std::max(edge.points[0], edge.points[1]) }] =
      edge.side;
  }
  std::vector<std::array<std::vector<int>, 4>> result(blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    for (std::size_t side = 0; side < 4; ++side)
    {
      if (blocks[b].neighbours[side].block >= 0)
      {
        continue;
      }
      const std::vector<int> points = PointsAlong(blocks[b], side);
      std::vector<int>& sides = result[b][side];
      for (std::size_t i = 1; i < points.size(); ++i)
      {
        const auto found =
          sideOf.find({ std::min(points[i - 1], points[i]), std::max(points[i - 1], points[i]) });
        if (found != sideOf.end() && found->second >= 0 &&
          (sides.empty() || sides.back() != found->second))
        {
          sides.push_back(found->second);
        }
      }
    }
  }
  return result;
}
}
