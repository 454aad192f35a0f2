#include "WriteCgns.h"

#include "BlockFaces.h"
#include "CgnsFile.h"
#include "Error.h"
#include "FormatNames.h"
#include "Index.h"

#include <cgnslib.h>

#include <array>
#include <cstdlib>
#include <exception>
#include <utility>

namespace
{
using crossfield::BlockConnection;
using crossfield::BlockFaces;
using crossfield::BlockRange;
using crossfield::Index;
using crossfield::MeshBlock;
using crossfield::SolverMesh;

constexpr std::size_t NameLength = 32;

crossfield::NameRule Rule()
{
  crossfield::NameRule rule;
  rule.isPlain = false;
  rule.isPathPart = true;
  rule.longest = NameLength;
  return rule;
}

std::string ZoneName(std::size_t block)
{
  return "block" + std::to_string(block);
}

/** A mesh that is written to the base of a file. */
class Writer
{
public:
  Writer(const SolverMesh& mesh, int file)
    : Mesh(mesh)
    , File(file)
  {
    this->Faces = FindBlockFaces(mesh, crossfield::MeshFaces(mesh));
  }

  void Write()
  {
    const bool isPlane = this->Mesh.dimension == 2 && this->Mesh.HasConstantHeight();
    const int space = isPlane ? 2 : 3;
    CgnsFile::Require(cg_base_write(this->File, "Base", this->Mesh.dimension, space, &this->Base));
    // Lengths have the unit of the domain, which is not known.
    CgnsFile::Require(cg_goto(this->File, this->Base, "end"));
    CgnsFile::Require(cg_dataclass_write(CGNS_ENUMV(NormalizedByUnknownDimensional)));
    std::vector<std::string> zones;
    for (std::size_t block = 0; block < this->Mesh.blocks.size(); ++block)
    {
      zones.push_back(ZoneName(block));
    }
    this->Families = FormatNames(this->Mesh.sideNames, Rule(), zones);
    for (const std::string& name : this->Families)
    {
      int family = 0;
      int condition = 0;
      CgnsFile::Require(cg_family_write(this->File, this->Base, name.c_str(), &family));
      CgnsFile::Require(cg_fambc_write(
        this->File, this->Base, family, "FamBC", CGNS_ENUMV(BCTypeUserDefined), &condition));
    }
    for (std::size_t block = 0; block < this->Mesh.blocks.size(); ++block)
    {
      this->WriteZone(block, space);
    }
    this->WriteConnections();
    this->WriteConditions();
  }

private:
  void WriteZone(std::size_t number, int space)
  {
    const MeshBlock& block = this->Mesh.blocks[number];
    std::vector<cgsize_t> size; // numbers of points, of cells, then zeros
    for (const int points : { 1, 0 })
    {
      for (int d = 0; d < this->Mesh.dimension; ++d)
      {
        size.push_back(block.cells[d] + points);
      }
    }
    size.resize(3 * Index(this->Mesh.dimension), 0);
    int zone = 0;
    CgnsFile::Require(cg_zone_write(this->File, this->Base, ZoneName(number).c_str(), size.data(),
      CGNS_ENUMV(Structured), &zone));
    this->Zones.push_back(zone);
    std::vector<double> values(block.nodes.size());
    const std::array<const char*, 3> names = { "CoordinateX", "CoordinateY", "CoordinateZ" };
    for (int axis = 0; axis < space; ++axis)
    {
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        values[i] = this->Mesh.points[block.nodes[i]][axis];
      }
      int coordinate = 0;
      CgnsFile::Require(cg_coord_write(this->File, this->Base, zone, CGNS_ENUMV(RealDouble),
        names[axis], values.data(), &coordinate));
      CgnsFile::Require(cg_goto(this->File, this->Base, "Zone_t", zone, "GridCoordinates_t", 1,
        "DataArray_t", coordinate, "end"));
      const std::array<double, 5> length = { 0.0, 1.0, 0.0, 0.0, 0.0 }; // powers of the units
      CgnsFile::Require(cg_exponents_write(CGNS_ENUMV(RealDouble), length.data()));
    }
  }

  /** Returns the indices of both corners from 1, first those of the first corner. */
  std::vector<cgsize_t> IndicesOf(const BlockRange& range) const
  {
    std::vector<cgsize_t> indices;
    for (const auto& corner : { range.begin, range.end })
    {
      for (int d = 0; d < this->Mesh.dimension; ++d)
      {
        indices.push_back(corner[d] + 1);
      }
    }
    return indices;
  }

  /** Writes a connection to the zone of its first block. The points of its range are in ascending order. */
  void WriteConnection(BlockConnection connection)
  {
    BlockRange& from = connection.from;
    BlockRange& to = connection.to;
    for (int d = 0; d < this->Mesh.dimension; ++d)
    {
      if (from.begin[d] > from.end[d])
      {
        const std::size_t image = Index(std::abs(connection.transform[d]) - 1);
        std::swap(from.begin[d], from.end[d]);
        std::swap(to.begin[image], to.end[image]);
      }
    }
    const std::string name = "connection" + std::to_string(++this->CountOfConnections);
    const std::vector<cgsize_t> range = this->IndicesOf(from);
    const std::vector<cgsize_t> donor = this->IndicesOf(to);
    int number = 0;
    CgnsFile::Require(cg_1to1_write(this->File, this->Base, this->Zones[from.block], name.c_str(),
      ZoneName(Index(to.block)).c_str(), range.data(), donor.data(), connection.transform.data(),
      &number));
  }

  /** Writes every connection to the zones on both of its sides. */
  void WriteConnections()
  {
    for (const BlockConnection& connection : this->Faces.connections)
    {
      BlockConnection back = { connection.to, connection.from, {} };
      for (int d = 0; d < this->Mesh.dimension; ++d)
      {
        const int image = connection.transform[d];
        back.transform[std::abs(image) - 1] = image > 0 ? d + 1 : -(d + 1);
      }
      this->WriteConnection(connection);
      this->WriteConnection(back);
    }
  }

  int WriteCondition(const std::string& name, CGNS_ENUMT(BCType_t) type, const BlockRange& range)
  {
    const std::vector<cgsize_t> points = this->IndicesOf(range);
    int condition = 0;
    CgnsFile::Require(cg_boco_write(this->File, this->Base, this->Zones[range.block], name.c_str(),
      type, CGNS_ENUMV(PointRange), 2, points.data(), &condition));
    return condition;
  }

  void WriteConditions()
  {
    std::vector<std::string> names; // of all pieces, different from each other in the whole file
    for (const crossfield::BlockPatch& patch : this->Faces.patches)
    {
      names.push_back(this->Families[patch.side]);
    }
    for (std::size_t i = 0; i < this->Faces.collapsed.size(); ++i)
    {
      names.emplace_back("axis");
    }
    names = FormatNames(names, Rule());
    std::size_t next = 0;
    for (const crossfield::BlockPatch& patch : this->Faces.patches)
    {
      const int condition =
        this->WriteCondition(names[next++], CGNS_ENUMV(FamilySpecified), patch.range);
      CgnsFile::Require(cg_goto(this->File, this->Base, "Zone_t", this->Zones[patch.range.block],
        "ZoneBC_t", 1, "BC_t", condition, "end"));
      CgnsFile::Require(cg_famname_write(this->Families[patch.side].c_str()));
    }
    for (const BlockRange& range : this->Faces.collapsed)
    {
      this->WriteCondition(names[next++], CGNS_ENUMV(BCDegenerateLine), range);
    }
  }

  const SolverMesh& Mesh;
  int File;
  BlockFaces Faces;
  int Base = 0;
  std::vector<int> Zones;            ///< Per block, its number in the file.
  std::vector<std::string> Families; ///< Per side, its name in the file.
  int CountOfConnections = 0;
};
}

void crossfieldWriteCgns(const SolverMesh& mesh, std::string& bytes, std::string& error)
{
  try
  {
    CgnsFile file;
    Writer(mesh, file.Number()).Write();
    bytes = file.Take();
  }
  catch (const std::exception& problem)
  {
    error = problem.what();
  }
}
