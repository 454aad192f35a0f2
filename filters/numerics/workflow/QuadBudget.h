#pragma once

#include "ResolvedRequest.h"

namespace crossfield
{
/// Maximum number of quads, and of edges of a side, which has as many quads: 50 GB with BytesPerQuad.
constexpr double MaximumQuads = 5e7;

/// Throws Error if a domain has more than MaximumQuads quads of a size, or more than the available memory holds; a
/// size of 0 stands for none.
void RequireQuadSize(const PlanarDomain& domain, double quadSize);

/// Throws Error, before any work, if a request is for more than MaximumQuads quads or edges of a side, or for more quads than
/// the available memory holds.
void RequireQuadBudget(const PlanarDomain& domain, const ResolvedRequest& request);
}
