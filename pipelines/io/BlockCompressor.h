#ifndef BlockCompressor_h
#define BlockCompressor_h

#include "vtkZLibDataCompressor.h"

#include <map>
#include <vector>

class vtkDataSet;

/**
 * zlib for VTK's writers on all cores. A writer asks for one block after the other; this compressor
 * has compressed the blocks of a data set's arrays before, in parallel and by ZlibBlock.h, and hands them out. What it
 * has not seen it compresses when asked. The file is the same for any number of cores.
 */
class BlockCompressor : public vtkZLibDataCompressor
{
public:
  // No vtkTypeMacro: writers put the class name into the file, and readers must know it.
  static BlockCompressor* New();

  /**
   * Compresses the arrays on points and cells, and the points, in blocks of a writer's BlockSize.
   * They must not change until they are written.
   */
  void Compress(vtkDataSet* data, size_t blockSize);
  using vtkZLibDataCompressor::Compress;

protected:
  size_t CompressBuffer(unsigned char const* uncompressedData, size_t uncompressedSize,
    unsigned char* compressedData, size_t compressionSpace) override;

private:
  struct Block
  {
    size_t size = 0;
    std::vector<unsigned char> compressed;
  };
  std::map<unsigned char const*, Block> Blocks; ///< By where they begin.
};

#endif
