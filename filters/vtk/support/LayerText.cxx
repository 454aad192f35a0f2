#include "LayerText.h"

#include "EntryText.h"
#include "Error.h"

#include <cmath>
#include <locale>
#include <map>
#include <optional>
#include <sstream>

namespace
{
/** Returns the number that a text consists of, or nothing. */
std::optional<double> ReadNumber(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  stream >> number;
  return stream.fail() || !(stream >> std::ws).eof() ? std::nullopt : std::make_optional(number);
}

/** Returns the numbers that the parts of a text consist of, or nothing if one is none. */
std::optional<std::vector<double>> ReadNumbers(const std::string& text, char separator)
{
  std::vector<double> numbers;
  for (const std::string& part : EntryText::Split(text, separator))
  {
    const std::optional<double> number = ReadNumber(part);
    if (!number)
    {
      return std::nullopt;
    }
    numbers.push_back(*number);
  }
  return numbers;
}
}

namespace LayerText
{
//------------------------------------------------------------------------------
std::vector<crossfield::LayerPrescription> ReadLayers(const std::string& text)
{
  const std::string form = "NAME:FIRST, NAME:FIRST,GROWTH or NAME:FIRST,GROWTH,ROWS";
  std::vector<crossfield::LayerPrescription> layers;
  for (const std::string& entry : EntryText::Split(text, ';'))
  {
    if (entry.empty())
    {
      continue;
    }
    const auto [name, values] = EntryText::Divide(entry, "layer", form);
    const std::optional<std::vector<double>> numbers = ReadNumbers(values, ',');
    if (!numbers || numbers->empty() || numbers->size() > 3)
    {
      throw crossfield::Error(
        "The layer '" + entry + "' does not have one to three numbers; give " + form + ".");
    }
    crossfield::LayerPrescription layer;
    layer.name = name;
    layer.first = (*numbers)[0];
    layer.growth = numbers->size() > 1 ? (*numbers)[1] : layer.growth;
    if (numbers->size() > 2)
    {
      const double rows = (*numbers)[2];
      if (!(rows >= 1.0 && rows <= 1e6) || rows != std::floor(rows))
      {
        throw crossfield::Error("The layer '" + entry +
          "' does not have a whole number of rows, 1 or more; correct it, or leave it out.");
      }
      layer.rows = static_cast<int>(rows);
    }
    layers.push_back(layer);
  }
  return layers;
}

//------------------------------------------------------------------------------
std::vector<crossfield::CornerRule> ReadCornerRows(
  const std::string& text, const crossfield::DomainPlane& plane)
{
  const std::map<std::string, crossfield::CornerRows> words = {
    { "end", crossfield::CornerRows::End },
    { "turn", crossfield::CornerRows::Turn },
    { "leave", crossfield::CornerRows::Leave },
  };
  const std::string form = "X,Y:WORD, ANGLE-ANGLE:WORD or NAME:WORD with end, turn or leave";
  std::vector<crossfield::CornerRule> rules;
  for (const std::string& entry : EntryText::Split(text, ';'))
  {
    if (entry.empty())
    {
      continue;
    }
    const auto [place, word] = EntryText::Divide(entry, "corner", form);
    const auto found = words.find(word);
    if (found == words.end())
    {
      throw crossfield::Error(
        "The corner '" + entry + "' has no word end, turn or leave; give " + form + ".");
    }
    crossfield::CornerRule rule;
    rule.rows = found->second;
    const std::optional<std::vector<double>> position = ReadNumbers(place, ',');
    const std::optional<std::vector<double>> angles = ReadNumbers(place, '-');
    if (position && (position->size() == 2 || position->size() == 3))
    {
      const double z = position->size() == 3 ? (*position)[2] : 0.0;
      rule.position =
        plane.RequireInPlane({ (*position)[0], (*position)[1], z }, "The corner '" + entry + "'");
    }
    else if (angles && angles->size() == 2)
    {
      constexpr double Degree = crossfield::Pi / 180.0;
      rule.angles = { (*angles)[0] * Degree, (*angles)[1] * Degree };
    }
    else
    {
      rule.side = place;
    }
    rules.push_back(rule);
  }
  return rules;
}
}
