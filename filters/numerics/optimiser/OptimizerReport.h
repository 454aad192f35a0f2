#pragma once

#include "OptimizerIteration.h"
#include "PlanarDomain.h"
#include "Singularity.h"

#include <string>
#include <vector>

namespace crossfield
{
/// A number with four digits, for messages.
std::string Short(double value);

/// Why a run ended, in one sentence.
std::string ReasonOf(
  OptimizerEnd end, const ObjectiveOptions& objective, std::size_t singularities, int iterations);

/// A given hole that leaves less than a quarter of the way to the boundary, or of half of that to
/// another one, has no room for a mesh in between: it becomes smaller. Returns a sentence for each.
std::vector<std::string> ShrinkRadii(const PlanarDomain& domain, Configuration& configuration);
}
