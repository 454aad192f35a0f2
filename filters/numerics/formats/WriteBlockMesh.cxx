#include "WriteBlockMesh.h"

#include "CutBlocks.h"
#include "FoamMesh.h"
#include "FoamText.h"
#include "MeshBlocks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace crossfield
{
namespace
{
using Place = std::array<int, 3>;

// Nodes nearer to the chord than this part of it, and ratios nearer to 1, differ by rounding.
constexpr double Rounding = 1e-9;

/// Corners of a hexahedron as ends of a block in the three directions.
constexpr std::array<Place, 8> Corners = { { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
  { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } } };

/// First corners of the twelve edges, four along each direction, in the order of blockMesh.
constexpr std::array<int, 12> EdgeStarts = { 0, 3, 7, 4, 0, 1, 5, 4, 0, 1, 2, 3 };

class DictWriting
{
public:
  DictWriting(const SolverMesh& mesh, const std::vector<MeshBlock>& blocks)
    : Mesh(mesh)
    , Blocks(blocks)
  {
    this->Text.Add(BlockMeshNote);
    AddFoamHeader(this->Text, "dictionary", "system", "blockMeshDict");
  }

  void AddVertices()
  {
    this->Text.Add("scale 1;\n\nvertices\n(\n");
    for (const MeshBlock& block : this->Blocks)
    {
      for (int corner = 0; corner < 8; ++corner)
      {
        const int node = block.NodeAt(PlaceOfCorner(block, corner));
        if (this->Vertices.emplace(node, static_cast<int>(this->Vertices.size())).second)
        {
          this->Text.Add("    (").Add(this->Mesh.points[node]).Add(")\n");
        }
      }
    }
    this->Text.Add(");\n\n");
  }

  void AddBlocks()
  {
    this->Text.Add("blocks\n(\n");
    for (const MeshBlock& block : this->Blocks)
    {
      this->Text.Add("    hex (");
      for (int corner = 0; corner < 8; ++corner)
      {
        this->Text.Add(corner == 0 ? "" : " ").Add(this->VertexAt(block, corner));
      }
      this->Text.Add(") (").Add(block.cells[0]).Add(' ').Add(block.cells[1]).Add(' ');
      this->Text.Add(block.cells[2]).Add(") ");
      std::array<double, 12> ratios{};
      bool isSimple = true;
      for (std::size_t edge = 0; edge < ratios.size(); ++edge)
      {
        ratios[edge] = this->RatioAlong(
          EdgeNodes(block, static_cast<int>(edge / 4), PlaceOfCorner(block, EdgeStarts[edge])));
        isSimple = isSimple && ratios[edge] == ratios[edge / 4 * 4];
      }
      this->Text.Add(isSimple ? "simpleGrading (" : "edgeGrading (");
      for (std::size_t edge = 0; edge < ratios.size(); edge += isSimple ? 4 : 1)
      {
        this->Text.Add(edge == 0 ? "" : " ").Add(ratios[edge]);
      }
      this->Text.Add(")\n");
    }
    this->Text.Add(");\n\n");
  }

  void AddEdges()
  {
    this->Text.Add("edges\n(\n");
    std::set<std::pair<int, int>> written;
    for (const MeshBlock& block : this->Blocks)
    {
      for (std::size_t edge = 0; edge < EdgeStarts.size(); ++edge)
      {
        const std::vector<int> nodes =
          EdgeNodes(block, static_cast<int>(edge / 4), PlaceOfCorner(block, EdgeStarts[edge]));
        if (this->IsStraight(nodes) ||
          !written.insert(std::minmax(nodes.front(), nodes.back())).second)
        {
          continue;
        }
        this->Text.Add("    polyLine ").Add(this->Vertices.at(nodes.front())).Add(' ');
        this->Text.Add(this->Vertices.at(nodes.back())).Add(" (");
        for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
        {
          this->Text.Add(i == 1 ? "(" : " (").Add(this->Mesh.points[nodes[i]]).Add(')');
        }
        this->Text.Add(")\n");
      }
    }
    this->Text.Add(");\n\n");
  }

  void AddPatches(const MeshFaces& ofMesh)
  {
    std::vector<int> patchOf;
    const std::vector<FoamPatch> patches = FoamPatches(this->Mesh, patchOf);
    std::vector<std::vector<std::array<int, 4>>> faces(patches.size());
    constexpr std::array<std::array<int, 4>, 6> Faces = { { { 0, 3, 2, 1 }, { 4, 5, 6, 7 },
      { 0, 1, 5, 4 }, { 2, 3, 7, 6 }, { 0, 4, 7, 3 }, { 1, 2, 6, 5 } } };
    for (const MeshBlock& block : this->Blocks)
    {
      for (const std::array<int, 4>& corners : Faces)
      {
        const std::array<int, 4> nodes = CornerCell(block, corners);
        const int side = ofMesh.SideOf(MeshFaces::MakeKey(nodes.data(), nodes.size()));
        if (side < 0)
        {
          continue;
        }
        std::array<int, 4> vertices{};
        for (std::size_t i = 0; i < 4; ++i)
        {
          vertices[i] = this->VertexAt(block, corners[i]);
        }
        faces[patchOf[side]].push_back(vertices);
      }
    }
    this->Text.Add("boundary\n(\n");
    for (std::size_t patch = 0; patch < patches.size(); ++patch)
    {
      if (faces[patch].empty())
      {
        continue;
      }
      this->Text.Add("    ").Add(patches[patch].name).Add("\n    {\n        type ");
      // blockMesh would have to keep the order of the faces of cyclic patches.
      this->Text.Add(patches[patch].type == "cyclic" ? "patch" : patches[patch].type)
        .Add(";\n        faces\n        (\n");
      for (const std::array<int, 4>& face : faces[patch])
      {
        this->Text.Add("            (").Add(face[0]).Add(' ').Add(face[1]).Add(' ').Add(face[2]);
        this->Text.Add(' ').Add(face[3]).Add(")\n");
      }
      this->Text.Add("        );\n    }\n");
    }
    this->Text.Add(");\n");
  }

  std::string Take() { return this->Text.Take(); }

private:
  static Place PlaceOfCorner(const MeshBlock& block, int corner)
  {
    const Place& end = Corners[corner];
    return { end[0] * block.cells[0], end[1] * block.cells[1], end[2] * block.cells[2] };
  }

  /// Returns the corners of the first cell face in a face of a block.
  static std::array<int, 4> CornerCell(const MeshBlock& block, const std::array<int, 4>& corners)
  {
    const Place first = PlaceOfCorner(block, corners[0]);
    std::array<int, 4> nodes{};
    for (std::size_t i = 0; i < 4; ++i)
    {
      Place place = PlaceOfCorner(block, corners[i]);
      for (std::size_t d = 0; d < 3; ++d)
      {
        place[d] = first[d] + std::clamp(place[d] - first[d], -1, 1);
      }
      nodes[i] = block.NodeAt(place);
    }
    return nodes;
  }

  int VertexAt(const MeshBlock& block, int corner) const
  {
    return this->Vertices.at(block.NodeAt(PlaceOfCorner(block, corner)));
  }

  double Distance(int a, int b) const
  {
    return (this->Mesh.points[a] - this->Mesh.points[b]).norm();
  }

  /// Returns the length of the last cell over that of the first one; inverse along the reversed edge, to the last
  /// bits, so that blocks agree.
  double RatioAlong(const std::vector<int>& nodes) const
  {
    const double first = this->Distance(nodes[0], nodes[1]);
    const double last = this->Distance(nodes[nodes.size() - 2], nodes.back());
    if (first == 0.0 || std::abs(last / first - 1.0) < Rounding)
    {
      return 1.0; // also on the axis of a revolution
    }
    return last / first;
  }

  bool IsStraight(const std::vector<int>& nodes) const
  {
    const Eigen::Vector3d& start = this->Mesh.points[nodes.front()];
    const Eigen::Vector3d chord = this->Mesh.points[nodes.back()] - start;
    const double length = chord.norm();
    if (length == 0.0)
    {
      return true; // a point on the axis of a revolution
    }
    return std::all_of(nodes.begin(), nodes.end(),
      [&](int node)
      {
        const Eigen::Vector3d way = this->Mesh.points[node] - start;
        return (way - way.dot(chord) / (length * length) * chord).norm() < Rounding * length;
      });
  }

  const SolverMesh& Mesh;
  const std::vector<MeshBlock>& Blocks;
  std::map<int, int> Vertices; ///< Numbers of vertices by node.
  MeshText Text;
};
}

std::string WriteBlockMesh(const SolverMesh& mesh, const MeshFaces& faces)
{
  const std::vector<MeshBlock> blocks = CutBlocks(mesh, faces);
  if (blocks.empty())
  {
    return "";
  }
  DictWriting dict(mesh, blocks);
  dict.AddVertices();
  dict.AddBlocks();
  dict.AddEdges();
  dict.AddPatches(faces);
  return dict.Take();
}
}
