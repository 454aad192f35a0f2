#include "ReadMsh.h"

#include "Error.h"
#include "MshElements.h"
#include "MshStream.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace crossfield
{
namespace
{
/// An edge along the boundary.
struct Edge
{
  std::vector<std::size_t> nodes; ///< Tags of its nodes in order.
  int faces = 0;                  ///< Number of faces with this edge.
  bool isLine = false;
  int group = 0; ///< Physical group of its line, 0 if there is none.
};

/// A triangle or quadrilateral.
struct Face
{
  std::vector<std::size_t> nodes; ///< Tags of the nodes around it.
  int group = 0;                  ///< Physical group, 0 if there is none.
};

class MshReader
{
public:
  MshReader(std::string_view text, const std::string& file)
    : Stream(text, file)
  {
  }

  Drawing Read()
  {
    bool hasFormat = false;
    bool hasElements = false;
    for (std::string section = this->Stream.NextSection(); !section.empty();
         section = this->Stream.NextSection())
    {
      if (section == "MeshFormat")
      {
        hasFormat = true;
        this->Stream.ReadFormat();
      }
      else if (!hasFormat)
      {
        break;
      }
      else if (section == "PhysicalNames")
      {
        this->ReadNames();
      }
      else if (section == "Entities" && this->Stream.Version() == 41)
      {
        this->Stream.EndLine();
        this->ReadEntities();
      }
      else if (section == "Nodes")
      {
        this->Stream.Version() == 41 ? this->ReadNodeBlocks() : this->ReadNodes();
      }
      else if (section == "Elements")
      {
        hasElements = true;
        this->Stream.Version() == 41 ? this->ReadElementBlocks() : this->ReadElements();
      }
    }
    if (!hasFormat || !hasElements)
    {
      this->Stream.Refuse(hasFormat ? "has no elements" : "has no section MeshFormat");
    }
    return this->Finish();
  }

private:
  void ReadNames()
  {
    const int count = this->Stream.TextInteger();
    for (int i = 0; i < count; ++i)
    {
      const int dimension = this->Stream.TextInteger();
      const int group = this->Stream.TextInteger();
      const std::string name = this->Stream.QuotedText();
      if (dimension == 1)
      {
        this->Names[group] = name;
      }
      else if (dimension == 2)
      {
        this->SurfaceNames[group] = name;
      }
    }
  }

  /// Reads the physical groups of curves and surfaces.
  void ReadEntities()
  {
    const std::size_t points = this->Stream.Count();
    const std::size_t curves = this->Stream.Count();
    const std::size_t surfaces = this->Stream.Count();
    this->Stream.Count();
    for (std::size_t i = 0; i < points + curves + surfaces; ++i)
    {
      const bool isPoint = i < points;
      const int tag = this->Stream.Integer();
      for (int number = 0; number < (isPoint ? 3 : 6); ++number)
      {
        this->Stream.Number();
      }
      const std::size_t groups = this->Stream.Count();
      for (std::size_t k = 0; k < groups; ++k)
      {
        const int group = this->Stream.Integer();
        if (!isPoint && k == 0)
        {
          (i < points + curves ? this->GroupOfCurve : this->GroupOfSurface)[tag] =
            GroupNumber(group);
        }
      }
      const std::size_t ends = isPoint ? 0 : this->Stream.Count();
      for (std::size_t k = 0; k < ends; ++k)
      {
        this->Stream.Integer();
      }
    }
  }

  /// Returns the number of a group; a negative one stands for the opposite direction.
  static int GroupNumber(int group)
  {
    return std::abs(std::max(group, -std::numeric_limits<int>::max()));
  }

  void ReadNode(std::size_t tag)
  {
    const double x = this->Stream.Number();
    const double y = this->Stream.Number();
    this->NodeAt[tag] = Eigen::Vector3d(x, y, this->Stream.Number());
  }

  void ReadNodes()
  {
    const int count = this->Stream.TextInteger();
    this->Stream.EndLine();
    for (int i = 0; i < count; ++i)
    {
      this->ReadNode(this->Stream.Count());
    }
  }

  void ReadNodeBlocks()
  {
    this->Stream.EndLine();
    const std::size_t blocks = this->Stream.Count();
    for (int i = 0; i < 3; ++i)
    {
      this->Stream.Count();
    }
    for (std::size_t block = 0; block < blocks; ++block)
    {
      const int dimension = this->Stream.Integer();
      this->Stream.Integer();
      const bool isParametric = this->Stream.Integer() != 0;
      const std::size_t count = this->Stream.Count();
      std::vector<std::size_t> tags;
      for (std::size_t i = 0; i < count; ++i)
      {
        tags.push_back(this->Stream.Count());
      }
      for (const std::size_t tag : tags)
      {
        this->ReadNode(tag);
        for (int i = 0; isParametric && i < dimension; ++i)
        {
          this->Stream.Number();
        }
      }
    }
  }

  /// Returns the shape of a type.
  MshElementType RequireType(int type) const
  {
    const MshElementType shape = MshTypeOf(type);
    if (shape.dimension < 0)
    {
      this->Stream.Refuse("has elements of the unknown type " + std::to_string(type));
    }
    if (shape.dimension == 3)
    {
      throw Error("The mesh has volumes; give a planar mesh, or its boundary lines.");
    }
    return shape;
  }

  void ReadElements()
  {
    const int count = this->Stream.TextInteger();
    this->Stream.EndLine();
    for (int read = 0; read < count;)
    {
      // In text, each element has its own header; in binary files, a block of them.
      const bool isText = !this->Stream.HasBlocks();
      if (isText)
      {
        this->Stream.Count();
      }
      const int type = this->Stream.Integer();
      const int inBlock = isText ? 1 : this->Stream.Integer();
      const int tags = this->Stream.Integer();
      const MshElementType shape = this->RequireType(type);
      if (inBlock < 1)
      {
        this->Stream.Refuse("has an empty block of elements");
      }
      for (int i = 0; i < inBlock; ++i)
      {
        if (!isText)
        {
          this->Stream.Count();
        }
        int group = 0;
        for (int tag = 0; tag < tags; ++tag)
        {
          const int value = this->Stream.Integer();
          group = tag == 0 ? GroupNumber(value) : group;
        }
        this->ReadElement(shape, group);
      }
      read += inBlock;
    }
  }

  void ReadElementBlocks()
  {
    this->Stream.EndLine();
    const std::size_t blocks = this->Stream.Count();
    for (int i = 0; i < 3; ++i)
    {
      this->Stream.Count();
    }
    for (std::size_t block = 0; block < blocks; ++block)
    {
      this->Stream.Integer();
      const int entity = this->Stream.Integer();
      const MshElementType shape = this->RequireType(this->Stream.Integer());
      const std::size_t count = this->Stream.Count();
      const auto& groups = shape.dimension == 1 ? this->GroupOfCurve : this->GroupOfSurface;
      const auto group = groups.find(entity);
      for (std::size_t i = 0; i < count; ++i)
      {
        this->Stream.Count();
        this->ReadElement(shape, shape.dimension > 0 && group != groups.end() ? group->second : 0);
      }
    }
  }

  void ReadElement(const MshElementType& shape, int group)
  {
    std::vector<std::size_t> nodes;
    for (int i = 0; i < shape.nodes; ++i)
    {
      nodes.push_back(this->Stream.Count());
    }
    this->HasFaces = this->HasFaces || shape.dimension == 2;
    if (shape.dimension == 2)
    {
      this->UsedSurfaces.insert(group);
      this->Faces.push_back({ {}, group });
    }
    if (shape.dimension == 0)
    {
      return;
    }
    for (std::vector<std::size_t>& along : MshEdges(shape, nodes))
    {
      if (shape.dimension == 2)
      {
        std::vector<std::size_t>& outline = this->Faces.back().nodes;
        outline.insert(outline.end(), along.begin(), along.end() - 1);
      }
      const auto ends = std::minmax(along.front(), along.back());
      const auto [found, isNew] = this->IndexOf.emplace(ends, this->Edges.size());
      if (isNew)
      {
        this->Edges.emplace_back();
        this->Edges.back().nodes = std::move(along);
      }
      Edge& edge = this->Edges[found->second];
      edge.faces += shape.dimension == 2 ? 1 : 0;
      edge.isLine = edge.isLine || shape.dimension == 1;
      edge.group = shape.dimension == 1 && edge.group == 0 ? group : edge.group;
    }
  }

  const Eigen::Vector3d& PlaceOf(std::size_t node) const
  {
    const auto found = this->NodeAt.find(node);
    if (found == this->NodeAt.end())
    {
      this->Stream.Refuse("has no node " + std::to_string(node) + " of one of its elements");
    }
    return found->second;
  }

  std::string NameOf(int group) const
  {
    const auto found = this->Names.find(group);
    return group == 0 ? "" : found == this->Names.end() ? std::to_string(group) : found->second;
  }

  std::string SurfaceNameOf(int group) const
  {
    const auto found = this->SurfaceNames.find(group);
    return found == this->SurfaceNames.end() ? std::to_string(group) : found->second;
  }

  bool HasMaterials() const { return this->UsedSurfaces.size() > 1; }

  /// Returns the faces, with their groups and named lines, if they are a surface in space, else none.
  DrawingSurface FindSurface() const
  {
    DrawingSurface surface;
    std::unordered_map<std::size_t, int> numbers;
    const auto numbersOf = [&](const std::vector<std::size_t>& nodes)
    {
      std::vector<int> points;
      for (const std::size_t node : nodes)
      {
        const auto [found, isNew] = numbers.emplace(node, static_cast<int>(surface.points.size()));
        if (isNew)
        {
          surface.points.push_back(this->PlaceOf(node));
        }
        points.push_back(found->second);
      }
      return points;
    };
    for (const Face& face : this->Faces)
    {
      surface.polygons.push_back(numbersOf(face.nodes));
      if (this->HasMaterials())
      {
        surface.regions.push_back(this->SurfaceNameOf(face.group));
      }
    }
    for (const Edge& edge : this->Edges)
    {
      if (edge.group != 0 && edge.faces > 0)
      {
        surface.lines.push_back({ numbersOf(edge.nodes), this->NameOf(edge.group) });
      }
    }
    Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(surface.points.size()));
    for (std::size_t i = 0; i < surface.points.size(); ++i)
    {
      places.col(static_cast<Eigen::Index>(i)) = surface.points[i];
    }
    return DomainPlane::Nearest(places).IsNear() ? DrawingSurface() : surface;
  }

  Drawing Finish() const
  {
    Drawing drawing;
    drawing.surface = this->FindSurface();
    if (!drawing.surface.polygons.empty())
    {
      return drawing;
    }
    std::vector<const Edge*> used;
    std::vector<const Eigen::Vector3d*> places;
    std::size_t inside = 0;
    for (const Edge& edge : this->Edges)
    {
      const bool isInside = this->HasFaces && edge.faces != 1;
      if (isInside && !(edge.isLine && this->HasMaterials()))
      {
        inside += edge.isLine ? 1 : 0;
        continue;
      }
      used.push_back(&edge);
      for (const std::size_t node : edge.nodes)
      {
        places.push_back(&this->PlaceOf(node));
      }
    }
    if (used.empty())
    {
      throw Error("The mesh has no boundary; give boundary lines, or triangles or quadrilaterals.");
    }
    Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      columns.col(static_cast<Eigen::Index>(i)) = *places[i];
    }
    drawing.FindPlane(columns);
    for (const Edge* edge : used)
    {
      this->AddPieces(*edge, drawing);
    }
    if (inside > 0)
    {
      drawing.warnings.push_back(std::to_string(inside) +
        (inside == 1 ? " line of the mesh inside the domain was"
                     : " lines of the mesh inside the domain were") +
        " left out.");
    }
    if (this->HasMaterials())
    {
      this->AddFaces(drawing);
    }
    return drawing;
  }

  /// Adds the faces with their materials, if they have several.
  void AddFaces(Drawing& drawing) const
  {
    for (const Face& face : this->Faces)
    {
      drawing.faces.push_back({ {}, this->SurfaceNameOf(face.group) });
      for (const std::size_t node : face.nodes)
      {
        drawing.faces.back().points.push_back(drawing.plane.ToPlane(this->PlaceOf(node)));
      }
    }
  }

  void AddPieces(const Edge& edge, Drawing& drawing) const
  {
    for (std::size_t i = 1; i < edge.nodes.size(); ++i)
    {
      DrawingPiece piece = LinePiece(drawing.plane.ToPlane(this->PlaceOf(edge.nodes[i - 1])),
        drawing.plane.ToPlane(this->PlaceOf(edge.nodes[i])));
      piece.isExact = false;
      piece.name = this->NameOf(edge.group);
      piece.origin = "the line from node " + std::to_string(edge.nodes[i - 1]) + " to node " +
        std::to_string(edge.nodes[i]);
      if (piece.first != piece.last)
      {
        drawing.pieces.push_back(std::move(piece));
      }
    }
  }

  MshStream Stream;
  bool HasFaces = false;
  std::map<int, std::string> Names;
  std::map<int, std::string> SurfaceNames;
  std::vector<Face> Faces;
  std::set<int> UsedSurfaces; ///< Physical groups of faces, 0 for none.
  std::map<int, int> GroupOfCurve;
  std::map<int, int> GroupOfSurface;
  std::unordered_map<std::size_t, Eigen::Vector3d> NodeAt;
  std::vector<Edge> Edges;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> IndexOf;
};
}

Drawing ReadMsh(std::string_view text, const std::string& file)
{
  return MshReader(text, file).Read();
}
}
