#ifndef TMeshConversion_h
#define TMeshConversion_h

#include "MapConversion.h"
#include "TMesh.h"

#include <vector>

class vtkFieldData;
class vtkPolyData;

/** Conversion of what is traced in a flat map; every function throws crossfield::Error. */
namespace TMeshConversion
{
/**
 * A polyline for each line, and four from each seed, of lengths up to `longest` in the map; see
 * vtkSeparatrices.
 */
void WriteTraces(const MapConversion::Map& traced, const crossfield::TraceGraph& graph,
  const std::vector<crossfield::Point>& seeds, double longest, vtkPolyData* output);

/** The field data of vtkSeparatrices. */
void AddCounts(const crossfield::TMesh& mesh, vtkFieldData* field);
}

#endif
