#ifndef ZlibBlock_h
#define ZlibBlock_h

#include <cstddef>
#include <vector>

/** Compression in the format of zlib, which every reader of VTK files supports. */
namespace ZlibBlock
{
/**
 * Compresses bytes with libdeflate, which takes less than half the time of zlib, at its fastest
 * level; higher levels gain a few per cent. Throws std::bad_alloc.
 */
std::vector<unsigned char> Compress(const unsigned char* data, std::size_t size);
}

#endif
