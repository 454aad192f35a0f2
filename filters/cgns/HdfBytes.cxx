#include "HdfBytes.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

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

/** A part of an object header of version 2, with its signature and without its checksum. */
struct Chunk
{
  std::size_t begin = 0;
  std::size_t messages = 0; ///< Where its messages begin.
  std::size_t end = 0;
};

class Header
{
public:
  Header(std::string& bytes, std::size_t begin)
    : Bytes(bytes)
  {
    // Signature, version, flags, times, limits of attributes, size, messages, checksum.
    this->Flags = this->At(begin + FlagsAt, 1);
    const std::size_t sizeAt = begin + FlagsAt + 1 +
      ((this->Flags & HasTimes) != 0U ? SizeOfTimes : 0) +
      ((this->Flags & HasLimits) != 0U ? 4 : 0);
    const std::size_t width = std::size_t(1) << (this->Flags & 3U); // bytes of the size
    const std::size_t messages = sizeAt + width;
    this->Add({ begin, messages, messages + this->At(sizeAt, width) });
    for (std::size_t i = 0; i < this->Chunks.size(); ++i)
    {
      this->ReadMessages(Chunk(this->Chunks[i]));
    }
  }

  /** Writes the zeros and the new checksums. */
  void Clean()
  {
    if (this->Chunks.empty())
    {
      return;
    }
    if ((this->Flags & HasTimes) != 0U)
    {
      this->Zeros.emplace_back(this->Chunks[0].begin + FlagsAt + 1, SizeOfTimes);
    }
    for (const auto& [at, size] : this->Zeros)
    {
      this->Bytes.replace(at, size, size, '\0');
    }
    for (const Chunk& chunk : this->Chunks)
    {
      const std::uint32_t sum = Checksum(this->Part(chunk));
      for (std::size_t i = 0; i < 4; ++i)
      {
        this->Bytes[chunk.end + i] = static_cast<char>((sum >> (8 * i)) & 0xFFU);
      }
    }
  }

private:
  static constexpr std::size_t FlagsAt = 5;
  static constexpr std::size_t SizeOfTimes = 16;
  static constexpr unsigned HasTimes = 0x20U;
  static constexpr unsigned HasLimits = 0x10U;
  static constexpr unsigned HasOrder = 0x04U;

  std::string_view Part(const Chunk& chunk) const
  {
    return std::string_view(this->Bytes).substr(chunk.begin, chunk.end - chunk.begin);
  }

  /** Returns a number of 1, 2, 4 or 8 bytes; in files below 4 GB the upper half of 8 bytes is 0. */
  std::uint32_t At(std::size_t at, std::size_t width) const
  {
    const std::string_view bytes = this->Bytes;
    return at < bytes.size() ? NumberAt(bytes.substr(at, width), 0) : 0U;
  }

  void Add(const Chunk& chunk)
  {
    // Other data may look like a header, but have another checksum.
    if (chunk.messages <= chunk.end && chunk.end + 4 <= this->Bytes.size() &&
      Checksum(this->Part(chunk)) == this->At(chunk.end, 4))
    {
      this->Chunks.push_back(chunk);
    }
  }

  void ReadMessages(const Chunk& chunk)
  {
    constexpr unsigned AttributeMessage = 12;
    constexpr unsigned Continuation = 16;
    constexpr std::size_t MaximumChunks = 1000;                        // more are a cycle
    const std::size_t prefix = (this->Flags & HasOrder) != 0U ? 6 : 4; // type, size, flags, order
    for (std::size_t at = chunk.messages; at + prefix <= chunk.end;)
    {
      const unsigned type = this->At(at, 1);
      const std::size_t size = this->At(at + 1, 2);
      at += prefix;
      if (at + size > chunk.end)
      {
        return;
      }
      if (type == Continuation && size >= 16 && this->Chunks.size() < MaximumChunks)
      {
        const std::size_t begin = this->At(at, 8);
        const std::size_t length = this->At(at + 8, 8);
        this->Add({ begin, begin + 4, begin + length - (length < 4 ? length : 4) });
      }
      if (type == AttributeMessage)
      {
        this->ReadAttribute(at, at + size);
      }
      at += size;
    }
  }

  /** Remembers what is behind the end of a text. */
  void ReadAttribute(std::size_t begin, std::size_t end)
  {
    constexpr unsigned Version = 3;
    constexpr unsigned TextClass = 3;
    // Version, flags, sizes of name, type and space, encoding; then these three and the value.
    const std::size_t type = begin + 9 + this->At(begin + 2, 2);
    const std::size_t value = type + this->At(begin + 4, 2) + this->At(begin + 6, 2);
    if (this->At(begin, 1) != Version || value >= end || (this->At(type, 1) & 0xFU) != TextClass)
    {
      return;
    }
    const std::size_t zero = this->Bytes.find('\0', value);
    if (zero < end)
    {
      this->Zeros.emplace_back(zero, end - zero);
    }
  }

  std::string& Bytes;
  unsigned Flags = 0;
  std::vector<Chunk> Chunks;
  std::vector<std::pair<std::size_t, std::size_t>> Zeros; ///< Begin and size.
};
}

void MakeHdfRepeatable(std::string& bytes)
{
  constexpr std::string_view Signature("OHDR\x02", 5);
  for (std::size_t at = bytes.find(Signature); at != std::string::npos;
       at = bytes.find(Signature, at + 1))
  {
    Header(bytes, at).Clean();
  }
}
