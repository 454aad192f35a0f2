#include "LineSides.h"

#include "Index.h"
#include "SparseCholesky.h"

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

UnionFind JoinArcs(const TMesh& mesh)
{
  UnionFind faces(mesh.arcs.size());
  for (const TPatch& patch : mesh.patches)
  {
    const int first = patch.sides[0].front() / 2;
    for (const std::vector<int>& side : patch.sides)
    {
      for (const int half : side)
      {
        faces.Join(half / 2, first);
      }
    }
  }
  return faces;
}

void MatchFaces(const TMesh& mesh, const std::vector<CountSum>& sums, std::vector<double>& lengths)
{
  UnionFind arcs = JoinArcs(mesh);
  std::map<int, int> number; // of faces
  for (int a = 0; a < static_cast<int>(mesh.arcs.size()); ++a)
  {
    number.emplace(arcs.Find(a), static_cast<int>(number.size()));
  }
  const auto faceOf = [&](int arc) { return number.at(arcs.Find(arc)); };
  const auto count = static_cast<Eigen::Index>(number.size());
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
