#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace crossfield
{
/// A file of the classic netCDF format with 64-bit offsets (CDF-2): named arrays in big-endian numbers.
class NetCdf
{
public:
  /// An attribute; a text, or one number of a type.
  struct Attribute
  {
    enum Type
    {
      Text = 2,
      Integer = 4,
      Float = 5
    };
    std::string name;
    Type type = Text;
    std::string text;
    double number = 0.0;
  };

  /// Adds a dimension and returns its number; the length 0 is that of the record dimension, which has no records.
  int AddDimension(const std::string& name, int length);
  void AddAttribute(const Attribute& attribute) { this->Attributes.push_back(attribute); }

  /// Adds a variable with dimensions by their numbers. `values` has as many values as they say.
  void AddIntegers(const std::string& name, const std::vector<int>& dimensions,
    const std::vector<int>& values, const std::vector<Attribute>& attributes = {});
  void AddNumbers(
    const std::string& name, const std::vector<int>& dimensions, const std::vector<double>& values);
  /// Adds texts, which are filled with zeros to the length of the second dimension and end with at least one.
  void AddTexts(const std::string& name, const std::vector<int>& dimensions,
    const std::vector<std::string>& texts);

  /// Returns the bytes of the file.
  std::string Bytes() const;

private:
  struct Dimension
  {
    std::string name;
    int length = 0;
  };
  struct Variable
  {
    std::string name;
    std::vector<int> dimensions;
    std::vector<Attribute> attributes;
    int type = 0;
    std::string bytes; ///< A multiple of 4.
  };

  std::string Header(std::uint64_t dataBegin, std::uint64_t dataEnd) const;

  std::vector<Dimension> Dimensions;
  std::vector<Attribute> Attributes;
  std::vector<Variable> Variables;
};
}
