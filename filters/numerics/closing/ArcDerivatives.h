#pragma once

#include "ArcPaths.h"
#include "PositionResponse.h"

namespace crossfield
{
/// Returns the derivative of the length of the arc of a path by the positions of the singularities,
/// a row of PositionResponse::Columns() (docs/method.md §14.10):
///   dℓ = −Im ∫ dF dw  along the path,
/// where parts near moving singularities are replaced by their closed form. Up to a common factor
/// of all lengths, which depends on the area of the map. First order accurate in the mesh size, and
/// only for moves that keep the holonomy defects at zero.
Eigen::RowVectorXd DifferentiateArc(const PositionResponse& response, const ArcPath& path);
}
