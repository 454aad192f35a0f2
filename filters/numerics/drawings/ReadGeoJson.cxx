#include "ReadGeoJson.h"

#include "Error.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace crossfield
{
namespace
{
using Json = nlohmann::json;

class GeoJsonReader
{
public:
  explicit GeoJsonReader(std::string file)
    : File(std::move(file))
  {
  }

  Drawing Read(std::string_view text)
  {
    const Json document = Json::parse(text, nullptr, false);
    if (document.is_discarded())
    {
      throw Error("The file '" + this->File + "' is no valid JSON; export it again.");
    }
    this->Collect(document, 0);
    if (this->Polygons.empty())
    {
      throw Error("The file '" + this->File + "' has no polygon; give one.");
    }
    for (const Json* polygon : this->Polygons)
    {
      this->AddRings(*polygon);
    }
    this->Result.unit = document.contains("crs") ? "" : "degree";
    if (this->Others > 0)
    {
      this->Result.warnings.push_back(std::to_string(this->Others) + " geometries of '" +
        this->File + "' that are no polygons were left out.");
    }
    if (this->SmallRings > 0)
    {
      this->Result.warnings.push_back(std::to_string(this->SmallRings) +
        (this->SmallRings == 1 ? " ring of '" : " rings of '") + this->File +
        "' with fewer than three places " + (this->SmallRings == 1 ? "was" : "were") +
        " left out.");
    }
    return std::move(this->Result);
  }

private:
  /// Returns a member of an object, null if it does not exist.
  static const Json& Member(const Json& object, const char* name)
  {
    static const Json None;
    const auto found = object.is_object() ? object.find(name) : object.end();
    return object.is_object() && found != object.end() ? *found : None;
  }

  /// Collects the polygons of a geometry, feature or collection.
  void Collect(const Json& object, int depth)
  {
    constexpr int Deepest = 32;
    const Json& type = Member(object, "type");
    if (!type.is_string() || depth > Deepest)
    {
      throw Error("The file '" + this->File +
        "' has an object that is no geometry or feature of GeoJSON; export it again.");
    }
    const auto& name = type.get_ref<const std::string&>();
    if (name == "FeatureCollection" || name == "GeometryCollection")
    {
      for (const Json& part : Member(object, name[0] == 'F' ? "features" : "geometries"))
      {
        this->Collect(part, depth + 1);
      }
    }
    else if (name == "Feature")
    {
      if (!Member(object, "geometry").is_null())
      {
        this->Collect(Member(object, "geometry"), depth + 1);
      }
    }
    else if (name == "Polygon")
    {
      this->Polygons.push_back(&Member(object, "coordinates"));
    }
    else if (name == "MultiPolygon")
    {
      for (const Json& part : Member(object, "coordinates"))
      {
        this->Polygons.push_back(&part);
      }
    }
    else
    {
      ++this->Others;
    }
  }

  void Require(bool isValid, std::size_t ring) const
  {
    if (!isValid)
    {
      throw Error("Ring " + std::to_string(ring + 1) + " of the polygon of '" + this->File +
        "' is no list of at least three places with two finite coordinates; correct it.");
    }
  }

  void AddRings(const Json& rings)
  {
    this->Require(rings.is_array(), 0);
    for (std::size_t ring = 0; ring < rings.size(); ++ring)
    {
      this->Require(rings[ring].is_array(), ring);
      std::vector<Point> points;
      for (const Json& place : rings[ring])
      {
        this->Require(
          place.is_array() && place.size() >= 2 && place[0].is_number() && place[1].is_number(),
          ring);
        const Point point(place[0].get<double>(), place[1].get<double>());
        this->Require(point.allFinite(), ring);
        if (points.empty() || point != points.back())
        {
          points.push_back(point);
        }
      }
      if (points.size() > 1 && points.front() == points.back())
      {
        points.pop_back();
      }
      if (points.size() < 3 && ring > 0)
      {
        ++this->SmallRings;
        continue;
      }
      this->Require(points.size() >= 3, ring);
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        DrawingPiece piece = LinePiece(points[i], points[(i + 1) % points.size()]);
        piece.isExact = false;
        piece.origin = "segment " + std::to_string(i + 1) + " of ring " + std::to_string(ring + 1);
        this->Result.pieces.push_back(std::move(piece));
      }
    }
  }

  std::string File;
  std::vector<const Json*> Polygons;
  std::size_t Others = 0;
  std::size_t SmallRings = 0;
  Drawing Result;
};
}

Drawing ReadGeoJson(std::string_view text, const std::string& file)
{
  return GeoJsonReader(file).Read(text);
}
}
