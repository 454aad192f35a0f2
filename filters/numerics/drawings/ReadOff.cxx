#include "ReadOff.h"

#include "Error.h"
#include "NumberLines.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace crossfield
{
Drawing ReadOff(std::string_view text, const std::string& file)
{
  NumberLines lines(text, file);
  lines.Next();
  const std::string_view word = lines.Word(0);
  const bool isOff = word.size() >= 3 && word.substr(word.size() - 3) == "OFF";
  if (!isOff || word == "4OFF" || word == "nOFF" || lines.Size() > 1)
  {
    lines.Refuse("is not OFF, which an .off file of ASCII in space begins with");
  }
  lines.Next();
  const int pointCount = lines.Count(0, 3);
  const int faceCount = lines.Count(1, 1);
  Eigen::Matrix3Xd places(3, pointCount);
  for (int i = 0; i < pointCount; ++i)
  {
    lines.Next();
    for (const int axis : { 0, 1, 2 })
    {
      places(axis, i) = lines.Number(static_cast<std::size_t>(axis));
    }
  }
  std::map<std::pair<int, int>, int> faces; // numbers of faces of edges
  DrawingSurface surface;
  for (int face = 0; face < faceCount; ++face)
  {
    lines.Next();
    const auto corners = static_cast<std::size_t>(lines.Count(0, 3));
    const auto corner = [&](std::size_t i)
    {
      const int number = lines.Count(1 + i % corners);
      if (number >= pointCount)
      {
        lines.Refuse("names a point that the file has not");
      }
      return number;
    };
    surface.polygons.emplace_back();
    for (std::size_t i = 0; i < corners; ++i)
    {
      ++faces[std::minmax({ corner(i), corner(i + 1) })];
      surface.polygons.back().push_back(corner(i));
    }
  }
  std::vector<std::pair<int, int>> boundary;
  Eigen::Matrix3Xd used(3, 2 * static_cast<Eigen::Index>(faces.size()));
  Eigen::Index count = 0;
  for (const auto& [edge, number] : faces)
  {
    used.col(count++) = places.col(edge.first);
    used.col(count++) = places.col(edge.second);
    if (number == 1 && edge.first != edge.second)
    {
      boundary.push_back(edge);
    }
  }
  if (faceCount > 0 && !DomainPlane::Nearest(used).IsNear())
  {
    for (int i = 0; i < pointCount; ++i)
    {
      surface.points.emplace_back(places.col(i));
    }
    Drawing drawing;
    drawing.surface = std::move(surface);
    return drawing;
  }
  if (boundary.empty())
  {
    throw Error("The mesh '" + file + "' has no boundary; give a planar mesh.");
  }
  Drawing drawing;
  drawing.FindPlane(used);
  for (const auto& [from, to] : boundary)
  {
    DrawingPiece piece =
      LinePiece(drawing.plane.ToPlane(places.col(from)), drawing.plane.ToPlane(places.col(to)));
    piece.isExact = false;
    piece.origin =
      "the edge from point " + std::to_string(from) + " to point " + std::to_string(to);
    if (piece.first != piece.last)
    {
      drawing.pieces.push_back(std::move(piece));
    }
  }
  return drawing;
}
}
