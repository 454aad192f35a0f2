#pragma once

#include "Layout.h"
#include "MeshForPoints.h"
#include "TMeshPatches.h"

namespace crossfield::test
{
/// Returns the layout of a map.
inline LayoutSet LayoutOf(const SeamlessMap& map)
{
  Layout layout;
  layout.map = map;
  layout.tMesh = MakeTMesh(map, TraceSeparatrices(map));
  return LayoutSet(std::move(layout));
}

/// Returns the layout of singularities in a domain.
inline Layout LayOutOn(const PlanarDomain& domain, const Configuration& singularities,
  const SeamlessMapOptions& options = {}, double meshSize = 0.0)
{
  return LayOut(ShareTopology(MeshThroughPoints(domain, singularities, meshSize)), singularities,
    options, true);
}
}
