#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace crossfield
{
/// Lines of numbers in a text file, without comments, which begin with #, and empty lines.
class NumberLines
{
public:
  NumberLines(std::string_view text, std::string file)
    : Text(text)
    , File(std::move(file))
  {
  }

  /// Reads the next line. Throws Error at the end of the file.
  void Next();
  std::size_t Size() const { return this->Words.size(); }
  std::string_view Word(std::size_t i) const { return this->Words[i]; }
  /// Returns a finite number of the line. Throws Error if it is none.
  double Number(std::size_t i) const;
  /// Returns a whole number from `least` on. Throws Error if it is none, or more than the file has bytes.
  int Count(std::size_t i, int least = 0) const;
  /// Throws Error that names the file and the line.
  [[noreturn]] void Refuse(const std::string& problem) const;

private:
  std::string_view Text;
  std::string File;
  std::size_t At = 0;
  int Line = 0;
  std::vector<std::string_view> Words;
};
}
