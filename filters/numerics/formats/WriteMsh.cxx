#include "WriteMsh.h"

#include "ElementNodes.h"
#include "FormatNames.h"
#include "Index.h"
#include "MeshText.h"
#include "SidePairs.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

namespace crossfield
{
namespace
{
/// Type of an element by its dimension and order.
int TypeOf(int dimension, int order)
{
  constexpr std::array<std::array<int, 3>, 3> Types = { { { 1, 8, 26 }, { 3, 10, 36 },
    { 5, 12, 92 } } };
  return Types[dimension - 1][order - 1];
}

// The faces and cells of prisms of order 1 and 2.
constexpr std::array<int, 2> Triangles = { 2, 9 };
constexpr std::array<int, 2> Prisms = { 6, 13 };

/// Elements of one type.
struct Elements
{
  int type = 0;
  std::vector<std::vector<int>> nodes; ///< Per element, in Gmsh's order.
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

  void Add(int type, const std::vector<int>& nodesOfElement)
  {
    auto ofType = std::find_if(this->elements.begin(), this->elements.end(),
      [type](const Elements& candidate) { return candidate.type == type; });
    if (ofType == this->elements.end())
    {
      ofType = this->elements.insert(ofType, { type, {} });
    }
    ofType->nodes.push_back(nodesOfElement);
  }
};

std::vector<Entity> SidesOf(const SolverMesh& mesh, const MeshFaces& faces,
  const ElementNodes& numbering, const std::vector<std::string>& names)
{
  std::vector<Entity> sides;
  for (int side = 0; side < static_cast<int>(names.size()); ++side)
  {
    Entity entity;
    entity.dimension = mesh.dimension - 1;
    entity.name = names[side];
    for (const CellFace& face : faces.OfSide(side))
    {
      const std::vector<int> nodes = numbering.OfFace(face);
      const bool isTriangle = mesh.dimension == 3 && nodes.size() == Index(3 * mesh.order);
      entity.Add(
        isTriangle ? Triangles[Index(mesh.order - 1)] : TypeOf(entity.dimension, mesh.order),
        nodes);
    }
    sides.push_back(std::move(entity));
  }
  return sides;
}

std::vector<Entity> RegionsOf(
  const SolverMesh& mesh, const ElementNodes& numbering, const std::vector<std::string>& names)
{
  std::vector<Entity> regions(names.size());
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    regions[i].dimension = mesh.dimension;
    regions[i].name = names[i];
  }
  for (int cell = 0; cell < mesh.CellCount(); ++cell)
  {
    const std::vector<int> nodes = numbering.OfCell(cell);
    const bool isPrism = mesh.dimension == 3 && mesh.CollapsedEdge(cell) >= 0;
    const int type = isPrism ? Prisms[Index(mesh.order - 1)] : TypeOf(mesh.dimension, mesh.order);
    regions[mesh.region[cell]].Add(type, nodes);
  }
  return regions;
}

/// Sets the tags of entities and gives each node to the first one that has it.
void Complete(const SolverMesh& mesh, const ElementNodes& numbering, std::vector<Entity>& entities)
{
  std::vector<bool> isTaken(numbering.UsedPoints().size(), false);
  int tag = 0;
  for (Entity& entity : entities)
  {
    entity.tag = ++tag;
    const double infinity = std::numeric_limits<double>::infinity();
    entity.low.setConstant(infinity);
    entity.high.setConstant(-infinity);
    for (const Elements& ofType : entity.elements)
    {
      for (const std::vector<int>& element : ofType.nodes)
      {
        for (const int node : element)
        {
          const Eigen::Vector3d& place = mesh.points[numbering.UsedPoints()[node - 1]];
          entity.low = entity.low.cwiseMin(place).eval();
          entity.high = entity.high.cwiseMax(place).eval();
          if (!isTaken[node - 1])
          {
            isTaken[node - 1] = true;
            entity.nodes.push_back(node);
          }
        }
      }
    }
  }
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
  for (const std::vector<int>& nodes : elements.nodes)
  {
    text.Add(++number).Add(prefix);
    for (const int node : nodes)
    {
      text.Add(' ').Add(node);
    }
    text.Add('\n');
  }
}

void AddVersion41(const SolverMesh& mesh, const ElementNodes& numbering,
  const std::vector<Entity>& entities, int elements, MeshText& text)
{
  std::array<int, 4> counts{}; // per dimension
  for (const Entity& entity : entities)
  {
    ++counts[entity.dimension];
  }
  text.Add("$Entities\n0 ").Add(counts[1]).Add(' ').Add(counts[2]).Add(' ');
  text.Add(counts[3]).Add('\n');
  for (const Entity& entity : entities)
  {
    text.Add(entity.tag).Add(' ');
    text.Add(entity.low);
    text.Add(' ');
    text.Add(entity.high);
    text.Add(" 1 ").Add(entity.tag).Add(" 0\n"); // one physical group, no entities around it
  }
  text.Add("$EndEntities\n$Nodes\n");
  AddBlocks(entities.size(), static_cast<int>(numbering.UsedPoints().size()), text);
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
      text.Add(mesh.points[numbering.UsedPoints()[node - 1]]);
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
      text.Add(static_cast<int>(ofType.nodes.size())).Add('\n');
      AddElements(ofType, "", number, text);
    }
  }
  text.Add("$EndElements\n");
}

void AddVersion22(const SolverMesh& mesh, const ElementNodes& numbering,
  const std::vector<Entity>& entities, int elements, MeshText& text)
{
  text.Add("$Nodes\n").Add(static_cast<int>(numbering.UsedPoints().size())).Add('\n');
  for (std::size_t i = 0; i < numbering.UsedPoints().size(); ++i)
  {
    text.Add(static_cast<int>(i) + 1).Add(' ');
    text.Add(mesh.points[numbering.UsedPoints()[i]]);
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
void AddPeriodic(const SolverMesh& mesh, const MeshFaces& faces, const ElementNodes& numbering,
  MshVersion version, MeshText& text)
{
  if (mesh.pairs.empty())
  {
    return;
  }
  text.Add("$Periodic\n").Add(static_cast<int>(mesh.pairs.size())).Add('\n');
  for (const SidePair& pair : mesh.pairs)
  {
    text.Add(mesh.dimension - 1).Add(' ').Add(pair.second + 1); // tags of sides count from 1
    text.Add(' ').Add(pair.first + 1).Add(version == MshVersion::V41 ? "\n16" : "\nAffine");
    for (Eigen::Index i = 0; i < 16; ++i)
    {
      text.Add(' ').Add(pair.motion(i / 4, i % 4));
    }
    const std::map<int, int> nodes = MatchPair(mesh, faces, pair).nodes;
    text.Add('\n').Add(static_cast<int>(nodes.size())).Add('\n');
    for (const auto& [first, second] : nodes)
    {
      text.Add(numbering.NumberOf(second)).Add(' ');
      text.Add(numbering.NumberOf(first)).Add('\n');
    }
  }
  text.Add("$EndPeriodic\n");
}
}

std::string WriteMsh(const SolverMesh& mesh, MshVersion version)
{
  NameRule rule;
  rule.isPlain = false;
  rule.longest = 127; // Gmsh's own limit
  const ElementNodes numbering(mesh, NodeOrder::Gmsh, 1);
  const MeshFaces faces(mesh);
  std::vector<Entity> entities = SidesOf(mesh, faces, numbering, FormatNames(mesh.sideNames, rule));
  for (Entity& region : RegionsOf(mesh, numbering, FormatNames(mesh.regionNames, rule)))
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
  AddPeriodic(mesh, faces, numbering, version, text);
  return text.Take();
}
}
