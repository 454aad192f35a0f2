#include "MshStream.h"

#include "Error.h"
#include "TextEncoding.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace crossfield
{
void MshStream::Refuse(const std::string& problem) const
{
  throw Error(
    "The mesh '" + this->File + "' " + problem + "; save it again in the format 4.1 or 2.2.");
}

std::string_view MshStream::Word()
{
  constexpr const char* Blanks = " \t\r\n";
  const std::size_t first = this->Text.find_first_not_of(Blanks, this->At);
  if (first == std::string_view::npos)
  {
    this->Refuse("ends too early");
  }
  this->At = std::min(this->Text.find_first_of(Blanks, first), this->Text.size());
  return this->Text.substr(first, this->At - first);
}

template <class Value>
Value MshStream::Bytes()
{
  if (this->Text.size() - this->At < sizeof(Value))
  {
    this->Refuse("ends too early");
  }
  Value value{};
  std::memcpy(&value, this->Text.data() + this->At, sizeof(Value));
  this->At += sizeof(Value);
  return value;
}

void MshStream::ReadFormat()
{
  this->IsBinary = false;
  const double version = this->Number();
  const int kind = this->TextInteger();
  const int size = this->TextInteger();
  this->FormatVersion = static_cast<int>(std::lround(10.0 * std::clamp(version, 0.0, 100.0)));
  if ((this->FormatVersion < 20 || this->FormatVersion > 22) && this->FormatVersion != 41)
  {
    this->Refuse("has a format that is not read");
  }
  if (size != 8 || (kind != 0 && kind != 1))
  {
    this->Refuse("has numbers of an unknown kind");
  }
  this->EndLine();
  this->IsBinary = kind == 1;
  if (this->IsBinary && this->Bytes<std::int32_t>() != 1)
  {
    this->Refuse("was written on a machine with another order of bytes");
  }
}

std::string MshStream::NextSection()
{
  while (true)
  {
    this->At = this->Text.find('$', this->At);
    if (this->At == std::string_view::npos)
    {
      this->At = this->Text.size();
      return {};
    }
    const bool startsLine = this->At == 0 || this->Text[this->At - 1] == '\n';
    ++this->At;
    if (startsLine)
    {
      return std::string(this->Word());
    }
  }
}

int MshStream::TextInteger()
{
  const std::string_view word = this->Word();
  int value = 0;
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  if (result.ec != std::errc() || result.ptr != word.data() + word.size())
  {
    this->Refuse("has '" + ToUtf8(word.substr(0, 20)) + "' in place of an integer");
  }
  return value;
}

int MshStream::Integer()
{
  return this->IsBinary ? this->Bytes<std::int32_t>() : this->TextInteger();
}

std::size_t MshStream::Count()
{
  if (this->IsBinary)
  {
    return this->FormatVersion == 41 ? this->Bytes<std::uint64_t>()
                                     : static_cast<std::size_t>(this->Bytes<std::uint32_t>());
  }
  const std::string_view word = this->Word();
  std::size_t value = 0;
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  if (result.ec != std::errc() || result.ptr != word.data() + word.size())
  {
    this->Refuse("has '" + ToUtf8(word.substr(0, 20)) + "' in place of a number of objects");
  }
  return value;
}

double MshStream::Number()
{
  double value = 0.0;
  if (this->IsBinary)
  {
    value = this->Bytes<double>();
  }
  else
  {
    const std::string_view word = this->Word();
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    if (result.ec != std::errc() || result.ptr != word.data() + word.size())
    {
      this->Refuse("has '" + ToUtf8(word.substr(0, 20)) + "' in place of a number");
    }
  }
  if (!std::isfinite(value))
  {
    this->Refuse("has a coordinate that is not finite");
  }
  return value;
}

std::string MshStream::QuotedText()
{
  const std::size_t open = this->Text.find('"', this->At);
  const std::size_t close = open == std::string_view::npos ? open : this->Text.find('"', open + 1);
  if (close == std::string_view::npos)
  {
    this->Refuse("has a name without quotes");
  }
  this->At = close + 1;
  return std::string(this->Text.substr(open + 1, close - open - 1));
}

void MshStream::EndLine()
{
  const std::size_t end = this->Text.find('\n', this->At);
  this->At = end == std::string_view::npos ? this->Text.size() : end + 1;
}
}
