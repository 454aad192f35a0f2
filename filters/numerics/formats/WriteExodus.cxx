#include "WriteExodus.h"

#include "ElementNodes.h"
#include "Error.h"
#include "FormatNames.h"
#include "NetCdf.h"

#include <array>
#include <numeric>

namespace crossfield
{
namespace
{
constexpr int NameLength = 32;
constexpr double Version = 5.1; // of the format, which has names of blocks and sets

/// How the elements of a mesh are called and their faces numbered.
struct ElementKind
{
  std::string type;
  std::vector<int> faces; ///< Per face of CellLattice, its number in the format.
};

ElementKind KindOf(const SolverMesh& mesh, bool isPlane)
{
  const std::string nodes = std::to_string(mesh.NodesOfCell());
  if (mesh.dimension == 3)
  {
    return { "HEX" + nodes, { 5, 6, 1, 2, 3, 4 } };
  }
  // Sides 1 and 2 of a shell are its faces.
  return isPlane ? ElementKind{ "QUAD" + nodes, { 1, 2, 3, 4 } }
                 : ElementKind{ "SHELL" + nodes, { 3, 4, 5, 6 } };
}

void AddHeader(NetCdf& file)
{
  using Attribute = NetCdf::Attribute;
  file.AddAttribute({ "api_version", Attribute::Float, {}, Version });
  file.AddAttribute({ "version", Attribute::Float, {}, Version });
  file.AddAttribute({ "floating_point_word_size", Attribute::Integer, {}, sizeof(double) });
  file.AddAttribute({ "file_size", Attribute::Integer, {}, 1 }); // each coordinate has a variable
  file.AddAttribute({ "maximum_name_length", Attribute::Integer, {}, NameLength });
  file.AddAttribute({ "int64_status", Attribute::Integer, {}, 0 });
  file.AddAttribute({ "title", Attribute::Text, "CrossField", 0.0 });
}

/// Adds status, numbers and names of the blocks or sets, given their sizes. The dimension 0 of an array is that
/// of records, so those without elements have no arrays, and their status is 0.
void AddGroups(const std::string& prefix, const std::string& dimensionName, int nameLength,
  const std::vector<std::string>& names, const std::vector<int>& sizes, NetCdf& file)
{
  if (names.empty())
  {
    return;
  }
  const int dimension = file.AddDimension(dimensionName, static_cast<int>(names.size()));
  std::vector<int> ids(names.size());
  std::iota(ids.begin(), ids.end(), 1);
  std::vector<int> status;
  for (const int size : sizes)
  {
    status.push_back(size > 0 ? 1 : 0);
  }
  file.AddIntegers(prefix + "_status", { dimension }, status);
  file.AddIntegers(
    prefix + "_prop1", { dimension }, ids, { { "name", NetCdf::Attribute::Text, "ID", 0.0 } });
  NameRule rule;
  rule.isPlain = false;
  rule.longest = NameLength;
  file.AddTexts(prefix + "_names", { dimension, nameLength }, FormatNames(names, rule));
}

/// Adds the elements of all blocks and returns the number of each cell.
std::vector<int> AddBlocks(
  const SolverMesh& mesh, const ElementKind& kind, const ElementNodes& numbering, NetCdf& file)
{
  std::vector<int> element(mesh.region.size());
  int next = 1;
  for (std::size_t region = 0; region < mesh.regionNames.size(); ++region)
  {
    const int first = next;
    std::vector<int> nodes;
    for (int cell = 0; cell < mesh.CellCount(); ++cell)
    {
      if (mesh.region[cell] != static_cast<int>(region))
      {
        continue;
      }
      const std::vector<int> ofCell = numbering.OfCell(cell);
      nodes.insert(nodes.end(), ofCell.begin(), ofCell.end());
      element[cell] = next++;
    }
    if (next > first)
    {
      const std::string number = std::to_string(region + 1);
      const int inBlock = file.AddDimension("num_el_in_blk" + number, next - first);
      const int inElement = file.AddDimension("num_nod_per_el" + number, mesh.NodesOfCell());
      file.AddIntegers("connect" + number, { inBlock, inElement }, nodes,
        { { "elem_type", NetCdf::Attribute::Text, kind.type, 0.0 } });
    }
  }
  return element;
}

void AddSets(const std::vector<std::vector<CellFace>>& sets, const ElementKind& kind,
  const std::vector<int>& element, NetCdf& file)
{
  for (std::size_t side = 0; side < sets.size(); ++side)
  {
    if (sets[side].empty())
    {
      continue;
    }
    const std::string number = std::to_string(side + 1);
    std::vector<int> elements;
    std::vector<int> sides;
    for (const CellFace& face : sets[side])
    {
      elements.push_back(element[face.cell]);
      sides.push_back(kind.faces[face.face]);
    }
    const int inSet = file.AddDimension("num_side_ss" + number, static_cast<int>(sides.size()));
    file.AddIntegers("elem_ss" + number, { inSet }, elements);
    file.AddIntegers("side_ss" + number, { inSet }, sides);
  }
}
}

std::string WriteExodus(const SolverMesh& mesh)
{
  for (int cell = 0; mesh.order > 1 && cell < mesh.CellCount(); ++cell)
  {
    if (mesh.CollapsedEdge(cell) >= 0)
    {
      throw Error("The format .ex2 has no prisms of order 2, such as that on the axis at " +
        PlaceOf(mesh, mesh.Cell(cell)[0]) + "; use order 1, or write a .msh, .inp or .vtu file.");
    }
  }
  const MeshFaces faces(mesh);
  const bool isPlane = mesh.dimension == 2 && mesh.HasConstantHeight();
  const int dimension = isPlane ? 2 : 3;
  const ElementKind kind = KindOf(mesh, isPlane);
  const ElementNodes numbering(mesh, NodeOrder::Exodus, 1);
  NetCdf file;
  AddHeader(file);
  const int nameLength = file.AddDimension("len_name", NameLength + 1);
  file.AddDimension("len_string", NameLength + 1);
  const int time = file.AddDimension("time_step", 0);
  const int axes = file.AddDimension("num_dim", dimension);
  const int nodes = file.AddDimension("num_nodes", static_cast<int>(numbering.UsedPoints().size()));
  file.AddDimension("num_elem", mesh.CellCount());
  file.AddNumbers("time_whole", { time }, {});
  std::vector<int> sizes(mesh.regionNames.size(), 0);
  for (const int region : mesh.region)
  {
    ++sizes[region];
  }
  AddGroups("eb", "num_el_blk", nameLength, mesh.regionNames, sizes, file);
  sizes.clear();
  for (const std::vector<CellFace>& side : faces.OfSides())
  {
    sizes.push_back(static_cast<int>(side.size()));
  }
  AddGroups("ss", "num_side_sets", nameLength, mesh.sideNames, sizes, file);
  const std::array<std::string, 3> axisNames = { "x", "y", "z" };
  file.AddTexts(
    "coor_names", { axes, nameLength }, { axisNames.begin(), axisNames.begin() + dimension });
  for (int axis = 0; axis < dimension; ++axis)
  {
    std::vector<double> values;
    values.reserve(numbering.UsedPoints().size());
    for (const int point : numbering.UsedPoints())
    {
      values.push_back(mesh.points[point][axis]);
    }
    file.AddNumbers("coord" + axisNames[axis], { nodes }, values);
  }
  AddSets(faces.OfSides(), kind, AddBlocks(mesh, kind, numbering, file), file);
  return file.Bytes();
}
}
