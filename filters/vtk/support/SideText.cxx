#include "SideText.h"

#include "Error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <map>
#include <optional>
#include <sstream>

namespace SideText
{
const std::array<Column, 11> Columns{ {
  { "Side", &Row::side },
  { "Count", &Row::count },
  { "Progression", &Row::progression },
  { "Size", &Row::size },
  { "SizeInside", &Row::sizeInside },
  { "Curve", &Row::curve },
  { "LayerFirst", &Row::layerFirst },
  { "LayerGrowth", &Row::layerGrowth },
  { "LayerRows", &Row::layerRows },
  { "Partner", &Row::partner },
  { "CornerRows", &Row::cornerRows },
} };

namespace
{
using crossfield::Error;
using CurveKind = crossfield::CurveDeclaration::Kind;

const std::map<std::string, CurveKind> CurveKinds = { { "line", CurveKind::Line },
  { "circle", CurveKind::Circle }, { "ellipse", CurveKind::Ellipse },
  { "spline", CurveKind::Spline } };
const std::map<std::string, crossfield::CornerRows> CornerWords = {
  { "end", crossfield::CornerRows::End },
  { "turn", crossfield::CornerRows::Turn },
  { "leave", crossfield::CornerRows::Leave },
};

/** Returns the parts of a text between separators, without blanks around them. */
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

/** A name and its value. */
struct Entry
{
  std::string name;
  std::string value;
};

/** Divides an entry at its last colon. `what` is its kind and `form` its form, for the message. */
Entry Divide(const std::string& entry, const char* what, const char* form)
{
  const std::size_t colon = entry.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == entry.size())
  {
    throw Error("The " + std::string(what) + " '" + entry +
      "' has no colon between a name and a value; give " + form + ".");
  }
  return { entry.substr(0, colon), entry.substr(colon + 1) };
}

/** Reads the entries of a text. */
std::vector<Entry> ReadEntries(const std::string& text, const char* what, const char* form)
{
  std::vector<Entry> entries;
  for (const std::string& entry : Split(text, ';'))
  {
    if (!entry.empty())
    {
      entries.push_back(Divide(entry, what, form));
    }
  }
  return entries;
}

/** Returns the number that a text consists of, or nothing. */
std::optional<double> ReadNumber(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  stream >> number;
  return stream.fail() || !(stream >> std::ws).eof() || !std::isfinite(number)
    ? std::nullopt
    : std::make_optional(number);
}

/** Returns the numbers that the parts of a text consist of, or nothing if one is none. */
std::optional<std::vector<double>> ReadNumbers(const std::string& text, char separator)
{
  std::vector<double> numbers;
  for (const std::string& part : Split(text, separator))
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

/** Reads the texts of a row. */
class RowReader
{
public:
  RowReader(const Row& row, const crossfield::DomainPlane& plane)
    : TheRow(row)
    , Plane(plane)
  {
  }

  /** Returns what is prescribed for the side. */
  crossfield::SideRequest ReadSide() const
  {
    const Row& row = this->TheRow;
    crossfield::SideRequest request;
    request.side = row.side;
    request.partner = row.partner;
    if (!row.count.empty())
    {
      request.count = this->WholeNumber(row.count, "number of edges");
    }
    if (!row.progression.empty())
    {
      request.progression = this->ReadProgression();
    }
    if (!row.size.empty())
    {
      request.size = this->Positive(row.size, "size", "a positive number");
    }
    if (!row.sizeInside.empty())
    {
      request.inside = this->Positive(row.sizeInside, "size inside", "a positive number");
    }
    if (!row.curve.empty())
    {
      const auto kind = CurveKinds.find(row.curve);
      if (kind == CurveKinds.end())
      {
        this->Refuse(row.curve, "curve", "circle, ellipse, spline or line");
      }
      request.curve = kind->second;
    }
    if (!row.layerFirst.empty() || !row.layerGrowth.empty() || !row.layerRows.empty())
    {
      request.layer = this->ReadLayer();
    }
    return request;
  }

  /** Returns what rows do at a corner, or at those of a side. */
  crossfield::CornerRule ReadCorner() const
  {
    const auto word = CornerWords.find(this->TheRow.cornerRows);
    if (word == CornerWords.end())
    {
      throw Error("What rows do at '" + this->TheRow.side + "' is '" + this->TheRow.cornerRows +
        "'; give end, turn or leave.");
    }
    crossfield::CornerRule rule;
    rule.rows = word->second;
    const std::string& place = this->TheRow.side;
    const std::optional<std::vector<double>> position = ReadNumbers(place, ',');
    const std::optional<std::vector<double>> angles = ReadNumbers(place, '-');
    if (position && (position->size() == 2 || position->size() == 3))
    {
      const double z = position->size() == 3 ? (*position)[2] : 0.0;
      rule.position = this->Plane.RequireInPlane(
        { (*position)[0], (*position)[1], z }, "The corner '" + place + "'");
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
    return rule;
  }

private:
  [[noreturn]] void Refuse(const std::string& text, const char* what, const char* form) const
  {
    throw Error("The " + std::string(what) + " '" + text + "' of side '" + this->TheRow.side +
      "' is not valid; give " + form + ".");
  }

  double Number(const std::string& text, const char* what, const char* form) const
  {
    const std::optional<double> value = ReadNumber(text);
    if (!value)
    {
      this->Refuse(text, what, form);
    }
    return *value;
  }

  double Positive(const std::string& text, const char* what, const char* form) const
  {
    const double value = this->Number(text, what, form);
    if (!(value > 0.0))
    {
      this->Refuse(text, what, form);
    }
    return value;
  }

  int WholeNumber(const std::string& text, const char* what) const
  {
    constexpr const char* Form = "a positive whole number";
    const double value = this->Number(text, what, Form);
    if (value < 1.0 || value > std::numeric_limits<int>::max() || value != std::floor(value))
    {
      this->Refuse(text, what, Form);
    }
    return static_cast<int>(value);
  }

  crossfield::Progression ReadProgression() const
  {
    constexpr const char* What = "progression";
    constexpr const char* Form =
      "RATIO, or FIRST,LAST for lengths, positive, after both: for both ends";
    crossfield::Progression progression;
    std::string text = this->TheRow.progression;
    const std::string both = "both:";
    progression.both = text.compare(0, both.size(), both) == 0;
    text = progression.both ? text.substr(both.size()) : text;
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos)
    {
      progression.ratio = this->Positive(text, What, Form);
    }
    else
    {
      progression.first = this->Positive(text.substr(0, comma), What, Form);
      progression.last = this->Positive(text.substr(comma + 1), What, Form);
    }
    return progression;
  }

  crossfield::LayerPrescription ReadLayer() const
  {
    crossfield::LayerPrescription layer;
    layer.name = this->TheRow.side;
    if (!this->TheRow.layerFirst.empty())
    {
      layer.first = this->Number(this->TheRow.layerFirst, "height of the first row", "a length");
    }
    if (!this->TheRow.layerGrowth.empty())
    {
      layer.growth = this->Number(this->TheRow.layerGrowth, "growth of rows",
        "the ratio of the heights of neighbouring rows");
    }
    if (!this->TheRow.layerRows.empty())
    {
      layer.rows = this->WholeNumber(this->TheRow.layerRows, "number of rows");
    }
    return layer;
  }

  const Row& TheRow;
  const crossfield::DomainPlane& Plane;
};
}

//------------------------------------------------------------------------------
std::vector<std::string> ReadNames(const std::string& text)
{
  std::vector<std::string> names = Split(text, ';');
  names.erase(std::remove(names.begin(), names.end(), ""), names.end());
  return names;
}

//------------------------------------------------------------------------------
std::vector<Row> ReadLayers(const std::string& text)
{
  constexpr const char* Form = "NAME:FIRST, NAME:FIRST,GROWTH or NAME:FIRST,GROWTH,ROWS, "
                               "where FIRST may be empty";
  std::vector<Row> rows;
  for (const Entry& entry : ReadEntries(text, "layer", Form))
  {
    std::vector<std::string> values = Split(entry.value, ',');
    if (values.size() > 3)
    {
      throw Error("The layer '" + entry.name + ":" + entry.value +
        "' has more than three numbers; give " + Form + ".");
    }
    if (std::all_of(values.begin(), values.end(), [](const auto& value) { return value.empty(); }))
    {
      throw Error(
        "The layer '" + entry.name + ":" + entry.value + "' has no number; give " + Form + ".");
    }
    values.resize(3);
    rows.emplace_back();
    rows.back().side = entry.name;
    rows.back().layerFirst = values[0];
    rows.back().layerGrowth = values[1];
    rows.back().layerRows = values[2];
  }
  return rows;
}

//------------------------------------------------------------------------------
std::vector<Row> ReadPartners(const std::string& text)
{
  std::vector<Row> rows;
  for (const Entry& entry : ReadEntries(text, "periodic pair", "A:B with two sides"))
  {
    rows.emplace_back();
    rows.back().side = entry.name;
    rows.back().partner = entry.value;
  }
  return rows;
}

//------------------------------------------------------------------------------
std::map<std::string, std::string> ReadPatchTypes(const std::string& text)
{
  std::map<std::string, std::string> types;
  for (const Entry& entry :
    ReadEntries(text, "type of a patch", "NAME:TYPE, such as cylinder:wall"))
  {
    types[entry.name] = entry.value;
  }
  return types;
}

//------------------------------------------------------------------------------
std::vector<Row> ReadCornerRows(const std::string& text)
{
  std::vector<Row> rows;
  for (const Entry& entry :
    ReadEntries(text, "corner", "X,Y:WORD, ANGLE-ANGLE:WORD or NAME:WORD with end, turn or leave"))
  {
    rows.emplace_back();
    rows.back().side = entry.name;
    rows.back().cornerRows = entry.value;
  }
  return rows;
}

//------------------------------------------------------------------------------
crossfield::CurveRequest ReadCurves(const std::string& text)
{
  constexpr const char* Form = "NAME:circle, NAME:ellipse, NAME:spline, NAME:line or auto";
  crossfield::CurveRequest request;
  for (const std::string& entry : Split(text, ';'))
  {
    if (entry == "auto")
    {
      request.findsArcs = true;
    }
    else if (!entry.empty())
    {
      const Entry divided = Divide(entry, "curve", Form);
      const auto kind = CurveKinds.find(divided.value);
      if (kind == CurveKinds.end())
      {
        throw Error("The curve '" + entry + "' is not of the form " + Form + "; correct it.");
      }
      request.declared.push_back({ divided.name, kind->second });
    }
  }
  return request;
}

//------------------------------------------------------------------------------
void Prescribe(
  const Row& row, const crossfield::DomainPlane& plane, crossfield::QuadRequest& request)
{
  const RowReader reader(row, plane);
  request.sideRequests.push_back(reader.ReadSide());
  if (!row.cornerRows.empty())
  {
    request.cornerRows.push_back(reader.ReadCorner());
  }
}
}
