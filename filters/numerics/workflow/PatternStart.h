#pragma once

#include "CleanBlocks.h"
#include "ResolvedRequest.h"

#include <string>

namespace crossfield
{
/// Tries four singularities around every round hole and the singularities of the domain with the
/// holes filled (docs/method.md §14.10). Replaces the start, and the corners of the options, if the mesh
/// has fewer blocks, is as good (CleanTolerance), and its number of quads is as near to the requested
/// one. Returns whether it did.
bool StartFromPattern(const PlanarDomain& domain, const ResolvedRequest& request,
  MeshedLayout& start, CleanOptions& options, const Progress& progress);

/// Returns a sentence about blocks that were merged, or that none were.
std::string DescribeClean(
  const CleanBlocksResult& clean, bool isPattern, const BlockCounts& blocks);
}
