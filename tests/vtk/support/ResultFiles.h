#ifndef ResultFiles_h
#define ResultFiles_h

class vtkAlgorithm;

/** Storage of results of filters for the verifier in tests/verify. */
namespace ResultFiles
{
/**
 * Writes the mesh or field that a filter of this project has computed to the folder named by the
 * environment variable CROSSFIELD_WRITTEN. The file name contains the running test; equal results
 * are written once. Does nothing without the variable and for other filters.
 */
void Save(vtkAlgorithm* filter);
}

#endif
