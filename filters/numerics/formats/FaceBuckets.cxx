#include "FaceBuckets.h"

#include "CellLattice.h"
#include "Index.h"

#include <algorithm>

namespace crossfield
{
FaceBuckets::FaceBuckets(const ExportMesh& mesh)
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
    this->Faces[next[Index(smallest[i])]++] = static_cast<int>(i);
  }
}

FaceBuckets::Key FaceBuckets::MakeKey(const int* corners, std::size_t count)
{
  Key key{};
  key.fill(corners[0]);
  std::size_t different = 0;
  for (std::size_t i = 0; i < count; ++i) // insertion sort: short, and called for every face
  {
    std::size_t place = different;
    while (place > 0 && key[place - 1] > corners[i])
    {
      --place;
    }
    if (place > 0 && key[place - 1] == corners[i])
    {
      continue;
    }
    for (std::size_t k = different; k > place; --k)
    {
      key[k] = key[k - 1];
    }
    key[place] = corners[i];
    ++different;
  }
  for (std::size_t k = different; k < key.size(); ++k)
  {
    key[k] = key[different - 1];
  }
  return key;
}

FaceBuckets::Key FaceBuckets::KeyOf(std::size_t face) const
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

SideFace FaceBuckets::FaceOf(std::size_t face) const
{
  return { static_cast<int>(face / this->FacesOfCell), static_cast<int>(face % this->FacesOfCell) };
}

std::size_t FaceBuckets::NumberOf(const SideFace& face) const
{
  return Index(face.cell) * this->FacesOfCell + Index(face.face);
}

std::vector<std::size_t> FaceBuckets::Find(const Key& key) const
{
  std::vector<std::size_t> found;
  for (std::size_t i = this->Starts[Index(key[0])]; i < this->Starts[Index(key[0]) + 1]; ++i)
  {
    const std::size_t face = Index(this->Faces[i]);
    if (this->KeyOf(face) == key)
    {
      found.push_back(face);
    }
  }
  return found;
}

std::vector<int> FaceBuckets::FindPartners() const
{
  std::vector<int> partners(this->Count(), Alone);
  std::vector<Key> keys;
  for (std::size_t point = 0; point + 1 < this->Starts.size(); ++point)
  {
    keys.clear();
    const std::size_t first = this->Starts[point];
    for (std::size_t i = first; i < this->Starts[point + 1]; ++i)
    {
      const Key key = this->KeyOf(Index(this->Faces[i]));
      int& partner = partners[Index(this->Faces[i])];
      const auto twin = std::find(keys.begin(), keys.end(), key);
      if (this->Mesh.dimension == 3 && key[1] == key[2])
      {
        partner = Line;
      }
      else if (twin != keys.end())
      {
        partner = this->Faces[first + static_cast<std::size_t>(twin - keys.begin())];
        partners[Index(partner)] = this->Faces[i];
      }
      keys.push_back(key);
    }
  }
  return partners;
}
}
