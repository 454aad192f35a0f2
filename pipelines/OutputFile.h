#ifndef OutputFile_h
#define OutputFile_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <string>
#include <utility>
#include <vector>

class OutputTransaction;

/** Writes results as parts of a transaction, which puts all outputs of a command into place or none. */
namespace OutputFile
{
/** Throws PipelineRun::Error unless `file` ends in `ending` and its folder can be written. */
void RequireWritable(const std::string& file, const std::string& ending);

/**
 * Writes a vtkPolyData (.vtp) or vtkUnstructuredGrid (.vtu) in inline binary with zlib: the VTKs of
 * Debian 12 cannot read appended data back.
 */
void Write(vtkDataObject* data, const std::string& file, OutputTransaction& outputs);

/** Data sets and their names. */
using Blocks = std::vector<std::pair<std::string, vtkSmartPointer<vtkDataObject>>>;

/**
 * Writes a multiblock F.vtm and its unstructured grids, as Write does, to F/NAME.vtu. The index is
 * written here: VTK's own writer leaves a broken file behind when it fails.
 */
void WriteBlocks(const Blocks& blocks, const std::string& file, OutputTransaction& outputs);
}

#endif
