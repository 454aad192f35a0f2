#include "ReadDxf.h"

#include "CurvePieces.h"
#include "DxfCurves.h"
#include "DxfText.h"
#include "Error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
/// An entity with the vertices that follow a POLYLINE.
struct Entity
{
  DxfObject object;
  std::vector<DxfObject> vertices;
};

struct Block
{
  Point base = Point::Zero();
  std::vector<Entity> entities;
};

/// Returns the name of the unit of $INSUNITS.
std::string UnitName(int code)
{
  constexpr std::array<const char*, 21> Names = { "", "in", "ft", "mi", "mm", "cm", "m", "km",
    "µin", "mil", "yd", "Å", "nm", "µm", "dm", "dam", "hm", "Gm", "au", "ly", "pc" };
  return code >= 0 && code < static_cast<int>(Names.size()) ? Names[code] : "";
}

/// Reads the sections of a file and inserts the blocks.
class DxfReader
{
public:
  explicit DxfReader(std::vector<DxfObject> objects)
    : Objects(std::move(objects))
  {
  }

  Drawing Read(const std::string& file)
  {
    std::vector<Entity> entities;
    bool hasEntities = false;
    while (this->At < this->Objects.size())
    {
      const DxfObject& object = this->Objects[this->At++];
      const std::string_view section = object.Type() == "SECTION" ? object.Text(2) : "";
      if (section == "HEADER")
      {
        this->ReadHeader(object);
      }
      else if (section == "TABLES")
      {
        this->ReadLayers();
      }
      else if (section == "BLOCKS")
      {
        this->ReadBlocks();
      }
      else if (section == "ENTITIES")
      {
        hasEntities = true;
        entities = this->ReadEntities("ENDSEC");
      }
    }
    if (!hasEntities)
    {
      throw Error("The file '" + file + "' has no section ENTITIES; export the drawing again.");
    }
    this->Insert(entities, IdentityMap(), "", 0);
    this->Finish(file);
    return std::move(this->Result);
  }

private:
  void ReadHeader(const DxfObject& header)
  {
    const std::vector<DxfGroup>& groups = header.All();
    for (std::size_t i = 0; i + 1 < groups.size(); ++i)
    {
      if (groups[i].code == 9 && groups[i].value == "$INSUNITS")
      {
        const double code = DxfObject::NumberOf(groups[i + 1]);
        this->Result.unit = UnitName(code >= 0.0 && code < 100.0 ? static_cast<int>(code) : 0);
      }
    }
  }

  void ReadLayers()
  {
    for (; this->At < this->Objects.size() && this->Objects[this->At].Type() != "ENDSEC";
         ++this->At)
    {
      const DxfObject& object = this->Objects[this->At];
      constexpr int Frozen = 1;
      if (object.Type() == "LAYER" &&
        (object.Number(62, 7.0) < 0.0 || (object.Integer(70) & Frozen) != 0))
      {
        this->HiddenLayers.emplace(object.Text(2));
      }
    }
  }

  void ReadBlocks()
  {
    while (this->At < this->Objects.size() && this->Objects[this->At].Type() != "ENDSEC")
    {
      const DxfObject object = this->Objects[this->At++];
      if (object.Type() == "BLOCK")
      {
        Block& block = this->Blocks[std::string(object.Text(2))];
        block.base = object.Place(10);
        block.entities = this->ReadEntities("ENDBLK");
      }
    }
  }

  std::vector<Entity> ReadEntities(std::string_view end)
  {
    std::vector<Entity> entities;
    for (; this->At < this->Objects.size(); ++this->At)
    {
      const DxfObject& object = this->Objects[this->At];
      if (object.Type() == end)
      {
        return entities;
      }
      if (object.Type() == "VERTEX" && !entities.empty())
      {
        entities.back().vertices.push_back(object);
      }
      else if (object.Type() != "SEQEND")
      {
        entities.push_back({ object, {} });
      }
    }
    throw Error(
      "A section of the drawing has no end " + std::string(end) + "; export the drawing again.");
  }

  /// Adds the pieces of entities that a map places. Curves on layer 0 have the given layer.
  void Insert(
    const std::vector<Entity>& entities, const AffineMap& map, const std::string& layer, int depth)
  {
    for (const Entity& entity : entities)
    {
      this->CountWork();
      const DxfObject& object = entity.object;
      constexpr int PaperSpace = 67;
      if (object.Integer(PaperSpace) != 0)
      {
        continue;
      }
      const std::string own = std::string(object.Text(8));
      const std::string name = own.empty() || own == "0" ? layer : own;
      constexpr int Meshes = 16 | 64;
      const bool isMesh = object.Type() == "POLYLINE" && (object.Integer(70) & Meshes) != 0;
      if (this->HiddenLayers.count(own.empty() ? "0" : own) > 0)
      {
        ++this->Hidden;
      }
      else if (object.Type() == "INSERT")
      {
        this->InsertBlock(object, map, name, depth);
      }
      else if (IsDxfCurve(object.Type()) && !isMesh)
      {
        this->AddCurve(entity, map, name);
      }
      else
      {
        ++this->Ignored[std::string(object.Type())];
      }
    }
  }

  void AddCurve(const Entity& entity, const AffineMap& map, const std::string& name)
  {
    this->NoteHeight(entity.object);
    for (DrawingPiece& piece : DxfCurves(entity.object, entity.vertices))
    {
      Transform(map, piece);
      piece.name = name;
      piece.origin += name.empty() ? "" : " (layer '" + name + "')";
      this->Result.pieces.push_back(std::move(piece));
    }
  }

  void CountWork()
  {
    constexpr std::size_t MostEntities = 2000000;
    if (++this->Work > MostEntities)
    {
      throw Error("The blocks of the drawing insert more than two million entities; explode and "
                  "simplify the drawing.");
    }
  }

  void InsertBlock(
    const DxfObject& insert, const AffineMap& map, const std::string& name, int depth)
  {
    constexpr int Deepest = 32;
    const auto block = this->Blocks.find(std::string(insert.Text(2)));
    if (block == this->Blocks.end())
    {
      throw Error("The block '" + std::string(insert.Text(2)) + "' of " + insert.Origin() +
        " is not defined; explode it in the drawing.");
    }
    if (depth >= Deepest)
    {
      throw Error("The block '" + block->first +
        "' inserts itself or is nested too deeply; explode it in the drawing.");
    }
    const double angle = insert.Number(50) * Pi / 180.0;
    const Point scale(insert.Number(41, 1.0), insert.Number(42, 1.0));
    AffineMap turn = IdentityMap();
    turn.leftCols<2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    const int columns = std::max(insert.Integer(70, 1), 1);
    const int rows = std::max(insert.Integer(71, 1), 1);
    for (int row = 0; row < rows; ++row)
    {
      for (int column = 0; column < columns; ++column)
      {
        this->CountWork();
        AffineMap place = IdentityMap();
        place(0, 0) = scale.x();
        place(1, 1) = scale.y();
        place.col(2) = Point(column * insert.Number(44), row * insert.Number(45)) -
          scale.cwiseProduct(block->second.base);
        AffineMap whole = Compose(turn, place);
        whole.col(2) += insert.Place(10);
        this->Insert(block->second.entities, Compose(map, Compose(DxfEntityMap(insert), whole)),
          name, depth + 1);
      }
    }
  }

  /// Records the z coordinates of an entity.
  void NoteHeight(const DxfObject& object)
  {
    const double sign = object.Number(230, 1.0) < 0.0 ? -1.0 : 1.0;
    const bool isLight = object.Type() == "LWPOLYLINE";
    for (const int code : { isLight ? 38 : 30, 31 })
    {
      if (code == 31 && object.Type() != "LINE" && object.Type() != "SPLINE")
      {
        continue;
      }
      for (const double z : object.Numbers(code))
      {
        this->Lowest = std::min(this->Lowest, sign * z);
        this->Highest = std::max(this->Highest, sign * z);
      }
    }
  }

  void Finish(const std::string& file)
  {
    std::string ignored;
    std::size_t count = 0;
    for (const auto& [type, number] : this->Ignored)
    {
      ignored += (ignored.empty() ? "" : ", ") + std::to_string(number) + " " + type;
      count += number;
    }
    if (this->Result.pieces.empty())
    {
      throw Error("The file '" + file + "' has no visible lines, arcs or splines" +
        (count > 0 ? " but " + ignored : "") + "; draw the boundary of the domain.");
    }
    if (count > 0)
    {
      this->Result.warnings.push_back(
        "Entities of '" + file + "' that are no curves were left out: " + ignored + ".");
    }
    if (this->Hidden > 0)
    {
      this->Result.warnings.push_back(std::to_string(this->Hidden) + " entities of '" + file +
        "' on layers that are off or frozen were left out.");
    }
    this->SetHeight(file);
  }

  void SetHeight(const std::string& file)
  {
    if (this->Lowest > this->Highest)
    {
      return;
    }
    // Single precision is enough to tell drawings from models in space.
    constexpr double Rounding = 1e-6;
    Eigen::Vector2d size = Eigen::Vector2d::Zero();
    for (const DrawingPiece& piece : this->Result.pieces)
    {
      size = size.cwiseMax((piece.first - this->Result.pieces.front().first).cwiseAbs());
    }
    if (this->Highest - this->Lowest >
      Rounding * (size.norm() + std::abs(this->Lowest) + std::abs(this->Highest)))
    {
      throw Error("The curves of '" + file + "' are not in one plane z = const: z ranges from " +
        std::to_string(this->Lowest) + " to " + std::to_string(this->Highest) +
        "; flatten the drawing.");
    }
    Eigen::Matrix3d corners = Eigen::Matrix3d::Identity();
    corners.row(2).setConstant(this->Lowest);
    this->Result.plane = DomainPlane::Find(corners);
  }

  std::vector<DxfObject> Objects;
  std::size_t At = 0;
  std::map<std::string, Block> Blocks;
  std::set<std::string> HiddenLayers;
  std::map<std::string, std::size_t> Ignored;
  std::size_t Hidden = 0;
  std::size_t Work = 0;
  double Lowest = std::numeric_limits<double>::max();
  double Highest = std::numeric_limits<double>::lowest();
  Drawing Result;
};
}

Drawing ReadDxf(std::string_view text, const std::string& file)
{
  return DxfReader(SplitDxf(text, file)).Read(file);
}
}
