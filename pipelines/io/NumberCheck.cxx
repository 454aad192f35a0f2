#include "NumberCheck.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace
{
/** Returns the number that a text is as a whole, or NaN. */
double NumberOf(const std::string& text)
{
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const bool isNumber = !text.empty() && end == text.c_str() + text.size();
  return isNumber && std::isfinite(number) ? number : std::numeric_limits<double>::quiet_NaN();
}

/** Returns digits in groups of three, such as 2,147,483,647. */
std::string Grouped(int number)
{
  std::string digits = std::to_string(number);
  const int first = number < 0 ? 1 : 0;
  for (int i = static_cast<int>(digits.size()) - 3; i > first; i -= 3)
  {
    digits.insert(static_cast<std::size_t>(i), ",");
  }
  return digits;
}

std::string Refusal(const std::string& required, const std::string& given)
{
  return "give " + required + " instead of '" + given + "'";
}

/** Returns a validator of numbers; `required` is what the message requests. */
template <typename Condition>
CLI::Validator Number(const char* name, const std::string& required, Condition holds)
{
  return CLI::Validator([required, holds](std::string& text)
    { return holds(NumberOf(text)) ? std::string() : Refusal(required, text); },
    name);
}
}

namespace NumberCheck
{
CLI::Validator Positive()
{
  return Number("POSITIVE", "a positive number", [](double number) { return number > 0.0; });
}

CLI::Validator NotNegative()
{
  return Number(
    "NONNEGATIVE", "a number that is not negative", [](double number) { return number >= 0.0; });
}

CLI::Validator Whole(int minimum, int maximum)
{
  const std::string required =
    "a whole number from " + Grouped(minimum) + " to " + Grouped(maximum);
  return CLI::Validator(
    [=](std::string& text)
    {
      const double number = NumberOf(text);
      if (!(number >= minimum && number <= maximum) || number != std::floor(number))
      {
        return Refusal(required, text);
      }
      text = std::to_string(static_cast<int>(number));
      return std::string();
    },
    "");
}

CLI::Validator Word(const std::vector<std::pair<std::string, int>>& words)
{
  std::string required;
  std::string description;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    required += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i].first;
    description += (i == 0 ? "{" : ",") + words[i].first;
  }
  return CLI::Validator(
    [=](std::string& text)
    {
      const auto found = std::find_if(
        words.begin(), words.end(), [&](const auto& word) { return word.first == text; });
      if (found == words.end())
      {
        return Refusal(required, text);
      }
      text = std::to_string(found->second);
      return std::string();
    },
    description + "}");
}
}
