#pragma once

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

namespace crossfield
{
/// Reads the values of a .msh file of Gmsh one by one, from text or binary data. All functions throw
/// Error at the end of the file and for values that are not valid.
class MshStream
{
public:
  MshStream(std::string_view text, std::string file)
    : Text(text)
    , File(std::move(file))
  {
  }

  /// Reads the format after $MeshFormat; the values after it are read accordingly.
  void ReadFormat();
  /// Returns the version of the format times 10: 22 or 41.
  int Version() const { return this->FormatVersion; }

  /// Returns whether elements of version 2.2 are stored in blocks, as in binary files.
  bool HasBlocks() const { return this->IsBinary; }

  /// Skips to the next line that starts with $, and returns it without the sign; empty at the end.
  std::string NextSection();

  /// Reads an integer of four bytes.
  int Integer();
  /// Reads a number of objects or a tag, of eight bytes in binary files of version 4.1.
  std::size_t Count();
  double Number();
  /// Reads an integer, and a text in quotes, in both kinds of files as text.
  int TextInteger();
  std::string QuotedText();
  /// Skips the end of a line, after which binary data start.
  void EndLine();

  [[noreturn]] void Refuse(const std::string& problem) const;

private:
  std::string_view Word();
  template <class Value>
  Value Bytes();

  std::string_view Text;
  std::size_t At = 0;
  std::string File;
  bool IsBinary = false;
  int FormatVersion = 0;
};
}
