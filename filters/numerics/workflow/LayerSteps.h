#pragma once

#include "QuadRequest.h"

namespace crossfield
{
/// Returns the sides of a request; without any, those between corners.
BoundarySides SidesOf(const PlanarDomain& domain, const QuadRequest& request);

/// Returns the corners of a request, completed by those that its treatments and layers need: at
/// corners of layered sides without a choice, that of DefaultRows (docs/method.md §16.4).
std::vector<CornerChoice> CornersForLayers(const PlanarDomain& domain, const QuadRequest& request);

/// Returns the factors of a clearance with which chosen singularities leave the bands of the layers
/// free, for quads of a size; none if there are no layers. QuadRequest::layerRoom is a factor of the
/// distance.
ClearanceFactors ClearanceForLayers(
  const PlanarDomain& domain, const QuadRequest& request, double clearance, double quadSize);

/// Returns the number of quads before layers are added, with which there are about as many quads as
/// requested afterwards.
int CountBeforeLayers(const PlanarDomain& domain, const QuadRequest& request);

/// Corrects such a number, with which there were `total` quads instead of `requested` ones.
int CorrectCountBeforeLayers(int before, int total, int requested);
}
