#include "WriteMsh.h"

#include "CellLattice.h"
#include "FormatNames.h"
#include "Index.h"
#include "MeshNumbering.h"
#include "MeshText.h"
#include "PeriodicNodes.h"
#include "SideFaces.h"

#include <array>
#include <limits>

namespace crossfield
{
namespace
{
/// Type of an element by its dimension and order.
int TypeOf(int dimension, int order)
{
  constexpr std::array<std::array<int, 3>, 3> Types = { { { 1, 8, 26 }, { 3, 10, 36 },
    { 5, 12, 92 } } };
  return Types[Index(dimension - 1)][Index(order - 1)];
}

// The faces and cells of prisms, which have order 1.
constexpr int GmshTriangle = 2;
constexpr int GmshPrism = 6;

/// Elements of one type.
struct Elements
{
  int type = 0;
  std::size_t nodesOfElement = 0;
  std::vector<int> nodes; ///< Of all elements in Gmsh's order.

  std::size_t Count() const { return this->nodes.size() / this->nodesOfElement; }
};

/// The elements of one entity, a side or region.
struct Entity
{
  int dimension = 0;
  int tag = 0;
  std::string name;
  std::vector<Elements> elements;
  std::vector<int> nodes; ///< Nodes that belong to no earlier entity.
  Eigen::Vector3d low = Eigen::Vector3d::Zero();
  Eigen::Vector3d high = Eigen::Vector3d::Zero();

  /// Returns the nodes of the elements of a type.
  std::vector<int>& Of(int type, std::size_t nodesOfElement)
  {
    for (Elements& ofType : this->elements)
    {
      if (ofType.type == type)
      {
        return ofType.nodes;
      }
    }
    this->elements.push_back({ type, nodesOfElement, {} });
    return this->elements.back().nodes;
  }
};

std::vector<Entity> SidesOf(
  const ExportMesh& mesh, const MeshNumbering& numbering, const std::vector<std::string>& names)
{
  const SideFaces faces = FindSideFaces(mesh);
  const CellLattice lattice(mesh.dimension, mesh.order);
  const std::vector<int> order = CellLattice(mesh.dimension - 1, mesh.order).GmshOrder();
  std::vector<std::vector<int>> positions; // per face of a cell
  for (int face = 0; face < lattice.FaceCount(); ++face)
  {
    const std::vector<int> all = lattice.Face(face);
    positions.emplace_back();
    for (const int position : order)
    {
      positions.back().push_back(all[Index(position)]);
    }
  }
  std::vector<Entity> sides;
  for (std::size_t side = 0; side < faces.ofSide.size(); ++side)
  {
    Entity entity;
    entity.dimension = mesh.dimension - 1;
    entity.name = names[side];
    for (const SideFace& face : faces.ofSide[side])
    {
      std::vector<int> nodes;
      for (const int position : positions[Index(face.face)])
      {
        nodes.push_back(numbering.number[Index(mesh.Cell(face.cell)[position])]);
      }
      if (mesh.dimension == 3)
      {
        RemoveRepeated(nodes);
      }
      const bool isTriangle = mesh.dimension == 3 && nodes.size() == 3;
      std::vector<int>& all =
        entity.Of(isTriangle ? GmshTriangle : TypeOf(entity.dimension, mesh.order), nodes.size());
      all.insert(all.end(), nodes.begin(), nodes.end());
    }
    sides.push_back(std::move(entity));
  }
  return sides;
}

std::vector<Entity> RegionsOf(const ExportMesh& mesh, const MeshNumbering& numbering,
  const std::vector<int>& positions, const std::vector<std::string>& names)
{
  std::vector<Entity> regions(mesh.regionNames.size());
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    regions[i].dimension = mesh.dimension;
    regions[i].name = names[i];
  }
  for (int cell = 0; cell < mesh.CellCount(); ++cell)
  {
    Entity& region = regions[Index(mesh.region[Index(cell)])];
    const int collapsed = mesh.CollapsedEdge(cell);
    if (collapsed >= 0)
    {
      std::vector<int>& nodes = region.Of(GmshPrism, 6);
      for (const int point : mesh.Prism(cell, collapsed))
      {
        nodes.push_back(numbering.number[Index(point)]);
      }
      continue;
    }
    std::vector<int>& nodes = region.Of(TypeOf(mesh.dimension, mesh.order), positions.size());
    for (const int position : positions)
    {
      nodes.push_back(numbering.number[Index(mesh.Cell(cell)[position])]);
    }
  }
  return regions;
}

/// Sets the tags of entities and gives each node to the first one that has it.
void Complete(const ExportMesh& mesh, const MeshNumbering& numbering, std::vector<Entity>& entities)
{
  std::vector<bool> isTaken(numbering.point.size(), false);
  int tag = 0;
  for (Entity& entity : entities)
  {
    entity.tag = ++tag;
    const double infinity = std::numeric_limits<double>::infinity();
    entity.low.setConstant(infinity);
    entity.high.setConstant(-infinity);
    for (const Elements& ofType : entity.elements)
    {
      for (const int node : ofType.nodes)
      {
        const Eigen::Vector3d& place = mesh.points[Index(numbering.point[Index(node - 1)])];
        entity.low = entity.low.cwiseMin(place).eval();
        entity.high = entity.high.cwiseMax(place).eval();
        if (!isTaken[Index(node - 1)])
        {
          isTaken[Index(node - 1)] = true;
          entity.nodes.push_back(node);
        }
      }
    }
  }
}

void AddPlace(const Eigen::Vector3d& place, MeshText& text)
{
  text.Add(place.x()).Add(' ').Add(place.y()).Add(' ').Add(place.z());
}

void AddNames(const std::vector<Entity>& entities, MeshText& text)
{
  text.Add("$PhysicalNames\n").Add(static_cast<int>(entities.size())).Add('\n');
  for (const Entity& entity : entities)
  {
    text.Add(entity.dimension).Add(' ').Add(entity.tag).Add(" \"").Add(entity.name).Add("\"\n");
  }
  text.Add("$EndPhysicalNames\n");
}

/// Adds the first line of nodes or elements: numbers of blocks and of items.
void AddBlocks(std::size_t blocks, int count, MeshText& text)
{
  text.Add(static_cast<int>(blocks)).Add(' ').Add(count).Add(" 1 ").Add(count).Add('\n');
}

/// Adds the elements of one type, each after `prefix`.
void AddElements(const Elements& elements, const std::string& prefix, int& number, MeshText& text)
{
  for (std::size_t i = 0; i < elements.nodes.size(); ++i)
  {
    if (i % elements.nodesOfElement == 0)
    {
      text.Add(++number).Add(prefix);
    }
    text.Add(' ').Add(elements.nodes[i]);
    if ((i + 1) % elements.nodesOfElement == 0)
    {
      text.Add('\n');
    }
  }
}

void AddVersion41(const ExportMesh& mesh, const MeshNumbering& numbering,
  const std::vector<Entity>& entities, int elements, MeshText& text)
{
  std::array<int, 4> counts{}; // per dimension
  for (const Entity& entity : entities)
  {
    ++counts[Index(entity.dimension)];
  }
  text.Add("$Entities\n0 ")
    .Add(counts[1])
    .Add(' ')
    .Add(counts[2])
    .Add(' ')
    .Add(counts[3])
    .Add('\n');
  for (const Entity& entity : entities)
  {
    text.Add(entity.tag).Add(' ');
    AddPlace(entity.low, text);
    text.Add(' ');
    AddPlace(entity.high, text);
    text.Add(" 1 ").Add(entity.tag).Add(" 0\n"); // one physical group, no entities around it
  }
  text.Add("$EndEntities\n$Nodes\n");
  AddBlocks(entities.size(), static_cast<int>(numbering.point.size()), text);
  for (const Entity& entity : entities)
  {
    text.Add(entity.dimension).Add(' ').Add(entity.tag).Add(" 0 ");
    text.Add(static_cast<int>(entity.nodes.size())).Add('\n');
    for (const int node : entity.nodes)
    {
      text.Add(node).Add('\n');
    }
    for (const int node : entity.nodes)
    {
      AddPlace(mesh.points[Index(numbering.point[Index(node - 1)])], text);
      text.Add('\n');
    }
  }
  text.Add("$EndNodes\n$Elements\n");
  std::size_t blocks = 0;
  for (const Entity& entity : entities)
  {
    blocks += entity.elements.size();
  }
  AddBlocks(blocks, elements, text);
  int number = 0;
  for (const Entity& entity : entities)
  {
    for (const Elements& ofType : entity.elements)
    {
      text.Add(entity.dimension).Add(' ').Add(entity.tag).Add(' ').Add(ofType.type).Add(' ');
      text.Add(static_cast<int>(ofType.Count())).Add('\n');
      AddElements(ofType, "", number, text);
    }
  }
  text.Add("$EndElements\n");
}

void AddVersion22(const ExportMesh& mesh, const MeshNumbering& numbering,
  const std::vector<Entity>& entities, int elements, MeshText& text)
{
  text.Add("$Nodes\n").Add(static_cast<int>(numbering.point.size())).Add('\n');
  for (std::size_t i = 0; i < numbering.point.size(); ++i)
  {
    text.Add(static_cast<int>(i) + 1).Add(' ');
    AddPlace(mesh.points[Index(numbering.point[i])], text);
    text.Add('\n');
  }
  text.Add("$EndNodes\n$Elements\n").Add(elements).Add('\n');
  int number = 0;
  for (const Entity& entity : entities)
  {
    for (const Elements& ofType : entity.elements)
    {
      const std::string tag = ' ' + std::to_string(entity.tag);
      AddElements(ofType, ' ' + std::to_string(ofType.type) + " 2" + tag + tag, number, text);
    }
  }
  text.Add("$EndElements\n");
}

/// Adds the pairs of periodic sides; the second side is the image of the first, Gmsh's master.
void AddPeriodic(
  const ExportMesh& mesh, const MeshNumbering& numbering, MshVersion version, MeshText& text)
{
  if (mesh.periodic.empty())
  {
    return;
  }
  text.Add("$Periodic\n").Add(static_cast<int>(mesh.periodic.size())).Add('\n');
  for (const PeriodicPair& pair : mesh.periodic)
  {
    text.Add(mesh.dimension - 1).Add(' ').Add(pair.second + 1); // tags of sides count from 1
    text.Add(' ').Add(pair.first + 1).Add(version == MshVersion::V41 ? "\n16" : "\nAffine");
    for (Eigen::Index i = 0; i < 16; ++i)
    {
      text.Add(' ').Add(pair.motion(i / 4, i % 4));
    }
    const std::vector<std::array<int, 2>> nodes = PeriodicNodes(mesh, pair);
    text.Add('\n').Add(static_cast<int>(nodes.size())).Add('\n');
    for (const auto& [first, second] : nodes)
    {
      text.Add(numbering.number[Index(second)]).Add(' ');
      text.Add(numbering.number[Index(first)]).Add('\n');
    }
  }
  text.Add("$EndPeriodic\n");
}
}

std::string WriteMsh(const ExportMesh& mesh, MshVersion version)
{
  NameRule rule;
  rule.isPlain = false;
  rule.longest = 127; // Gmsh's own limit
  const std::vector<int> positions = CellLattice(mesh.dimension, mesh.order).GmshOrder();
  const MeshNumbering numbering = NumberNodes(mesh, positions, 1);
  std::vector<Entity> entities = SidesOf(mesh, numbering, FormatNames(mesh.sideNames, rule));
  for (Entity& region : RegionsOf(mesh, numbering, positions, FormatNames(mesh.regionNames, rule)))
  {
    entities.push_back(std::move(region));
  }
  Complete(mesh, numbering, entities);
  MeshText text;
  text.Add(version == MshVersion::V41 ? "$MeshFormat\n4.1 0 8\n" : "$MeshFormat\n2.2 0 8\n");
  text.Add("$EndMeshFormat\n");
  AddNames(entities, text);
  const int elements = mesh.CellCount() + mesh.FaceCount();
  (version == MshVersion::V41 ? AddVersion41 : AddVersion22)(
    mesh, numbering, entities, elements, text);
  AddPeriodic(mesh, numbering, version, text);
  return text.Take();
}
}
