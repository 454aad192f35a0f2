#ifndef ViewText_h
#define ViewText_h

#include <string>

class vtkTable;

/** Texts for a view. ParaView displays the text of a table. */
namespace ViewText
{
/** Returns the words of a text in lines of at most 60 characters, with at least one word each. */
std::string WrapLines(const std::string& text);

/**
 * Writes one column with one row, the text, and the field data `Alarm`: 1 if the text reports a
 * problem.
 */
void Write(const char* name, const std::string& text, bool isAlarm, vtkTable* table);
}

#endif
