#include "LoopText.h"

#include "PipelineRun.h"

#include "vtkCellArray.h"
#include "vtkDelimitedTextReader.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <vtksys/SystemTools.hxx>

#include <array>
#include <cmath>
#include <sstream>
#include <vector>

namespace
{
using PipelineRun::Error;

/** The column of a coordinate, or null. */
vtkAbstractArray* FindColumn(vtkTable* table, int axis)
{
  const std::string number = std::to_string(axis);
  const std::array<std::string, 3> names = { std::string(1, static_cast<char>('x' + axis)),
    "points:" + number, "points_" + number };
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    std::string word;
    const char* title = table->GetColumnName(i);
    std::istringstream(title == nullptr ? "" : title) >> word; // without blanks around it
    for (const std::string& name : names)
    {
      if (vtksys::SystemTools::LowerCase(word) == name)
      {
        return table->GetColumn(i);
      }
    }
  }
  return nullptr;
}

vtkSmartPointer<vtkPolyData> CloseLoop(const std::vector<std::array<double, 3>>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(places.size()) + 1);
  for (const auto& place : places)
  {
    lines->InsertCellPoint(points->InsertNextPoint(place.data()));
  }
  lines->InsertCellPoint(0);
  auto loop = vtkSmartPointer<vtkPolyData>::New();
  loop->SetPoints(points);
  loop->SetLines(lines);
  return loop;
}
}

namespace LoopText
{
vtkSmartPointer<vtkPolyData> ReadTable(const std::string& text, const std::string& file)
{
  vtkNew<vtkDelimitedTextReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(text + "\n"); // no text at all would be no string to VTK
  reader->SetHaveHeaders(true);
  PipelineRun::Update(reader, "reading");
  vtkTable* table = reader->GetOutput();
  vtkAbstractArray* columns[3] = { FindColumn(table, 0), FindColumn(table, 1),
    FindColumn(table, 2) };
  if (columns[0] == nullptr || columns[1] == nullptr)
  {
    throw Error("The file '" + file + "' has no columns x and y; its first line must be x,y.");
  }
  if (table->GetNumberOfRows() == 0)
  {
    throw Error("The file '" + file + "' holds no points; give those of one loop.");
  }
  std::vector<std::array<double, 3>> places;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    places.push_back({ 0.0, 0.0, 0.0 });
    for (std::size_t i = 0; i < 3 && columns[i] != nullptr; ++i)
    {
      bool valid = true;
      places.back()[i] = columns[i]->GetVariantValue(row).ToDouble(&valid);
      if (!valid)
      {
        throw Error("Row " + std::to_string(row + 1) + " of '" + file +
          "' does not hold numbers for its coordinates; correct it.");
      }
    }
  }
  return CloseLoop(places);
}

vtkSmartPointer<vtkPolyData> ReadAerofoil(const std::string& text, const std::string& file)
{
  std::vector<std::array<double, 3>> places;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number)
  {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word))
    {
      continue; // an empty line
    }
    double x = 0.0;
    double y = 0.0;
    std::istringstream numbers(line);
    if (numbers >> x >> y && !(numbers >> word) && std::isfinite(x) && std::isfinite(y))
    {
      places.push_back({ x, y, 0.0 });
    }
    else if (number > 1)
    {
      throw Error("Line " + std::to_string(number) + " of '" + file +
        "' does not hold the two numbers x and y; correct it.");
    }
  }
  if (places.size() < 3)
  {
    throw Error("The file '" + file + "' holds fewer than three points; give those of a profile.");
  }
  // Lednicer's format begins with how many points the upper and the lower side have.
  const double count = places[0][0] + places[0][1];
  if (count == static_cast<double>(places.size() - 1) && places[0][1] > 1.0)
  {
    throw Error("The file '" + file +
      "' is in Lednicer's format, which lists both sides from the leading edge; save it in Selig's, "
      "from the trailing edge around the profile.");
  }
  return CloseLoop(places);
}
}
