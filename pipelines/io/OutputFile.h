#ifndef OutputFile_h
#define OutputFile_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

class OutputTransaction;
class vtkDataSet;

/** Writes results as parts of a transaction, which puts all outputs of a command into place or none. */
namespace OutputFile
{
/** A file that a command was asked for, if any; "-" is standard output, whatever the ending. */
struct Output
{
  std::string file;
  std::string ending;
};

/**
 * Throws PipelineRun::Error unless every file ends as it should, its folder can be written, and no two
 * are the same. Commands call it before any work.
 */
void RequireWritable(std::initializer_list<Output> outputs);

/**
 * Writes a vtkPolyData (.vtp), vtkUnstructuredGrid (.vtu) or vtkStructuredGrid (.vts) in inline binary with zlib: the VTKs of
 * Debian 12 cannot read appended data back.
 */
void Write(vtkDataObject* data, const std::string& file, OutputTransaction& outputs);

/** The same, unless no file is named; returns the seconds that it took. */
double WriteIfNamed(vtkDataObject* data, const std::string& file, OutputTransaction& outputs);

/** Writes singularities as the .csv file that vtkSingularitySource reads, with the radii they have. */
void WriteConfiguration(
  vtkDataSet* singularities, bool hasHeight, const std::string& file, OutputTransaction& outputs);

/** Data sets and their names. */
using Blocks = std::vector<std::pair<std::string, vtkSmartPointer<vtkDataObject>>>;

/**
 * Writes a multiblock F.vtm and its grids, as Write does, to F/NAME.vtu or F/NAME.vts. The index is
 * written here: VTK's own writer leaves a broken file behind when it fails.
 */
void WriteBlocks(const Blocks& blocks, const std::string& file, OutputTransaction& outputs);
}

#endif
