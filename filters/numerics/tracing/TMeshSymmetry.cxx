#include "TMeshSymmetry.h"

#include "Index.h"

#include <algorithm>

namespace crossfield
{
namespace
{
constexpr int None = -1;

/// Finds the half-edges that those of a T-mesh are mapped to. One image determines all others of its connected
/// part.
class ImageSearch
{
public:
  ImageSearch(const TMesh& mesh, const Isometry& isometry, double reach)
    : Mesh(mesh)
    , Map(isometry)
    , Reach(reach)
    , Previous(mesh.halfEdges.size(), None)
    , Sides(mesh.halfEdges.size(), None)
    , Images(mesh.halfEdges.size(), None)
    , IsTaken(mesh.halfEdges.size(), false)
  {
    for (int h = 0; h < static_cast<int>(mesh.halfEdges.size()); ++h)
    {
      if (mesh.halfEdges[h].next >= 0)
      {
        this->Previous[mesh.halfEdges[h].next] = h;
      }
    }
    for (const TPatch& patch : mesh.patches)
    {
      for (int side = 0; side < 4; ++side)
      {
        for (const int half : patch.sides[Index(side)])
        {
          this->Sides[half] = side;
        }
      }
    }
  }

  /// Returns the images of all half-edges; none if there are none.
  std::vector<int> Find()
  {
    const auto count = static_cast<int>(this->Mesh.halfEdges.size());
    for (int first = 0; first < count; ++first)
    {
      int image = 0;
      while (this->Images[first] == None && image < count)
      {
        this->Spread(first, image++);
      }
      if (this->Images[first] == None)
      {
        return {};
      }
    }
    return this->Images;
  }

private:
  int EndOf(int half) const { return this->Mesh.halfEdges[TMesh::Twin(half)].node; }

  bool Fits(int node, int image) const
  {
    const TNode& from = this->Mesh.nodes[node];
    const TNode& to = this->Mesh.nodes[image];
    return from.kind == to.kind && from.quarters == to.quarters && from.isFixed == to.isFixed &&
      (this->Map(from.place.head<2>()) - to.place.head<2>()).norm() <= this->Reach;
  }
  bool NodesFit(int half, int image) const
  {
    return this->Fits(this->Mesh.halfEdges[half].node, this->Mesh.halfEdges[image].node) &&
      this->Fits(this->EndOf(half), this->EndOf(image)) &&
      this->Mesh.arcs[half / 2].onBoundary == this->Mesh.arcs[image / 2].onBoundary;
  }

  /// Returns the half-edge with the image of the patch on its left, for the image of a half-edge.
  int Beside(int image) const { return this->Map.reflects ? TMesh::Twin(image) : image; }
  /// Returns the image of the next half-edge around the patch.
  int Following(int image) const
  {
    if (!this->Map.reflects)
    {
      return this->Mesh.halfEdges[image].next;
    }
    const int previous = this->Previous[TMesh::Twin(image)];
    return previous < 0 ? None : TMesh::Twin(previous);
  }

  /// Sets the images of a connected part if one of its half-edges is mapped to a given one; changes nothing
  /// if that is impossible.
  void Spread(int first, int image)
  {
    std::vector<int> reached;
    const auto set = [&](int half, int to)
    {
      if (this->Images[half] != None)
      {
        return this->Images[half] == to;
      }
      if (this->IsTaken[to] || !this->NodesFit(half, to))
      {
        return false;
      }
      this->Images[half] = to;
      this->IsTaken[to] = true;
      reached.push_back(half);
      return true;
    };
    bool fits = set(first, image);
    for (std::size_t i = 0; i < reached.size() && fits; ++i)
    {
      const int half = reached[i];
      const int to = this->Images[half];
      fits = set(TMesh::Twin(half), TMesh::Twin(to));
      const int next = this->Mesh.halfEdges[half].next;
      const int following = this->Following(to);
      fits = fits && (next < 0) == (following < 0);
      if (fits && next >= 0)
      {
        const bool turns = this->Sides[half] != this->Sides[next];
        fits = set(next, following) &&
          turns == (this->Sides[this->Beside(to)] != this->Sides[this->Beside(following)]);
      }
    }
    for (std::size_t i = 0; i < reached.size() && !fits; ++i)
    {
      this->IsTaken[this->Images[reached[i]]] = false;
      this->Images[reached[i]] = None;
    }
  }

  const TMesh& Mesh;
  const Isometry& Map;
  const double Reach;
  std::vector<int> Previous; ///< Per half-edge, the one before it around its patch.
  std::vector<int> Sides;    ///< Per half-edge, the side of its patch.
  std::vector<int> Images;   ///< Per half-edge.
  std::vector<bool> IsTaken; ///< Per half-edge, whether it is an image.
};
}

std::vector<int> FindArcImages(const TMesh& mesh, const Isometry& isometry, double reach)
{
  std::vector<int> arcs;
  const std::vector<int> images = ImageSearch(mesh, isometry, reach).Find();
  for (std::size_t h = 0; h < images.size(); h += 2)
  {
    arcs.push_back(images[h] / 2);
  }
  return arcs;
}
}
