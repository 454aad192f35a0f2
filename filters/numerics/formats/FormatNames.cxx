#include "FormatNames.h"

#include <algorithm>
#include <map>
#include <set>

namespace crossfield
{
namespace
{
bool IsLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool IsContinuation(char c)
{
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; // of a character in UTF-8
}

std::string Cut(std::string name, std::size_t longest)
{
  if (name.size() > longest)
  {
    std::size_t end = longest;
    while (end > 0 && IsContinuation(name[end]))
    {
      --end;
    }
    name.resize(end);
  }
  return name;
}

std::string PlainName(const std::string& name)
{
  std::string plain;
  for (const char c : name)
  {
    const bool isAllowed = IsLetter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_';
    if (!IsContinuation(c))
    {
      plain += isAllowed ? c : '_';
    }
  }
  return plain.empty() || !IsLetter(plain[0]) ? "side_" + plain : plain;
}

std::string QuotedName(const std::string& name, bool isPathPart)
{
  std::string quoted = name;
  for (char& c : quoted)
  {
    const auto code = static_cast<unsigned char>(c);
    c = c == '"' ? '\'' : (code < 0x20U || code == 0x7FU ? ' ' : c);
  }
  if (isPathPart)
  {
    std::replace(quoted.begin(), quoted.end(), '/', '_');
    // Blanks at the ends get lost in some readers.
    const std::size_t first = quoted.find_first_not_of(' ');
    quoted = first == std::string::npos
      ? ""
      : quoted.substr(first, quoted.find_last_not_of(' ') + 1 - first);
    quoted = quoted.find_first_not_of('.') == std::string::npos ? "side" + quoted : quoted;
  }
  return quoted.empty() ? "side" : quoted;
}

std::string KeyOf(std::string name, const NameRule& rule)
{
  if (!rule.hasCase)
  {
    std::transform(name.begin(), name.end(), name.begin(),
      [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  }
  return name;
}
}

std::vector<std::string> FormatNames(const std::vector<std::string>& names, const NameRule& rule,
  const std::vector<std::string>& reserved)
{
  std::vector<std::string> result;
  std::set<std::string> taken;
  for (const std::string& name : reserved)
  {
    taken.insert(KeyOf(name, rule));
  }
  std::set<std::string> unchanged; // these keep their names, wherever they are in the list
  for (const std::string& name : names)
  {
    result.push_back(
      Cut(rule.isPlain ? PlainName(name) : QuotedName(name, rule.isPathPart), rule.longest));
    if (result.back() == name && taken.count(KeyOf(name, rule)) == 0)
    {
      unchanged.insert(KeyOf(name, rule));
    }
  }
  std::map<std::string, int> copies;
  std::set<std::string> kept;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const std::string wanted = result[i];
    const std::string wantedKey = KeyOf(wanted, rule);
    if (wanted == names[i] && unchanged.count(wantedKey) > 0 && kept.insert(wantedKey).second)
    {
      taken.insert(wantedKey);
      continue;
    }
    int& copy = copies[wantedKey];
    while (taken.count(KeyOf(result[i], rule)) > 0 || unchanged.count(KeyOf(result[i], rule)) > 0)
    {
      copy = std::max(copy, 1) + 1;
      const std::string ending = "_" + std::to_string(copy);
      result[i] = Cut(wanted, rule.longest - ending.size()) + ending;
    }
    taken.insert(KeyOf(result[i], rule));
  }
  return result;
}
}
