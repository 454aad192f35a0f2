#ifndef IsolatedReading_h
#define IsolatedReading_h

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;

/**
 * Reading in a process of its own. VTK's readers trust their files: a damaged one may make them write
 * beyond an array, allocate all memory or count for hours. None of that reaches this process, which
 * takes over nothing but a copy that VTK's own writer made of what was read.
 */
namespace IsolatedReading
{
/**
 * Updates the reader of a file in a child process, and returns a source of a copy of its output.
 * Warnings of the reader go to standard error.
 *
 * Throws PipelineRun::Error with the reader's own sentence, or with one for a reader that dies of the
 * file, that needs more than ten seconds of processor time and ten for every megabyte of the file, or
 * more memory than the machine has or the file can ask for: a gigabyte, and 1000 times its size,
 * which is as far as the compression of .vtu and .vtp files goes.
 */
vtkSmartPointer<vtkAlgorithm> Read(const std::string& file, vtkAlgorithm* reader);
}

#endif
