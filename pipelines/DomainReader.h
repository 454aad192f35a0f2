#ifndef DomainReader_h
#define DomainReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;
class vtkDataSet;

/** The program's DOMAIN argument: a file, or builtin:NAME. */
namespace DomainReader
{
/** Help text for the argument. */
extern const char* const Help;

/**
 * A source or reader for the argument: .vtp .vtu .vtk .stl .obj .ply through VTK's
 * readers, .csv as one loop of points x,y or x,y,z, builtin:NAME with curves sampled at `edgeLength` (0: the
 * default). Throws PipelineRun::Error for a file that is missing,
 * cannot be read or holds no cells, and for an unknown ending.
 */
vtkSmartPointer<vtkAlgorithm> Open(const std::string& argument, double edgeLength);

/** A source or reader for points with quarter indices: a .vtp file, else .csv. */
vtkSmartPointer<vtkAlgorithm> OpenPoints(const std::string& file);

/** Whether a domain is in no plane z = const, so that its points are told with their z. */
bool HasHeight(vtkDataSet* domain);
}

#endif
