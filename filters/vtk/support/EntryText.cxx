#include "EntryText.h"

#include "Error.h"

#include <sstream>

namespace EntryText
{
//------------------------------------------------------------------------------
std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  std::string part;
  while (std::getline(stream, part, separator))
  {
    const std::size_t first = part.find_first_not_of(" \t\n");
    const std::size_t last = part.find_last_not_of(" \t\n");
    parts.push_back(first == std::string::npos ? "" : part.substr(first, last - first + 1));
  }
  return parts;
}

//------------------------------------------------------------------------------
std::pair<std::string, std::string> Divide(
  const std::string& entry, const std::string& what, const std::string& form)
{
  const std::size_t colon = entry.rfind(':');
  if (colon == std::string::npos || colon == 0)
  {
    throw crossfield::Error(
      "The " + what + " '" + entry + "' has no colon after a name; give " + form + ".");
  }
  return { entry.substr(0, colon), entry.substr(colon + 1) };
}
}
