#pragma once

#include "QuadBlocks.h"
#include "QuadMesh.h"

#include <Eigen/Core>

namespace crossfield
{
/// A block's points with the lengths wanted in its cells.
struct QuadLattice
{
  int width = 0;
  int height = 0;
  std::vector<int> points;                   ///< (width + 1) (height + 1), i fastest.
  std::vector<std::array<double, 2>> wanted; ///< Along i and j, per cell,
  std::vector<double> weights;               ///< and how many quads it is.
};

std::vector<QuadLattice> LatticesOf(const QuadMesh& mesh, const QuadBlocks& blocks);

/// About every second line of a mesh's blocks, with the points that the mesh has there (docs/method.md §14.5). Which lines of
/// a side are kept depends on their number alone and is the same from both ends, so blocks agree about the sides
/// that they share.
///
/// Moves of points are two numbers each as in QuadEnergy. From the coarser to the finer mesh they are interpolated
/// bilinearly in the lattices, places inside and lengths on the boundary; gradients go the other way by the transpose.
class CoarseQuads
{
public:
  CoarseQuads(const QuadMesh& fineMesh, const std::vector<QuadLattice>& fineLattices);

  QuadMesh mesh;                     ///< To be moved.
  std::vector<double> weights;       ///< How many quads each of its quads is.
  std::vector<QuadLattice> lattices; ///< Of it.

  /// By half at least: else it is not worth while.
  bool IsSmaller() const { return 2 * this->mesh.quads.size() <= this->Fine.quads.size(); }
  Eigen::VectorXd Prolong(const BoundaryCurves& curves, const Eigen::VectorXd& moves) const;
  /// The way of every point inside to the place between the corners of its cell, and on the boundary of `moves` as by Prolong.
  Eigen::VectorXd Interpolate(const BoundaryCurves& curves, const Eigen::VectorXd& moves) const;
  Eigen::VectorXd Restrict(const BoundaryCurves& curves, const Eigen::VectorXd& gradient) const;

private:
  /// Of a point of the finer mesh the corners of its cell, with their parts.
  struct Link
  {
    int fine;
    std::array<int, 4> coarse;
    std::array<double, 4> parts;
  };
  template <typename Function>
  void ForEachLink(const Function& function) const;
  /// The direction in which a point of the boundary moves, by number.
  Eigen::VectorXd Tangents(const BoundaryCurves& curves) const;

  const QuadMesh& Fine;
  const std::vector<QuadLattice>& FineLattices;
};

/// The lines of n that are kept, 0 and n among them; all where they are few.
std::vector<int> KeptLines(int count);
}
