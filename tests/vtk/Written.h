#ifndef Written_h
#define Written_h

class vtkAlgorithm;

/** Results of filters, kept for the verifier in tests/verify. */
namespace Written
{
/**
 * Writes the mesh or field that a filter of this project has computed to the folder that the
 * environment variable CROSSFIELD_WRITTEN names, with the running test in its name, once whatever the
 * number of runs that have it. Without the variable, and for other filters, it does nothing.
 */
void Keep(vtkAlgorithm* filter);
}

#endif
