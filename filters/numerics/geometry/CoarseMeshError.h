#pragma once

#include "Error.h"

namespace crossfield
{
/// Error that a finer triangle mesh may cure. MakeQuadMesh refines the mesh once before it passes
/// such an error on.
class CoarseMeshError : public Error
{
public:
  using Error::Error;
};
}
