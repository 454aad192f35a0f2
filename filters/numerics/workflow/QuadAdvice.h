#pragma once

#include "FlatteningReport.h"
#include "HolonomyRepair.h"
#include "PlanarDomain.h"
#include "QuadMesher.h"

#include <optional>
#include <string>

namespace crossfield
{
/// Number of quads with an accepted size, as a remedy.
struct SmallerSize
{
  double size = 0.0;
  std::size_t quads = 0;
};

/// Throws Error if an interior singularity has a quarter index above 2, for which there is no node.
void RequireNodes(const PlanarDomain& domain, const Configuration& singularities);

/// Returns a sentence for every interior singularity of quarter index 2: its node has two quads, with
/// an angle of 180° each.
std::vector<std::string> DescribeFlatNodes(
  const PlanarDomain& domain, const Configuration& singularities);

/// Returns a sentence for every interior singularity of quarter index −2 or below, whose node has
/// six quads or more.
std::vector<std::string> DescribeCrowdedNodes(
  const PlanarDomain& domain, const Configuration& singularities);

/// Returns a sentence about inverted quads. The remedy is a size with which there are none, if one
/// was found.
std::string DescribeInverted(const QuadQuality& quality, const std::optional<SmallerSize>& smaller);

/// Returns the clause that offers a repair of the holonomy that was found to work.
std::string RepairAdvice(const HolonomyRepair& repair);

/// Returns a sentence with another clause before its full stop.
std::string WithAdvice(std::string sentence, const std::string& clause);
}
