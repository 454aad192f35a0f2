#ifndef PeriodicConversion_h
#define PeriodicConversion_h

#include "ExportMesh.h"

#include <string>
#include <vector>

class vtkFieldData;

/**
 * Conversion of periodic sides to field data: `PeriodicSides` (strings, two names for each pair) and
 * `PeriodicMotion` (16 components for each pair: the matrix, row by row, that takes points (x, y, z, 1) of
 * the first side to those of the second).
 */
namespace PeriodicConversion
{
/**
 * Reads the pairs of periodic sides of a mesh; none if it has not the arrays. Throws crossfield::Error if
 * they do not belong together or name a side that the mesh has not.
 */
std::vector<crossfield::PeriodicPair> Read(
  vtkFieldData* data, const std::vector<std::string>& sideNames);
}

#endif
