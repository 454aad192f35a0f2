#include "ReadPoly.h"

#include "Error.h"
#include "NumberLines.h"
#include "UnionFind.h"

#include <utility>
#include <vector>

namespace crossfield
{
namespace
{
/// Reads the points in the order of their numbers, which begin at 0 or 1, and returns the first number.
int ReadPoints(NumberLines& lines, const std::string& file, std::vector<Point>& points)
{
  lines.Next();
  const int count = lines.Count(0);
  if (count == 0)
  {
    throw Error("The file '" + file +
      "' has no points, which may be in a .node file; write them into the .poly file.");
  }
  if (lines.Size() > 1 && lines.Count(1) != 2)
  {
    lines.Refuse("says that points have other than 2 coordinates");
  }
  int first = 0;
  for (int i = 0; i < count; ++i)
  {
    lines.Next();
    const int number = lines.Count(0);
    first = i == 0 ? number : first;
    if (first > 1 || number != first + i)
    {
      lines.Refuse("has not the next number of a point, counted from 0 or 1");
    }
    points.emplace_back(lines.Number(1), lines.Number(2));
  }
  return first;
}
}

Drawing ReadPoly(std::string_view text, const std::string& file)
{
  NumberLines lines(text, file);
  std::vector<Point> points;
  const int first = ReadPoints(lines, file, points);
  Drawing drawing;
  lines.Next();
  const int segments = lines.Count(0, 1);
  UnionFind joined(points.size());
  int curves = 0;
  std::vector<bool> isUsed(points.size(), false);
  const bool hasMarkers = lines.Size() > 1 && lines.Count(1) > 0;
  for (int i = 0; i < segments; ++i)
  {
    lines.Next();
    const auto end = [&](std::size_t entry)
    {
      const int number = lines.Count(entry) - first;
      if (number < 0 || number >= static_cast<int>(points.size()))
      {
        lines.Refuse("names a point that the file has not");
      }
      return static_cast<std::size_t>(number);
    };
    const std::size_t from = end(1);
    const std::size_t to = end(2);
    for (const std::size_t point : { from, to })
    {
      curves += isUsed[point] ? 0 : 1;
      isUsed[point] = true;
    }
    curves -= joined.Join(static_cast<int>(from), static_cast<int>(to)) ? 1 : 0;
    DrawingPiece piece = LinePiece(points[from], points[to]);
    piece.isExact = false; // may be a chord of a curve
    piece.name = hasMarkers && lines.Size() > 3 && lines.Word(3) != "0" ? lines.Word(3) : "";
    piece.origin = "segment " + std::to_string(i + 1);
    if (piece.first != piece.last)
    {
      drawing.pieces.push_back(std::move(piece));
    }
  }
  lines.Next();
  const int holes = lines.Count(0);
  for (int i = 0; i < holes; ++i)
  {
    lines.Next();
    lines.Number(1);
    lines.Number(2);
  }
  if (holes != curves - 1)
  {
    drawing.warnings.push_back("The file '" + file + "' has " + std::to_string(holes) +
      (holes == 1 ? " hole" : " holes") + " and " + std::to_string(curves) +
      " curves that are not joined; every closed curve inside another one is taken for a hole.");
  }
  return drawing;
}
}
