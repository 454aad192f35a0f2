#pragma once

#include <string>
#include <vector>

namespace crossfield
{
/// What the names of a format may be.
struct NameRule
{
  bool isPlain = true;      ///< Only letters, digits, - and _ of ASCII, beginning with a letter.
  bool hasCase = true;      ///< Whether names that differ in case are different.
  bool isPathPart = false;  ///< Whether names have no / and are not only dots.
  std::size_t longest = 80; ///< Bytes.
};

/// Returns for each name one that the format can have: other characters become _ (in names that need
/// not be plain only " and control characters, which become ' and blanks, and / of parts of paths), a prefix is set before a name
/// that must begin with a letter, long names are cut, and _2, _3, ... is added to names that are then
/// equal to an earlier or a reserved one. Names that the format can have stay as they are.
std::vector<std::string> FormatNames(const std::vector<std::string>& names, const NameRule& rule,
  const std::vector<std::string>& reserved = {});
}
