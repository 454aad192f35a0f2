#ifndef HdfTimes_h
#define HdfTimes_h

#include <string>

/**
 * Sets the times in the object headers of an HDF5 file to zero, so that the same data give the same bytes. libcgns
 * has no option for that.
 */
void ClearHdfTimes(std::string& bytes);

#endif
