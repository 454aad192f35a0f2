#include "ViewText.h"

#include "ColumnWriting.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDataSetAttributes.h"
#include "vtkTable.h"

#include <sstream>

namespace ViewText
{
//------------------------------------------------------------------------------
std::string WrapLines(const std::string& text)
{
  constexpr std::size_t LongestLine = 60;
  std::istringstream words(text);
  std::string lines;
  std::size_t lineLength = 0;
  for (std::string word; words >> word;)
  {
    const bool fits = lineLength + word.size() < LongestLine;
    if (!lines.empty())
    {
      lines += fits ? " " : "\n";
    }
    lines += word;
    lineLength = fits && lineLength > 0 ? lineLength + 1 + word.size() : word.size();
  }
  return lines;
}

//------------------------------------------------------------------------------
void Write(const char* name, const std::string& text, bool isAlarm, vtkTable* table)
{
  ColumnWriting::AddText(table->GetRowData(), name, text);
  ColumnWriting::AddIntegers(
    table->GetFieldData(), vtkCrossFieldArrayNames::Alarm, { isAlarm ? 1 : 0 });
}
}
