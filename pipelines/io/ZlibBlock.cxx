#include "ZlibBlock.h"

#include <libdeflate.h>

#include <memory>
#include <new>

namespace ZlibBlock
{
std::vector<unsigned char> Compress(const unsigned char* data, std::size_t size)
{
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
    libdeflate_alloc_compressor(1), &libdeflate_free_compressor);
  if (compressor == nullptr)
  {
    throw std::bad_alloc();
  }
  std::vector<unsigned char> result(libdeflate_zlib_compress_bound(compressor.get(), size));
  result.resize(
    libdeflate_zlib_compress(compressor.get(), data, size, result.data(), result.size()));
  result.shrink_to_fit();
  return result;
}
}
