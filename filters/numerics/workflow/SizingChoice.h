#pragma once

#include "CleanBlocks.h"

#include <string>
#include <vector>

namespace crossfield
{
/// Whether singularities move for uniform sizes.
enum class SizingFreedom
{
  Free,       ///< They may: the program chose them.
  PreferHeld, ///< Only where shapes or sizes are poor otherwise: they are given.
  Held        ///< They do not.
};

/// Replaces a mesh with conformal sizes by one with uniform sizes where that is better, and sets the
/// sizing of the options to that of the result (docs/method.md §14.8). Conformal sizes are retained
/// if their standard deviation is at most GoodVariation of the mean and the minimum scaled Jacobian at least
/// 0.8 of the attainable one, or if uniform ones have less than 0.975 of the minimum scaled Jacobian or more
/// blocks; with given singularities if the deviation is at most half of the mean.
/// Returns the decision as an event, or none.
std::vector<std::string> ChooseSizing(
  MeshedLayout& meshed, QuadOptions& options, SizingFreedom freedom, const Progress& progress = {});
}
