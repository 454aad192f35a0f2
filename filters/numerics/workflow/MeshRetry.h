#pragma once

#include "CoarseMeshError.h"

#include <string>
#include <vector>

namespace crossfield
{
/// Returns attempt(1.0), where the argument is the refinement of a mesh (MeshThroughPoints). If
/// that throws CoarseMeshError, adds an event with its message and returns attempt(2.0), on a mesh
/// with edges half as long. Passes on all other errors, and those of the second attempt.
template <typename Attempt>
auto RetryOnFinerMesh(const Attempt& attempt, std::vector<std::string>& events)
{
  try
  {
    return attempt(1.0);
  }
  catch (const CoarseMeshError& error)
  {
    events.push_back("The triangle mesh was refined once, to edges half as long. With the first "
                     "mesh: " +
      std::string(error.what()));
  }
  return attempt(2.0);
}
}
