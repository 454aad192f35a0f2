#ifndef SizeConversion_h
#define SizeConversion_h

#include "DomainPlane.h"
#include "PrescribedSizes.h"

#include <functional>
#include <string>

class vtkDataSet;

/** Reads target sizes of quads from filter properties and from a point array of a domain. */
namespace SizeConversion
{
/**
 * Returns the sizing that a value of vtkQuadMesher::SizingType or
 * vtkSingularityOptimizer::SizingType stands for.
 */
crossfield::Sizing ReadSizing(int sizing);

/**
 * Reads the lengths in the point array `name` of a domain: linear on surface cells, else along
 * curves, where they are known on the boundary only. The result keeps a copy of the data. Throws
 * crossfield::Error when the array is missing, has several components, or a length is not a
 * positive number.
 */
crossfield::PrescribedSizes ReadSizes(
  vtkDataSet* domain, const std::string& name, const crossfield::DomainPlane& plane);

/** Reads lengths of a surface in space in the same way: at the nearest point of its cells. */
std::function<double(const crossfield::SpacePoint&)> ReadSizesOnSurface(
  vtkDataSet* surface, const std::string& name);
}

#endif
