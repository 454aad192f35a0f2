#include "BlockFaces.h"

#include "Error.h"
#include "Index.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
namespace
{
/// How the indices along two rectangles correspond.
struct Orientation
{
  bool isSwapped = false;
  std::array<bool, 2> isReversed{}; ///< Per index of the second rectangle.
};

/// A side of a block as a lattice of columns × rows faces; one row in two dimensions.
struct Side
{
  int block = 0;
  int face = 0;
  std::array<int, 2> along{}; ///< Directions of columns and rows.
  std::array<int, 2> size{};  ///< Numbers of columns and rows.
  int first = 0;              ///< Number of its first face.
};

using Place = std::array<int, 2>; // column and row of a face or a point

class Finder
{
public:
  Finder(const SolverMesh& mesh, const MeshFaces& faces)
    : Mesh(mesh)
    , Faces(faces)
    , IsFlat(mesh.dimension == 2)
  {
    this->AddSides();
    this->Match();
  }

  BlockFaces Find()
  {
    BlockFaces faces;
    for (std::size_t face = 0; face < this->SideOf.size(); ++face)
    {
      const Side& side = this->Sides[this->SideOf[face]];
      const Place begin = this->PlaceOfFace(static_cast<int>(face));
      if (this->Taken[face])
      {
        continue;
      }
      if (this->Partner[face] >= 0)
      {
        faces.connections.push_back(this->Connect(side, begin));
        continue;
      }
      const int label = this->Label[face];
      const Place end = this->Grow(side, begin,
        [&](const Place& place)
        {
          const std::size_t other = Index(At(side, place));
          return !this->Taken[other] && this->Partner[other] < 0 && this->Label[other] == label;
        });
      this->Take(side, begin, end);
      const BlockRange range = this->RangeOf(side, begin, end);
      if (label == Collapsed)
      {
        faces.collapsed.push_back(range);
      }
      else
      {
        faces.patches.push_back({ range, label });
      }
    }
    return faces;
  }

private:
  static constexpr int Collapsed = -1;

  void AddSides()
  {
    const int dimension = this->Mesh.dimension;
    int first = 0;
    for (std::size_t b = 0; b < this->Mesh.blocks.size(); ++b)
    {
      const MeshBlock& block = this->Mesh.blocks[b];
      for (int face = 0; face < 2 * dimension; ++face)
      {
        Side side{ static_cast<int>(b), face, { face < 2 ? 1 : 0, face < 4 ? 2 : 1 }, {}, first };
        side.size = { block.cells[side.along[0]], this->IsFlat ? 1 : block.cells[side.along[1]] };
        first += side.size[0] * side.size[1];
        this->Sides.push_back(side);
        this->SideOf.resize(Index(first), static_cast<int>(this->Sides.size()) - 1);
      }
    }
    this->Taken.resize(Index(first), false);
    this->Stamp.resize(Index(first), 0);
    this->Partner.resize(Index(first), -1);
    this->Label.resize(Index(first), Collapsed);
  }

  static int At(const Side& side, const Place& place)
  {
    return side.first + place[0] + side.size[0] * place[1];
  }

  Place PlaceOfFace(int face) const
  {
    const Side& side = this->Sides[this->SideOf[face]];
    return { (face - side.first) % side.size[0], (face - side.first) / side.size[0] };
  }

  /// Returns the indices in the block of a point of a side.
  std::array<int, 3> IndexOf(const Side& side, const Place& point) const
  {
    std::array<int, 3> index{};
    const std::size_t across = Index(side.face / 2);
    index[across] = side.face % 2 == 0 ? 0 : this->Mesh.blocks[side.block].cells[across];
    index[side.along[0]] = point[0];
    index[side.along[1]] = this->IsFlat ? 0 : point[1];
    return index;
  }

  int Node(const Side& side, const Place& point) const
  {
    const MeshBlock& block = this->Mesh.blocks[side.block];
    return block.NodeAt(this->IndexOf(side, point));
  }

  MeshFaces::Key KeyOf(const Side& side, const Place& face) const
  {
    MeshFaces::Key key{};
    const int corners = this->Mesh.CornersOfFace();
    for (int i = 0; i < corners; ++i)
    {
      key[i] = this->Node(side, { face[0] + i % 2, face[1] + i / 2 });
    }
    return MeshFaces::MakeKey(key.data(), Index(corners));
  }

  bool IsCollapsed(const MeshFaces::Key& key) const
  {
    return this->IsFlat ? key[0] == key[1] : key[1] == key[3];
  }

  /// Finds the partner or the side of the mesh of every face.
  void Match()
  {
    std::vector<std::pair<MeshFaces::Key, int>> faces;
    for (int face = 0; face < static_cast<int>(this->SideOf.size()); ++face)
    {
      const MeshFaces::Key key =
        this->KeyOf(this->Sides[this->SideOf[face]], this->PlaceOfFace(face));
      if (!this->IsCollapsed(key))
      {
        faces.emplace_back(key, face);
      }
    }
    std::sort(faces.begin(), faces.end());
    for (std::size_t i = 0, end = 0; i < faces.size(); i = end)
    {
      const MeshFaces::Key& key = faces[i].first;
      while (end < faces.size() && faces[end].first == key)
      {
        ++end;
      }
      const int side = this->Faces.SideOf(key);
      const bool isInside = end - i == 2;
      if (end - i > 2 || isInside != (side < 0))
      {
        throw Error(
          (end - i > 2 ? "More than two blocks meet " : "The blocks differ from the cells ") +
          this->PlaceOfKey(key) + ", so the mesh is damaged; make it again.");
      }
      this->Label[faces[i].second] = side;
      this->Partner[faces[i].second] = isInside ? faces[i + 1].second : -1;
      this->Partner[faces[end - 1].second] = isInside ? faces[i].second : -1;
    }
  }

  std::string PlaceOfKey(const MeshFaces::Key& key) const
  {
    return "at " + PlaceOf(this->Mesh, key[0]);
  }

  /// Returns the place after the last face of the largest rectangle that begins at a face and whose
  /// faces are all accepted, or `begin` if none is; columns are added first.
  template <typename Accepts>
  Place Grow(const Side& side, const Place& begin, const Accepts& accepts) const
  {
    Place end = { begin[0], begin[1] + 1 };
    while (end[0] < side.size[0] && accepts({ end[0], begin[1] }))
    {
      ++end[0];
    }
    if (end[0] == begin[0])
    {
      return begin;
    }
    for (bool isWhole = true; isWhole && end[1] < side.size[1];)
    {
      for (int column = begin[0]; isWhole && column < end[0]; ++column)
      {
        isWhole = accepts({ column, end[1] });
      }
      end[1] += isWhole ? 1 : 0;
    }
    return end;
  }

  void Take(const Side& side, const Place& begin, const Place& end)
  {
    for (int row = begin[1]; row < end[1]; ++row)
    {
      for (int column = begin[0]; column < end[0]; ++column)
      {
        this->Taken[At(side, { column, row })] = true;
      }
    }
  }

  BlockRange RangeOf(const Side& side, const Place& begin, const Place& end) const
  {
    return { side.block, side.face, this->IndexOf(side, begin), this->IndexOf(side, end) };
  }

  /// Returns the place of a point (`isPoint`) or face on the other side; `from` and `to` are faces that
  /// correspond to each other.
  static Place Image(
    const Place& place, const Place& from, const Place& to, const Orientation& way, bool isPoint)
  {
    Place image{};
    for (std::size_t i = 0; i < 2; ++i)
    {
      const std::size_t j = way.isSwapped ? 1 - i : i;
      const int step = place[j] - from[j];
      image[i] = to[i] + (way.isReversed[i] ? (isPoint ? 1 : 0) - step : step);
    }
    return image;
  }

  /// Returns whether the corners of a face are those of its image.
  bool Fits(const Side& side, const Place& face, const Side& other, const Place& image,
    const Orientation& way) const
  {
    for (int corner = 0; corner < (this->IsFlat ? 2 : 4); ++corner)
    {
      const Place point = { face[0] + corner % 2, face[1] + corner / 2 };
      if (this->Node(side, point) != this->Node(other, Image(point, face, image, way, true)))
      {
        return false;
      }
    }
    return true;
  }

  BlockConnection Connect(const Side& side, const Place& begin)
  {
    const int partner = this->Partner[At(side, begin)];
    const Side& other = this->Sides[this->SideOf[partner]];
    const Place image = this->PlaceOfFace(partner);
    Orientation best;
    Place bestEnd = begin;
    for (int i = 0; i < (this->IsFlat ? 2 : 8); ++i) // several fit a triangle
    {
      const Orientation way = { (i & 4) != 0, { (i & 1) != 0, (i & 2) != 0 } };
      ++this->Trial;
      const Place end = this->Grow(side, begin,
        [&](const Place& place)
        {
          const int face = At(side, place);
          const int match = this->Partner[face];
          const Place there = Image(place, begin, image, way, false);
          // The stamps keep a rectangle from meeting its own image.
          const bool isGood = match >= 0 && !this->Taken[face] &&
            this->Stamp[face] != this->Trial && &this->Sides[this->SideOf[match]] == &other &&
            this->PlaceOfFace(match) == there && this->Fits(side, place, other, there, way);
          if (isGood)
          {
            this->Stamp[match] = this->Trial;
          }
          return isGood;
        });
      if ((end[0] - begin[0]) * (end[1] - begin[1]) >
        (bestEnd[0] - begin[0]) * (bestEnd[1] - begin[1]))
      {
        best = way;
        bestEnd = end;
      }
    }
    if (bestEnd == begin)
    {
      throw Error("Two blocks meet in twisted faces " + this->PlaceOfKey(this->KeyOf(side, begin)) +
        ", so the mesh is damaged; make it again.");
    }
    return this->ConnectionOf(side, begin, bestEnd, other, image, best);
  }

  BlockConnection ConnectionOf(const Side& side, const Place& begin, const Place& end,
    const Side& other, const Place& image, const Orientation& way)
  {
    const Place imageBegin = Image(begin, begin, image, way, true);
    const Place imageEnd = Image(end, begin, image, way, true);
    const Place low = { std::min(imageBegin[0], imageEnd[0]),
      std::min(imageBegin[1], imageEnd[1]) };
    Place high = { std::max(imageBegin[0], imageEnd[0]), std::max(imageBegin[1], imageEnd[1]) };
    this->Take(side, begin, end);
    this->Take(other, low, high);
    BlockConnection connection = { this->RangeOf(side, begin, end),
      this->RangeOf(other, imageBegin, imageEnd), {} };
    // Across, the step leaves the first block and enters the second.
    connection.transform[side.face / 2] =
      (1 + other.face / 2) * (side.face % 2 == other.face % 2 ? -1 : 1);
    for (std::size_t i = 0; i < (this->IsFlat ? 1U : 2U); ++i)
    {
      const std::size_t j = way.isSwapped ? 1 - i : i;
      connection.transform[side.along[j]] = (1 + other.along[i]) * (way.isReversed[i] ? -1 : 1);
    }
    return connection;
  }

  const SolverMesh& Mesh;
  const MeshFaces& Faces;
  bool IsFlat;
  std::vector<Side> Sides;
  std::vector<int> SideOf;  ///< Per face, its side.
  std::vector<bool> Taken;  ///< Per face, whether it is in a result.
  std::vector<int> Stamp;   ///< Per face, the last trial that it was the image of a face in.
  std::vector<int> Partner; ///< Per face, the face with the same corners, or −1.
  std::vector<int> Label;   ///< Per face without a partner, its side of the mesh, or Collapsed.
  int Trial = 0;
};
}

BlockFaces FindBlockFaces(const SolverMesh& mesh, const MeshFaces& faces)
{
  return Finder(mesh, faces).Find();
}
}
