#ifndef SizeConversion_h
#define SizeConversion_h

#include "AutomaticConfiguration.h"
#include "DomainConversion.h"
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

/** The same without a mesh at hand: one with edges of a length, 0 for the default, is made. */
Sizes ReadSizes(vtkDataSet* domain, const std::string& name, const DomainConversion::Domain& input,
  double meshSize);

/** Properties of vtkQuadMesher with these names. */
struct QuadRequest
{
  int sizing = 0;
  std::string sizeArray;
  double quadSize = 0.0;
  int quadCount = 0;
  int pairs = 0;
};

/** Asks for singularities of which such quads can be made, on meshes as the options have them. */
void ChooseForQuads(vtkDataSet* domain, const DomainConversion::Domain& input,
  const QuadRequest& request, crossfield::AutomaticOptions& automatic);
}

#endif
