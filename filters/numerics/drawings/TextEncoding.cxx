#include "TextEncoding.h"

namespace crossfield
{
namespace
{
/// Returns the number of bytes of the character at a position, 0 if it is not valid.
std::size_t CharacterLength(std::string_view text, std::size_t at)
{
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(at);
  const std::size_t length = first < 0x80 ? 1
    : first < 0xC2                        ? 0
    : first < 0xE0                        ? 2
    : first < 0xF0                        ? 3
    : first < 0xF5                        ? 4
                                          : 0;
  if (length == 0 || at + length > text.size())
  {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((byte(at + i) & 0xC0U) != 0x80U)
    {
      return 0;
    }
  }
  // Overlong forms, surrogates, and numbers beyond the last character.
  const unsigned second = length > 1 ? byte(at + 1) : 0;
  const bool isExcluded = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
    (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
  return isExcluded ? 0 : length;
}

bool IsUtf8(std::string_view text)
{
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t length = CharacterLength(text, at);
    if (length == 0)
    {
      return false;
    }
    at += length;
  }
  return true;
}
}

std::string ToUtf8(std::string_view text)
{
  const bool isUtf8 = IsUtf8(text);
  std::string result;
  for (const char letter : text)
  {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < 0x20 || byte == 0x7F)
    {
      result += ' ';
    }
    else if (isUtf8 || byte < 0x80)
    {
      result += letter;
    }
    else
    {
      result += static_cast<char>(0xC0U | (byte >> 6U));
      result += static_cast<char>(0x80U | (byte & 0x3FU));
    }
  }
  return result;
}
}
