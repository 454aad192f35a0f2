#pragma once

#include "PointPotential.h"
#include "TriangleFrames.h"
#include "VertexPotential.h"

namespace crossfield
{
/// Returns the steps of the phase of one configuration: those of the conjugate of R plus the angles at
/// which the positions of the logarithms see each step.
PhaseSteps StepsOf(const PointPotential& potential, const PointPotential::Solution& solution);

/// Returns those of singularities at vertices: of the conjugate of Φ and the shift that closes it around
/// handles, in the chart of each triangle.
PhaseSteps StepsOf(const VertexPotential& potential, const VertexPotential::Solution& solution);
}
