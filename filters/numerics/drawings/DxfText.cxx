#include "DxfText.h"

#include "Error.h"

#include <charconv>
#include <cmath>

namespace crossfield
{
namespace
{
/// Returns the text up to the end of a line and removes it from `rest`.
std::string_view TakeLine(std::string_view& rest)
{
  const std::size_t end = rest.find('\n');
  const std::string_view line = rest.substr(0, end);
  rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  return line;
}
}

bool ReadNumber(std::string_view text, double& number)
{
  text = Trimmed(text);
  if (!text.empty() && text.front() == '+')
  {
    text.remove_prefix(1);
  }
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  return result.ec == std::errc() && result.ptr == text.data() + text.size() &&
    std::isfinite(number);
}

std::string_view Trimmed(std::string_view text)
{
  constexpr const char* Blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(Blanks);
  return first == std::string_view::npos
    ? std::string_view()
    : text.substr(first, text.find_last_not_of(Blanks) - first + 1);
}

std::string DxfObject::Origin() const
{
  return "the " + std::string(this->Type()) + " of line " +
    std::to_string(this->Groups.front().line);
}

bool DxfObject::Has(int code) const
{
  for (const DxfGroup& group : this->Groups)
  {
    if (group.code == code)
    {
      return true;
    }
  }
  return false;
}

std::string_view DxfObject::Text(int code) const
{
  for (const DxfGroup& group : this->Groups)
  {
    if (group.code == code)
    {
      return group.value;
    }
  }
  return {};
}

double DxfObject::NumberOf(const DxfGroup& group)
{
  double number = 0.0;
  if (!ReadNumber(group.value, number))
  {
    throw Error("Line " + std::to_string(group.line) +
      " of the drawing must be a finite number; correct it, or export the drawing again.");
  }
  return number;
}

double DxfObject::Number(int code, double fallback) const
{
  for (const DxfGroup& group : this->Groups)
  {
    if (group.code == code)
    {
      return NumberOf(group);
    }
  }
  return fallback;
}

int DxfObject::Integer(int code, int fallback) const
{
  constexpr double Largest = 1e9;
  const double number = this->Number(code, fallback);
  if (!(std::abs(number) <= Largest))
  {
    throw Error("The code " + std::to_string(code) + " of " + this->Origin() +
      " is too large; correct it, or export the drawing again.");
  }
  return static_cast<int>(number);
}

std::vector<double> DxfObject::Numbers(int code) const
{
  std::vector<double> numbers;
  for (const DxfGroup& group : this->Groups)
  {
    if (group.code == code)
    {
      numbers.push_back(NumberOf(group));
    }
  }
  return numbers;
}

Point DxfObject::Place(int code) const
{
  return { this->Number(code), this->Number(code + 10) };
}

std::vector<Point> DxfObject::Places(int code) const
{
  const std::vector<double> x = this->Numbers(code);
  const std::vector<double> y = this->Numbers(code + 10);
  if (x.size() != y.size())
  {
    throw Error("A point of " + this->Origin() +
      " lacks a coordinate; correct it, or export the drawing again.");
  }
  std::vector<Point> points;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    points.emplace_back(x[i], y[i]);
  }
  return points;
}

std::vector<DxfObject> SplitDxf(std::string_view text, const std::string& file)
{
  if (text.substr(0, 18) == "AutoCAD Binary DXF" || text.substr(0, 2) == "AC")
  {
    throw Error(
      "The file '" + file + "' is a binary drawing of AutoCAD; export it as ASCII DXF instead.");
  }
  if (text.find('\0') != std::string_view::npos)
  {
    throw Error(
      "The file '" + file + "' has bytes that are no text; export it as ASCII DXF again.");
  }
  std::vector<DxfObject> objects;
  std::vector<DxfGroup> groups;
  bool hasEnd = false;
  int line = 0;
  while (!text.empty() && !hasEnd)
  {
    double code = 0.0;
    line += 2;
    if (!ReadNumber(TakeLine(text), code) || std::abs(code) > 10000.0)
    {
      throw Error("Line " + std::to_string(line - 1) + " of '" + file +
        "' is not the code of a DXF group; export the drawing again.");
    }
    const DxfGroup group = { static_cast<int>(code), Trimmed(TakeLine(text)), line };
    if (group.code == 0 && !groups.empty())
    {
      objects.emplace_back(std::move(groups));
      groups.clear();
    }
    hasEnd = group.code == 0 && group.value == "EOF";
    if (group.code == 0 || !groups.empty()) // a comment, code 999, may come first
    {
      groups.push_back(group);
    }
  }
  if (!hasEnd)
  {
    throw Error("The file '" + file + "' ends before its line EOF; export the drawing again.");
  }
  return objects;
}
}
