#include "MeshFaces.h"

#include "CellLattice.h"
#include "Error.h"
#include "Index.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
MeshFaces::MeshFaces(const SolverMesh& mesh)
  : Mesh(mesh)
  , FacesOfCell(mesh.dimension == 2 ? 4 : 6)
  , Starts(mesh.points.size() + 1, 0)
{
  const CellLattice lattice(mesh.dimension, mesh.order);
  for (int face = 0; face < lattice.FaceCount(); ++face)
  {
    this->Corners.push_back(lattice.FaceCorners(face));
  }
  const std::size_t count = mesh.region.size() * this->FacesOfCell;
  std::vector<int> smallest(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    smallest[i] = this->KeyOf(i)[0];
    ++this->Starts[Index(smallest[i]) + 1];
  }
  for (std::size_t point = 0; point < mesh.points.size(); ++point)
  {
    this->Starts[point + 1] += this->Starts[point];
  }
  this->Faces.resize(count);
  std::vector<std::size_t> next(this->Starts.begin(), this->Starts.end() - 1);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Faces[next[smallest[i]]++] = static_cast<int>(i);
  }
  this->FindPartners();
  this->FindSides();
}

MeshFaces::Key MeshFaces::MakeKey(const int* corners, std::size_t count)
{
  Key key{};
  key.fill(corners[0]);
  std::copy(corners, corners + count, key.begin());
  std::sort(key.begin(), key.end());
  const auto end = std::unique(key.begin(), key.end());
  std::fill(end, key.end(), *(end - 1));
  return key;
}

MeshFaces::Key MeshFaces::KeyOf(std::size_t face) const
{
  const int* nodes = this->Mesh.Cell(static_cast<int>(face / this->FacesOfCell));
  const std::vector<int>& positions = this->Corners[face % this->FacesOfCell];
  Key corners{};
  for (std::size_t c = 0; c < positions.size(); ++c)
  {
    corners[c] = nodes[positions[c]];
  }
  return MakeKey(corners.data(), positions.size());
}

std::vector<std::size_t> MeshFaces::Find(const Key& key) const
{
  std::vector<std::size_t> found;
  for (std::size_t i = this->Starts[key[0]]; i < this->Starts[Index(key[0]) + 1]; ++i)
  {
    const std::size_t face = Index(this->Faces[i]);
    if (this->KeyOf(face) == key)
    {
      found.push_back(face);
    }
  }
  return found;
}

void MeshFaces::FindPartners()
{
  this->PartnerOfFace.assign(this->Count(), Alone);
  std::vector<Key> keys;
  for (std::size_t point = 0; point + 1 < this->Starts.size(); ++point)
  {
    keys.clear();
    const std::size_t first = this->Starts[point];
    for (std::size_t i = first; i < this->Starts[point + 1]; ++i)
    {
      const Key key = this->KeyOf(Index(this->Faces[i]));
      int& partner = this->PartnerOfFace[this->Faces[i]];
      const auto twin = std::find(keys.begin(), keys.end(), key);
      if (this->Mesh.dimension == 3 && key[1] == key[2])
      {
        partner = Line;
      }
      else if (twin != keys.end())
      {
        partner = this->Faces[first + static_cast<std::size_t>(twin - keys.begin())];
        this->PartnerOfFace[partner] = this->Faces[i];
      }
      keys.push_back(key);
    }
  }
}

void MeshFaces::FindSides()
{
  const std::string kind = this->Mesh.dimension == 2 ? "edge" : "face";
  const std::string article = this->Mesh.dimension == 2 ? "an " : "a ";
  this->FacesOfSide.resize(this->Mesh.sideNames.size());
  this->Inside.assign(this->Mesh.sideNames.size(), false);
  this->SideOfFace.assign(this->Count(), -1);
  const std::size_t corners = Index(this->Mesh.CornersOfFace());
  for (int i = 0; i < this->Mesh.FaceCount(); ++i)
  {
    const Key key = MakeKey(this->Mesh.faces.data() + Index(i) * corners, corners);
    const std::vector<std::size_t> found = this->Find(key);
    const int side = this->Mesh.side[i];
    if (found.empty() || this->SideOfFace[found[0]] >= 0)
    {
      throw Error("Side '" + this->Mesh.sideNames[side] + "' has " + article + kind + " at " +
        PlaceOf(this->Mesh, key[0]) +
        (found.empty() ? " that belongs to no cell" : " that is given twice") +
        "; give the boundary of this mesh.");
    }
    for (const std::size_t face : found)
    {
      this->SideOfFace[face] = side;
    }
    this->Inside[side] = this->Inside[side] || found.size() > 1;
    this->OfBoundary.push_back(this->FaceOf(found[0]));
    this->FacesOfSide[side].push_back(this->OfBoundary.back());
  }
  for (std::size_t i = 0; i < this->Count(); ++i)
  {
    if (this->SideOfFace[i] < 0 && this->PartnerOfFace[i] == Alone)
    {
      throw Error("The " + kind + " of the boundary at " + PlaceOf(this->Mesh, this->KeyOf(i)[0]) +
        " belongs to no side; give all edges of the boundary.");
    }
  }
}

int MeshFaces::SideOf(const Key& key) const
{
  const std::vector<std::size_t> found = this->Find(key);
  const int side = found.size() == 1 ? this->SideOfFace[found[0]] : -1;
  return side >= 0 && this->IsInside(side) ? -1 : side;
}

void RemoveInnerSides(SolverMesh& mesh)
{
  const MeshFaces faces(mesh);
  std::vector<int> number(mesh.sideNames.size(), -1);
  std::vector<std::string> names;
  for (std::size_t side = 0; side < number.size(); ++side)
  {
    if (!faces.IsInside(static_cast<int>(side)))
    {
      number[side] = static_cast<int>(names.size());
      names.push_back(mesh.sideNames[side]);
    }
  }
  const std::size_t corners = Index(mesh.CornersOfFace());
  std::size_t kept = 0;
  for (std::size_t face = 0; face < mesh.side.size(); ++face)
  {
    const int side = number[Index(mesh.side[face])];
    if (side < 0)
    {
      continue;
    }
    std::copy_n(mesh.faces.begin() + static_cast<std::ptrdiff_t>(face * corners), corners,
      mesh.faces.begin() + static_cast<std::ptrdiff_t>(kept * corners));
    mesh.side[kept] = side;
    for (std::vector<int>* const of : { &mesh.curve, &mesh.sources.faces })
    {
      if (!of->empty())
      {
        (*of)[kept] = (*of)[face];
      }
    }
    ++kept;
  }
  mesh.faces.resize(kept * corners);
  mesh.side.resize(kept);
  for (std::vector<int>* const of : { &mesh.curve, &mesh.sources.faces })
  {
    of->resize(std::min(of->size(), kept));
  }
  mesh.sideNames = std::move(names);
  for (int* const end : { &mesh.sweep.back, &mesh.sweep.front })
  {
    *end = *end < 0 ? -1 : number[Index(*end)];
  }
  for (SidePair& pair : mesh.pairs)
  {
    pair.first = number[Index(pair.first)];
    pair.second = number[Index(pair.second)];
  }
}
}
