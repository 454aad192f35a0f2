#include "PointTable.h"

#include "vtkAbstractArray.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDelimitedTextReader.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

namespace PointTable
{
std::string ReadFile(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

vtkSmartPointer<vtkTable> Read(const std::string& text)
{
  vtkNew<vtkDelimitedTextReader> reader;
  // Messages of VTK about bytes that are not text are not printed. The callers report the missing
  // columns.
  vtkNew<vtkCallbackCommand> silence;
  reader->AddObserver(vtkCommand::ErrorEvent, silence);
  reader->ReadFromInputStringOn();
  reader->SetInputString(text + "\n"); // VTK does not accept an empty string
  reader->SetHaveHeaders(true);
  reader->SetFieldDelimiterCharacters(",");
  reader->Update();
  return reader->GetOutput();
}

std::vector<std::string> NamesOfAxis(int axis)
{
  const std::string number = std::to_string(axis);
  return { std::string(1, static_cast<char>('x' + axis)), "points:" + number, "points_" + number };
}

vtkAbstractArray* FindColumn(vtkTable* table, const std::vector<std::string>& names)
{
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    std::string word;
    const char* title = table->GetColumnName(i);
    std::istringstream(title == nullptr ? "" : title) >> word; // removes surrounding blanks
    if (std::find(names.begin(), names.end(), vtksys::SystemTools::LowerCase(word)) != names.end())
    {
      return table->GetColumn(i);
    }
  }
  return nullptr;
}

std::optional<double> NumberAt(vtkAbstractArray* column, vtkIdType row)
{
  const std::string text = column->GetVariantValue(row).ToString();
  std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos)
  {
    return std::nullopt;
  }
  if (text[first] == '+' && text.compare(first, 2, "+-") != 0)
  {
    ++first;
  }
  const char* const end = text.data() + text.find_last_not_of(" \t\r") + 1;
  double number = 0.0;
  const auto result = std::from_chars(text.data() + first, end, number);
  return result.ec == std::errc() && result.ptr == end ? std::optional(number) : std::nullopt;
}
}
