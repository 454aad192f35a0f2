#ifndef MapConversion_h
#define MapConversion_h

#include "DomainPlane.h"
#include "FlatMap.h"
#include "TMesh.h"

#include <vector>

class vtkFieldData;
class vtkPolyData;
class vtkUnstructuredGrid;

/** Conversion of flat maps and what is traced in them; every function throws crossfield::Error. */
namespace MapConversion
{
/** A map, and the plane in space that its domain lies in. */
struct Map
{
  crossfield::FlatMap map;
  crossfield::DomainPlane plane;
};

/** The mesh cut along the seams, with the arrays of vtkCrossFieldMap. */
void WriteMap(const Map& written, vtkUnstructuredGrid* output);

/** What WriteMap has written. */
Map ReadMap(vtkUnstructuredGrid* input);

/**
 * A polyline for each line, and four from each seed, of lengths up to `longest` in the map; see
 * vtkSeparatrices.
 */
void WriteTraces(const Map& traced, const crossfield::TraceGraph& graph,
  const std::vector<crossfield::Point>& seeds, double longest, vtkPolyData* output);

/** Triangles for each face, and its outline; see vtkSeparatrices. */
void WriteFaces(const Map& traced, const crossfield::TMesh& mesh, vtkPolyData* output);

/** The field data of vtkSeparatrices. */
void AddCounts(const crossfield::TMesh& mesh, vtkFieldData* field);
}

#endif
