#pragma once

#include "PartRequests.h"
#include "RegionSet.h"

#include <map>
#include <string>
#include <vector>

namespace crossfield::test
{
/// Collects polygons of materials; points at equal places are one.
class CellMaker
{
public:
  void Add(const std::string& material, const Loop& polygon);

  MaterialCells Cells;

private:
  std::map<std::pair<long, long>, int> Numbers;
};

/// Returns points of an arc in the plane, both ends included.
Loop ArcOf(const Point& centre, double radius, double from, double to, int count);

/// A square [−1, 1]² cut by the line through its centre at an angle with the x axis.
MaterialCells ObliqueCut(double degrees);

/// A disc of radius r in a square [−1, 1]².
MaterialCells FibreInSquare(double r);

/// Three sectors of 120° of a disc.
MaterialCells ThreeSectors();

/// The Voronoi cells of points of a jittered grid in a square [−1, 1]², each of a material of its own; on
/// request every second one has an inclusion of half its size.
MaterialCells VoronoiCells(unsigned seed, int rows, bool haveInclusions = false);

/// A square [−1, 1]² of the material `plate` with lines, by name.
MaterialCells SquareWithLines(const std::vector<std::pair<std::string, Loop>>& lines);

/// Returns the regions of a set with their sides.
std::vector<DomainPart> PartsOf(const RegionSet& set);
}
