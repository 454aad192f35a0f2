#ifndef ZlibBlock_h
#define ZlibBlock_h

#include <cstddef>
#include <vector>

/** Compression of data into the format of zlib, which every reader of VTK's files knows. */
namespace ZlibBlock
{
/**
 * The bytes in the format of zlib, by libdeflate, which takes less than half the time, at its quickest level: higher
 * ones gain a few per cent. Throws std::bad_alloc.
 */
std::vector<unsigned char> Compress(const unsigned char* data, std::size_t size);
}

#endif
