#pragma once

#include "EdgeCounts.h"
#include "QuantisationProblem.h"

namespace crossfield
{
/// A few flows suffice in all cases tried with planar domains; each takes milliseconds with hundreds of arcs.
constexpr int MaximumFlows = 200;

/// Solves a problem without separation rows and prescribed sums by minimum cost flows, and branch and bound on arcs
/// with half-integral counts (docs/method.md §14.2). After a maximum number of flows it returns the
/// best counts found, at worst twice the relaxed solution, which is always feasible. There are no
/// counts if the equations and lower bounds are infeasible.
EdgeCounts SolveBidirectedFlow(const QuantisationProblem& problem, int maximumFlows = MaximumFlows);
}
