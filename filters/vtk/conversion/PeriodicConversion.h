#ifndef PeriodicConversion_h
#define PeriodicConversion_h

#include "DomainPlane.h"
#include "QuadMesh.h"
#include "SolverMesh.h"

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
std::vector<crossfield::SidePair> Read(
  vtkFieldData* data, const std::vector<std::string>& sideNames);

/** Adds both arrays, and removes those of another mesh. */
void Write(
  const crossfield::QuadMesh& mesh, const crossfield::DomainPlane& plane, vtkFieldData* data);

/**
 * Adds both arrays and, one tuple for each pair, `PeriodicKind` (translation or rotation), `PeriodicVector`
 * (3, 0 for a rotation), `PeriodicCentre` (3) and `PeriodicAngle` (radians, 0 for a translation), `PeriodicEdges` and
 * `PeriodicMismatch`.
 */
void WriteReport(
  const crossfield::QuadMesh& mesh, const crossfield::DomainPlane& plane, vtkFieldData* data);

/** Copies both arrays. */
void Copy(vtkFieldData* from, vtkFieldData* to);
}

#endif
