#include "LoopText.h"

#include "Error.h"
#include "PointTable.h"

#include "vtkAbstractArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <vtksys/SystemTools.hxx>

#include <cmath>
#include <map>
#include <sstream>

namespace
{
using crossfield::Error;
using LoopText::Loop;

/** Reads the two numbers of a line; returns false if it does not have exactly two. */
bool ReadPair(const std::string& line, double& x, double& y)
{
  std::istringstream numbers(line);
  std::string rest;
  return numbers >> x >> y && !(numbers >> rest) && std::isfinite(x) && std::isfinite(y);
}

bool IsBlank(const std::string& line)
{
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

/**
 * Returns the loops. Throws crossfield::Error if one of several loops has fewer than three points.
 * The filters check a single loop, but would ignore one of several.
 */
std::vector<Loop> RequireComplete(std::vector<Loop> loops, const std::string& file)
{
  for (std::size_t i = 0; i < loops.size() && loops.size() > 1; ++i)
  {
    if (loops[i].size() < 3)
    {
      throw Error("Loop " + std::to_string(i + 1) + " of '" + file +
        "' holds fewer than three points; complete or remove it.");
    }
  }
  return loops;
}
}

namespace LoopText
{
Format FindFormat(const std::string& text, const std::string& file)
{
  const std::string ending =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file));
  if (ending == ".csv" || ending == ".dat")
  {
    return ending == ".csv" ? Format::Table : Format::Aerofoil;
  }
  const std::string firstLine = text.substr(0, text.find('\n'));
  return firstLine.find(',') != std::string::npos ? Format::Table : Format::Aerofoil;
}

bool LooksLike(const std::string& text, Format format)
{
  std::istringstream lines(text);
  std::string first;
  std::string second;
  std::getline(lines, first);
  if (format == Format::Table)
  {
    const auto table = PointTable::Read(first);
    return PointTable::FindColumn(table, PointTable::NamesOfAxis(0)) != nullptr &&
      PointTable::FindColumn(table, PointTable::NamesOfAxis(1)) != nullptr;
  }
  while (std::getline(lines, second) && IsBlank(second))
  {
  }
  double x = 0.0;
  double y = 0.0;
  return ReadPair(second, x, y);
}

std::vector<Loop> ReadTable(const std::string& text, const std::string& file)
{
  const auto table = PointTable::Read(text);
  std::array<vtkAbstractArray*, 3> columns{};
  for (int axis = 0; axis < 3; ++axis)
  {
    columns[axis] = PointTable::FindColumn(table, PointTable::NamesOfAxis(axis));
  }
  if (columns[0] == nullptr || columns[1] == nullptr)
  {
    throw Error("The file '" + file + "' has no columns x and y; its first line must be x,y.");
  }
  if (table->GetNumberOfRows() == 0)
  {
    throw Error("The file '" + file + "' holds no points; add the points of a loop.");
  }
  vtkAbstractArray* names = PointTable::FindColumn(table, { "loop" });
  std::map<std::string, std::size_t> known;
  std::vector<Loop> loops;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    std::array<double, 3> place = { 0.0, 0.0, 0.0 };
    for (std::size_t i = 0; i < 3 && columns[i] != nullptr; ++i)
    {
      const auto number = PointTable::NumberAt(columns[i], row);
      place[i] = number.value_or(0.0);
      if (!number)
      {
        throw Error("Row " + std::to_string(row + 1) + " of '" + file +
          "' does not hold numbers for its coordinates; correct it.");
      }
    }
    const std::string name = names == nullptr ? "" : names->GetVariantValue(row).ToString();
    const std::size_t loop = known.emplace(name, loops.size()).first->second;
    loops.resize(known.size());
    loops[loop].push_back(place);
  }
  return RequireComplete(loops, file);
}

std::vector<Loop> ReadAerofoil(const std::string& text, const std::string& file)
{
  std::vector<Loop> loops(1);
  std::istringstream lines(text);
  std::string line;
  int blanks = 0;
  for (int number = 1; std::getline(lines, line); ++number)
  {
    double x = 0.0;
    double y = 0.0;
    if (IsBlank(line))
    {
      ++blanks;
      continue;
    }
    const bool isPair = ReadPair(line, x, y);
    if (!isPair && number > 1)
    {
      throw Error("Line " + std::to_string(number) + " of '" + file +
        "' does not hold the two numbers x and y; correct it.");
    }
    const bool separates = isPair && x == 999.0 && y == 999.0;
    if ((separates || blanks > 1) && !loops.back().empty())
    {
      loops.emplace_back();
    }
    blanks = 0;
    if (isPair && !separates)
    {
      loops.back().push_back({ x, y, 0.0 });
    }
  }
  if (loops.size() > 1 && loops.back().empty())
  {
    loops.pop_back(); // separator after the last loop
  }
  if (loops[0].size() < 3)
  {
    throw Error(
      "The file '" + file + "' holds fewer than three points; add the points of a profile.");
  }
  // The first row of Lednicer's format has the numbers of points of the upper and the lower side.
  const std::array<double, 3> first = loops[0][0];
  std::size_t count = 0;
  for (const Loop& loop : loops)
  {
    count += loop.size();
  }
  if (first[0] + first[1] == static_cast<double>(count - 1) && first[1] > 1.0)
  {
    throw Error("The file '" + file +
      "' is in Lednicer's format, which lists both sides from the leading edge; save it in Selig's, "
      "from the trailing edge around the profile.");
  }
  return RequireComplete(loops, file);
}

std::vector<Loop> Read(const std::string& text, const std::string& file)
{
  return FindFormat(text, file) == Format::Table ? ReadTable(text, file) : ReadAerofoil(text, file);
}
}
