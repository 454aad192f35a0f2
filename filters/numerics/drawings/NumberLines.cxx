#include "NumberLines.h"

#include "Error.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace crossfield
{
void NumberLines::Next()
{
  this->Words.clear();
  while (this->Words.empty())
  {
    if (this->At >= this->Text.size())
    {
      ++this->Line;
      this->Refuse("is missing; the file ends too early");
    }
    const std::size_t end = std::min(this->Text.find('\n', this->At), this->Text.size());
    std::string_view line = this->Text.substr(this->At, end - this->At);
    this->At = end + 1;
    ++this->Line;
    line = line.substr(0, line.find('#'));
    constexpr std::string_view Blanks = " \t\r,";
    for (std::size_t begin = line.find_first_not_of(Blanks); begin != std::string_view::npos;)
    {
      const std::size_t stop = std::min(line.find_first_of(Blanks, begin), line.size());
      this->Words.push_back(line.substr(begin, stop - begin));
      begin = line.find_first_not_of(Blanks, stop);
    }
  }
}

double NumberLines::Number(std::size_t i) const
{
  double value = 0.0;
  if (i < this->Words.size())
  {
    std::istringstream stream{ std::string(this->Words[i]) };
    stream.imbue(std::locale::classic());
    if (stream >> value && stream.eof() && std::isfinite(value))
    {
      return value;
    }
  }
  this->Refuse("has no number as entry " + std::to_string(i + 1));
}

int NumberLines::Count(std::size_t i, int least) const
{
  const double value = this->Number(i);
  const double most = std::min(static_cast<double>(this->Text.size()), 2e9);
  if (value != std::floor(value) || value < least || value > most)
  {
    this->Refuse("has no whole number of at least " + std::to_string(least) + " as entry " +
      std::to_string(i + 1));
  }
  return static_cast<int>(value);
}

void NumberLines::Refuse(const std::string& problem) const
{
  throw Error("Line " + std::to_string(this->Line) + " of '" + this->File + "' " + problem +
    "; correct it, or export the file again.");
}
}
