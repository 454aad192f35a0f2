#pragma once

#include "ResolvedRequest.h"

namespace crossfield
{
/// Returns the corners of a request, completed by those that its treatments, periodic sides and layers
/// need: at two ends of periodic sides that together leave room for two quads, one at each, unless
/// singularities are given (docs/method.md §19.2); at other corners of layered sides without a choice, that
/// of DefaultRows (docs/method.md §16.4).
std::vector<CornerChoice> CompleteCorners(
  const PlanarDomain& domain, const ResolvedRequest& request);

/// Returns the factors of a clearance with which chosen singularities leave the bands of the layers
/// free, for quads of given side lengths at the boundary; none if there are no layers.
/// QuadRequest::layerDistance is a factor of the distance.
ClearanceFactors ClearanceForLayers(const PlanarDomain& domain, const ResolvedRequest& request,
  double clearance, const SizeFunction& quadSize);

/// Returns the number of quads before layers are added, with which there are about as many quads as
/// requested afterwards.
int CountBeforeLayers(const PlanarDomain& domain, const ResolvedRequest& request);

/// Adds the layers of a request to the quads of layouts, as AddLayers does. If a number of quads or
/// of edges of a side is requested that the mesh does not have with them, makes it again with other
/// numbers before, and takes the one that comes nearest to `total`. Throws Error as AddLayers does,
/// and if a side does not get its number of edges.
std::vector<LayerReport> AddLayersForCount(const PlanarDomain& domain,
  const ResolvedRequest& request, int total, const LayoutSet& layouts, QuadOptions options,
  QuadResult& quads);
}
