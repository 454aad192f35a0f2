#pragma once

#include "OptimizerIteration.h"
#include "PlanarDomain.h"
#include "Singularity.h"

#include <string>
#include <vector>

namespace crossfield
{
/// Returns a sentence with its first letter in upper case.
std::string Capitalised(std::string sentence);
/// Formats a number with four digits, for messages.
std::string FormatShort(double value);

/// Returns the sentence that states why a run ended. `held` is the number of singularities that the
/// clearance holds (HeldSingularities).
std::string EndReason(OptimizerEnd end, const ObjectiveOptions& objective,
  std::size_t singularities, std::size_t held, int iterations);

/// Reduces the radii of given holes that leave too little space for a mesh: less than a quarter of
/// the distance to the boundary, or of half of the distance to another hole. Returns a sentence for
/// each.
std::vector<std::string> ShrinkRadii(const PlanarDomain& domain, Configuration& configuration);
}
