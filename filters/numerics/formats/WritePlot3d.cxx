#include "WritePlot3d.h"

#include "BlockFaces.h"
#include "FormatNames.h"
#include "Index.h"
#include "MeshText.h"

namespace crossfield
{
namespace
{
constexpr int NumbersInLine = 4;

/// Returns the two directions along a face in the cyclic order of the format, the primary one first.
std::array<std::size_t, 2> DirectionsOf(const BlockRange& range)
{
  const std::size_t across = Index(range.face / 2);
  return { (across + 1) % 3, (across + 2) % 3 };
}

void AddRange(const BlockRange& range, MeshText& text)
{
  constexpr std::array<int, 3> FirstFace = { 3, 5, 1 }; // at the ends of I, J and K
  text.Add(' ').Add(range.block + 1).Add(' ');
  text.Add(FirstFace[range.face / 2] + range.face % 2);
  for (const std::size_t direction : DirectionsOf(range))
  {
    text.Add(' ').Add(range.begin[direction] + 1).Add(' ').Add(range.end[direction] + 1);
  }
}

/// Returns whether the primary direction of one face is the secondary one of the other.
bool IsSwapped(const BlockConnection& connection)
{
  const std::array<std::size_t, 2> from = DirectionsOf(connection.from);
  const std::array<std::size_t, 2> to = DirectionsOf(connection.to);
  const std::size_t i = connection.transform[from[0]] != 0 ? 0 : 1; // K has none in two dimensions
  return std::abs(connection.transform[from[i]]) - 1 != static_cast<int>(to[i]);
}
}

std::string WritePlot3d(const SolverMesh& mesh)
{
  const bool isPlane = mesh.dimension == 2 && mesh.HasConstantHeight();
  const int dimension = isPlane ? 2 : 3;
  MeshText text;
  text.Add(static_cast<int>(mesh.blocks.size())).Add('\n');
  for (const MeshBlock& block : mesh.blocks)
  {
    for (int i = 0; i < dimension; ++i)
    {
      text.Add(block.cells[i] + 1).Add(i + 1 < dimension ? ' ' : '\n');
    }
  }
  for (const MeshBlock& block : mesh.blocks)
  {
    for (int i = 0; i < dimension; ++i)
    {
      int inLine = 0;
      for (const int node : block.nodes)
      {
        text.Add(mesh.points[node][i]);
        inLine = (inLine + 1) % NumbersInLine;
        text.Add(inLine == 0 ? '\n' : ' ');
      }
      if (inLine != 0)
      {
        text.Add('\n');
      }
    }
  }
  return text.Take();
}

std::string WriteNmf(const SolverMesh& mesh)
{
  const MeshFaces ofMesh(mesh);
  const BlockFaces faces = FindBlockFaces(mesh, ofMesh);
  MeshText text;
  text.Add("# Neutral map file\n# Block IDIM JDIM KDIM\n");
  text.Add(static_cast<int>(mesh.blocks.size())).Add('\n');
  int number = 0;
  for (const MeshBlock& block : mesh.blocks)
  {
    text.Add(++number);
    for (const int cells : block.cells)
    {
      text.Add(' ').Add(cells + 1);
    }
    text.Add('\n');
  }
  text.Add("# Type B1 F1 S1 E1 S2 E2 B2 F2 S1 E1 S2 E2 Swap\n");
  for (const BlockConnection& connection : faces.connections)
  {
    text.Add("'ONE_TO_ONE'");
    AddRange(connection.from, text);
    AddRange(connection.to, text);
    text.Add(IsSwapped(connection) ? " 'TRUE'\n" : " 'FALSE'\n");
  }
  NameRule rule;
  rule.hasCase = false;
  const std::vector<std::string> names =
    FormatNames(mesh.sideNames, rule, { "ONE_TO_ONE", "COLLAPSED" });
  for (const BlockPatch& patch : faces.patches)
  {
    text.Add("'").Add(names[patch.side]).Add("'");
    AddRange(patch.range, text);
    text.Add('\n');
  }
  for (const BlockRange& range : faces.collapsed)
  {
    text.Add("'COLLAPSED'");
    AddRange(range, text);
    text.Add('\n');
  }
  return text.Take();
}
}
