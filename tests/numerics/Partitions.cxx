#include "Partitions.h"

#include "CellsAlongLines.h"
#include "RegionSides.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <random>
#include <utility>

namespace crossfield::test
{
void CellMaker::Add(const std::string& material, const Loop& polygon)
{
  auto name = std::find(this->Cells.names.begin(), this->Cells.names.end(), material);
  this->Cells.materials.push_back(static_cast<int>(name - this->Cells.names.begin()));
  if (name == this->Cells.names.end())
  {
    this->Cells.names.push_back(material);
  }
  this->Cells.cells.emplace_back();
  for (const Point& point : polygon)
  {
    const auto key = std::make_pair(std::lround(1e7 * point.x()), std::lround(1e7 * point.y()));
    const auto [found, isNew] =
      this->Numbers.emplace(key, static_cast<int>(this->Cells.points.size()));
    if (isNew)
    {
      this->Cells.points.push_back(point);
    }
    std::vector<int>& cell = this->Cells.cells.back();
    if (cell.empty() || (cell.back() != found->second && cell.front() != found->second))
    {
      cell.push_back(found->second);
    }
  }
}

Loop ArcOf(const Point& centre, double radius, double from, double to, int count)
{
  Loop points;
  for (int i = 0; i <= count; ++i)
  {
    const double angle = from + (to - from) * i / count;
    points.push_back(centre + radius * Point(std::cos(angle), std::sin(angle)));
  }
  return points;
}

MaterialCells ObliqueCut(double degrees)
{
  const double x = 1.0 / std::tan(degrees * Pi / 180.0);
  CellMaker maker;
  maker.Add("left", { { -1, -1 }, { -x, -1 }, { x, 1 }, { -1, 1 } });
  maker.Add("right", { { -x, -1 }, { 1, -1 }, { 1, 1 }, { x, 1 } });
  return maker.Cells;
}

MaterialCells FibreInSquare(double r)
{
  constexpr int Half = 40;
  const Loop upper = ArcOf(Point::Zero(), r, 0.0, Pi, Half);
  const Loop lower = ArcOf(Point::Zero(), r, -Pi, 0.0, Half);
  Loop fibre(upper.begin(), upper.end() - 1);
  fibre.insert(fibre.end(), lower.begin(), lower.end() - 1);
  CellMaker maker;
  maker.Add("fibre", fibre);
  Loop above = { { 1, 0 }, { 1, 1 }, { -1, 1 }, { -1, 0 } };
  above.insert(above.end(), upper.rbegin(), upper.rend());
  Loop below = { { -1, 0 }, { -1, -1 }, { 1, -1 }, { 1, 0 } };
  below.insert(below.end(), lower.rbegin(), lower.rend());
  maker.Add("matrix", above);
  maker.Add("matrix", below);
  return maker.Cells;
}

MaterialCells ThreeSectors()
{
  CellMaker maker;
  for (int i = 0; i < 3; ++i)
  {
    Loop sector = ArcOf(Point::Zero(), 1.0, 2.0 * Pi * i / 3.0, 2.0 * Pi * (i + 1) / 3.0, 40);
    sector.push_back(Point::Zero());
    maker.Add(std::string(1, static_cast<char>('a' + i)), sector);
  }
  return maker.Cells;
}

namespace
{
/// Returns the part of a polygon where (x − middle) · normal ≤ 0.
Loop Clip(const Loop& polygon, const Point& middle, const Point& normal)
{
  Loop clipped;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    const double da = (a - middle).dot(normal);
    const double db = (b - middle).dot(normal);
    if (da <= 0.0)
    {
      clipped.push_back(a);
    }
    if ((da <= 0.0) != (db <= 0.0))
    {
      clipped.push_back(a + da / (da - db) * (b - a));
    }
  }
  return clipped;
}
}

MaterialCells VoronoiCells(unsigned seed, int rows, bool haveInclusions)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  std::vector<Point> seeds;
  for (int i = 0; i < rows * rows; ++i)
  {
    const double x = i % rows + 0.5 + jitter(random);
    const double y = i / rows + 0.5 + jitter(random);
    seeds.emplace_back(2.0 * x / rows - 1.0, 2.0 * y / rows - 1.0);
  }
  std::vector<Loop> cells;
  for (const Point& own : seeds)
  {
    Loop cell = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
    for (const Point& other : seeds)
    {
      if (other != own)
      {
        cell = Clip(cell, 0.5 * (own + other), other - own);
      }
    }
    cells.push_back(cell);
  }
  CellMaker maker;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const std::string name = "m" + std::to_string(i);
    if (!haveInclusions || i % 2 == 1)
    {
      maker.Add(name, cells[i]);
      continue;
    }
    const Point middle = std::accumulate(cells[i].begin(), cells[i].end(), Point(0, 0)) /
      static_cast<double>(cells[i].size());
    Loop inner;
    std::transform(cells[i].begin(), cells[i].end(), std::back_inserter(inner),
      [&middle](const Point& corner) -> Point { return 0.5 * (middle + corner); });
    for (std::size_t c = 0; c < inner.size(); ++c)
    {
      const std::size_t next = (c + 1) % inner.size();
      maker.Add(name, { cells[i][c], cells[i][next], inner[next], inner[c] });
    }
    maker.Add("inclusion", inner);
  }
  return maker.Cells;
}

MaterialCells SquareWithLines(const std::vector<std::pair<std::string, Loop>>& lines)
{
  std::vector<SegmentOnLine> segments;
  std::vector<std::string> names;
  for (const auto& [name, points] : lines)
  {
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      segments.push_back({ points[i - 1], points[i], static_cast<int>(names.size()) });
    }
    names.push_back(name);
  }
  const PlanarDomain square{ { { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } } };
  return CellsAlongLines(EdgesOf(square), { "plate" }, segments, names);
}

std::vector<DomainPart> PartsOf(const RegionSet& set)
{
  std::vector<DomainPart> parts;
  std::vector<std::string> taken;
  for (std::size_t r = 0; r < set.regions.size(); ++r)
  {
    parts.push_back({ set.regions[r].domain, SidesOfRegion(set, r, {}, taken), {} });
    const BoundarySides& sides = parts.back().sides;
    taken.insert(taken.end(), sides.names.begin() + sides.given, sides.names.end());
  }
  return parts;
}
}
