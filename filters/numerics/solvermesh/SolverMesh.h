#pragma once

#include "PlaneCurve.h"

#include <Eigen/Core>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace crossfield
{
/// A structured block: cells in columns, rows and, in three dimensions, layers.
struct MeshBlock
{
  std::array<int, 3> cells = { 1, 1, 0 }; ///< Numbers of cells; the last is 0 in two dimensions.
  /// Points at the corners of cells, one more than cells along each direction, the first index fastest.
  std::vector<int> nodes;

  /// Returns the place in `nodes` of the point at a column, row and layer.
  std::size_t PlaceOf(const std::array<int, 3>& index) const;
  /// Returns the point at a column, row and layer.
  int NodeAt(const std::array<int, 3>& index) const { return this->nodes[this->PlaceOf(index)]; }
};

/// Calls a function with all indices from `low` to `high`, both included, the first fastest.
template <class Function>
void ForEachIndex(
  const std::array<int, 3>& low, const std::array<int, 3>& high, const Function& function)
{
  std::array<int, 3> index{};
  for (index[2] = low[2]; index[2] <= high[2]; ++index[2])
  {
    for (index[1] = low[1]; index[1] <= high[1]; ++index[1])
    {
      for (index[0] = low[0]; index[0] <= high[0]; ++index[0])
      {
        function(std::as_const(index));
      }
    }
  }
}

/// The two ends of a mesh that was swept (SweepQuads.h).
struct SweepEnds
{
  int back = -1;           ///< Side at the start of the sweep, −1 if there is none.
  int front = -1;          ///< Side at its end, −1 if there is none.
  int layers = 0;          ///< 0 if the mesh was not swept.
  bool isRotation = false; ///< Whether the sweep was a revolution, not a translation.
};

/// Two sides whose nodes match one by one under a motion, such as those of a rotor's sector.
struct SidePair
{
  int first = 0; ///< Index of a side.
  int second = 0;
  /// Takes points (x, y, z, 1) of the first side to those of the second: a translation or rotation.
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
};

/// Where the parts of a mesh come from: numbers in the data that it was read from. RaiseOrder and SweepQuads keep
/// them. Without an entry, a part has its own number.
struct MeshSources
{
  std::vector<int> points; ///< Per point, −1 if RaiseOrder added it.
  std::vector<int> cells;  ///< Per cell.
  std::vector<int> faces;  ///< Per boundary face, −1 at the ends of a sweep.
};

/// The mesh after smoothing: quads or hexahedra with regions, and boundary faces with sides, as solvers read them.
///
/// The nodes of a cell of order p are a lattice of (p + 1)^dimension points, the first index fastest: of a
/// quad, the row from corner 0 to corner 1 comes first and the row from corner 3 to corner 2 last; of a
/// hexahedron, the lattice of the bottom (0, 1, 2, 3) comes first and that of the top (4, 5, 6, 7) last.
/// Corners have the order of VTK_QUAD and VTK_HEXAHEDRON (CellLattice.h). Faces, which are edges in two dimensions,
/// are given by their corners, since their other nodes are those of the cell; a triangle repeats one.
struct SolverMesh
{
  int dimension = 2; ///< 2 for quads, 3 for hexahedra.
  int order = 1;     ///< 1 to 3; hexahedra 1 or 2.
  std::vector<Eigen::Vector3d> points;
  std::vector<int> cells;               ///< Nodes of all cells, one cell after the other.
  std::vector<int> region;              ///< Per cell, index of its region.
  std::vector<std::string> regionNames; ///< Different from each other, as are those of sides.
  std::vector<int> faces; ///< Corners of all boundary faces, 2 or 4 each, in any direction.
  std::vector<int> side;  ///< Per face, index of its side.
  std::vector<std::string> sideNames;
  /// Types of patches in OpenFOAM by names of sides; others have the default (FoamMesh.h).
  std::map<std::string, std::string> patchTypes;
  std::vector<int> curve; ///< Per face, index of its curve, −1 without one; empty without curves.
  std::vector<PlaneCurve> curves; ///< In coordinates of the plane of quads (DomainPlane.h).
  std::vector<MeshBlock> blocks;  ///< Right-handed, of all cells; empty if they are not known.
  SweepEnds sweep;
  std::vector<SidePair> pairs; ///< Periodic sides; MatchPair finds the nodes that match.
  MeshSources sources;

  int NodesOfCell() const; ///< (order + 1)^dimension
  int CornersOfFace() const { return this->dimension == 2 ? 2 : 4; }
  int CellCount() const { return static_cast<int>(this->region.size()); }
  int FaceCount() const { return static_cast<int>(this->side.size()); }
  /// Returns the nodes of a cell.
  const int* Cell(int cell) const;
  /// Returns whether a hexahedron is a prism: two neighbouring corners of the bottom are also
  /// the corners above them. Returns the first of them, 0 to 3, or −1.
  int CollapsedEdge(int cell) const;
  bool HasConstantHeight() const; ///< Whether all points have the same z.
};

/// Returns the place of a point in space for messages.
std::string PlaceOf(const SolverMesh& mesh, int point);

/// Makes all hexahedra right-handed and, if z is constant, all quads counter-clockwise. Nodes that are
/// not points of the mesh, points that are not finite and orders without a lattice are an Error.
void OrientCells(SolverMesh& mesh);
}
