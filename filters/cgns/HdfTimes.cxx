#include "HdfTimes.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace
{
std::uint32_t Rotated(std::uint32_t value, int bits)
{
  return (value << bits) | (value >> (32 - bits));
}

/** Returns the number in four bytes, the lowest first; bytes after the end are 0. */
std::uint32_t NumberAt(std::string_view bytes, std::size_t at)
{
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4 && at + i < bytes.size(); ++i)
  {
    number |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return number;
}

/** Returns the checksum of HDF5's metadata, Bob Jenkins's lookup3. */
std::uint32_t Checksum(std::string_view bytes)
{
  const std::uint32_t start = 0xDEADBEEFU + static_cast<std::uint32_t>(bytes.size());
  std::array<std::uint32_t, 3> s = { start, start, start };
  constexpr std::size_t Round = 12;
  std::size_t at = 0;
  for (; bytes.size() - at > Round; at += Round)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      s[i] += NumberAt(bytes, at + 4 * i);
    }
    std::size_t i = 0;
    for (const int bits : { 4, 6, 8, 16, 19, 4 })
    {
      std::uint32_t& a = s[i % 3];
      std::uint32_t& b = s[(i + 1) % 3];
      std::uint32_t& c = s[(i + 2) % 3];
      a -= c;
      a ^= Rotated(c, bits);
      c += b;
      ++i;
    }
  }
  if (at == bytes.size())
  {
    return s[2];
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    s[i] += NumberAt(bytes, at + 4 * i);
  }
  std::size_t i = 2;
  for (const int bits : { 14, 11, 25, 16, 4, 14, 24 })
  {
    std::uint32_t& target = s[i % 3];
    const std::uint32_t source = s[(i + 2) % 3];
    target ^= source;
    target -= Rotated(source, bits);
    ++i;
  }
  return s[2];
}
}

void ClearHdfTimes(std::string& bytes)
{
  // A header of version 2: signature, version, flags, times, limits of attributes, size, messages, checksum.
  constexpr std::string_view Signature("OHDR\x02", 5);
  constexpr std::size_t FlagsAt = 5;
  constexpr unsigned HasTimes = 0x20U;
  constexpr unsigned HasLimits = 0x10U;
  constexpr std::size_t SizeOfTimes = 16;
  for (std::size_t at = bytes.find(Signature); at != std::string::npos;
       at = bytes.find(Signature, at + 1))
  {
    const std::string_view header = std::string_view(bytes).substr(at);
    const unsigned flags =
      header.size() > FlagsAt ? static_cast<unsigned char>(header[FlagsAt]) : 0U;
    if ((flags & HasTimes) == 0U)
    {
      continue;
    }
    const std::size_t sizeAt = FlagsAt + 1 + SizeOfTimes + ((flags & HasLimits) != 0U ? 4 : 0);
    const std::size_t width = std::size_t(1) << (flags & 3U); // bytes of the size
    std::size_t size = NumberAt(header, sizeAt);
    size = width < 4 ? size & ((std::size_t(1) << (8 * width)) - 1) : size;
    const std::size_t end = sizeAt + width + size;
    // Other data may look like a header, but have another checksum.
    if (end + 4 > header.size() || Checksum(header.substr(0, end)) != NumberAt(header, end))
    {
      continue;
    }
    bytes.replace(at + FlagsAt + 1, SizeOfTimes, SizeOfTimes, '\0');
    const std::uint32_t sum = Checksum(std::string_view(bytes).substr(at, end));
    for (std::size_t i = 0; i < 4; ++i)
    {
      bytes[at + end + i] = static_cast<char>((sum >> (8 * i)) & 0xFFU);
    }
  }
}
