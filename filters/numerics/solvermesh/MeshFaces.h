#pragma once

#include "Index.h"
#include "SolverMesh.h"

#include <array>
#include <string>
#include <vector>

namespace crossfield
{
/// A face of a cell.
struct CellFace
{
  int cell = 0;
  int face = 0; ///< Number of the face in the cell (CellLattice.h).
};

/// The faces of all cells of a mesh: which have the same corners, and which are in a side. A face is given by its
/// number in all cells: cell · faces of a cell + face. The object refers to the mesh.
class MeshFaces
{
public:
  /// The different corners of a face in ascending order, then the last one again.
  using Key = std::array<int, 4>;

  /// Returns the key of `count` corners, 1 to 4.
  static Key MakeKey(const int* corners, std::size_t count);

  enum Partners
  {
    Alone = -1, ///< No other cell has these corners: the face is on the boundary.
    Line = -2   ///< The corners are two points: a face of a prism that has no area.
  };

  /// Finds the cells of all boundary faces of a mesh whose nodes are valid (OrientCells). Throws Error if a
  /// boundary face belongs to no cell or is given twice, or if a face with one cell is missing.
  explicit MeshFaces(const SolverMesh& mesh);

  std::size_t Count() const { return this->Faces.size(); }
  Key KeyOf(std::size_t face) const;
  CellFace FaceOf(std::size_t face) const
  {
    return { static_cast<int>(face / this->FacesOfCell),
      static_cast<int>(face % this->FacesOfCell) };
  }
  std::size_t NumberOf(const CellFace& face) const
  {
    return Index(face.cell) * this->FacesOfCell + Index(face.face);
  }

  /// Returns another face with the same corners, or one of Partners.
  int PartnerOf(std::size_t face) const { return this->PartnerOfFace[face]; }

  /// Returns whether a face is one of a side, on the boundary or inside.
  bool HasSide(std::size_t face) const { return this->SideOfFace[face] >= 0; }

  /// Returns the side on the boundary that has a face with these corners, −1 if they are inside or no face.
  int SideOf(const Key& key) const;

  /// Returns per boundary face of the mesh the face of a cell.
  const std::vector<CellFace>& BoundaryFaces() const { return this->OfBoundary; }
  /// Returns the boundary faces of all sides, in the order of the mesh.
  const std::vector<std::vector<CellFace>>& OfSides() const { return this->FacesOfSide; }
  const std::vector<CellFace>& OfSide(int side) const { return this->FacesOfSide[side]; }
  /// Returns whether there are cells on both sides of a face of a side.
  bool IsInside(int side) const { return this->Inside[side]; }

private:
  std::vector<std::size_t> Find(const Key& key) const;
  void FindPartners();
  void FindSides();

  const SolverMesh& Mesh;
  std::size_t FacesOfCell;
  std::vector<std::vector<int>> Corners; ///< Per face of a cell, positions of its corners.
  std::vector<std::size_t> Starts;       ///< Per point, the beginning of its bucket.
  std::vector<int> Faces;                ///< Of all buckets, by their smallest corner.
  std::vector<int> PartnerOfFace;
  std::vector<int> SideOfFace; ///< Per face, −1 if it is in no side.
  std::vector<CellFace> OfBoundary;
  std::vector<std::vector<CellFace>> FacesOfSide;
  std::vector<bool> Inside; ///< Per side.
};

/// Removes the sides that are inside, such as interfaces of materials, with their faces.
void RemoveInnerSides(SolverMesh& mesh);
}
