#ifndef DomainReader_h
#define DomainReader_h

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;

/** Reads the argument DOMAIN of the program: a file, or builtin:NAME. */
namespace DomainReader
{
/** Help text for the argument. */
extern const char* const Help;

/** How a drawing is read, by properties of vtkDrawingReader. */
struct DrawingOptions
{
  double joinTolerance = 0.0;
  std::vector<std::string> layers;
  bool closedCurvesAreRegions = false;
  bool allFaces = false;
  std::vector<std::string> lines; ///< Those that no curve is called by are ignored.
};

/**
 * Returns a source or reader for the argument: VTK's readers for .vtp .vtu .vtk .stl .obj .ply,
 * vtkDrawingReader for drawings and aerofoils, vtkPlanarDomainReader for .csv and
 * other .dat, and vtkPlanarDomainSource for builtin:NAME, with curves sampled at `edgeLength` (0: the
 * default). "-" is standard input; the type of data from standard input and other pipes follows from
 * their first bytes. Throws PipelineRun::Error for a file that
 * is missing, cannot be read or has no cells, and for an unknown ending.
 */
vtkSmartPointer<vtkAlgorithm> Open(
  const std::string& name, double edgeLength, const DrawingOptions& drawing = {});

/** Returns a source or reader for points with quarter indices: .vtp or .csv; "-" is standard input.
 */
vtkSmartPointer<vtkAlgorithm> OpenPoints(const std::string& name);

/** Connects the corners of a file to a filter, if one is named. */
template <class Filter>
void ConnectCorners(Filter* filter, const std::string& file)
{
  if (!file.empty())
  {
    filter->SetCornersConnection(OpenPoints(file)->GetOutputPort());
  }
}

/** Returns whether a domain is a mesh of vtkDrillHoles, with the arrays on its boundary. */
bool IsDrilled(vtkDataObject* domain);

/** Returns the bounding box of the points that lines and surface cells of a domain use. */
std::array<double, 6> Bounds(vtkDataSet* domain);
}

#endif
