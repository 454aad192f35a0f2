#ifndef WriteCgns_h
#define WriteCgns_h

#include "SolverMesh.h"

#include <string>

/** Type of the function that the library for CGNS exports. */
using WriteCgnsFunction = void(
  const crossfield::SolverMesh& mesh, std::string& bytes, std::string& error);
/** Its name in the library. */
constexpr const char* WriteCgnsName = "crossfieldWriteCgns";

/**
 * Writes the blocks of a mesh as a CGNS file in HDF5: a structured zone for each block, its points in double
 * precision, 1-to-1 connections in both zones, and for each piece of a side a boundary condition that refers to the
 * family with the side's name. Blocks of quads have two coordinates if z is constant, otherwise three.
 *
 * Names have at most 32 bytes, without `/`. Zones are called block0, block1, .... Faces that are a line are conditions
 * of the type BCDegenerateLine.
 *
 * The mesh is prepared (PrepareMesh). On failure `error` is one sentence and not empty. No exception leaves the
 * function.
 */
extern "C" WriteCgnsFunction crossfieldWriteCgns;

#endif
