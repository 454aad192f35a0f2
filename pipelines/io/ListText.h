#ifndef ListText_h
#define ListText_h

#include <string>
#include <vector>

/** Lists in the form of the filters' properties. */
namespace ListText
{
/** Returns entries with a semicolon after each. */
inline std::string Join(const std::vector<std::string>& entries)
{
  std::string text;
  for (const std::string& entry : entries)
  {
    text += entry + ";";
  }
  return text;
}
}

#endif
