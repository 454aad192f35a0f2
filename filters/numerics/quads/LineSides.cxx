#include "LineSides.h"

#include "BoundaryNames.h"
#include "Index.h"
#include "SparseCholesky.h"
#include "UnionFind.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace crossfield
{
std::vector<int> SidesOfArcs(
  const std::vector<PairedSides>& pairs, const MeshBoundary& curves, const TMesh& mesh)
{
  std::map<int, std::vector<std::pair<SideSpan, int>>> spans; // per loop
  for (const PairedSides& pair : pairs)
  {
    for (const int index : { 0, 1 })
    {
      const SideSpan& span = (*pair.spans)[Index(index)];
      spans[span.loop].emplace_back(span, pair.first + index);
    }
  }
  std::vector<int> sides(mesh.arcs.size(), -1);
  for (std::size_t a = 0; a < mesh.arcs.size(); ++a)
  {
    const TArc& arc = mesh.arcs[a];
    if (!arc.onBoundary)
    {
      continue;
    }
    // Arcs end at the ends of sides, so the first boundary entry after the start is on the side.
    const CurvePlace at = curves.Place(arc.pieces.front().position, 0.5);
    const double loop = curves.Length(at.loop);
    for (const auto& [span, side] : spans[at.loop])
    {
      const double offset = at.at - span.start;
      sides[a] = offset - loop * std::floor(offset / loop) < span.length ? side : sides[a];
    }
  }
  return sides;
}

SurfaceSideNames NamesOfSides(const LayoutSet& layouts, const std::vector<int>& sideOfArc)
{
  const Layout& layout = layouts.Single();
  SurfaceSideNames names;
  names.ofEntries = layouts.sides.ofBoundary;
  names.ofEntries.resize(layout.map.topology->mesh.boundary.size());
  std::vector<bool> isOnLine(names.ofEntries.size(), false);
  const auto forLines = [&](const auto& visit)
  {
    for (std::size_t a = 0; a < sideOfArc.size(); ++a)
    {
      for (const ChartPiece& piece : layout.tMesh.arcs[a].pieces)
      {
        if (sideOfArc[a] >= 0)
        {
          visit(Index(piece.position), Index(sideOfArc[a] / 2));
        }
      }
    }
  };
  forLines([&](std::size_t entry, std::size_t) { isOnLine[entry] = true; });
  names.ofLoops = NameBoundary(layout.map, layouts.sides.twins, isOnLine, names.ofEntries);
  forLines([&](std::size_t entry, std::size_t pair)
    { names.ofEntries[entry] = layouts.sides.ofPairs[pair]; });
  return names;
}

std::vector<CountSum> SumsOfPairs(
  const std::vector<PairedSides>& pairs, const std::vector<int>& sideOfArc)
{
  std::vector<CountSum> sums(pairs.size());
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    sums[p].name = pairs[p].name;
  }
  for (std::size_t a = 0; a < sideOfArc.size(); ++a)
  {
    if (sideOfArc[a] >= 0)
    {
      const int factor = sideOfArc[a] % 2 == 0 ? 1 : -1;
      sums[Index(sideOfArc[a] / 2)].terms.emplace_back(static_cast<int>(a), factor);
    }
  }
  return sums;
}

std::vector<int> FacesOfArcs(const MeshTopology& topology, const TMesh& mesh)
{
  UnionFind vertices(Index(topology.VertexCount()));
  for (const std::array<int, 2>& ends : topology.edges.vertices)
  {
    vertices.Join(ends[0], ends[1]);
  }
  std::map<int, int> number; // of sets
  for (const std::array<int, 3>& triangle : topology.mesh.triangles)
  {
    number.emplace(vertices.Find(triangle[0]), static_cast<int>(number.size()));
  }
  std::vector<int> faces;
  for (const TArc& arc : mesh.arcs)
  {
    const auto& triangle = topology.mesh.triangles[Index(arc.pieces.front().triangle)];
    faces.push_back(number.at(vertices.Find(triangle[0])));
  }
  return faces;
}

void MatchFaces(const TMesh& mesh, const std::vector<int>& faceOfArc,
  const std::vector<CountSum>& sums, std::vector<double>& lengths)
{
  const auto faceOf = [&](int arc) { return faceOfArc[Index(arc)]; };
  const auto count =
    static_cast<Eigen::Index>(*std::max_element(faceOfArc.begin(), faceOfArc.end()) + 1);
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(count);
  for (const TPatch& patch : mesh.patches)
  {
    areas[faceOf(patch.sides[0].front() / 2)] +=
      mesh.SideLength(patch, 0) * mesh.SideLength(patch, 1);
  }
  // The graph Laplacian of faces, without the first one.
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
  for (const CountSum& sum : sums)
  {
    std::array<double, 2> ofSides = { 0.0, 0.0 };
    std::array<int, 2> faces = { -1, -1 };
    for (const auto& [arc, factor] : sum.terms)
    {
      const std::size_t side = factor > 0 ? 0 : 1;
      ofSides[side] += lengths[Index(arc)];
      faces[side] = faceOf(arc);
    }
    if (faces[0] == faces[1])
    {
      continue;
    }
    const double weight = 0.5 * (ofSides[0] + ofSides[1]);
    const double ratio = std::log(ofSides[1] / ofSides[0]);
    for (const std::size_t i : { 0, 1 })
    {
      right[faces[i]] += (i == 0 ? weight : -weight) * ratio;
      for (const std::size_t j : { 0, 1 })
      {
        if (faces[i] > 0 && faces[j] > 0)
        {
          entries.emplace_back(faces[i] - 1, faces[j] - 1, i == j ? weight : -weight);
        }
      }
    }
  }
  Eigen::VectorXd logarithms = Eigen::VectorXd::Zero(count);
  if (count > 1)
  {
    Eigen::SparseMatrix<double> matrix(count - 1, count - 1);
    matrix.setFromTriplets(entries.begin(), entries.end());
    std::vector<int> order(Index(static_cast<int>(count)) - 1);
    std::iota(order.begin(), order.end(), 0);
    logarithms.tail(count - 1) = SparseCholesky(matrix, order).Solve(right.tail(count - 1));
  }
  const Eigen::VectorXd factors = logarithms.array().exp();
  const double scale = std::sqrt(areas.sum() / areas.dot(factors.cwiseAbs2()));
  for (int a = 0; a < static_cast<int>(mesh.arcs.size()); ++a)
  {
    lengths[Index(a)] *= scale * factors[faceOf(a)];
  }
}
}
