#include "BlockCompressor.h"

#include "ZlibBlock.h"

#include "vtkCellData.h"
#include "vtkCrossFieldParts.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

vtkStandardNewMacro(BlockCompressor);

//------------------------------------------------------------------------------
void BlockCompressor::Compress(vtkDataSet* data, size_t blockSize)
{
  std::vector<vtkDataArray*> arrays;
  for (vtkDataSetAttributes* attributes :
    { static_cast<vtkDataSetAttributes*>(data->GetPointData()),
      static_cast<vtkDataSetAttributes*>(data->GetCellData()) })
  {
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      arrays.push_back(attributes->GetArray(i));
    }
  }
  if (vtkPointSet* points = vtkPointSet::SafeDownCast(data))
  {
    arrays.push_back(points->GetPoints() != nullptr ? points->GetPoints()->GetData() : nullptr);
  }
  this->Blocks.clear();
  for (vtkDataArray* array : arrays)
  {
    if (array == nullptr || !array->HasStandardMemoryLayout())
    {
      continue;
    }
    const auto* begin = static_cast<unsigned char const*>(array->GetVoidPointer(0));
    const size_t size = static_cast<size_t>(array->GetNumberOfValues()) *
      static_cast<size_t>(array->GetDataTypeSize());
    for (size_t at = 0; at < size; at += blockSize)
    {
      this->Blocks[begin + at] = { std::min(blockSize, size - at), {} };
    }
  }

  std::vector<std::pair<unsigned char const* const, Block>*> blocks;
  for (auto& block : this->Blocks)
  {
    blocks.push_back(&block);
  }
  vtkCrossFieldParts::Run(blocks.size(),
    [&](size_t i)
    {
      Block& block = blocks[i]->second;
      try
      {
        block.compressed = ZlibBlock::Compress(blocks[i]->first, block.size);
      }
      catch (const std::bad_alloc&)
      {
        // This block is compressed when the writer requests it.
      }
    });
}

//------------------------------------------------------------------------------
size_t BlockCompressor::CompressBuffer(unsigned char const* uncompressedData,
  size_t uncompressedSize, unsigned char* compressedData, size_t compressionSpace)
{
  const auto found = this->Blocks.find(uncompressedData);
  const bool known = found != this->Blocks.end() && found->second.size == uncompressedSize &&
    !found->second.compressed.empty();
  const std::vector<unsigned char> compressed = known
    ? std::move(found->second.compressed) // each block is requested once
    : ZlibBlock::Compress(uncompressedData, uncompressedSize);
  if (compressed.size() > compressionSpace)
  {
    return this->vtkZLibDataCompressor::CompressBuffer(
      uncompressedData, uncompressedSize, compressedData, compressionSpace);
  }
  std::memcpy(compressedData, compressed.data(), compressed.size());
  return compressed.size();
}
