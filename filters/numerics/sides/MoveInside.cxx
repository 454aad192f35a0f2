#include "MoveInside.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <utility>

namespace crossfield
{
void MoveInside(const std::vector<QuadPoint>& before, bool hold, QuadMesh& mesh)
{
  const std::size_t count = mesh.points.size();
  std::vector<Eigen::Index> unknown(count, -1);
  Eigen::Index unknowns = 0;
  for (std::size_t p = 0; p < count; ++p)
  {
    if (mesh.points[p].curve.loop < 0 && !(hold && mesh.points[p].fixed))
    {
      unknown[p] = unknowns++;
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(unknowns, 3);
  for (const std::array<int, 4>& quad : mesh.quads)
  {
    for (std::size_t side = 0; side < 4; ++side)
    {
      // every inner edge has two quads, which add one half-edge each
      for (const auto& [from, to] : { std::pair(quad[side], quad[(side + 1) % 4]),
             std::pair(quad[(side + 1) % 4], quad[side]) })
      {
        const Eigen::Index row = unknown[from];
        if (row < 0)
        {
          continue;
        }
        entries.emplace_back(row, row, 1.0);
        if (unknown[to] >= 0)
        {
          entries.emplace_back(row, unknown[to], -1.0);
        }
        else
        {
          right.row(row) += (mesh.points[to].place - before[to].place).transpose();
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(matrix);
  solver.setTolerance(1e-4); // only a start for the smoothing
  const Eigen::MatrixX3d moves = solver.solve(right);
  for (std::size_t p = 0; p < count; ++p)
  {
    if (unknown[p] >= 0)
    {
      mesh.points[p].place += moves.row(unknown[p]).transpose();
    }
  }
}
}
