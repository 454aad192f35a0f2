#pragma once

#include "ResolvedRequest.h"

namespace crossfield
{
/// Returns the request with all that it says about sizes as one field of target sizes
/// (docs/method.md §14.8), in ResolvedRequest::targets; unchanged if it has
/// only a size or a number of quads.
///
/// With the size h elsewhere, which is uniform or proportional to the prescribed sizes, and the sizes
/// H_i of sides, positions and insides of sides, it is the largest field
///   s(x) ≤ max(h(x), max_i (H_i − a d_i(x))),  s(x) ≤ H_i at set i,  |∇s| ≤ a = ln(growth),
/// with distances d_i inside the domain, between the minimum and the maximum size. If a number of
/// quads is requested, h has the factor with which ∫ dA / s² is that number. If there is none, all
/// of these sizes have one (SizeTargets::factor). Otherwise QuadRequest::quadSize is h, or a factor of
/// the prescribed sizes; without it there are about DefaultQuads elsewhere, or the factor is 1.
///
/// Throws Error as RequireConsistent does, if the minimum size exceeds the maximum, the growth is not
/// above 1, a position is not in the domain, or a side encloses nothing.
ResolvedRequest WithSizeTargets(const PlanarDomain& domain, ResolvedRequest request);
}
