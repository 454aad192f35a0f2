#ifndef IsolatedReading_h
#define IsolatedReading_h

#include "PipelineRun.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;

/**
 * Reads files in a child process. VTK's readers trust their files: a damaged file may make them
 * write beyond an array, allocate all memory or loop for hours. None of this affects the parent
 * process, which reads only a copy of the data that VTK's own writer has made.
 */
namespace IsolatedReading
{
/** Failure without an error message of the reader: a crash, or a limit that was reached. */
class Crash : public PipelineRun::Error
{
public:
  using PipelineRun::Error::Error;
};

/**
 * Updates the reader of a file in a child process, and returns a source for a copy of its output.
 * Warnings of the reader go to standard error.
 *
 * Throws PipelineRun::Error with the message of the reader, or Crash if the reader crashes, needs more
 * than ten seconds of processor time plus ten for every megabyte of the file, or more memory than
 * the machine has or than a gigabyte plus 1000 times the size of the file, the limit of compression
 * in .vtu and .vtp files.
 */
vtkSmartPointer<vtkAlgorithm> Read(const std::string& file, vtkAlgorithm* reader);
}

#endif
