#ifndef SizeConversion_h
#define SizeConversion_h

#include "DomainPlane.h"
#include "MeshTopology.h"
#include "QuadSizes.h"

#include <string>

class vtkDataSet;

/** Wanted sizes from a point array of a domain; throws crossfield::Error. */
namespace SizeConversion
{
/** Sizes relative to `mean`, in the plane; quads of side `mean` would be as many. */
struct Sizes
{
  crossfield::SizeFunction relative;
  double mean = 0.0;
};

/**
 * Reads the lengths in the point array `name`: linear on surface cells and along curves; inside of
 * curves as crossfield::ExtendSizes, on a mesh of the domain.
 */
Sizes ReadSizes(vtkDataSet* domain, const std::string& name, const crossfield::DomainPlane& plane,
  const crossfield::MeshTopology& topology);
}

#endif
