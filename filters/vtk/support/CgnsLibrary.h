#ifndef CgnsLibrary_h
#define CgnsLibrary_h

#include "SolverMesh.h"

#include <string>

/**
 * Writes CGNS files. The library that does, filters/cgns, is loaded when a file is written: it and HDF5 would
 * make the program start later.
 */
namespace CgnsLibrary
{
/** Returns whether CGNS files can be written. */
bool IsAvailable();

/** Throws crossfield::Error unless CGNS files can be written. */
void Require();

/** Prepares a mesh and returns the bytes of its file. Throws crossfield::Error. */
std::string Write(crossfield::SolverMesh mesh);
}

#endif
