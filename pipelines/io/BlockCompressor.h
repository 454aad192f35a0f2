#ifndef BlockCompressor_h
#define BlockCompressor_h

#include "vtkZLibDataCompressor.h"

#include <map>
#include <vector>

class vtkDataSet;

/**
 * zlib compressor for VTK's writers that uses as many threads as the filters. A writer requests one block after another.
 * This compressor has compressed the blocks of the data set's arrays beforehand, in parallel and
 * with ZlibBlock.h; it compresses other blocks when they are requested. The file does not depend on
 * the number of threads.
 */
class BlockCompressor : public vtkZLibDataCompressor
{
public:
  // No vtkTypeMacro: writers store the class name in the file, and readers must know it.
  static BlockCompressor* New();

  /**
   * Compresses the points and the arrays on points and cells, in blocks of the writer's BlockSize.
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
  std::map<unsigned char const*, Block> Blocks; ///< Blocks by their first byte.
};

#endif
