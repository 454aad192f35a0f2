#ifndef HdfBytes_h
#define HdfBytes_h

#include <string>

/**
 * Sets to zero what differs between HDF5 files of the same data by libcgns: the times in object headers, and what
 * was in memory behind the texts of attributes. Headers whose checksum is wrong are left as they are.
 */
void MakeHdfRepeatable(std::string& bytes);

#endif
