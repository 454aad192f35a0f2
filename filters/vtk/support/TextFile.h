#ifndef TextFile_h
#define TextFile_h

#include <string>

namespace TextFile
{
/**
 * Writes a text to a file, or leaves the old file: the text is first written to a second file in the
 * same folder. Throws crossfield::Error.
 */
void Write(const std::string& text, const std::string& file);
}

#endif
