#include "WriteEnSight.h"

#include "ElementNodes.h"
#include "FormatNames.h"

#include <cstdint>
#include <cstring>

namespace crossfield
{
namespace
{
constexpr std::size_t LineLength = 80;

class Geometry
{
public:
  explicit Geometry(const SolverMesh& mesh)
    : Mesh(mesh)
    , Number(mesh.points.size(), 0)
  {
    for (const char* line : { "C Binary", "CrossField", "", "node id off", "element id off" })
    {
      this->AddLine(line);
    }
  }

  /// Adds a part of elements of one type, given by their points.
  void AddPart(
    const std::string& name, const std::string& type, const std::vector<std::vector<int>>& elements)
  {
    std::vector<int> used; // in the order of points
    for (const std::vector<int>& points : elements)
    {
      for (const int point : points)
      {
        this->Number[point] = 1;
      }
    }
    for (std::size_t point = 0; point < this->Number.size(); ++point)
    {
      if (this->Number[point] > 0)
      {
        used.push_back(static_cast<int>(point));
        this->Number[point] = static_cast<int>(used.size());
      }
    }
    this->AddLine("part");
    this->AddInteger(++this->Parts);
    this->AddLine(name);
    this->AddLine("coordinates");
    this->AddInteger(static_cast<int>(used.size()));
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const int point : used)
      {
        this->AddFloat(static_cast<float>(this->Mesh.points[point][axis]));
      }
    }
    this->AddLine(type);
    this->AddInteger(static_cast<int>(elements.size()));
    for (const std::vector<int>& points : elements)
    {
      for (const int point : points)
      {
        this->AddInteger(this->Number[point]);
      }
    }
    for (const int point : used)
    {
      this->Number[point] = 0;
    }
  }

  std::string Take() { return std::move(this->Bytes); }

private:
  void AddLine(std::string line)
  {
    line.resize(LineLength, '\0');
    this->Bytes += line;
  }

  void AddBits(std::uint32_t bits)
  {
    for (int shift = 0; shift < 32; shift += 8)
    {
      this->Bytes += static_cast<char>((bits >> shift) & 0xFFU);
    }
  }

  void AddInteger(int number) { this->AddBits(static_cast<std::uint32_t>(number)); }

  void AddFloat(float number)
  {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &number, sizeof(bits));
    this->AddBits(bits);
  }

  const SolverMesh& Mesh;
  std::vector<int> Number; ///< Per point, its number in the part that is written, otherwise 0.
  std::string Bytes;
  int Parts = 0;
};
}

std::string WriteEnSightCase(const std::string& geometry)
{
  return "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: " + geometry + "\n";
}

std::string WriteEnSightGeometry(const SolverMesh& mesh)
{
  const MeshFaces faces(mesh);
  const ElementNodes nodes(mesh, NodeOrder::EnSight);
  std::vector<std::string> names = mesh.regionNames;
  names.insert(names.end(), mesh.sideNames.begin(), mesh.sideNames.end());
  NameRule rule;
  rule.isPlain = false;
  rule.longest = LineLength - 1;
  names = FormatNames(names, rule);
  Geometry geometry(mesh);
  std::vector<std::vector<std::vector<int>>> parts(names.size()); // elements
  for (int cell = 0; cell < mesh.CellCount(); ++cell)
  {
    parts[mesh.region[cell]].push_back(nodes.OfCell(cell));
  }
  for (int face = 0; face < mesh.FaceCount(); ++face)
  {
    parts[mesh.regionNames.size() + Index(mesh.side[face])].push_back(
      nodes.OfFace(faces.BoundaryFaces()[face]));
  }
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    const bool isRegion = part < mesh.regionNames.size();
    const int dimension = isRegion ? mesh.dimension : mesh.dimension - 1;
    const std::size_t count =
      CellLattice(dimension, mesh.order).OrderFor(NodeOrder::EnSight).size();
    const char* type = dimension == 1 ? "bar" : dimension == 2 ? "quad" : "hexa";
    geometry.AddPart(names[part], type + std::to_string(count), parts[part]);
  }
  return geometry.Take();
}
}
