#pragma once

#include "QuadBlocks.h"
#include "TangentFrames.h"

#include <Eigen/Core>

namespace crossfield
{
/// The points of a block, with the target lengths of its cells.
struct QuadLattice
{
  int width = 0;
  int height = 0;
  std::vector<int> points;                          ///< (width + 1) (height + 1), i fastest.
  std::vector<std::array<double, 2>> targetLengths; ///< Per cell, along i and j.
  std::vector<double>
    weights; ///< Per cell, the number of quads of the finest mesh that it represents.
};

/// Returns the lattices of all blocks, with weight 1 for each cell.
std::vector<QuadLattice> LatticesOf(const QuadMesh& mesh, const QuadBlocks& blocks);

/// A coarser mesh of about every second grid line of the blocks, with the points of the finer mesh
/// (docs/method.md §14.5). Which lines remain depends only on their number, and is symmetric, so
/// blocks agree on the sides that they share. Points of periodic sides of which only one of two images
/// remains are fixed.
///
/// Displacements are two numbers per point, as in QuadEnergy. They are prolonged from the coarser
/// to the finer mesh by bilinear interpolation in the lattices, of vectors in space inside and of arc
/// lengths on the boundary. Gradients are restricted by the transpose. Frames are those of the energies of both meshes.
class CoarseQuads
{
public:
  CoarseQuads(const QuadMesh& fineMesh, const std::vector<QuadLattice>& fineLattices);

  QuadMesh mesh;                     ///< The coarser mesh, whose points may be moved.
  std::vector<double> weights;       ///< Per quad, the number of quads of the finest mesh.
  std::vector<QuadLattice> lattices; ///< Lattices of the coarser mesh.

  /// Returns whether the number of quads is at most half, so that the coarser mesh is worth its
  /// cost.
  bool IsSmaller() const { return 2 * this->mesh.quads.size() <= this->Fine.quads.size(); }
  /// Interpolates displacements of the coarser mesh.
  Eigen::VectorXd Prolong(const BoundaryCurves& curves, const TangentFrames& fineFrames,
    const TangentFrames& frames, const Eigen::VectorXd& moves) const;
  /// Returns the displacement of every inner point to the interpolated position in its coarse cell;
  /// on the boundary, the displacement of Prolong.
  Eigen::VectorXd Interpolate(const BoundaryCurves& curves, const TangentFrames& fineFrames,
    const TangentFrames& frames, const Eigen::VectorXd& moves) const;
  /// Applies the transpose of Prolong to a gradient of the finer mesh.
  Eigen::VectorXd Restrict(const BoundaryCurves& curves, const TangentFrames& fineFrames,
    const TangentFrames& frames, const Eigen::VectorXd& gradient) const;

private:
  /// The interpolation of a point of the finer mesh: the corners of its coarse cell and their
  /// weights.
  struct Link
  {
    int fine;
    std::array<int, 4> coarse;
    std::array<double, 4> parts; ///< They add up to 1.
  };
  template <typename Function>
  void ForEachLink(const Function& function) const;
  /// Returns the unit tangents at the coarser mesh's boundary points, 0 inside.
  std::vector<SpacePoint> Tangents(const BoundaryCurves& curves) const;

  const QuadMesh& Fine;
  const std::vector<QuadLattice>& FineLattices;
};

/// Returns the lines out of 0, ..., count that remain, including both ends; all of them if there
/// are few.
std::vector<int> KeptLines(int count);
}
