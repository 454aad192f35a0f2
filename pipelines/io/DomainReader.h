#ifndef DomainReader_h
#define DomainReader_h

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>

class vtkDataObject;
class vtkDataSet;

/** The program's DOMAIN argument: a file, or builtin:NAME. */
namespace DomainReader
{
/** Help text for the argument. */
extern const char* const Help;

/**
 * A source or reader for the argument: .vtp .vtu .vtk .stl .obj .ply through VTK's
 * readers, .csv and .dat through vtkPlanarDomainReader, builtin:NAME with curves sampled at `edgeLength` (0:
 * the default). "-" is standard input; of it and of other pipes the first bytes say what they are. Throws PipelineRun::Error for a file that is missing,
 * cannot be read or holds no cells, and for an unknown ending.
 */
vtkSmartPointer<vtkAlgorithm> Open(const std::string& name, double edgeLength);

/** A source or reader for points with quarter indices: a .vtp file, else .csv; "-" is standard input. */
vtkSmartPointer<vtkAlgorithm> OpenPoints(const std::string& name);

/** Gives a filter the corners of a file, if one is named. */
template <class Filter>
void ConnectCorners(Filter* filter, const std::string& file)
{
  if (!file.empty())
  {
    filter->SetCornersConnection(OpenPoints(file)->GetOutputPort());
  }
}

/** Whether a domain is a mesh of vtkDrillHoles, with what it says of its boundary. */
bool IsDrilled(vtkDataObject* domain);

/** The bounding box of the points that the lines and surface cells of a domain use. */
std::array<double, 6> Bounds(vtkDataSet* domain);

/** Whether a domain is in no plane z = const, so that its points are told with their z. */
bool HasHeight(vtkDataSet* domain);
}

#endif
