#include "WriteEnSight.h"

#include "CellLattice.h"
#include "FormatNames.h"
#include "Index.h"
#include "SideFaces.h"

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
  explicit Geometry(const ExportMesh& mesh)
    : Mesh(mesh)
    , Number(mesh.points.size(), 0)
  {
    for (const char* line : { "C Binary", "CrossField", "", "node id off", "element id off" })
    {
      this->AddLine(line);
    }
  }

  /// Adds a part of elements of one type, given by their points.
  void AddPart(const std::string& name, const std::string& type, const std::vector<int>& points,
    std::size_t nodesOfElement)
  {
    std::vector<int> used; // in the order of points
    for (const int point : points)
    {
      this->Number[Index(point)] = 1;
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
        this->AddFloat(static_cast<float>(this->Mesh.points[Index(point)][axis]));
      }
    }
    this->AddLine(type);
    this->AddInteger(static_cast<int>(points.size() / nodesOfElement));
    for (const int point : points)
    {
      this->AddInteger(this->Number[Index(point)]);
    }
    for (const int point : used)
    {
      this->Number[Index(point)] = 0;
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

  const ExportMesh& Mesh;
  std::vector<int> Number; ///< Per point, its number in the part that is written, otherwise 0.
  std::string Bytes;
  int Parts = 0;
};
}

std::string WriteEnSightCase(const std::string& geometry)
{
  return "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: " + geometry + "\n";
}

std::string WriteEnSightGeometry(const ExportMesh& mesh)
{
  const SideFaces faces = FindSideFaces(mesh);
  const CellLattice lattice(mesh.dimension, mesh.order);
  const bool isFlat = mesh.dimension == 2;
  std::vector<std::string> names = mesh.regionNames;
  names.insert(names.end(), mesh.sideNames.begin(), mesh.sideNames.end());
  NameRule rule;
  rule.isPlain = false;
  rule.longest = LineLength - 1;
  names = FormatNames(names, rule);
  Geometry geometry(mesh);
  const std::vector<int> positions = lattice.AbaqusOrder();
  const std::string count = std::to_string(positions.size());
  for (std::size_t region = 0; region < mesh.regionNames.size(); ++region)
  {
    std::vector<int> points;
    for (int cell = 0; cell < mesh.CellCount(); ++cell)
    {
      for (const int position : positions)
      {
        if (mesh.region[Index(cell)] == static_cast<int>(region))
        {
          points.push_back(mesh.Cell(cell)[position]);
        }
      }
    }
    geometry.AddPart(names[region], (isFlat ? "quad" : "hexa") + count, points, positions.size());
  }
  // The nodes of a line are in order; those of a quad are corners, then the middles of edges.
  const std::vector<int> ofFace = isFlat
    ? (mesh.order == 1 ? std::vector<int>{ 0, 1 } : std::vector<int>{ 0, 1, 2 })
    : CellLattice(2, mesh.order).AbaqusOrder();
  for (std::size_t side = 0; side < mesh.sideNames.size(); ++side)
  {
    std::vector<int> points;
    for (const SideFace& face : faces.ofSide[side])
    {
      const std::vector<int> places = lattice.Face(face.face);
      for (const int node : ofFace)
      {
        points.push_back(mesh.Cell(face.cell)[places[Index(node)]]);
      }
    }
    geometry.AddPart(names[mesh.regionNames.size() + side],
      (isFlat ? "bar" : "quad") + std::to_string(ofFace.size()), points, ofFace.size());
  }
  return geometry.Take();
}
}
