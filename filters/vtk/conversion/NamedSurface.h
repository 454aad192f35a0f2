#ifndef NamedSurface_h
#define NamedSurface_h

#include "RegionValues.h"
#include "SurfaceMesh.h"

#include <string>

class vtkDataSet;

/** A surface in space with its regions and named lines. */
struct NamedSurface
{
  crossfield::SurfaceMesh mesh;
  crossfield::SurfaceNames names;
  RegionValues regions; ///< Empty unless the surface has regions.

  /**
   * Reads triangles as SurfaceConversion::ReadTriangles does, regions from the cell array `materials`
   * (MaterialCheck::FindArray), and the lines that line cells with a name in the array `sides`
   * (SideConversion::FindArray) lead along. Throws crossfield::Error as these do, and if such a line is along no
   * edge of the surface.
   */
  static NamedSurface Read(
    vtkDataSet* input, const std::string& materials = {}, const std::string& sides = {});
};

#endif
