#ifndef TMeshConversion_h
#define TMeshConversion_h

#include "MapConversion.h"
#include "TMesh.h"

#include <vector>

class vtkFieldData;
class vtkPolyData;

/** Conversion of lines traced in a seamless map. Every function throws crossfield::Error. */
namespace TMeshConversion
{
/**
 * Writes a polyline for each separatrix and four streamlines from each seed, of lengths up to
 * `longest` in the map; see vtkSeparatrices.
 */
void WriteTraces(const MapConversion::Map& traced, const crossfield::TraceGraph& graph,
  const std::vector<crossfield::Point>& seeds, double longest, vtkPolyData* output);

/**
 * Writes a polyline for each arc inside of a surface, with the arrays of vtkSeparatrices; `EndsAt` and `Seed` have no
 * meaning.
 */
void WriteArcs(
  const MapConversion::Map& traced, const crossfield::TMesh& mesh, vtkPolyData* output);

/** Adds the field data of vtkSeparatrices. */
void AddCounts(const crossfield::TMesh& mesh, vtkFieldData* field);
}

#endif
