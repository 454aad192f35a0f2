#pragma once

#include "ExportMesh.h"

#include <array>
#include <vector>

namespace crossfield
{
/// A boundary face as a part of a cell.
struct SideFace
{
  int cell = 0;
  int face = 0; ///< Number of the face in the cell (CellLattice.h).
};

/// The faces of all cells of a mesh, found by their corners. A face is given by its number in all cells: cell ·
/// faces of a cell + face. The object refers to the mesh.
class FaceBuckets
{
public:
  /// The different corners of a face in ascending order, then the last one again.
  using Key = std::array<int, 4>;

  /// Returns the key of `count` corners.
  static Key MakeKey(const int* corners, std::size_t count);

  enum Partners
  {
    Alone = -1, ///< No other cell has these corners: the face is on the boundary.
    Line = -2   ///< The corners are two points: a face of a prism that has no area.
  };

  explicit FaceBuckets(const ExportMesh& mesh);

  std::size_t Count() const { return this->Faces.size(); }
  Key KeyOf(std::size_t face) const;
  SideFace FaceOf(std::size_t face) const;
  std::size_t NumberOf(const SideFace& face) const;

  /// Returns the faces with these corners.
  std::vector<std::size_t> Find(const Key& key) const;

  /// Returns per face another one with the same corners, or one of Partners.
  std::vector<int> FindPartners() const;

private:
  const ExportMesh& Mesh;
  std::size_t FacesOfCell;
  std::vector<std::vector<int>> Corners; ///< Per face of a cell, positions of its corners.
  std::vector<std::size_t> Starts;       ///< Per point, the beginning of its bucket.
  std::vector<int> Faces;                ///< Of all buckets, by their smallest corner.
};
}
