#ifndef QuadBoundary_h
#define QuadBoundary_h

class vtkAlgorithm;
class vtkInformation;
class vtkPolyData;

/** Finds the boundary edges of quads, which are another output of the filter that makes the quads. */
namespace QuadBoundary
{
/** Declares, in FillOutputPortInformation, which output has the boundary edges of the quads of a port. */
void Declare(vtkInformation* quads, int boundaryPort);

/**
 * Returns the boundary edges of the quads at input port 0: the data of input port 1 or, if it has no
 * connection, the declared output of the nearest filter upstream that makes the quads. Filters in
 * between may add arrays, but must keep points and cells. Returns nullptr if there is no such filter.
 */
vtkPolyData* Find(vtkAlgorithm* self);
}

#endif
