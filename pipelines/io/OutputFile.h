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
class vtkUnstructuredGrid;

/** Writes results as parts of a transaction, which puts all outputs of a command in place or none.
 */
namespace OutputFile
{
/** Output file of a command, empty if there is none; "-" is standard output. */
struct Output
{
  std::string file;
  std::string endings; ///< Possible endings, separated by blanks, / for folders; empty if all are.
};

/**
 * Throws PipelineRun::Error unless every file has one of its endings, its folder can be written, and no two
 * files are the same. Commands call it before any work.
 */
void RequireWritable(std::initializer_list<Output> outputs);

/**
 * Writes a vtkPolyData (.vtp), vtkUnstructuredGrid (.vtu) or vtkStructuredGrid (.vts) in inline
 * binary with zlib: the VTKs of Debian 12 cannot read appended data.
 */
void Write(vtkDataObject* data, const std::string& file, OutputTransaction& outputs);

/** Throws PipelineRun::Error if a file for WriteQuads cannot have quads of an order. */
void RequireOrder(const std::string& file, int order);

/**
 * Writes quads with their boundary edges to a .vtu file, to standard output for "-", or to the format of
 * another ending with vtkQuadMeshWriter, whose folders are made. `mshVersion` and `patchTypes` are those of that filter.
 */
void WriteQuads(vtkUnstructuredGrid* quads, const std::string& file, int mshVersion,
  const std::string& patchTypes, OutputTransaction& outputs);

/** Writes the data if a file is named; returns the seconds that this took. */
double WriteIfNamed(vtkDataObject* data, const std::string& file, OutputTransaction& outputs);

/** Writes singularities, with their radii if they have any, as .csv for vtkSingularitySource. */
void WriteConfiguration(
  vtkDataSet* singularities, bool hasHeight, const std::string& file, OutputTransaction& outputs);

/** Names and data sets of a multiblock. */
using Blocks = std::vector<std::pair<std::string, vtkSmartPointer<vtkDataObject>>>;

/**
 * Writes a multiblock F.vtm, and its grids as Write does to F/NAME.vtu or F/NAME.vts. VTK's own
 * writer is not used, because it leaves a broken file when it fails.
 */
void WriteBlocks(const Blocks& blocks, const std::string& file, OutputTransaction& outputs);
}

#endif
