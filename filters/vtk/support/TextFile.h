#ifndef TextFile_h
#define TextFile_h

#include <string>
#include <utility>
#include <vector>

namespace TextFile
{
/**
 * Writes files, given by names and contents, or leaves the old ones: all are first written to second files in
 * the same folders. With `makeFolders` these are made if they are missing. Throws crossfield::Error.
 */
void Write(const std::vector<std::pair<std::string, std::string>>& files, bool makeFolders = false);
}

#endif
