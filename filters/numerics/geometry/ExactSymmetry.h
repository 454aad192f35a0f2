#pragma once

#include "PlanarDomain.h"

namespace crossfield
{
/// Returns a domain with exactly the symmetries that the given one has to 1e-6 of its diagonal, the
/// rounding of coordinates in single precision or with six digits: each vertex becomes the mean of
/// the preimages of its images. Without it one digit would decide whether a mesh is symmetric.
/// A domain whose symmetries are exact already is returned as it is.
PlanarDomain WithExactSymmetries(const PlanarDomain& domain);
}
