#ifndef ViewText_h
#define ViewText_h

#include <string>

class vtkTable;

/** Sentences for a view: ParaView draws the text of a table. */
namespace ViewText
{
/** The words of a text in lines of at most 60 characters, but at least one word each. */
std::string InLines(const std::string& text);

/** One column with one row, the text, and field data `Alarm`: whether it says that something is wrong. */
void Write(const char* name, const std::string& text, bool isAlarm, vtkTable* table);
}

#endif
