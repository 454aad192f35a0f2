#pragma once

#include "Drawing.h"

#include <string>
#include <string_view>
#include <vector>

namespace crossfield
{
/// A group of a .dxf file: its code and its value.
struct DxfGroup
{
  int code = 0;
  std::string_view value; ///< Part of the text of the file.
  int line = 0;           ///< Line of the value.
};

/// Reads a number; returns false if the text is not exactly one finite number.
bool ReadNumber(std::string_view text, double& number);
/// Returns a text without blanks at its ends.
std::string_view Trimmed(std::string_view text);

/// An object of a .dxf file: the groups from one of code 0 up to the next.
class DxfObject
{
public:
  DxfObject() = default;
  explicit DxfObject(std::vector<DxfGroup> groups)
    : Groups(std::move(groups))
  {
  }

  std::string_view Type() const { return this->Groups.front().value; }
  const std::vector<DxfGroup>& All() const { return this->Groups; }
  /// Returns the type and the line, for messages.
  std::string Origin() const;

  bool Has(int code) const;
  /// Returns the text of a code, empty if there is none.
  std::string_view Text(int code) const;
  /// Returns the first number of a code or the fallback. Throws Error if it is no finite number.
  double Number(int code, double fallback = 0.0) const;
  /// Returns an integer between −1e9 and 1e9, else throws Error.
  int Integer(int code, int fallback = 0) const;
  /// Returns all numbers of a code.
  std::vector<double> Numbers(int code) const;
  /// Returns x of the given code with y of code + 10.
  Point Place(int code) const;
  /// Returns all such points. Throws Error if there are not as many y as x.
  std::vector<Point> Places(int code) const;

  /// Returns the number of a group; throws Error if it is not one.
  static double NumberOf(const DxfGroup& group);

private:
  std::vector<DxfGroup> Groups;
};

/// Splits the text of an ASCII .dxf file into its objects. Throws Error for a binary file, a file
/// of AutoCAD (.dwg), and one that does not consist of groups or has no end.
std::vector<DxfObject> SplitDxf(std::string_view text, const std::string& file);
}
