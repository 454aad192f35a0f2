#ifndef CadLibrary_h
#define CadLibrary_h

#include "ReadCad.h"

#include <string>

/**
 * Reads models of Open CASCADE. The library that does, filters/cad, is loaded when a model is read:
 * it and the libraries it needs would double the time that the program takes to start.
 */
namespace CadLibrary
{
/** Returns whether an ending in lower case, with its dot, is that of a model. */
bool IsCad(const std::string& ending);

/** Returns whether models can be read. */
bool IsAvailable();

/** Reads a model as crossfieldReadCad does. Throws crossfield::Error if that fails or if models cannot be read. */
crossfield::Drawing Read(const std::string& file, const CadRequest& request);
}

#endif
