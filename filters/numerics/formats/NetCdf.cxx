#include "NetCdf.h"

#include "Index.h"

#include <algorithm>
#include <cstring>

namespace crossfield
{
namespace
{
// Tags and types of the format.
constexpr int DimensionTag = 10;
constexpr int VariableTag = 11;
constexpr int AttributeTag = 12;
constexpr int Character = 2;
constexpr int Integer = 4;
constexpr int Double = 6;

/// Adds the bytes of a number, the highest first.
template <typename Bits>
void AddBits(Bits bits, std::string& bytes)
{
  for (int shift = 8 * (static_cast<int>(sizeof(Bits)) - 1); shift >= 0; shift -= 8)
  {
    bytes += static_cast<char>((bits >> shift) & 0xFFU);
  }
}

void AddInteger(int number, std::string& bytes)
{
  AddBits(static_cast<std::uint32_t>(number), bytes);
}

void Pad(std::string& bytes)
{
  bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
}

void AddText(const std::string& text, std::string& bytes)
{
  AddInteger(static_cast<int>(text.size()), bytes);
  bytes += text;
  Pad(bytes);
}

void AddList(int tag, std::size_t size, std::string& bytes)
{
  AddInteger(size == 0 ? 0 : tag, bytes);
  AddInteger(static_cast<int>(size), bytes);
}

void AddAttributes(const std::vector<NetCdf::Attribute>& attributes, std::string& bytes)
{
  AddList(AttributeTag, attributes.size(), bytes);
  for (const NetCdf::Attribute& attribute : attributes)
  {
    AddText(attribute.name, bytes);
    AddInteger(attribute.type, bytes);
    if (attribute.type == NetCdf::Attribute::Text)
    {
      AddText(attribute.text, bytes);
      continue;
    }
    const auto number = static_cast<float>(attribute.number);
    auto bits = static_cast<std::uint32_t>(static_cast<int>(attribute.number));
    if (attribute.type == NetCdf::Attribute::Float)
    {
      std::memcpy(&bits, &number, sizeof(bits));
    }
    AddInteger(1, bytes);
    AddBits(bits, bytes);
  }
}
}

int NetCdf::AddDimension(const std::string& name, int length)
{
  this->Dimensions.push_back({ name, length });
  return static_cast<int>(this->Dimensions.size()) - 1;
}

void NetCdf::AddIntegers(const std::string& name, const std::vector<int>& dimensions,
  const std::vector<int>& values, const std::vector<Attribute>& attributes)
{
  Variable variable = { name, dimensions, attributes, Integer, {} };
  variable.bytes.reserve(values.size() * sizeof(int));
  for (const int value : values)
  {
    AddInteger(value, variable.bytes);
  }
  this->Variables.push_back(std::move(variable));
}

void NetCdf::AddNumbers(
  const std::string& name, const std::vector<int>& dimensions, const std::vector<double>& values)
{
  Variable variable = { name, dimensions, {}, Double, {} };
  variable.bytes.reserve(values.size() * sizeof(double));
  for (const double value : values)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    AddBits(bits, variable.bytes);
  }
  this->Variables.push_back(std::move(variable));
}

void NetCdf::AddTexts(const std::string& name, const std::vector<int>& dimensions,
  const std::vector<std::string>& texts)
{
  Variable variable = { name, dimensions, {}, Character, {} };
  const std::size_t length = Index(this->Dimensions[dimensions.back()].length);
  for (const std::string& text : texts)
  {
    std::string cell = text.substr(0, length - 1);
    cell.resize(length, '\0');
    variable.bytes += cell;
  }
  Pad(variable.bytes);
  this->Variables.push_back(std::move(variable));
}

std::string NetCdf::Header(std::uint64_t dataBegin, std::uint64_t dataEnd) const
{
  std::string bytes = "CDF\x02";
  AddInteger(0, bytes); // records
  AddList(DimensionTag, this->Dimensions.size(), bytes);
  for (const Dimension& dimension : this->Dimensions)
  {
    AddText(dimension.name, bytes);
    AddInteger(dimension.length, bytes);
  }
  AddAttributes(this->Attributes, bytes);
  AddList(VariableTag, this->Variables.size(), bytes);
  for (const Variable& variable : this->Variables)
  {
    AddText(variable.name, bytes);
    AddInteger(static_cast<int>(variable.dimensions.size()), bytes);
    bool isRecord = false;
    for (const int dimension : variable.dimensions)
    {
      AddInteger(dimension, bytes);
      isRecord = isRecord || this->Dimensions[dimension].length == 0;
    }
    AddAttributes(variable.attributes, bytes);
    AddInteger(variable.type, bytes);
    constexpr std::uint64_t Largest = 0xFFFFFFFFU; // of larger sizes, as the format says
    const std::uint64_t size = isRecord ? sizeof(double) : variable.bytes.size();
    AddBits(static_cast<std::uint32_t>(std::min(size, Largest)), bytes);
    AddBits(isRecord ? dataEnd : dataBegin, bytes); // records come after all other data
    dataBegin += variable.bytes.size();
  }
  return bytes;
}

std::string NetCdf::Bytes() const
{
  const std::size_t begin = this->Header(0, 0).size();
  std::size_t end = begin;
  for (const Variable& variable : this->Variables)
  {
    end += variable.bytes.size();
  }
  std::string bytes = this->Header(begin, end);
  bytes.reserve(end);
  for (const Variable& variable : this->Variables)
  {
    bytes += variable.bytes;
  }
  return bytes;
}
}
